//! Files of parts through the command line: the same part in every form, the unit of a 3MF file, what is told of files
//! that are not clean, and what is said of files that are no parts.

use clearbeam::beam::{Head, Obstacle};
use clearbeam::cell::Setup;
use clearbeam::part::{LoadError, Units};
use clearbeam::program::{Comment, FileNote, Program, dialects};
use clearbeam::sample::{Triangles, solids, stl_bytes};
use clearbeam::text::program_comment;
use serde_json::Value;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {output:?}"))
}

struct Bench(tempfile::TempDir);

impl Bench {
    fn new() -> Bench {
        Bench(tempfile::tempdir().expect("a folder"))
    }

    fn file(&self, name: &str, bytes: impl AsRef<[u8]>) -> String {
        let file = self.path(name);
        std::fs::write(&file, bytes).expect("writes");
        file.display().to_string()
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Plans a part coarsely; the report and all that was written as text.
    fn plan(&self, file: &str, options: &[&str]) -> (Output, Value, String) {
        let out = self.path("out");
        let _ = std::fs::remove_dir_all(&out);
        let given = ["plan", file, "--spacing", "4", "--direction", "auto", "--json", "--out"];
        let folder = out.display().to_string();
        let output = run(&[&given[..], &[&folder], options].concat());
        assert!(output.status.success(), "{output:?}");
        let report: Value =
            serde_json::from_slice(&std::fs::read(out.join("report.json")).expect("a report")).expect("JSON");
        (output, report, programs(&out))
    }
}

/// The files of an export that are no tables, one behind the other.
fn programs(folder: &Path) -> String {
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("a folder").map(|f| f.expect("a file").path()).collect();
    files.sort();
    let is_other = |f: &PathBuf| {
        let name = f.file_name().unwrap_or_default().to_string_lossy().into_owned();
        ["report.json", "job.toml", "path.csv", "dose.ply", "joints.csv"].contains(&name.as_str())
    };
    files
        .iter()
        .filter(|f| !is_other(f))
        .map(|f| String::from_utf8_lossy(&std::fs::read(f).expect("reads")).into_owned())
        .collect()
}

/// Codes of what was found in the file: what nobody has checked of cell and controller is no matter of it.
fn codes(report: &Value) -> Vec<&str> {
    let codes = report["findings"].as_array().into_iter().flatten().filter_map(|f| f["code"].as_str());
    codes.filter(|code| !code.starts_with("unverified")).collect()
}

fn corners(triangles: &Triangles) -> Vec<[f64; 3]> {
    triangles.iter().flatten().copied().collect()
}

fn obj(triangles: &Triangles) -> String {
    let vertices = corners(triangles).iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect::<String>();
    vertices
        + &(0..triangles.len()).map(|t| format!("f {} {} {}\n", 3 * t + 1, 3 * t + 2, 3 * t + 3)).collect::<String>()
}

fn ply(triangles: &Triangles) -> String {
    let n = triangles.len();
    let vertices = corners(triangles).iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect::<String>();
    let faces = (0..n).map(|t| format!("3 {} {} {}\n", 3 * t, 3 * t + 1, 3 * t + 2)).collect::<String>();
    format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {n}\nproperty list uchar int vertex_indices\nend_header\n{vertices}{faces}",
        3 * n
    )
}

fn threemf(triangles: &Triangles, unit: &str) -> Vec<u8> {
    let vertices = corners(triangles)
        .iter()
        .map(|[x, y, z]| format!("<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>"))
        .collect::<String>();
    let faces = (0..triangles.len())
        .map(|t| format!("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", 3 * t, 3 * t + 1, 3 * t + 2))
        .collect::<String>();
    let model = format!(
        "<model unit=\"{unit}\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>\
         <object id=\"1\"><mesh><vertices>{vertices}</vertices><triangles>{faces}</triangles></mesh></object>\
         </resources><build><item objectid=\"1\"/></build></model>"
    );
    let rels = "<Relationships><Relationship Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" \
                Target=\"/3D/3dmodel.model\"/></Relationships>";
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in [("_rels/.rels", rels), ("3D/3dmodel.model", &model)] {
        zip.start_file(name, zip::write::SimpleFileOptions::default()).expect("begins");
        zip.write_all(text.as_bytes()).expect("writes");
    }
    zip.finish().expect("ends").into_inner()
}

#[test]
fn a_part_is_the_same_in_every_form_whatever_its_name() {
    let bench = Bench::new();
    let part = solids::v_groove(20.0, 2.0, 2.0, 3.0);
    let stl = json(&run(&["inspect", &bench.file("part.stl", stl_bytes(&part)), "--json"]));
    for (name, bytes) in [
        ("part.obj", obj(&part).into_bytes()),
        ("part.ply", ply(&part).into_bytes()),
        ("part.3mf", threemf(&part, "millimeter")),
        ("obj.stl", obj(&part).into_bytes()),
        ("3mf.stl", threemf(&part, "millimeter")),
        ("stl.ply", stl_bytes(&part)),
    ] {
        let output = run(&["inspect", &bench.file(name, bytes), "--json"]);
        assert_eq!((output.status.code(), json(&output)), (Some(0), stl.clone()), "{name}");
    }
}

#[test]
fn the_unit_of_a_3mf_file_is_taken_and_overridden() {
    let bench = Bench::new();
    let size =
        |v: &Value| v["bounds_mm"]["max"][0].as_f64().expect("x") - v["bounds_mm"]["min"][0].as_f64().expect("x");
    for (unit, mm, word, told) in [
        ("inch", 25.4, "inch", &["unit_taken"][..]),
        ("centimeter", 10.0, "mm", &["unit_taken"]),
        ("millimeter", 1.0, "mm", &[]),
    ] {
        let file = bench.file("part.3mf", threemf(&solids::cube(12.0 / mm), unit));
        let inspected = json(&run(&["inspect", &file, "--json"]));
        assert!((size(&inspected) - 12.0).abs() < 1e-5, "{unit}");
        assert_eq!(codes(&inspected), told, "{unit}");
        let (_, report, _) = bench.plan(&file, &["--surfaces", "1"]);
        assert_eq!(codes(&report), told, "{unit}");
        let job = std::fs::read_to_string(bench.path("out/job.toml")).expect("a job");
        assert!(job.contains(&format!("units = \"{word}\"")), "{job}");
        // The job knows it: planned again it is the same.
        let again = bench.path("again").display().to_string();
        let output = run(&["plan", &bench.path("out/job.toml").display().to_string(), "--out", &again, "--json"]);
        assert_eq!(json(&output)["work_mm"], report["work_mm"]);
    }
    let file = bench.file("part.3mf", threemf(&solids::cube(10.0), "inch"));
    let (output, report, program) = bench.plan(&file, &["--surfaces", "1", "--units", "mm"]);
    assert_eq!((output.status.code(), codes(&report)), (Some(0), vec!["unit_overridden"]));
    assert!(program.contains("the part file states inch, it was read in mm"), "{program}");
}

#[test]
fn clamps_and_heads_come_in_the_same_forms_and_in_no_other_unit_than_their_own() {
    let bench = Bench::new();
    let file = bench.file("clamp.3mf", threemf(&solids::cube(1.0), "inch"));
    let height = |clamp: &Obstacle| clamp.solid().mesh.bounds().1.z - clamp.solid().mesh.bounds().0.z;
    let mut clamp = Obstacle::of_file("clamp.3mf".into(), Path::new(&file));
    clamp.load(Some(bench.0.path())).expect("loads");
    assert!((clamp.units, height(&clamp)) == (Units::Inch, 25.4), "{clamp:?}");
    // A job that says nothing of the unit means millimetres, which this file does not.
    let refused = Obstacle::named("clamp.3mf".into()).load(Some(bench.0.path()));
    assert!(matches!(refused, Err(LoadError::OtherUnit { units: Units::Mm, .. })), "{refused:?}");
    let head = bench.file("head.obj", obj(&solids::cube(10.0)));
    assert!(Head::load(Path::new(&head)).is_ok_and(|h| h.solid().is_some_and(|s| s.mesh.facets.len() == 12)));
}

/// A cube with five bytes behind it, one whose header counts half of it, and two behind each other.
fn not_clean() -> [(&'static str, Vec<u8>, &'static str); 3] {
    let cube = stl_bytes(&solids::cube(10.0));
    let mut half = cube.clone();
    half[80] = 6;
    [
        ("bytes_passed_over", [&cube[..], b"12345"].concat(), "5 from byte 684"),
        ("count_differs", half, "6 facets, 12 were read"),
        (
            "solids_joined",
            [&cube[..], &stl_bytes(&vec![[[30.0, 0.0, 0.0], [40.0, 0.0, 0.0], [30.0, 9.0, 0.0]]])].concat(),
            "one part: 2",
        ),
    ]
}

#[test]
fn what_was_found_in_the_file_is_in_report_and_head_and_does_not_change_the_status() {
    let bench = Bench::new();
    for (code, bytes, said) in not_clean() {
        let file = bench.file("part.stl", bytes);
        let inspected = run(&["inspect", &file, "--json"]);
        assert_eq!(inspected.status.code(), Some(0));
        assert!(codes(&json(&inspected)).contains(&code), "{inspected:?}");
        let text = run(&["inspect", &file]);
        assert!(String::from_utf8_lossy(&text.stdout).contains("\n! "), "{text:?}");
        let (output, report, program) = bench.plan(&file, &["--surfaces", "1"]);
        assert_eq!(output.status.code(), Some(0), "{code}");
        assert!(codes(&report).contains(&code), "{report}");
        assert!(program.contains(said), "{said}: {program}");
    }
    let clean = bench.file("clean.stl", stl_bytes(&solids::cube(10.0)));
    let (_, report, program) = bench.plan(&clean, &["--surfaces", "1"]);
    assert!(codes(&report).is_empty() && !program.contains("part file"), "{program}");
}

fn finding<'a>(report: &'a Value, code: &str) -> &'a Value {
    let mut all = report["findings"].as_array().into_iter().flatten();
    all.find(|f| f["code"] == code).unwrap_or(&Value::Null)
}

#[test]
fn a_part_far_from_the_origin_is_told_with_its_steps_before_it_is_planned() {
    let bench = Bench::new();
    let far = |[x, y, z]: [f64; 3]| [x + 512_345.0, y + 5_412_345.0, z + 120.0];
    let plant: Triangles = solids::cube(40.0).into_iter().map(|t| t.map(far)).collect();
    let file = bench.file("plant.stl", stl_bytes(&plant));
    let inspected = run(&["inspect", &file]);
    let text = String::from_utf8_lossy(&inspected.stdout).into_owned();
    assert_eq!(inspected.status.code(), Some(0));
    let told = "! the part lies 5436.563 m from the origin, where the file's coordinates have steps of 0.5 mm";
    assert!(text.contains(told), "{text}");
    let report = json(&run(&["inspect", &file, "--json"]));
    assert_eq!(
        (codes(&report), finding(&report, "far_from_origin")["resolution_mm"].as_f64()),
        (vec!["far_from_origin"], Some(0.5))
    );
    // Without a robot nothing of an arm can be singular, wherever the part lies.
    let out = bench.path("far").display().to_string();
    let output = run(&["plan", &file, "--surfaces", "1", "--spacing", "10", "--json", "--out", &out]);
    assert!(matches!(output.status.code(), Some(0 | 3)), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("steps of 0.5 mm"), "{output:?}");
    let report = json(&output);
    assert_eq!(finding(&report, "far_from_origin")["resolution_mm"].as_f64(), Some(0.5));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("singular"), "{report}");
}

#[test]
fn a_size_that_no_unit_makes_plausible_is_told_as_such() {
    let bench = Bench::new();
    for (edge, size) in [(40_000.0, "40000.000"), (4e21, "4.0e21"), (1e-9, "1.0e-9")] {
        let file = bench.file("part.stl", stl_bytes(&solids::cube(edge)));
        let inspected = run(&["inspect", &file]);
        let text = String::from_utf8_lossy(&inspected.stdout).into_owned();
        assert_eq!(inspected.status.code(), Some(0));
        let told = format!("! a size of {size} × {size} × {size} mm is implausible, and no unit makes it plausible");
        assert!(text.contains(&told), "{text}");
        let report = json(&run(&["inspect", &file, "--json"]));
        let found = finding(&report, "implausible_size");
        assert!(found.is_object() && found["better_units"].is_null(), "{report}");
    }
    let file = bench.file("part.stl", stl_bytes(&solids::cube(2.0)));
    let text = String::from_utf8_lossy(&run(&["inspect", &file]).stdout).into_owned();
    assert!(text.contains("in inch it would be 50.8 × 50.8 × 50.8 mm; use --units inch"), "{text}");
}

#[test]
fn a_part_that_shatters_is_told_with_the_area_that_brings_it_to_order() {
    let bench = Bench::new();
    // Fields of 0.6 mm²; two together have more than 1 mm².
    let file = bench.file("sheet.stl", stl_bytes(&solids::folded_sheet(150, 0.03)));
    let inspected = run(&["inspect", &file]);
    let text = String::from_utf8_lossy(&inspected.stdout).into_owned();
    assert!(text.contains("! 150 of 152 surfaces are smaller than the spot (0.79 mm²)"), "{text}");
    assert!(text.contains("write min_area_mm2 = 1 under [surfaces]"), "{text}");
    let report = json(&run(&["inspect", &file, "--json"]));
    let found = finding(&report, "shattered");
    assert_eq!((&found["surfaces"], &found["smaller"]), (&152.into(), &150.into()));
    let then = found["surfaces_then"].as_u64().expect("a count");
    // The job that does so has as many, and the finding is gone.
    let job = "[part]\nfile = \"sheet.stl\"\n[surfaces]\nmin_area_mm2 = 1.0\n[clean]\nsurfaces = [1]\n";
    let job = bench.file("job.toml", job);
    let (_, report, _) = bench.plan(&file, &["--surfaces", "1"]);
    assert!(codes(&report).contains(&"shattered"), "{report}");
    let output = run(&["plan", &job, "--json", "--out", &bench.path("again").display().to_string()]);
    let report = json(&output);
    assert!(!codes(&report).contains(&"shattered"), "{report}");
    assert!(!String::from_utf8_lossy(&output.stderr).contains("smaller than the spot"), "{output:?}");
    assert!(then < 100, "{then}");
}

#[test]
fn every_dialect_says_it_at_the_head() {
    let setup = Setup::shipped().expect("shipped");
    let head = vec![Comment::PartFile(FileNote::BytesPassedOver { count: 5, at: 684 })];
    let program = Program { head, lines: Vec::new(), setup: &setup, wording: program_comment };
    for name in dialects::names() {
        let files = dialects::known(name).expect("known").write(&program).expect("writes");
        // Short lines break between words, so only those are looked for.
        let mut words = files.iter().flat_map(|f| f.text.split(|c: char| !c.is_ascii_alphanumeric()));
        let has = |word: &&str| words.any(|w| w == *word);
        assert!(["CAUTION", "passed", "over", "5", "684"].iter().all(has), "{name}");
    }
}

const SCAN: &[u8] = b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
    end_header\n1 2 3\n";

const COMMA: &[u8] = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0,5 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
    endfacet\nendsolid a\n";

#[test]
fn files_that_are_no_parts_are_named_in_one_line() {
    let bench = Bench::new();
    let cube = stl_bytes(&solids::cube(10.0));
    let cases: [(&str, Vec<u8>, &str); 8] = [
        ("lfs.stl", b"version https://git-lfs.github.com/spec/v1\noid sha256:12\nsize 9\n".to_vec(), "git lfs pull"),
        ("page.stl", b"<!DOCTYPE html><html><head>".to_vec(), "a web page"),
        ("part.stp.stl", b"ISO-10303-21;\nHEADER;".to_vec(), "a STEP file"),
        ("cut.stl", cube[..400].to_vec(), "cut off"),
        ("cut.3mf", threemf(&solids::cube(1.0), "inch")[..300].to_vec(), "cut off"),
        ("scan.ply", SCAN.to_vec(), "1 points tell no surface"),
        ("comma.stl", COMMA.to_vec(), "decimal comma (byte 45)"),
        ("bad.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n".to_vec(), "line 4"),
    ];
    for (name, bytes, said) in cases {
        let file = bench.file(name, bytes);
        for arguments in [&["inspect", &file][..], &["plan", &file, "--out", "nowhere"]] {
            let output = run(arguments);
            let line = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(1), "{name}: {line}");
            assert!(line.lines().count() == 1 && line.contains(name) && line.contains(said), "{name}: {line}");
        }
    }
    let folder = bench.path("").display().to_string();
    for arguments in [&["inspect", &folder][..], &["plan", &folder, "--out", "nowhere"]] {
        let line = String::from_utf8_lossy(&run(arguments).stderr).into_owned();
        assert!(line.contains("is a folder"), "{line}");
    }
}
