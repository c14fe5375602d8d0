//! `plan --report`: the page for people is one file, says what the JSON says, and belongs to the export.

mod common;

use clearbeam::app::{Command as WindowCommand, Purpose};
use common::window::{Answers, click, job_on, settle, window};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

/// Crater and boss of the workpiece, which the beam meets with and without correction, by a robot.
fn plan(out: &Path, options: &[&str]) -> Output {
    let job = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/samples/workpiece.toml");
    let mut command = Command::new(env!("CARGO_BIN_EXE_clearbeam"));
    command.arg("plan").arg(job).arg("--out").arg(out).args(["--surfaces", "2,4", "--spacing", "3", "--robot", "mz04"]);
    command.args(options).output().expect("runs")
}

fn page_and_report(out: &Path) -> (String, Value) {
    let read = |name: &str| std::fs::read(out.join(name)).expect("written");
    let report = serde_json::from_slice(&read("report.json")).expect("JSON");
    (String::from_utf8(read("report.html")).expect("text"), report)
}

/// The words of the page, without marks, pictures and style, on single lines.
fn words(page: &str) -> Vec<String> {
    let body = page.split_once("</head>").expect("a head").1;
    let words = body.split('<').map(|piece| piece.split_once('>').map_or(piece, |(_, words)| words).trim().to_owned());
    words.filter(|w| !w.is_empty()).collect()
}

#[test]
fn the_page_says_what_the_report_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let said = plan(&out, &["--report"]);
    let (page, report) = page_and_report(&out);
    assert_eq!(said.status.code(), Some(if report["problems"].as_array().is_some_and(Vec::is_empty) { 0 } else { 3 }));
    let words = words(&page);
    let row = |name: &str| {
        let at = words.iter().position(|w| w == name).unwrap_or_else(|| panic!("{name} of {words:?}"));
        words[at + 1].clone()
    };
    let count = |key: &str| report[key].as_u64().expect("a count").to_string();
    assert_eq!(row("Targets whose beam along the normal hits something"), count("interfering"));
    assert_eq!(row("Targets corrected"), count("corrected"));
    assert_eq!(row("Targets blocked"), count("blocked"));
    let proof = &report["proof"];
    let proven = format!("{} / {}", proof["proven"], proof["intervals"]);
    assert_eq!(row("Moves with the laser on, proven to touch nothing"), proven);
    assert!(report["interfering"].as_u64() > Some(0), "the crater has something to say");
    for surface in report["surfaces"].as_array().expect("surfaces") {
        let at = words.iter().position(|w| *w == format!("surface {}", surface["surface"])).expect("its row");
        let figure = |i: usize| words[at + i].parse::<f64>().expect("a figure");
        for (place, key) in [(1, "area_mm2"), (7, "passes"), (8, "work_mm"), (10, "blocked_mm")] {
            assert!((figure(place) - surface[key].as_f64().expect("a number")).abs() <= 0.05, "{key} of {surface}");
        }
    }
    for file in report["files"].as_array().expect("files").iter().filter(|f| f["name"] != "report.html") {
        assert_eq!(row(file["name"].as_str().expect("a name")), file["sha256"].as_str().expect("a digest"));
    }
    assert!(words.contains(&"Not computed for this report".to_owned()), "no dose was asked for");
    let seconds = report["time_s"].as_f64().expect("a time");
    let [h, m, s]: [u64; 3] =
        std::array::from_fn(|i| row("Program").split(':').nth(i).and_then(|t| t.parse().ok()).expect("hh:mm:ss"));
    assert!((seconds - (h * 3600 + m * 60 + s) as f64).abs() <= 1.0, "{seconds} s");
}

#[test]
fn the_page_needs_nothing_else_and_is_the_same_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    plan(&one, &["--report"]);
    plan(&two, &["--report"]);
    let (page, report) = page_and_report(&one);
    assert_eq!(page, page_and_report(&two).0);
    let sources = page.matches("src=").count();
    assert!(sources > 0 && sources == page.matches("src=\"data:image/png;base64,").count());
    assert!(!page.contains("href=") && !page.contains("<script") && !page.contains("url("));
    // Every mark that is opened is closed.
    let opened = |tag: &str| page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
    for tag in ["html", "head", "body", "table", "tr", "td", "th", "ul", "li", "p", "h1", "h2", "figure", "style"] {
        assert_eq!(opened(tag), page.matches(&format!("</{tag}>")).count(), "{tag}");
    }
    let digest = clearbeam::part::digest_of(page.as_bytes());
    let of_page = report["files"].as_array().expect("files").iter().find(|f| f["name"] == "report.html");
    assert_eq!(of_page.expect("listed")["sha256"], digest.as_str());
}

#[test]
fn the_page_goes_with_the_export_that_does_not_have_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    plan(&out, &["--report"]);
    assert!(out.join("report.html").exists());
    plan(&out, &[]);
    assert!(!out.join("report.html").exists() && out.join("report.json").exists());
    std::fs::write(out.join("report.html"), "mine").expect("writes");
    let refused = plan(&out, &["--report"]);
    assert_eq!(refused.status.code(), Some(1), "{refused:?}");
    assert!(String::from_utf8_lossy(&refused.stderr).contains("report.html"));
}

/// In Chinese the words are others and the figures are not.
#[test]
fn the_page_is_in_the_language_in_use() {
    let folder = tempfile::tempdir().expect("a folder");
    let (english, chinese) = (folder.path().join("en"), folder.path().join("zh"));
    plan(&english, &["--report"]);
    let said = plan(&chinese, &["--report", "--lang", "zh"]);
    assert!(String::from_utf8_lossy(&said.stdout).contains("已写入"), "{said:?}");
    let ((en, report), (zh, of_zh)) = (page_and_report(&english), page_and_report(&chinese));
    assert!(en.contains("<html lang=\"en\">") && zh.contains("<html lang=\"zh\">") && zh.contains("待清洗面与路径"));
    let is_figure = |w: &&String| w.chars().all(|c| c.is_ascii_digit() || "./:\u{2013} \u{a0}\u{202f}".contains(c));
    let figures = |page: &str| words(page).iter().filter(is_figure).cloned().collect::<Vec<_>>();
    assert!(figures(&en).len() > 30);
    assert_eq!(figures(&en), figures(&zh));
    let program = |report: &Value| report["files"].as_array().expect("files")[1].clone();
    assert_eq!(program(&report), program(&of_zh), "programs are the same in every language");
}

/// The window writes the page that the command line writes.
#[test]
fn the_window_writes_the_same_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let job = job_on(&folder, "workpiece", "[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 3.0\n");
    let (by_window, by_command) = (folder.path().join("window"), folder.path().join("command"));
    let answers = Answers::default();
    answers.0.lock().expect("not poisoned").push((Purpose::Export, by_window.clone()));
    let mut h = window(Some(job.clone()), &answers);
    h.state_mut().give(WindowCommand::Export, &[]);
    settle(&mut h);
    click(&mut h, "Report as a page, too");
    click(&mut h, "Export");
    let mut run = Command::new(env!("CARGO_BIN_EXE_clearbeam"));
    run.args(["plan", "--report"]).arg(&job).arg("--out").arg(&by_command);
    assert!(run.output().expect("runs").status.code().is_some_and(|code| code == 0 || code == 3));
    assert_eq!(page_and_report(&by_window).0, page_and_report(&by_command).0);
}
