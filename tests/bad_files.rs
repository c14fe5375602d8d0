//! Files whose numbers cannot be: jobs, cells, robots, heads and recipes are read, or refused with the key and its line.
//! No number of any of them makes the reader panic, and none that is not finite goes through.

use clearbeam::beam::Head;
use clearbeam::cell::{Cell, Robot};
use clearbeam::document::{Job, Library, PARAMETERS, Recipe, files, job_file};
use clearbeam::text::Sentence;
use std::path::{Path, PathBuf};
use toml::Value;

fn asset(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets").join(name);
    std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

/// Ways to all numbers of a value, as JSON pointers.
fn numbers(value: &Value, at: &str, out: &mut Vec<String>) {
    match value {
        Value::Table(table) => table.iter().for_each(|(key, v)| numbers(v, &format!("{at}/{key}"), out)),
        Value::Array(list) => list.iter().enumerate().for_each(|(i, v)| numbers(v, &format!("{at}/{i}"), out)),
        Value::Float(_) | Value::Integer(_) => out.push(at.to_owned()),
        _ => {}
    }
}

/// The value at such a way.
fn at<'v>(value: &'v mut Value, way: &str) -> &'v mut Value {
    way.split('/').skip(1).fold(value, |value, step| match value {
        Value::Table(table) => table.get_mut(step).expect("a key that was found"),
        Value::Array(list) => &mut list[step.parse::<usize>().expect("a place")],
        other => panic!("{other} holds nothing"),
    })
}

/// Puts odd numbers in place of each number of a file. `read` says why it refuses a text.
fn spoilt(name: &str, text: &str, read: &dyn Fn(&str) -> Result<(), String>) {
    assert_eq!(read(text), Ok(()), "{name} is sound");
    let whole: Value = text.parse::<toml::Table>().expect("TOML").into();
    let mut ways = Vec::new();
    numbers(&whole, "", &mut ways);
    assert!(!ways.is_empty(), "{name} has numbers");
    for way in &ways {
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300, -1.0, 0.0] {
            let mut other = whole.clone();
            *at(&mut other, way) = Value::Float(odd);
            let why = read(&toml::to_string(&other).expect("TOML"));
            assert!(odd.is_finite() || why.is_err(), "{name}{way} = {odd} goes through");
            let Err(why) = why else { continue };
            let key = way.rsplit('/').find(|step| step.parse::<usize>().is_err()).expect("a key");
            assert!(why.contains("line ") && why.lines().count() == 1, "{name}{way} = {odd}: {why}");
            assert!(
                odd.is_finite() || why.contains(key.rsplit('.').next().expect("a word")),
                "{name}{way} = {odd}: {why}"
            );
        }
    }
}

/// Reads a text by way of a file.
fn by_file<T, E: Sentence>(name: &str, load: impl Fn(&Path) -> Result<T, E>) -> impl Fn(&str) -> Result<(), String> {
    let folder = tempfile::tempdir().expect("a folder");
    let file: PathBuf = folder.path().join(name);
    move |text| {
        let _kept = &folder;
        std::fs::write(&file, text).expect("writes");
        load(&file).map(drop).map_err(|e| e.sentence())
    }
}

#[test]
fn no_number_of_a_cell_or_a_robot_goes_through_unseen() {
    spoilt("cells/mz04.toml", &asset("cells/mz04.toml"), &by_file("cell.toml", Cell::load));
    let robot = |file: &Path| Robot::load(&file.display().to_string(), None);
    for name in ["robots/mz04.toml", "robots/ur5e.toml"] {
        spoilt(name, &asset(name), &by_file("robot.toml", robot));
    }
}

#[test]
fn no_number_of_a_head_goes_through_unseen() {
    let head = "[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 4\nr1_mm = 20\n[[part]]\nfrom_mm = 60.5\nto_mm = 90.0\n\
                r0_mm = 20.0\nr1_mm = 0.0\n";
    spoilt("head", head, &by_file("head.toml", Head::load));
}

#[test]
fn no_number_of_a_job_goes_through_unseen() {
    let mut job = Job::default();
    let mut recipe = Recipe { name: "Fine".into(), centre_mm: Some([1.0, 2.0, 3.0]), ..Recipe::default() };
    recipe.values.insert("layers.spacing_mm".into(), 0.25);
    job.recipes.push(recipe);
    job.layers.centre_mm = Some([1.0, 2.0, 3.0]);
    let mut text = files::to_toml(&job).expect("writes");
    text.push_str("[[tilts]]\nsurface = 1\nleast_deg = 5.0\npreferred = { lead_deg = 1.0, lean_deg = 2.0 }\n");
    text.push_str("[[pins]]\nsurface = 1\nline = 1\nat_mm = 2.0\ntilt = { lead_deg = 1.0, lean_deg = 2.0 }\n");
    text.push_str("[[starts]]\nsurface = 1\ncentre_mm = [1.0, 2.0, 3.0]\n");
    text.push_str("[[clamps]]\nfile = \"a.stl\"\nposition_mm = [1.0, 2.0, 3.0]\nrz_ry_rx_deg = [1.0, 2.0, 3.0]\n");
    spoilt("job", &text, &|text| job_file::parse(text).map(drop).map_err(|e| e.sentence()));
}

#[test]
fn every_parameter_is_held_to_its_range_with_its_line() {
    for p in PARAMETERS {
        let (table, field) = p.table_and_field();
        let read = |value: f64| {
            let number =
                if p.kind.is_whole() && value.fract() == 0.0 { format!("{value:.0}") } else { format!("{value:?}") };
            let text = format!("version = 2\n\n[{table}]\n{field} = {number}\n");
            job_file::parse(&text).map_err(|e| e.sentence())
        };
        let (least, greatest) = (p.limits.least, p.limits.greatest);
        assert_eq!(read(greatest).map(|job| job.number(p)), Ok(greatest), "{}", p.key);
        assert_eq!(read(least).is_err(), p.limits.is_above_least, "{}", p.key);
        for bad in [least - 1.0, greatest + 1.0, f64::NAN, f64::INFINITY] {
            let why = read(bad).expect_err(p.key);
            assert!(why.contains("line 4") && why.contains(field), "{} = {bad}: {why}", p.key);
        }
    }
}

#[test]
fn a_recipe_file_is_refused_by_line_and_key() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = "name = \"Fine\"\n[values]\n\"layers.spacing_mm\" = nan\n";
    std::fs::write(folder.path().join("fine.toml"), text).expect("writes");
    let library = Library::open(Some(folder.path().to_path_buf()));
    let [broken] = library.broken.as_slice() else { panic!("{} broken", library.broken.len()) };
    let why = broken.why.sentence();
    assert!(why.contains("line 3") && why.contains("spacing_mm") && why.contains("nan"), "{why}");
}
