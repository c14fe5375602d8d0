//! The command line is a contract: files, columns, keys, exit statuses, and messages of one line.

use clearbeam::sample::{SAMPLES, solids, stl_bytes};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn code(arguments: &[&str]) -> i32 {
    run(arguments).status.code().expect("no signal")
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {output:?}"))
}

/// A folder with a cube of 10 mm in it.
fn cube() -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("folder");
    let file = folder.path().join("cube.stl");
    std::fs::write(&file, stl_bytes(&solids::cube(10.0))).expect("writes");
    (folder, file.display().to_string())
}

fn inside(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

/// Number of the cube's side that looks along +x.
fn upright_side(file: &str) -> String {
    let out = tempfile::tempdir().expect("folder");
    run(&["plan", file, "--out", &inside(out.path(), "o"), "--spacing", "5"]);
    let path = std::fs::read_to_string(out.path().join("o/path.csv")).expect("path");
    let row = path.lines().skip(1).map(|l| l.split(',').collect::<Vec<_>>()).find(|c| c[8] == "1").expect("a side");
    row[2].to_owned()
}

#[test]
fn inspect_states_every_key() {
    let (_folder, file) = cube();
    let output = run(&["inspect", &file, "--json"]);
    assert_eq!(output.status.code(), Some(0));
    let v = json(&output);
    let keys: Vec<&str> = v.as_object().expect("object").keys().map(String::as_str).collect();
    let expected = "facets vertices edges boundary_edges non_manifold_edges joined_corners shells watertight degenerate_facets \
                    duplicate_facets flipped_facets invalid_facets area_mm2 volume_mm3 bounds_mm angle_deg surfaces";
    assert_eq!(keys, expected.split_whitespace().collect::<Vec<_>>());
    assert_eq!((v["facets"].as_u64(), v["edges"].as_u64(), v["vertices"].as_u64()), (Some(12), Some(18), Some(8)));
    assert_eq!((v["area_mm2"].as_f64(), v["volume_mm3"].as_f64()), (Some(600.0), Some(1000.0)));
    assert_eq!(v["surfaces"].as_array().map(Vec::len), Some(6));
    let first: Vec<&String> = v["surfaces"][0].as_object().expect("row").keys().collect();
    assert_eq!(first, ["surface", "facets", "area_mm2", "shape"]);
    let inch = json(&run(&["inspect", &file, "--units", "inch", "--json"]));
    let side =
        inch["bounds_mm"]["max"][0].as_f64().expect("number") - inch["bounds_mm"]["min"][0].as_f64().expect("number");
    assert!((side - 254.0).abs() < 1e-9);
}

/// A cube of which one facet lies a rounding off its neighbours, in a folder.
fn cracked_cube() -> (tempfile::TempDir, String) {
    let mut cube = solids::cube(10.0);
    cube[0] = cube[0].map(|p| p.map(|x| f64::from((x as f32).next_up())));
    let (folder, file) = self::cube();
    std::fs::write(&file, stl_bytes(&cube)).expect("writes");
    (folder, file)
}

#[test]
fn corners_a_rounding_apart_are_joined_and_said_unless_exact() {
    let (folder, file) = cracked_cube();
    let figures = |weld: &[&str]| {
        let output = run(&[&["inspect", &file, "--json"], weld].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let v = json(&output);
        let count = |key: &str| v[key].as_u64().expect("a count");
        let said = String::from_utf8_lossy(&output.stderr).contains("corners were joined to others");
        (count("vertices"), count("boundary_edges"), count("joined_corners"), v["watertight"] == true, said)
    };
    assert_eq!(figures(&[]), (8, 0, 3, true, true));
    assert_eq!(figures(&["--weld", "auto"]), figures(&[]));
    assert_eq!(figures(&["--weld", "exact"]), (11, 6, 0, false, false));
    assert_eq!(code(&["inspect", &file, "--weld", "close"]), 2);

    // A job that says nothing of it is welded as it was, and says so from then on.
    let old = inside(folder.path(), "old.toml");
    let text = "[part]\nfile = \"cube.stl\"\n[clean]\nsurfaces = [7]\n[layers]\nspacing_mm = 5.0\ndirection = \"1,0.3,-0.2\"\n";
    std::fs::write(&old, text).expect("writes");
    let job_of = |options: &[&str], out: &str| {
        let out = inside(folder.path(), out);
        let output = run(&[&["plan", &old, "--out", &out], options].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        std::fs::read_to_string(PathBuf::from(out).join("job.toml")).expect("a job")
    };
    let kept = job_of(&[], "kept");
    assert!(kept.contains("weld = \"exact\"") && kept.contains("surfaces = [7]"), "{kept}");
    let carried = job_of(&["--weld", "auto"], "carried");
    assert!(carried.contains("weld = \"auto\"") && carried.contains("surfaces = [6]"), "{carried}");
}

#[test]
fn plan_writes_its_files_and_the_job_plans_the_same_again() {
    let (folder, file) = cube();
    let side = upright_side(&file);
    let out = inside(folder.path(), "deep/er");
    let output = run(&["plan", &file, "--surfaces", &side, "--spacing", "2", "--out", &out, "--dose", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = json(&output);
    let keys: Vec<&str> = report.as_object().expect("object").keys().map(String::as_str).collect();
    let expected = "layers passes points line_points dense_points work_mm corrected_mm blocked_mm air_mm time_s \
                    order interfering corrected blocked \
                    max_tilt_deg max_tilt_rate_deg_per_mm max_chord_error_mm max_surface_spacing_mm \
                    missed_area_mm2 surfaces problems findings \
                    splits proof proven min_clearance_mm dose inputs job part plan_sha256 programs files";
    assert_eq!(keys, expected.split_whitespace().collect::<Vec<_>>());
    let row: Vec<&String> = report["surfaces"][0].as_object().expect("row").keys().collect();
    let expected =
        "surface area_mm2 passes points work_mm corrected_mm blocked_mm missed_area_mm2 spacing_min_mm spacing_max_mm";
    assert_eq!(row, expected.split_whitespace().collect::<Vec<_>>());
    assert_eq!((report["passes"].as_u64(), report["work_mm"].as_f64()), (Some(5), Some(50.0)));
    let dose = &report["dose"];
    let shares: f64 = ["within", "under", "over", "shaded"].iter().filter_map(|k| dose[k].as_f64()).sum();
    assert!((shares - 1.0).abs() < 1e-9, "{dose}");
    let keys: Vec<&String> = dose.as_object().expect("dose").keys().collect();
    let expected =
        "within under over shaded collateral_mm2 low_j_cm2 high_j_cm2 collateral_j_cm2 collateral not_cleanable";
    assert_eq!(keys, expected.split_whitespace().collect::<Vec<_>>());
    let names = ["job.toml", "MZ04-01-A.001", "report.json", "path.csv", "dose.ply"];
    let read = |dir: &str| names.map(|n| std::fs::read(PathBuf::from(dir).join(n)).expect(n));
    let path = String::from_utf8(read(&out)[3].clone()).expect("text");
    assert!(path.starts_with(
        "pass,point,surface,laser,state,px,py,pz,nx,ny,nz,ax,ay,az,ox,oy,oz,x,y,z,tilt_deg,clearance_mm\n"
    ));
    assert!(path.lines().all(|l| l.split(',').count() == 22));
    assert_dose_ply(&read(&out)[4], &side);

    let again = inside(folder.path(), "deep/again");
    assert_eq!(code(&["plan", &inside(folder.path(), "deep/er/job.toml"), "--out", &again, "--dose"]), 0);
    assert!(read(&out) == read(&again), "a plan's own job gives the same bytes");
}

/// Header and length are those of the counts, and the highest dose lies on the chosen side.
fn assert_dose_ply(bytes: &[u8], side: &str) {
    let end = bytes.windows(11).position(|w| w == b"end_header\n").expect("a header") + 11;
    let header = String::from_utf8(bytes[..end].to_vec()).expect("text");
    assert!(header.starts_with("ply\nformat binary_little_endian 1.0\n"), "{header}");
    let count = |what: &str| -> usize {
        let line = header.lines().find_map(|l| l.strip_prefix(what)).expect("a count");
        line.trim().parse().expect("a number")
    };
    let vertices = count("element vertex");
    let vertex = |i: usize| &bytes[end + 28 * i..end + 28 * (i + 1)];
    let float = |i: usize, k: usize| f32::from_le_bytes(vertex(i)[4 * k..4 * k + 4].try_into().expect("four"));
    let surface = |i: usize| i32::from_le_bytes(vertex(i)[20..24].try_into().expect("four"));
    let best = (0..vertices).max_by(|a, b| float(*a, 3).total_cmp(&float(*b, 3))).expect("vertices");
    assert_eq!(surface(best).to_string(), side);
    assert!((0..vertices).all(|i| (float(i, 3) == 0.0) == (float(i, 4) == -1.0)));
    assert_eq!(end + 28 * vertices, bytes.len());
    let area_mm2: f64 = (0..vertices).map(|i| f64::from(float(i, 6))).sum();
    assert!((area_mm2 - 600.0).abs() < 0.01, "the cube's six sides: {area_mm2}");
}

#[test]
fn what_is_missed_or_blocked_is_told_by_the_status() {
    let (folder, file) = cube();
    let out = inside(folder.path(), "o");
    let output = run(&["plan", &file, "--out", &out, "--direction", "z", "--json"]);
    assert_eq!(output.status.code(), Some(3), "top and bottom lie in the planes");
    let report = json(&output);
    assert_eq!(report["missed_area_mm2"].as_f64(), Some(200.0));
    let causes: Vec<&str> =
        report["problems"].as_array().expect("list").iter().filter_map(|p| p["cause"].as_str()).collect();
    assert_eq!(causes, ["missed", "missed"]);
    let remark = &report["surfaces"][0]["remarks"][0];
    assert_eq!((&remark["code"], &remark["cause"]), (&"no_lines".into(), &"direction".into()));
    assert_eq!(remark["area_mm2"].as_f64(), Some(100.0));
    let said = String::from_utf8(run(&["plan", &file, "--out", &out, "--direction", "z"]).stdout).expect("text");
    assert!(said.contains("surface 1: no line on its 100.00 mm²: the section planes lie along it"), "{said}");
    assert!(said.contains("to help: use direction auto: that gives lines to surface 1, surface 2"), "{said}");
    assert_eq!(code(&["plan", &file, "--out", &out]), 0, "a direction of its own for each side");
}

#[test]
fn wrong_usage_is_2() {
    let (folder, file) = cube();
    let out = inside(folder.path(), "o");
    for bad in [
        &["--spacing", "0"][..],
        &["--spacing", "-1"],
        &["--spacing", "nan"],
        &["--surfaces", "7"],
        &["--surfaces", "1,1"],
        &["--surfaces", "one"],
        &["--direction", "0,0,0"],
        &["--direction", "up"],
        &["--order", "spiral"],
        &["--offset", "3"],
        &["--units", "ft"],
        &["--correction", "hope"],
        &["--dialect", "karel"],
        &["--angle", "0"],
        &["--no-such-option"],
    ] {
        let all: Vec<&str> = ["plan", &file, "--out", &out].iter().chain(bad).copied().collect();
        assert_eq!(code(&all), 2, "{bad:?}");
    }
    assert_eq!(code(&["inspect", &file, "--angle", "181"]), 2);
    assert_eq!(code(&["inspect"]), 2);
    assert!(!folder.path().join("o").exists(), "nothing was written");
}

#[test]
fn a_language_is_taken_anywhere_and_an_unknown_one_names_those_there_are() {
    let (_folder, file) = cube();
    let plain = run(&["inspect", &file]);
    for with in
        [&["--lang", "en", "inspect", &file][..], &["inspect", "--lang=en", &file], &["inspect", &file, "--lang", "en"]]
    {
        let output = run(with);
        assert_eq!((output.status.code(), &output.stdout), (Some(0), &plain.stdout), "{with:?}");
    }
    for wrong in [
        &["--lang", "xx", "inspect", &file][..],
        &["inspect", &file, "--lang=xx"],
        &["inspect", &file, "--lang"],
        &["--lang", "xx"],
    ] {
        let output = run(wrong);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{wrong:?}: {said}");
        assert!(said.contains("--lang") && said.contains("[possible values: en"), "{wrong:?}: {said}");
    }
    for help in [&["--help"][..], &["plan", "--help"]] {
        assert!(String::from_utf8_lossy(&run(help).stdout).contains("--lang <LANG>"), "{help:?}");
    }
}

#[test]
fn bad_input_is_1_with_one_line_that_names_it() {
    let (folder, file) = cube();
    let good = std::fs::read(&file).expect("reads");
    let mut billions = good.clone();
    billions[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let cases: [(&str, &[u8]); 5] = [
        ("empty.stl", b""),
        ("cut.stl", &good[..300]),
        ("billions.stl", &billions),
        ("holiday.stl", b"\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01"),
        ("text.stl", b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
    ];
    for (name, bytes) in cases {
        let bad = inside(folder.path(), name);
        std::fs::write(&bad, bytes).expect("writes");
        for arguments in [&["inspect", &bad][..], &["plan", &bad, "--out", &inside(folder.path(), "o")]] {
            let output = run(arguments);
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(output.status.code(), Some(1), "{name}: {said}");
            assert!(said.lines().count() == 1 && said.contains(name), "{name}: {said}");
        }
    }
    let blocked = inside(folder.path(), "cube.stl/o");
    let output = run(&["plan", &file, "--out", &blocked]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot be written"), "{output:?}");
    let output = run(&["plan", &file, "--spacing", "500", "--out", &inside(folder.path(), "o")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("larger than the part"), "{output:?}");
    let output = run(&["plan", &file, "--spacing", "1e-9", "--out", &inside(folder.path(), "o")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("points"), "{output:?}");
    let mut far = good.clone();
    far[84 + 12 + 3] = 0x7e; // the exponent of one coordinate
    let bad = inside(folder.path(), "far.stl");
    std::fs::write(&bad, &far).expect("writes");
    let output = run(&["plan", &bad, "--out", &inside(folder.path(), "o")]);
    assert!(
        output.status.code() == Some(1) && String::from_utf8_lossy(&output.stderr).contains("mm large"),
        "{output:?}"
    );
    let flat: Vec<[[f64; 3]; 3]> = vec![[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]; 4];
    let bad = inside(folder.path(), "lines.stl");
    std::fs::write(&bad, stl_bytes(&flat)).expect("writes");
    assert_eq!(code(&["inspect", &bad]), 1, "no facet has any area");
}

#[test]
fn a_job_whose_part_moved_or_changed_is_refused() {
    let (folder, file) = cube();
    let out = folder.path().join("job");
    assert_eq!(code(&["plan", &file, "--out", &out.display().to_string()]), 0);
    let job = inside(&out, "job.toml");
    std::fs::write(&file, stl_bytes(&solids::cube(11.0))).expect("writes");
    let output = run(&["plan", &job, "--out", &inside(folder.path(), "o")]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("has changed"), "{output:?}");
    std::fs::remove_file(&file).expect("removes");
    let output = run(&["plan", &job, "--out", &inside(folder.path(), "o")]);
    assert!(
        output.status.code() == Some(1) && String::from_utf8_lossy(&output.stderr).contains("is not there"),
        "{output:?}"
    );
    let misspelt = folder.path().join("misspelt.toml");
    std::fs::write(&misspelt, "[layers]\nspaceing_mm = 1\n").expect("writes");
    let output = run(&["plan", &misspelt.display().to_string(), "--out", &inside(folder.path(), "o")]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && said.contains("spaceing_mm") && said.lines().count() == 1, "{said}");
}

#[test]
fn render_draws_every_sample() {
    let folder = tempfile::tempdir().expect("folder");
    for s in SAMPLES {
        let job = format!("{}/assets/samples/{}.toml", env!("CARGO_MANIFEST_DIR"), s.name);
        let picture = inside(folder.path(), "p.png");
        let output = run(&["render", &job, "--out", &picture, "--size", "320x200", "--view", "front"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let image = image::open(&picture).expect("a picture").to_rgb8();
        assert_eq!(image.dimensions(), (320, 200));
        let corner = image.get_pixel(2, 100);
        let part = image.pixels().filter(|p| (0..3).any(|k| p[k].abs_diff(corner[k]) > 60)).count();
        assert!(part > 2000, "{}: the part fills {part} pixels", s.name);
    }
}
