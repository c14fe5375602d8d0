//! A worn part of which there is nothing but its scan: the file is the part, the sound regions around the wear tell what
//! is missing, lines go through the points, and what was not scanned is kept clear of.

use clearbeam::sample::FixedNumbers;
use clearbeam::scan::{Cloud, ply_file};
use nalgebra::{Point3, Vector3};
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::process::{Command, Output};

fn clearbeam(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn said(of: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&of.stdout), String::from_utf8_lossy(&of.stderr))
}

fn read(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("there")).expect("JSON")
}

const RADIUS_MM: f64 = 12.0;
const LENGTH_MM: f64 = 30.0;
/// Wear of METHODS: h·(1 − (r/R)²)².
const WEAR_MM: f64 = 0.3;
const WORN_MM: f64 = 6.0;
const NOISE_MM: f64 = 0.01;

fn wear(way_mm: f64) -> f64 {
    let share = 1.0 - (way_mm / WORN_MM).min(1.0).powi(2);
    WEAR_MM * share * share
}

/// How deep a shaft about x is worn, `turn` from +z, `x` along it.
fn depth(turn: f64, x: f64) -> f64 {
    let around = RADIUS_MM * (turn - TAU * (turn / TAU).round());
    wear((around * around + (x - 0.5 * LENGTH_MM).powi(2)).sqrt())
}

/// Points on the shaft where `is_seen` says so, some 10 a mm²; without its ends.
fn scan(is_seen: impl Fn(f64) -> bool) -> Cloud {
    let mut numbers = FixedNumbers::new(7);
    let count = (10.0 * TAU * RADIUS_MM * LENGTH_MM) as usize;
    let mut points = Vec::with_capacity(count);
    for _ in 0..count {
        let (turn, x) = (TAU * numbers.share() - PI, LENGTH_MM * numbers.share());
        let out = Vector3::new(0.0, libm::sin(turn), libm::cos(turn));
        let radius = RADIUS_MM - depth(turn, x) + NOISE_MM * numbers.normal_vector().x;
        if is_seen(turn) {
            points.push(Point3::from(out * radius) + Vector3::x() * x);
        }
    }
    Cloud::of_points(&points)
}

fn written(folder: &Path, name: &str, cloud: &Cloud) {
    std::fs::write(folder.join(name), ply_file::bytes(cloud, &[])).expect("written");
}

/// A job that works what is missing of a shaft, through the points of its scan.
fn job(folder: &Path, by: &str) -> String {
    let text = format!(
        "version = 2\n[part]\nfile = \"shaft.ply\"\n[layers]\ndirection = \"x\"\nspacing_mm = 1.0\n\
         [scan]\nmin_depth_mm = 0.06\nlines = \"points\"\nfiles = [{{ file = \"shaft.ply\" }}]\n\
         transform = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n\
         [[scan.continued]]\nby = \"{by}\"\n\
         damaged = [{{ shape = \"sphere\", centre_mm = [15, 0, 12], radius_mm = 6.5 }}]\n\
         sound = [{{ shape = \"box\", min_mm = [1, -13, -13], max_mm = [29, 13, 13] }}]\n"
    );
    let path = folder.join("job.toml");
    std::fs::write(&path, text).expect("written");
    path.display().to_string()
}

#[test]
fn wear_is_told_by_what_is_left_of_the_shaft_and_worked_through_its_points() {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path(), "shaft.ply", &scan(|_| true));
    let (job, out) = (job(folder.path(), "cylinder"), folder.path().join("out"));
    let run = clearbeam(&["plan", &job, "--out", out.to_str().expect("a name")]);
    assert!(matches!(run.status.code(), Some(0 | 3)), "{}", said(&run));
    let report = read(&out.join("report.json"));
    let patches = report["patches"].as_array().expect("patches");
    let [patch] = &patches[..] else { panic!("{patches:?}\n{}", said(&run)) };
    let number = |key: &str| patch[key].as_f64().unwrap_or_else(|| panic!("{key} in {patch}"));
    assert!((number("depth_mm") - WEAR_MM).abs() < 0.02, "{patch}");
    // π·R²·(1 − √(t/h)): over so little of the shaft it is as good as plane.
    let area_mm2 = PI * WORN_MM * WORN_MM * (1.0 - (0.06f64 / WEAR_MM).sqrt());
    assert!((number("area_mm2") / area_mm2 - 1.0).abs() < 0.06, "{patch} for {area_mm2}");
    assert_eq!(report["proven"], true, "{}", said(&run));
    assert!(report["passes"].as_u64().expect("a count") > 5);
    // Targets lie on the worn surface, not on the cylinder.
    let path = std::fs::read_to_string(out.join("path.csv")).expect("there");
    let mut deepest_mm = 0.0f64;
    for row in path.lines().skip(1) {
        let p: Vec<f64> = row.split(',').skip(5).take(3).map(|x| x.parse().expect("mm")).collect();
        let (turn, radius) = (libm::atan2(p[1], p[2]), libm::hypot(p[1], p[2]));
        let off_mm = radius - (RADIUS_MM - depth(turn, p[0]));
        assert!(off_mm.abs() < 0.02, "{off_mm} mm off the worn surface: {row}");
        deepest_mm = deepest_mm.max(RADIUS_MM - radius);
    }
    assert!(deepest_mm > 0.8 * WEAR_MM, "{deepest_mm}");
    let program = report["programs"][0]["names"][0].as_str().expect("a name");
    let (program, job) = (out.join(program), out.join("job.toml"));
    let verified = clearbeam(&["verify", program.to_str().expect("a name"), "--job", job.to_str().expect("a name")]);
    assert_eq!(verified.status.code(), Some(0), "{}", said(&verified));
}

#[test]
fn sound_regions_that_tell_no_such_surface_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    written(folder.path(), "shaft.ply", &scan(|_| true));
    let (job, out) = (job(folder.path(), "plane"), folder.path().join("out"));
    let run = clearbeam(&["plan", &job, "--out", out.to_str().expect("a name")]);
    assert_eq!(run.status.code(), Some(1));
    assert!(said(&run).contains("damage 1") && said(&run).contains("choose another kind"), "{}", said(&run));
    assert!(!out.exists());
}

#[test]
fn what_was_not_scanned_is_no_way_for_the_beam() {
    let folder = tempfile::tempdir().expect("a folder");
    // Seen from above, a third of the way round: beams along the normals leave towards the scanner.
    written(folder.path(), "top.ply", &scan(|turn| turn.abs() < 0.33 * PI));
    let part = folder.path().join("top.ply");
    let out = folder.path().join("out");
    let arguments = ["plan", part.to_str().expect("a name"), "--out", out.to_str().expect("a name")];
    let run = clearbeam(&[&arguments[..], &["--direction", "x", "--spacing", "3", "--correction", "none"]].concat());
    assert!(matches!(run.status.code(), Some(0 | 3)), "{}", said(&run));
    let report = read(&out.join("report.json"));
    let codes: Vec<&str> =
        report["findings"].as_array().expect("a list").iter().filter_map(|f| f["code"].as_str()).collect();
    assert!(codes.contains(&"meshed"), "{codes:?}");
    let points = report["points"].as_u64().expect("a count");
    let blocked = report["blocked"].as_u64().expect("a count");
    assert!(points > 50 && blocked * 20 < points, "{blocked} of {points}: {}", said(&run));
    assert_eq!(report["proven"], true, "{}", said(&run));
    // From the side, through what nobody has seen, none gets there.
    let inspected = clearbeam(&["inspect", part.to_str().expect("a name"), "--json"]);
    let found: Value = serde_json::from_slice(&inspected.stdout).expect("JSON");
    assert_eq!(found["watertight"], false, "{found}");
    assert!(found["boundary_edges"].as_u64().expect("a count") > 50);
}
