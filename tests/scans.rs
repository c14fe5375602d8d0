//! Scans by command: the sample camshaft as it came from the bench is laid on its model, its wear is found, and a
//! program is made for the worn place alone.

use clearbeam::sample::{FixedNumbers, solids, stl_bytes};
use clearbeam::scan::{Cloud, ply_file};
use nalgebra::{Matrix4, Point3};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn clearbeam(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn sample(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples").join(name);
    path.display().to_string()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&output.stderr)))
}

fn read(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("there")).expect("JSON")
}

fn matrix(value: &Value) -> Matrix4<f64> {
    let rows: Vec<f64> = value.as_array().expect("rows").iter().map(|x| x.as_f64().expect("a number")).collect();
    Matrix4::from_row_slice(&rows)
}

/// How far two positions of the scan are apart at the corner of the shaft's box where that is most, mm.
fn apart_mm(one: &Value, other: &Value) -> f64 {
    let part = clearbeam(&["inspect", &sample("camshaft.stl"), "--json"]);
    let bounds = &json(&part)["bounds_mm"];
    let end = |k: usize, side: &str| bounds[side][k].as_f64().expect("a number");
    let difference = matrix(one) * matrix(other).try_inverse().expect("a motion");
    let corner = |i: usize| Point3::from([0, 1, 2].map(|k| end(k, if i >> k & 1 == 0 { "min" } else { "max" })));
    (0..8).map(|i| (difference.transform_point(&corner(i)) - corner(i)).norm()).fold(0.0, f64::max)
}

#[test]
fn the_camshafts_scan_is_laid_where_it_was_taken() {
    let run = clearbeam(&["register", &sample("camshaft_scan.ply"), "--part", &sample("camshaft.stl"), "--json"]);
    let found = json(&run);
    assert_eq!(run.status.code(), Some(0), "{found}");
    let truth = read(Path::new(&sample("camshaft_truth.json")));
    let off_mm = apart_mm(&found["model_from_scan"], &truth["model_from_scan"]);
    assert!(off_mm < 0.03, "{off_mm} mm off");
    // A shaft is weakly held, and that is said with its axis.
    let weak: Vec<&Value> = found["sliding"].as_array().expect("a list").iter().collect();
    assert!(weak.iter().any(|s| s["kind"] == "weakly_held" && s["axis"]["direction"][0].as_f64().is_some()), "{found}");
    assert!(found["overlap"].as_f64().expect("a share") > 0.9);
    // Where points are far apart what the shaft bends between them counts as noise.
    let noise_mm = found["noise_mm"].as_f64().expect("mm");
    assert!((0.027..0.05).contains(&noise_mm), "{noise_mm}");
    // The fit is not fooled by that: its own σ is the noise.
    assert!((found["sigma_mm"].as_f64().expect("mm") - 0.03).abs() < 0.003, "{}", found["sigma_mm"]);
}

#[test]
fn another_parts_scan_is_refused() {
    let run = clearbeam(&["register", &sample("camshaft_scan.ply"), "--part", &sample("connecting_rod.stl")]);
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(said.contains("not a scan of the part") || said.contains("another unit"), "{said}");
}

#[test]
fn wear_is_told_as_it_was_made() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("off.ply");
    let given = sample("camshaft_truth.json");
    let arguments = ["deviation", &sample("camshaft_scan.ply"), "--part", &sample("camshaft.stl"), "--json", "--out"];
    let run = clearbeam(&[&arguments[..], &[out.to_str().expect("a name"), "--transform", &given]].concat());
    assert_eq!(run.status.code(), Some(0), "{}", String::from_utf8_lossy(&run.stderr));
    let (found, truth) = (json(&run), read(Path::new(&given)));
    let number = |v: &Value, key: &str| v[key].as_f64().unwrap_or_else(|| panic!("{key} in {v}"));
    assert_eq!(found["threshold_mm"], truth["threshold_mm"]);
    assert!((number(&found, "deepest_mm") - number(&truth, "deepest_mm")).abs() < 0.01, "{found}");
    let patches = found["patches"].as_array().expect("a list");
    let missing: Vec<&Value> = patches.iter().filter(|p| p["kind"] == "missing").collect();
    assert_eq!(missing.len(), 1, "{found}");
    for (key, of_truth) in [("area_mm2", "worn_area_mm2"), ("volume_mm3", "worn_volume_mm3")] {
        let ratio = number(missing[0], key) / number(&truth, of_truth);
        assert!((ratio - 1.0).abs() < 0.03, "{key}: {ratio}");
    }
    // Every point is there, in the part frame, with what it is off.
    let head = String::from_utf8_lossy(&std::fs::read(&out).expect("written")[..400]).into_owned();
    assert!(head.contains("property float deviation_mm"), "{head}");
}

#[test]
fn the_worn_place_alone_is_planned_and_its_program_is_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a name");
    let scan = sample("camshaft_scan.ply");
    let run = clearbeam(&["plan", &sample("camshaft.toml"), "--scan", &scan, "--min-depth", "0.05", "--out", out]);
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    assert!(matches!(run.status.code(), Some(0 | 3)), "{said}");
    let report = read(&folder.path().join("report.json"));
    assert!(report["passes"].as_u64().expect("a count") > 3, "{said}");
    assert_eq!(report["proven"], true, "{said}");
    assert_eq!(report["patches"].as_array().map(Vec::len), Some(1), "{said}");
    // Without a place of the scanner in the base nothing of the scan goes to the cell, and that is said.
    assert_eq!(report["scan"]["is_placed"], false);
    assert!(said.contains("where the scanner stands"), "{said}");
    // All targets lie within the worn disc of 7 mm about its middle; the way over the flank is longer than straight.
    let centre: Vec<f64> =
        report["patches"][0]["centre"].as_array().expect("three").iter().map(|x| x.as_f64().expect("mm")).collect();
    let path = std::fs::read_to_string(folder.path().join("path.csv")).expect("there");
    for row in path.lines().skip(1) {
        let p: Vec<f64> = row.split(',').skip(5).take(3).map(|x| x.parse().expect("mm")).collect();
        let off = (0..3).map(|k| (p[k] - centre[k]).powi(2)).sum::<f64>().sqrt();
        assert!(off < 7.0, "{row}");
    }
    let program = report["programs"][0]["names"][0].as_str().expect("a name");
    let (program, job) = (folder.path().join(program), folder.path().join("job.toml"));
    let verified = clearbeam(&["verify", program.to_str().expect("a name"), "--job", job.to_str().expect("a name")]);
    assert_eq!(verified.status.code(), Some(0), "{}", String::from_utf8_lossy(&verified.stdout));
}

/// The sample's job in a folder of its own, with other lines in place of some of its.
fn job_with(folder: &Path, changed: &[(&str, String)]) -> String {
    let mut text = std::fs::read_to_string(sample("camshaft.toml")).expect("there");
    text = text.replace("camshaft.stl", &sample("camshaft.stl"));
    for (line, other) in changed {
        assert!(text.contains(&format!("{line}\n")), "{line}");
        text = text.replace(&format!("{line}\n"), &format!("{other}\n"));
    }
    let path = folder.join("job.toml");
    std::fs::write(&path, text).expect("written");
    path.display().to_string()
}

#[test]
fn a_row_of_scans_goes_on_past_the_part_that_is_another_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let truth = read(Path::new(&sample("camshaft_truth.json")));
    let rows = &truth["model_from_scan"];
    // As worn as that it is refused, as another part would be.
    let job = job_with(folder.path(), &[("gate_mm = 5.0", format!("gate_mm = 0.1\ntransform = {rows}"))]);
    let (scan, other) = (sample("camshaft_scan.ply"), folder.path().join("none.ply"));
    let out = folder.path().join("out");
    let [out_word, other_word] = [&out, &other].map(|p| p.to_str().expect("a name"));
    let run = clearbeam(&["plan", &job, "--scan", other_word, "--scan", &scan, "--out", out_word, "--jobs", "2"]);
    assert_eq!(run.status.code(), Some(1));
    let lines: Vec<Value> = String::from_utf8_lossy(&run.stdout)
        .lines()
        .map(|line| serde_json::from_str(line).expect("a line of JSON"))
        .collect();
    let [gone, worn] = &lines[..] else { panic!("{lines:?}") };
    assert_eq!((&gone["status"], gone["scan"].as_str()), (&Value::from(1), Some(other_word)));
    // Another file has another frame: it is laid anew, and then stopped at the gate.
    let said = worn["error"].as_str().expect("why");
    assert!(worn["status"] == 1 && said.contains("0.1 mm that the job allows"), "{said}");
    assert!(!out.join("camshaft_scan").exists());
}

#[test]
fn the_jobs_own_surfaces_are_worked_where_the_scan_found_the_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let work = "work = \"surfaces\"".into();
    let job = job_with(folder.path(), &[("work = \"patches\"", work), ("surfaces = [52]", "surfaces = [3]".into())]);
    let (scan, out) = (sample("camshaft_scan.ply"), folder.path().join("out"));
    let run = clearbeam(&["plan", &job, "--scan", &scan, "--spacing", "4", "--out", out.to_str().expect("a name")]);
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    assert!(matches!(run.status.code(), Some(0 | 3)), "{said}");
    let report = read(&out.join("report.json"));
    assert_eq!(report["surfaces"][0]["surface"], 3, "{said}");
    assert_eq!(report["proven"], true, "{said}");
    // A shaft is weakly held about its axis: everything keeps clear by so much more, and that is said.
    assert!(
        report["scan"]["slack_mm"].as_f64().expect("mm") > 0.1 && said.contains("more than their margin"),
        "{said}"
    );
}

#[test]
fn beads_fill_the_worn_place_in_layers() {
    let folder = tempfile::tempdir().expect("a folder");
    let truth = read(Path::new(&sample("camshaft_truth.json")));
    let scan = sample("camshaft_scan.ply");
    let placed =
        format!("files = [{{ file = \"{scan}\" }}]\ntransform = {}\ntolerance_mm = 0.1", truth["model_from_scan"]);
    let job =
        job_with(folder.path(), &[("tolerance_mm = 0.1", placed), ("height_mm = 0.3", "height_mm = 0.08".into())]);
    let out = folder.path().join("out");
    let run = clearbeam(&["plan", &job, "--out", out.to_str().expect("a name")]);
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    assert!(matches!(run.status.code(), Some(0 | 3)), "{said}");
    let report = read(&out.join("report.json"));
    let layers = report["patches"][0]["layers"].as_array().expect("layers");
    assert_eq!(layers.len(), 3, "0.2 mm take three beads of 0.08 mm: {said}");
    let areas: Vec<f64> = layers.iter().map(|l| l["area_mm2"].as_f64().expect("mm²")).collect();
    assert!(areas[0] > areas[1] && areas[1] > areas[2] && areas[2] > 0.0, "{areas:?}");
    assert!(said.contains("3 layers fill it"), "{said}");
    assert_eq!(report["proven"], true, "{said}");
}

/// A cube's upper face with a bump 2 mm high on it, as a scanner sees it: some 9 points a mm².
fn bumpy_face() -> Vec<u8> {
    let mut numbers = FixedNumbers::new(3);
    let height = |x: f64, y: f64| {
        let share = 1.0 - (((x - 15.0).powi(2) + (y - 15.0).powi(2)) / 100.0).min(1.0);
        2.0 * share * share
    };
    let points: Vec<Point3<f64>> = (0..8100)
        .map(|_| {
            let (x, y) = (30.0 * numbers.share(), 30.0 * numbers.share());
            Point3::new(x, y, 30.0 + height(x, y) + 0.01 * numbers.normal_vector().x)
        })
        .collect();
    ply_file::bytes(&Cloud::of_points(&points), &[])
}

#[test]
fn what_is_built_up_stands_out_of_the_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("cube.stl"), stl_bytes(&solids::cube(30.0))).expect("written");
    std::fs::write(at("face.ply"), bumpy_face()).expect("written");
    let job = |gate_mm: f64| {
        let text = format!(
            "version = 2\n[part]\nfile = \"cube.stl\"\n[layers]\ndirection = \"x\"\nspacing_mm = 2.0\n\
             [scan]\nwork = \"surfaces\"\ngate_mm = {gate_mm}\nfiles = [{{ file = \"face.ply\" }}]\n\
             transform = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n[clean]\nsurfaces = \"all\"\n"
        );
        std::fs::write(at("job.toml"), text).expect("written");
        let (job, out) = (at("job.toml"), at("out"));
        clearbeam(&["plan", job.to_str().expect("a name"), "--out", out.to_str().expect("a name")])
    };
    let said =
        |run: &Output| format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    let stopped = job(1.5);
    assert_eq!(stopped.status.code(), Some(1));
    assert!(said(&stopped).contains("too much at"), "{}", said(&stopped));
    let run = job(5.0);
    assert!(matches!(run.status.code(), Some(0 | 3)), "{}", said(&run));
    assert!(said(&run).contains("highest 1.9") || said(&run).contains("highest 2.0"), "{}", said(&run));
    let report = read(&at("out").join("report.json"));
    assert_eq!(report["proven"], true, "{}", said(&run));
    // Spots on the face go up the bump, and no line of another face is any the worse for it.
    let path = std::fs::read_to_string(at("out").join("path.csv")).expect("there");
    let heights = path.lines().skip(1).filter_map(|row| row.split(',').nth(7)?.parse::<f64>().ok());
    let highest = heights.fold(0.0, f64::max);
    assert!((31.8..32.1).contains(&highest), "{highest}");
}
