//! A job with all its files in one: packed, unpacked elsewhere and planned, it is the same job on the same files.

mod common;

use clearbeam::app::Purpose;
use clearbeam::document::files::package::{PackageError, is_package, pack, unpack, unpacked_in};
use clearbeam::document::files::{self, JobError, inputs};
use clearbeam::sample::{solids, stl_bytes};
use common::window::{Answers, settle, window};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use zip::write::SimpleFileOptions;

const HEAD: &str = "[[part]]\nfrom_mm = 120.0\nto_mm = 200.0\nr0_mm = 15.0\nr1_mm = 15.0\n";

/// A job whose files lie all over the place: part, head, a clamp twice, and a cell with an obstacle of its own.
fn scattered(folder: &Path) -> PathBuf {
    let write = |name: &str, bytes: &[u8]| {
        let file = folder.join(name);
        std::fs::create_dir_all(file.parent().expect("a folder")).expect("makes");
        std::fs::write(file, bytes).expect("writes");
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets");
    write("parts/a part.stl", &std::fs::read(root.join("samples/workpiece.stl")).expect("shipped"));
    write("tools/head.toml", HEAD.as_bytes());
    write("clamps/part.stl", &stl_bytes(&solids::cube(5.0)));
    write("cells/bodies/post.stl", &stl_bytes(&solids::cube(20.0)));
    let cell = std::fs::read_to_string(root.join("cells/mz04.toml")).expect("shipped");
    let obstacle = "obstacles = [{ file = \"bodies/post.stl\", position_mm = [-900.0, 0.0, 0.0] }]\n";
    write("cells/own.toml", cell.replace("[bodies]", &format!("[bodies]\n{obstacle}")).as_bytes());
    let clamp = |x: f64| format!("[[clamps]]\nfile = \"../clamps/part.stl\"\nposition_mm = [{x:?}, 300.0, 0.0]\n");
    let job = format!(
        "[part]\nfile = \"../parts/a part.stl\"\n[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 3.0\n\
         [beam]\nhead = \"../tools/head.toml\"\n[cell]\nfile = \"../cells/own.toml\"\n{}{}",
        clamp(0.0),
        clamp(50.0)
    );
    write("jobs/lug.toml", job.as_bytes());
    folder.join("jobs/lug.toml")
}

fn packed(job_file: &Path) -> Vec<u8> {
    pack(&files::read(job_file).expect("a job"), Some(job_file), None).expect("packs")
}

/// A package of a job on scattered files, alone in a folder.
fn alone() -> (tempfile::TempDir, PathBuf) {
    let (from, to) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let package = to.path().join("lug.clearbeam");
    std::fs::write(&package, packed(&scattered(from.path()))).expect("writes");
    (to, package)
}

fn refused(package: &Path, folder: &Path) -> PackageError {
    match unpack(package, folder).expect_err("refused") {
        JobError::Package { file, what } if file == package.display().to_string() => what,
        other => panic!("{other}"),
    }
}

#[test]
fn what_is_unpacked_is_the_job_on_the_same_files() {
    let from = tempfile::tempdir().expect("a folder");
    let job_file = scattered(from.path());
    let bytes = packed(&job_file);
    assert_eq!(bytes, packed(&job_file), "the same files are the same package");
    let before = inputs(&files::read(&job_file).expect("a job"), Some(&job_file));
    let (to, package) = alone();
    assert_eq!(std::fs::read(&package).expect("there"), bytes, "wherever they lie");
    assert!(is_package(&package) && !is_package(&job_file));
    let folder = unpacked_in(to.path(), &package);
    let unpacked = unpack(&package, &folder).expect("unpacks");
    assert_eq!(unpacked, to.path().join("lug_files/lug.toml"));
    let job = files::read(&unpacked).expect("a job");
    let after = inputs(&job, Some(&unpacked));
    assert_eq!((after.len(), &after), (6, &before), "part, cell, head, two clamps, obstacle");
    assert_eq!(job.clamps[0].file, job.clamps[1].file, "a file that is named twice is in it once");
    assert_eq!(unpack(&package, &folder).expect("it is there already"), unpacked);
    std::fs::remove_dir_all(from.path()).expect("the first files are not needed any more");
    files::load_setup(&job, Some(&unpacked)).expect("a set-up");
}

#[test]
fn nothing_is_written_over_what_was_done_since() {
    let (to, package) = alone();
    let folder = unpacked_in(to.path(), &package);
    let unpacked = unpack(&package, &folder).expect("unpacks");
    std::fs::write(&unpacked, "version = 2\n").expect("edited");
    let occupied = PackageError::Occupied { folder: folder.clone(), file: "lug.toml".into() };
    assert_eq!(refused(&package, &folder), occupied);
    assert_eq!(std::fs::read_to_string(&unpacked).expect("there"), "version = 2\n");
    assert_eq!(std::fs::read_dir(to.path()).expect("a folder").count(), 2, "nothing half done stays");
}

#[test]
fn packages_that_cannot_be_are_refused() {
    let (to, package) = alone();
    let folder = to.path().join("new");
    let whole = std::fs::read(&package).expect("there");
    let refused_with = |bytes: &[u8]| {
        std::fs::write(&package, bytes).expect("writes");
        let why = refused(&package, &folder);
        assert!(!folder.exists(), "{why}");
        why
    };
    for length in [4, whole.len() / 2, whole.len() - 1] {
        assert_eq!(refused_with(&whole[..length]), PackageError::Archive);
    }
    let made = |files: &[(&str, &str)]| {
        let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        for (name, text) in files {
            zip.start_file(*name, SimpleFileOptions::default()).expect("begins");
            zip.write_all(text.as_bytes()).expect("writes");
        }
        refused_with(zip.finish().expect("ends").get_ref())
    };
    let about = ("package.toml", "schema = 1\n");
    assert_eq!(made(&[about]), PackageError::NoJob);
    assert_eq!(made(&[("job.toml", "version = 2\n")]), PackageError::NoJob, "a zip of something else");
    let later = ("package.toml", "schema = 2\n");
    assert_eq!(made(&[later, ("job.toml", "")]), PackageError::Later { schema: 2 });
    for name in ["../x.stl", "/x.stl", "files/../../x.stl", "c:/x.stl", "a\\..\\..\\x.stl"] {
        let why = made(&[about, ("job.toml", ""), (name, "x")]);
        assert!(matches!(&why, PackageError::Name { .. } | PackageError::Archive), "{name}: {why}");
    }
}

#[test]
fn what_lies_outside_of_a_cell_s_folder_is_named() {
    let from = tempfile::tempdir().expect("a folder");
    let job_file = scattered(from.path());
    let cell = from.path().join("cells/own.toml");
    let text = std::fs::read_to_string(&cell).expect("there");
    std::fs::write(&cell, text.replace("bodies/post.stl", "../clamps/part.stl")).expect("writes");
    let why = pack(&files::read(&job_file).expect("a job"), Some(&job_file), None).expect_err("refused");
    let JobError::Package { file, what: PackageError::Outside { file: named, .. } } = why else { panic!("{why}") };
    assert!(file.ends_with("own.toml") && named == "../clamps/part.stl", "{file}: {named}");
    std::fs::remove_file(from.path().join("tools/head.toml")).expect("removes");
    assert!(pack(&files::read(&job_file).expect("a job"), Some(&job_file), None).is_err());
}

#[test]
fn a_package_is_planned_as_its_job_is() {
    let from = tempfile::tempdir().expect("a folder");
    let job_file = scattered(from.path());
    let (to, package) = alone();
    let plan = |input: &Path, out: &Path| {
        let run = Command::new(env!("CARGO_BIN_EXE_clearbeam")).arg("plan").arg(input).arg("--out").arg(out).output();
        let run = run.expect("runs");
        assert!(matches!(run.status.code(), Some(0 | 3)), "{run:?}");
    };
    let (one, two) = (to.path().join("one"), to.path().join("two"));
    plan(&job_file, &one);
    plan(&package, &two);
    let bytes = |out: &Path, name: &str| std::fs::read(out.join(name)).expect("written");
    assert_eq!(bytes(&one, "path.csv"), bytes(&two, "path.csv"));
    assert!(two.join("lug_files/files/1/a part.stl").exists(), "all that was unpacked is in the plan's folder");
    assert_eq!(std::fs::read_dir(to.path()).expect("a folder").count(), 3);
    plan(&two.join("job.toml"), &two);
}

#[test]
fn the_window_packs_and_opens_packages() {
    let from = tempfile::tempdir().expect("a folder");
    let job_file = scattered(from.path());
    let package = from.path().join("to hand over.clearbeam");
    let answers = Answers::default();
    answers.0.lock().expect("not poisoned").push((Purpose::SaveJob, package.clone()));
    let mut h = window(Some(job_file.clone()), &answers);
    settle(&mut h);
    h.state_mut().give(clearbeam::app::Command::SaveAs, &[]);
    settle(&mut h);
    assert!(is_package(&package), "it was packed");
    assert_eq!(h.state().document().file(), Some(job_file.as_path()), "the document stays where it is kept");
    let job = h.state().document().job().clone();
    drop(h);
    let mut h = window(Some(package), &Answers::default());
    settle(&mut h);
    let opened = from.path().join("to hand over_files/to hand over.toml");
    assert_eq!(h.state().document().file(), Some(opened.as_path()));
    assert_eq!(h.state().document().job().settings, job.settings);
    assert!(h.state().plan().is_some(), "and is planned");
}
