//! Exports into folders where something stands already: what the next one removes, replaces, and refuses to touch.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::planning::export::{self, ExportError, ExportInput, ExportOptions};
use clearbeam::progress::Progress;
use clearbeam::sample::{solids, stl_bytes};
use clearbeam::text::program_comment;
use parts::Planned;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder with a cube in it, and one to export into.
struct Bench {
    folder: tempfile::TempDir,
    out: PathBuf,
}

impl Bench {
    fn new() -> Bench {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("cube.stl"), stl_bytes(&solids::cube(10.0))).expect("writes");
        // Pages of a few moves: a program of several files.
        let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/cells/mz04.toml");
        let cell = std::fs::read_to_string(shipped).expect("shipped");
        std::fs::write(folder.path().join("cell.toml"), short_subprograms(&cell)).expect("writes");
        let out = folder.path().join("out");
        Bench { folder, out }
    }

    fn file(&self, name: &str) -> String {
        self.folder.path().join(name).display().to_string()
    }

    fn plan_into(&self, input: &str, out: &Path, options: &[&str]) -> Output {
        let (cell, out) = (self.file("cell.toml"), out.display().to_string());
        let arguments = ["plan", input, "--out", &out, "--cell", &cell, "--direction", "auto"];
        let all = arguments.iter().chain(options);
        Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(all).output().expect("runs")
    }

    fn plan(&self, options: &[&str]) -> Output {
        self.plan_into(&self.file("cube.stl"), &self.out, options)
    }

    /// Plans, and has to succeed.
    fn planned(&self, options: &[&str]) {
        let output = self.plan(options);
        assert_eq!(output.status.code(), Some(0), "{options:?}: {output:?}");
    }

    /// Plans, and is refused with a line that names these files; nothing changes.
    fn refused(&self, output: Output, before: &Files, names: &[&str]) {
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.lines().count() == 1 && said.contains("--overwrite"), "{said}");
        assert!(names.iter().all(|n| said.contains(n)), "{said}");
        assert!(self.files() == *before, "nothing was written");
    }

    fn files(&self) -> Files {
        files(&self.out)
    }

    fn report(&self) -> Value {
        serde_json::from_slice(&self.files()["report.json"]).expect("JSON")
    }
}

type Files = BTreeMap<String, Vec<u8>>;

fn short_subprograms(cell: &str) -> String {
    let mut table: toml::Table = toml::from_str(cell).expect("TOML");
    let nachi = table.entry("nachi").or_insert_with(|| toml::Value::Table(toml::Table::new()));
    nachi.as_table_mut().expect("a table").insert("max_moves".into(), toml::Value::Integer(30));
    toml::to_string(&table).expect("TOML")
}

fn files(dir: &Path) -> Files {
    let entries = std::fs::read_dir(dir).expect("a folder").map(|e| e.expect("an entry"));
    entries.map(|e| (e.file_name().into_string().expect("a name"), std::fs::read(e.path()).expect("reads"))).collect()
}

fn programs(files: &Files) -> Vec<&str> {
    files.keys().map(String::as_str).filter(|n| n.starts_with("MZ04")).collect()
}

const FINE: &[&str] = &["--spacing", "1"];
const COARSE: &[&str] = &["--spacing", "4"];

#[test]
fn a_shorter_program_removes_the_longer_one_s_files() {
    let bench = Bench::new();
    bench.planned(FINE);
    let fine = bench.files();
    let last = programs(&fine).pop().expect("programs").to_owned();
    assert!(programs(&fine).len() > 4, "{:?}", programs(&fine));
    let output = bench.plan(COARSE);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let removed = format!("removed {}", bench.out.join(&last).display());
    assert!(String::from_utf8_lossy(&output.stdout).contains(&removed), "{output:?}");
    let coarse = bench.files();
    assert!(programs(&coarse).len() < programs(&fine).len() && !coarse.contains_key(&last));

    // What is there is what was written and listed, and the same as in a folder of its own.
    let report = bench.report();
    assert_eq!((&report["job"], &report["part"]), (&"cube".into(), &"cube.stl".into()));
    let listed: Vec<&str> =
        report["files"].as_array().expect("a list").iter().filter_map(|f| f["name"].as_str()).collect();
    assert_eq!(listed.len() + 1, coarse.len());
    assert!(listed.iter().all(|n| coarse.contains_key(*n)) && !listed.contains(&"report.json"));
    for f in report["files"].as_array().expect("a list") {
        let bytes = &coarse[f["name"].as_str().expect("a name")];
        assert_eq!(f["sha256"], clearbeam::part::digest_of(bytes));
    }
    let elsewhere = bench.folder.path().join("elsewhere");
    assert_eq!(bench.plan_into(&bench.file("cube.stl"), &elsewhere, COARSE).status.code(), Some(0));
    assert!(files(&elsewhere) == coarse);
}

#[test]
fn what_was_changed_by_hand_stays_until_it_may_go() {
    let bench = Bench::new();
    bench.planned(FINE);
    let last = programs(&bench.files()).pop().expect("programs").to_owned();
    for name in [last.as_str(), "path.csv"] {
        std::fs::write(bench.out.join(name), "by hand").expect("writes");
    }
    let before = bench.files();
    bench.refused(bench.plan(COARSE), &before, &[&last, "path.csv", "by hand"]);
    bench.planned(&[COARSE, &["--overwrite"]].concat());
    assert!(!bench.files().contains_key(&last) && bench.files()["path.csv"] != b"by hand");
}

#[test]
fn what_no_export_wrote_stays_until_it_may_go() {
    let bench = Bench::new();
    bench.planned(FINE);
    let program = programs(&bench.files())[2].to_owned();
    std::fs::remove_dir_all(&bench.out).expect("removes");
    std::fs::create_dir_all(&bench.out).expect("makes");
    // A sub-program's name is known only when there is a plan.
    for name in [program.as_str(), "notes.txt"] {
        std::fs::write(bench.out.join(name), "mine").expect("writes");
    }
    let before = bench.files();
    bench.refused(bench.plan(FINE), &before, &[&program, "not exported"]);
    bench.planned(&[FINE, &["--overwrite"]].concat());
    assert_eq!(bench.files()["notes.txt"], b"mine", "only what is in the way");
    std::fs::write(bench.out.join("report.json"), "{}").expect("writes");
    let before = bench.files();
    bench.refused(bench.plan(FINE), &before, &["report.json", "MZ04-01-A.001"]);
}

#[test]
fn another_job_s_export_stays_until_it_may_go() {
    let bench = Bench::new();
    bench.planned(FINE);
    let before = bench.files();
    std::fs::copy(bench.file("cube.stl"), bench.file("other.stl")).expect("copies");
    let other = |options: &[&str]| bench.plan_into(&bench.file("other.stl"), &bench.out, options);
    let last = programs(&before).pop().expect("programs");
    bench.refused(other(COARSE), &before, &["job.toml", last, "the job cube on cube.stl"]);
    assert_eq!(other(&[COARSE, &["--overwrite"]].concat()).status.code(), Some(0));
    assert!(!bench.files().contains_key(last), "no file of the other job is left");
    assert_eq!(bench.report()["part"], "other.stl");
}

#[test]
fn an_export_without_a_list_stays_until_it_may_go() {
    let bench = Bench::new();
    bench.planned(FINE);
    let mut report = bench.report();
    for key in ["job", "part", "files", "findings"] {
        report.as_object_mut().expect("an object").remove(key);
    }
    std::fs::write(bench.out.join("report.json"), report.to_string()).expect("writes");
    let before = bench.files();
    bench.refused(bench.plan(FINE), &before, &["report.json", "earlier version"]);
    bench.planned(&[FINE, &["--overwrite"]].concat());
    bench.planned(FINE);
}

#[test]
fn a_job_is_planned_again_in_its_own_folder() {
    let bench = Bench::new();
    bench.planned(FINE);
    let before = bench.files();
    let job = bench.out.join("job.toml");
    let again = |options: &[&str]| bench.plan_into(&job.display().to_string(), &bench.out, options);
    assert_eq!(again(&[]).status.code(), Some(0));
    assert!(bench.files() == before, "the same job gives the same bytes");

    let edited = std::fs::read_to_string(&job).expect("reads").replace("spacing_mm = 1.0", "spacing_mm = 4.0");
    std::fs::write(&job, edited).expect("writes");
    assert_eq!(again(&[]).status.code(), Some(0), "the job that is read may have been changed");
    assert!(programs(&bench.files()).len() < programs(&before).len());
    bench.planned(FINE);
    assert!(bench.files() == before, "and it is still the part's own job");
}

#[test]
fn an_earlier_program_goes_where_nothing_is_left_to_do() {
    let bench = Bench::new();
    bench.planned(FINE);
    let output = bench.plan(&["--spacing", "1", "--inset", "6"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("nothing to do"), "{said}");
    let files = bench.files();
    assert!(programs(&files).is_empty());
    assert!(["job.toml", "path.csv", "report.json"].iter().all(|n| files.contains_key(*n)));
    let findings = &bench.report()["findings"];
    assert_eq!((&findings[0]["code"], &findings[0]["reason"]), (&"nothing_planned".into(), &"no_lines".into()));
    assert_eq!((&findings[0]["cause"], &findings[0]["inset_mm"]), (&"inset".into(), &6.0.into()));
    assert_eq!((&findings[0]["area_mm2"], &bench.report()["missed_area_mm2"]), (&600.0.into(), &600.0.into()));
    assert_eq!(findings[0]["by"].as_array().map(Vec::len), Some(6));
    assert!(said.contains("to help: use an inset of 4.5 mm: that gives lines to surface 1, surface 2"), "{said}");
    bench.planned(FINE);
    assert!(programs(&bench.files()).len() > 4);
}

#[test]
fn a_folder_in_the_way_is_never_replaced() {
    let bench = Bench::new();
    std::fs::create_dir_all(bench.out.join("path.csv")).expect("makes");
    let output = bench.plan(&[COARSE, &["--overwrite"]].concat());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && said.contains("path.csv is a folder"), "{said}");
    assert_eq!(std::fs::read_dir(&bench.out).expect("reads").count(), 1);
}

#[test]
fn a_cancelled_export_makes_no_folder() {
    let planned = parts::planned(parts::part(&solids::cube(10.0)), parts::job("auto", 2.0));
    let dir = tempfile::tempdir().expect("a folder");
    let out = dir.path().join("out");
    let (setup, progress) = (parts::setup(), Progress::default());
    let Planned { part, surfaces, job, plan } = &planned;
    let (wording, options) = (program_comment, ExportOptions::default());
    let input = ExportInput { job, part, surfaces, setup: &setup, plan, findings: &[], wording, options, page: None };
    progress.cancel();
    let said = export::write(&out, &input, None, false, &progress);
    assert!(matches!(said, Err(ExportError::Cancelled)), "{said:?}");
    assert!(!out.exists());
}
