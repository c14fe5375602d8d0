//! `clearbeam weld` on the shipped images: what it measures beside the truth, what it writes, and what it says of images that
//! cannot be used.

use clearbeam::sample::weld_panel::{self, WeldPanel, WeldScene};
use clearbeam::sample::{Triangles, stl_bytes};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn clearbeam(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn said(of: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&of.stdout), String::from_utf8_lossy(&of.stderr))
}

fn sample(name: &str) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/samples/weld").join(name);
    file.display().to_string()
}

/// `weld` on the sample with more options, into a folder.
fn weld(out: &Path, more: &[&str]) -> Output {
    let (gray, depth, camera) = (sample("gray.png"), sample("depth.png"), sample("camera.toml"));
    let out = out.display().to_string();
    let mut arguments = vec!["weld", "--gray", &gray, "--depth", &depth, "--camera", &camera, "--out", &out];
    arguments.extend(more);
    clearbeam(&arguments)
}

fn json(of: &Output) -> Value {
    serde_json::from_slice(&of.stdout).unwrap_or_else(|e| panic!("{e}: {}", said(of)))
}

fn number(of: &Value, key: &str) -> f64 {
    of[key].as_f64().unwrap_or_else(|| panic!("{key} in {of}"))
}

fn points(of: &Value) -> Vec<[f64; 3]> {
    serde_json::from_value(of.clone()).expect("points")
}

/// Distance of a point from a polyline, mm.
fn off(line: &[[f64; 3]], p: &[f64; 3]) -> f64 {
    let to = |w: &[[f64; 3]]| {
        let along: [f64; 3] = std::array::from_fn(|k| w[1][k] - w[0][k]);
        let from: [f64; 3] = std::array::from_fn(|k| p[k] - w[0][k]);
        let dot = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
        let t = (dot(&from, &along) / dot(&along, &along)).clamp(0.0, 1.0);
        let left: [f64; 3] = std::array::from_fn(|k| from[k] - along[k] * t);
        dot(&left, &left).sqrt()
    };
    line.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_sample_is_measured_planned_written_and_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let made = weld(&out, &["--json"]);
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    let found = json(&made);
    let truth: Value = serde_json::from_slice(&std::fs::read(sample("truth.json")).expect("there")).expect("JSON");
    let near = |key: &str, within_mm: f64| {
        let (is, ought) = (number(&found, key), number(&truth, key));
        assert!((is - ought).abs() <= within_mm, "{key}: {is} for {ought}");
    };
    near("max_height_mm", 0.2);
    near("width_mm", 0.5);
    // Its tips taper off into the noise, 1.6 mm at either end.
    near("length_mm", 4.0);
    let passes = (number(&found, "max_height_mm") / 0.5).ceil();
    assert_eq!(number(&found, "passes"), passes);
    let (line, true_line) = (points(&found["centre_line_mm"]), points(&truth["centre_line_mm"]));
    let squares: f64 = line.iter().map(|p| off(&true_line, p).powi(2)).sum();
    let rms = (squares / line.len() as f64).sqrt();
    assert!(line.len() > 50 && rms <= 0.15, "{rms} over {}", line.len());
    for area in ["bead", "defect"] {
        let rows: Vec<&Value> =
            found["times"].as_array().expect("times").iter().filter(|t| t["area"] == area).collect();
        let speeds: Vec<f64> = rows.iter().map(|t| number(t, "speed_mm_s")).collect();
        assert_eq!(speeds, [50.0, 70.0, 90.0, 110.0], "{area}");
        for row in rows.iter().filter(|_| area == "defect") {
            let [one_way, zigzag, spiral] = ["one_way_s", "zigzag_s", "spiral_s"].map(|key| number(row, key));
            assert!(spiral < zigzag && zigzag < one_way, "{row}");
        }
    }
    let report: Value = serde_json::from_slice(&std::fs::read(out.join("report.json")).expect("there")).expect("JSON");
    assert_eq!(report["weld"]["max_height_mm"], found["max_height_mm"]);
    assert_eq!((report["proven"].as_bool(), report["blocked"].as_u64()), (Some(true), Some(0)), "{report:#}");
    for name in ["job.toml", "path.csv", "mask.png", "bead.ply"] {
        assert!(out.join(name).is_file(), "{name}");
    }
    let program = report["files"].as_array().expect("files").iter().filter_map(|f| f["name"].as_str());
    let known = ["job.toml", "path.csv", "mask.png", "bead.ply"];
    let program = program.filter(|name| !known.contains(name)).map(|name| out.join(name)).next().expect("a program");
    let job = out.join("job.toml").display().to_string();
    let verified = clearbeam(&["verify", &program.display().to_string(), "--job", &job]);
    assert_eq!(verified.status.code(), Some(0), "{}", said(&verified));
    let text = String::from_utf8_lossy(&std::fs::read(&program).expect("there")).to_ascii_lowercase();
    assert!(text.contains("grind") && !text.contains("laser"), "{text}");
}

/// The bare skin of the panel, 340 × 240 mm.
fn skin_stl() -> Vec<u8> {
    let at = |i: usize, j: usize| {
        let (x, y) = (5.0 * i as f64 - 170.0, 5.0 * j as f64 - 120.0);
        [x, y, WeldPanel.parent(x, y)]
    };
    let cells = (0..68).flat_map(|i| (0..48).map(move |j| (i, j)));
    let skin: Triangles = cells
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    stl_bytes(&skin)
}

/// On a skin without edges the images may lie anywhere: a program would grind beside the bead, so there is none before the
/// place is known.
#[test]
fn on_a_skin_that_they_slide_on_the_passes_wait() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path();
    let skin = write(dir, "skin.stl", &skin_stl()).display().to_string();
    let report = |out: &str| -> Value {
        serde_json::from_slice(&std::fs::read(dir.join(out).join("report.json")).expect("there")).expect("JSON")
    };
    let made = weld(&dir.join("open"), &["--part", &skin]);
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    let told = said(&made);
    assert!(told.contains("slides: nothing holds") && told.contains("state where the camera stood"), "{told}");
    assert!(told.contains("the passes wait for your word") && !told.contains("patch to work"), "{told}");
    let open = report("open");
    assert_eq!((&open["weld"]["held"]["cause"], open["points"].as_u64()), (&Value::from("place"), Some(0)), "{open:#}");
    let written = std::fs::read_dir(dir.join("open")).expect("there").map(|e| e.expect("readable").file_name());
    let mut written: Vec<String> = written.map(|name| name.to_string_lossy().into_owned()).collect();
    written.sort();
    assert_eq!(written, ["bead.ply", "job.toml", "mask.png", "path.csv", "report.json"], "no program");
    let stand =
        b"base_from_camera = [1.0, 0.0, 0.0, 600.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 700.0, 0.0, 0.0, 0.0, 1.0]";
    let stand = write(dir, "stand.toml", stand).display().to_string();
    let made = weld(&dir.join("known"), &["--part", &skin, "--hand-eye", &stand]);
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    let known = report("known");
    assert!(known["weld"]["held"].is_null() && known["points"].as_u64() > Some(0), "{known:#}");
}

fn write(folder: &Path, name: &str, bytes: &[u8]) -> PathBuf {
    let file = folder.join(name);
    std::fs::write(&file, bytes).expect("written");
    file
}

#[test]
fn images_that_cannot_be_used_are_told_with_what_to_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let dir = folder.path();
    let scene = WeldScene::new();
    let (grey, depth) = scene.images(0.3, 1);
    let camera = write(dir, "camera.toml", weld_panel::camera_toml().as_bytes());
    let good_grey = write(dir, "gray.png", &weld_panel::grey_png(&grey));
    let good_depth = write(dir, "depth.png", &weld_panel::depth_png(&depth));
    let refused = |gray: &Path, depth: &Path, camera: &Path, words: &[&str]| {
        let [gray, depth, camera, out] = [gray, depth, camera, &dir.join("out")].map(|p| p.display().to_string());
        let made = clearbeam(&["weld", "--gray", &gray, "--depth", &depth, "--camera", &camera, "--out", &out]);
        assert_eq!(made.status.code(), Some(1), "{}", said(&made));
        let line = String::from_utf8_lossy(&made.stderr).into_owned();
        assert!(words.iter().all(|word| line.contains(word)), "{line}");
        assert!(!Path::new(&out).exists(), "nothing is written");
    };
    let none = write(dir, "none.png", &weld_panel::depth_png(&vec![0; depth.len()]));
    refused(&good_grey, &none, &camera, &["none.png", "no depth"]);
    let white =
        write(dir, "white.png", &weld_panel::grey_png(&grey.iter().map(|g| g.saturating_add(180)).collect::<Vec<_>>()));
    refused(&white, &good_depth, &camera, &["white.png", "less light"]);
    let wide = write(dir, "wide.toml", weld_panel::camera_toml().replace("cx = 322.4", "cx = 622.4").as_bytes());
    refused(&good_grey, &good_depth, &wide, &["wide.toml", "another camera"]);
    let no_image = write(dir, "empty.png", b"");
    refused(&no_image, &good_depth, &camera, &["empty.png"]);
    let plain: Vec<u8> = (0..grey.len()).map(|i| 100 + (i % 7) as u8).collect();
    let plain = write(dir, "plain.png", &weld_panel::grey_png(&plain));
    refused(&plain, &good_depth, &camera, &["paint"]);
}
