//! Jobs and recipes. What is read is written, and read again it is the same.

use crate::run::{Kind, check_sentence, outline, run};
use clearbeam::document::{Job, Recipe, files, job_file};
use clearbeam::file;
use clearbeam::text::Sentence;
use std::path::Path;

/// What TOML and jobs are made of.
pub const WORDS: [&str; 58] = [
    "[[",
    "]]",
    "[",
    "]",
    "{ ",
    " }",
    " = ",
    "'''",
    "\"\"\"",
    "\"",
    "true",
    "false",
    "1979-05-27T07:32:00Z",
    "0xff",
    "\\u0000",
    "\\n",
    "\\",
    "\u{feff}",
    "ä",
    "\u{2028}",
    "\n",
    "\r\n",
    "#",
    ".",
    "version = 1\n",
    "version = 2\n",
    "[part]\n",
    "[part.placement]\n",
    "[layers]\n",
    "[cell]\n",
    "[[tilts]]\n",
    "[[pins]]\n",
    "[[starts]]\n",
    "[[clamps]]\n",
    "[[recipes]]\n",
    "[recipes.values]\n",
    "[recipe_of]\n",
    "[surfaces.names]\n",
    "surface = 1\n",
    "\"all\"",
    "\"auto\"",
    "\"exact\"",
    "\"inch\"",
    "\"offset\"",
    "\"spiral\"",
    "\"clearance\"",
    "\"1,0,0\"",
    "[0, 0, 0]",
    "border = 1\n",
    "centre_mm = [1, 2, 3]\n",
    "least_deg = 5\n",
    "forbidden = [\"lead\"]\n",
    "surfaces = [1, 2]\n",
    "\"layers.spacing_mm\" = 1.0\n",
    "merge = [1, 2]\n",
    "edits = []\n",
    "weld = \"auto\"\n",
    "positions",
];

const LISTS: &str = "[[tilts]]\nsurface = 1\nleast_deg = 5.0\npreferred = { lead_deg = 1.0, lean_deg = 2.0 }\n\
    [[pins]]\nsurface = 1\nline = 1\nat_mm = 2.0\ntilt = { lead_deg = 1.0, lean_deg = 2.0 }\n\
    [[starts]]\nsurface = 1\ncentre_mm = [1.0, 2.0, 3.0]\n[[starts]]\nsurface = 2\nborder = 3\n\
    [[clamps]]\nfile = \"a.stl\"\nposition_mm = [1.0, 2.0, 3.0]\nrz_ry_rx_deg = [1.0, 2.0, 3.0]\nunits = \"m\"\n\
    [[recipes]]\nname = \"Fine\"\nstrategy = \"spiral\"\ncentre_mm = [1.0, 2.0, 3.0]\nvalues = { \"layers.spacing_mm\" = \
    0.25 }\n[recipe_of]\n1 = \"Fine\"\n";

/// The files of a folder of the project, by name.
pub fn files_of(folder: &str) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).expect("a folder");
    let mut paths: Vec<_> = entries.map(|e| e.expect("readable").path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "toml"));
    paths.sort();
    paths.iter().map(|p| std::fs::read(p).expect("readable")).collect()
}

fn read_job(bytes: &[u8]) -> String {
    let job = match job_file::from_bytes(bytes) {
        Ok(job) => job,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    let text = files::to_toml(&job).expect("what is read can be written");
    let again = job_file::parse(&text).unwrap_or_else(|e| panic!("what is written can be read: {e}\n{text}"));
    assert_eq!(again, job, "{text}");
    assert_eq!(files::to_toml(&again).expect("writes"), text);
    let checked = job.check();
    if let Err(e) = &checked {
        check_sentence(&e.sentence());
    }
    let lists = [job.recipes.len(), job.clamps.len(), job.surfaces.edits.len(), job.settings.iter().count()];
    format!("{} {:?}", outline(&checked), lists.map(|n| n.min(3)))
}

fn read_recipe(bytes: &[u8]) -> String {
    let text = match file::decode(bytes) {
        Ok(text) => text,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    let recipe: Recipe = match file::read_toml(text) {
        Ok(recipe) => recipe,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    let written = toml::to_string(&recipe).expect("what is read can be written");
    let again: Recipe = file::read_toml(&written).unwrap_or_else(|e| panic!("it can be read: {e}\n{written}"));
    assert_eq!(again, recipe, "{written}");
    let checked = recipe.check();
    match &checked {
        Err(e) => check_sentence(&e.sentence()),
        Ok(()) => assert!(recipe.applied(&Job::default()).layers.spacing_mm.is_finite()),
    }
    format!("{} {}", outline(&checked), recipe.values.len().min(5))
}

#[test]
fn jobs() {
    let default = files::to_toml(&Job::default()).expect("writes");
    let own = vec![default.clone().into_bytes(), format!("version = 2\n{LISTS}").into_bytes(), LISTS.into()];
    let own = [own, files_of("tests/jobs"), files_of("assets/samples")].concat();
    run(&Kind { name: "job", own, words: &WORDS, read: &read_job });
}

#[test]
fn recipes() {
    run(&Kind { name: "recipe", own: files_of("assets/recipes"), words: &WORDS, read: &read_recipe });
}
