//! The dose when it is asked for, dry runs, and programs that go on after a stop: what is written, what stands beside it, and
//! what reading back finds.

use clearbeam::sample::{solids, stl_bytes};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder with a cube in it, planned with some options.
struct Bench {
    folder: tempfile::TempDir,
    options: Vec<String>,
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

/// Coarse lines on the sides of a cube.
const COARSE: &[&str] = &["--direction", "z", "--spacing", "2"];

impl Bench {
    fn new(options: &[&str]) -> Bench {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("cube.stl"), stl_bytes(&solids::cube(10.0))).expect("writes");
        Bench { folder, options: options.iter().map(|o| (*o).to_owned()).collect() }
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    fn plan(&self, more: &[&str]) -> Output {
        let (part, out) = (self.folder.path().join("cube.stl").display().to_string(), self.out().display().to_string());
        let own: Vec<&str> = self.options.iter().map(String::as_str).collect();
        run(&[&["plan", &part, "--out", &out], COARSE, &own, more].concat())
    }

    /// Plans, and gives the report.
    fn planned(&self, more: &[&str]) -> Value {
        let output = self.plan(&[more, &["--json"]].concat());
        // The upper and lower side are missed by level planes.
        assert_eq!(output.status.code(), Some(3), "{more:?}: {}", said(&output));
        serde_json::from_slice(&output.stdout).expect("JSON")
    }

    fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(self.out()).expect("a folder").map(|e| e.expect("an entry"));
        entries
            .map(|e| (e.file_name().into_string().expect("a name"), std::fs::read(e.path()).expect("reads")))
            .collect()
    }

    fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.out().join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    fn verify(&self, name: &str) -> (Option<i32>, Value) {
        let (file, job) = (self.out().join(name), self.out().join("job.toml"));
        let output = run(&["verify", &shown(&file), "--job", &shown(&job), "--json"]);
        let verdict = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", said(&output)));
        (output.status.code(), verdict)
    }
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// The first program of a report.
fn main_name(report: &Value) -> String {
    report["programs"][0]["names"][0].as_str().expect("a program").to_owned()
}

/// What each is called: whole, dry, from pass 2 on, and that dry.
const NAMES: [(&[&str], [&str; 4]); 7] = [
    (&["--dialect", "nachi"], ["MZ04-01-A.001", "MZ04-01-A.401", "MZ04-01-A.201", "MZ04-01-A.601"]),
    (&["--dialect", "kuka"], ["clearbeam.src", "clearbeam_DRY.src", "clearbeam_P2.src", "clearbeam_DRY_P2.src"]),
    (&["--dialect", "abb"], ["clearbeam.mod", "clearbeam_DRY.mod", "clearbeam_P2.mod", "clearbeam_DRY_P2.mod"]),
    (&["--dialect", "fanuc"], ["CLEAN.LS", "CLEAN_DRY.LS", "CLEAN_P2.LS", "CLEAN_DRY_P2.LS"]),
    (&["--dialect", "ur"], ["Clean.script", "Clean_DRY.script", "Clean_P2.script", "Clean_DRY_P2.script"]),
    (&["--dialect", "estun"], ["clearbeam.erp", "clearbeam_DRY.erp", "clearbeam_P2.erp", "clearbeam_DRY_P2.erp"]),
    (&["--dialect", "csv"], ["program.csv", "program_DRY.csv", "program_P2.csv", "program_DRY_P2.csv"]),
];
const VARIANTS: [&[&str]; 4] = [&[], &["--dry-run"], &["--from-pass", "2"], &["--from-pass", "2", "--dry-run"]];

#[test]
fn the_dose_is_computed_where_it_is_asked_for() {
    let bench = Bench::new(&[]);
    assert_eq!(bench.planned(&[])["dose"], "not looked at");
    assert!(!bench.files().contains_key("dose.ply") && said(&bench.plan(&[])).contains("dose: not looked at"));
    assert!(bench.planned(&["--dose"])["dose"]["within"].is_f64() && bench.files().contains_key("dose.ply"));
    bench.planned(&[]);
    assert!(!bench.files().contains_key("dose.ply"), "what is no longer written goes");
    let job = bench.text("job.toml").replace("collateral_j_cm2 = 0.0", "collateral_j_cm2 = 5.0");
    std::fs::write(bench.out().join("job.toml"), job).expect("writes");
    let (job, out) = (shown(&bench.out().join("job.toml")), shown(&bench.out()));
    let report: Value = serde_json::from_slice(&run(&["plan", &job, "--out", &out, "--json"]).stdout).expect("JSON");
    assert_eq!(report["dose"]["collateral_j_cm2"], 5.0, "a job with a threshold has its dose looked at");
    assert!(bench.files().contains_key("dose.ply"));
}

#[test]
fn all_programs_of_a_plan_stand_beside_each_other_and_are_what_they_are_called() {
    for (options, names) in NAMES {
        let bench = Bench::new(options);
        let mut before: BTreeMap<String, Vec<u8>> = BTreeMap::new();
        for (variant, name) in VARIANTS.iter().zip(names) {
            let report = bench.planned(variant);
            assert_eq!(main_name(&report), name);
            let files = bench.files();
            assert!(
                names.iter().all(|n| before.get(*n).is_none_or(|bytes| files[*n] == *bytes)),
                "{name}: others stay"
            );
            before = files;
        }
        for (variant, name) in VARIANTS.iter().zip(names) {
            let (status, verdict) = bench.verify(name);
            assert_eq!((status, &verdict["findings"]), (Some(0), &Value::Array(Vec::new())), "{name}: {verdict}");
            assert_eq!(verdict["dry_run"], variant.contains(&"--dry-run"), "{name}");
            assert_eq!(verdict["from_pass"].as_u64(), variant.contains(&"--from-pass").then_some(2), "{name}");
            assert_eq!(verdict["lit_moves"] == 0, variant.contains(&"--dry-run"), "{name}");
        }
        // A program that is not of the plan any more does not stand beside one that is.
        bench.planned(&["--speed", "5"]);
        let files = bench.files();
        assert!(files.contains_key(names[0]) && names[1..].iter().all(|n| !files.contains_key(*n)), "{options:?}");
    }
}

#[test]
fn a_robot_does_them_with_the_part_and_with_the_tool_in_its_hand() {
    let sample = format!("{}/assets/samples/workpiece.toml", env!("CARGO_MANIFEST_DIR"));
    // Yaskawa's speeds have one decimal: of the program's 3 mm/s a dry run has 0.7.
    let robots = [
        ("mz04", "nachi", "part-in-hand", &VARIANTS[..]),
        ("irb1200", "abb", "tool-in-hand", &VARIANTS[..]),
        ("gp7", "yaskawa", "tool-in-hand", &VARIANTS[..2]),
    ];
    for (robot, dialect, mount, variants) in robots {
        let folder = tempfile::tempdir().expect("a folder");
        let out = shown(folder.path());
        let options = ["--surfaces", "1", "--spacing", "8", "--robot", robot, "--dialect", dialect, "--mount", mount];
        for variant in variants {
            let arguments = [&["plan", &sample, "--out", &out, "--json"], &options[..], variant].concat();
            let output = run(&arguments);
            let report: Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", said(&output)));
            let name = main_name(&report);
            let verified = run(&["verify", &format!("{out}/{name}"), "--job", &format!("{out}/job.toml")]);
            assert_eq!(verified.status.code(), Some(0), "{robot} {name}: {}", said(&verified));
            let joints = std::fs::read_to_string(format!("{out}/joints.csv")).expect("joints");
            let first = joints.lines().nth(1).and_then(|l| l.split(',').next()).expect("a row");
            assert_eq!(first == "2", variant.contains(&"--from-pass"), "{robot}: {first}");
        }
    }
}

#[test]
fn a_dry_run_switches_nothing_on_takes_four_times_as_long_and_keeps_the_tables() {
    let bench = Bench::new(&[]);
    bench.planned(&[]);
    let (whole, tables) = (bench.text("MZ04-01-A.001"), bench.files());
    let report = bench.planned(&["--dry-run"]);
    assert_eq!((&report["dry_run"]["speed_percent"], &report["from_pass"]), (&Value::from(25.0), &Value::Null));
    assert!(["path.csv", "job.toml"].iter().all(|name| bench.files()[*name] == tables[*name]));
    let dry = bench.text("MZ04-01-A.401");
    let head = dry.lines().next().expect("a head");
    assert!(head.contains("DRY RUN") && head.contains("25 per cent"), "{head}");
    assert!(whole.contains("MZ04-01-A.401"), "the program tells which is its dry run");
    assert!(!dry.contains("\nSET ") && !dry.contains("power"), "{dry}");
    let acts = |text: &str| text.lines().filter(|l| !l.starts_with("REM")).map(str::to_owned).collect::<Vec<_>>();
    let (whole, dry) = (acts(&whole), acts(&dry));
    assert_eq!(whole.len(), dry.len());
    let seconds = |line: &str| line.split("T=").nth(1)?.split(',').next()?.parse::<f64>().ok();
    for (w, d) in whole.iter().zip(&dry) {
        if let (Some(w), Some(d)) = (seconds(w), seconds(d)) {
            assert!((d - 4.0 * w).abs() < 3e-4, "{d} s for {w} s");
        }
    }
}

#[test]
fn an_output_that_is_on_in_a_dry_run_is_found() {
    let bench = Bench::new(&[]);
    bench.planned(&["--dry-run"]);
    let dry = bench.text("MZ04-01-A.401");
    let off = dry.rfind("RESET O3").expect("the laser is switched off");
    let (time, behind) = dry.split_once("T=").expect("a timed move");
    let fast = format!("{time}T=0.0100{}", &behind[behind.find(',').expect("figures")..]);
    for (changed, what) in [
        (dry.replacen("RESET O3", "SET O3", 1), "the first off is an on"),
        (format!("{}SET O4\n{}", &dry[..off], &dry[off..]), "another output"),
        (fast, "a move is faster"),
    ] {
        assert_ne!(changed, dry, "{what}");
        std::fs::write(bench.out().join("MZ04-01-A.401"), &changed).expect("writes");
        let (status, verdict) = bench.verify("MZ04-01-A.401");
        assert_eq!(status, Some(3), "{what}");
        assert_eq!(verdict["dry_run"], true, "{what}");
        assert!(verdict["findings"].as_array().expect("a list").len() < 6, "{what}: {verdict}");
    }
    // The dry run under the program's own name is not the program, nor the other way round.
    std::fs::write(bench.out().join("MZ04-01-A.001"), &dry).expect("writes");
    assert_eq!(bench.verify("MZ04-01-A.001").0, Some(3));
}

#[test]
fn what_is_left_behind_a_stop_is_the_program_s_own() {
    let bench = Bench::new(&["--dialect", "csv"]);
    let all = bench.planned(&[]);
    let (whole, path) = (bench.text("program.csv"), bench.text("path.csv"));
    let report = bench.planned(&["--from-pass", "2"]);
    assert_eq!(report["from_pass"], 2);
    let count = |report: &Value, key: &str| report[key].as_u64().expect("a count");
    assert_eq!(count(&report, "passes"), count(&all, "passes") - 2);
    let rows = bench.text("path.csv");
    let left: Vec<&str> = path.lines().skip(1).filter(|l| !l.starts_with("0,") && !l.starts_with("1,")).collect();
    assert_eq!(rows.lines().skip(1).collect::<Vec<_>>(), left, "rows keep their numbers");
    assert_eq!(count(&report, "points"), left.len() as u64);
    let (whole, left) = (acts(&whole), acts(&bench.text("program_P2.csv")));
    assert_eq!(behind_the_way_in(&left, 0), behind_the_way_in(&whole, 0), "lit from pass 2 on as it was");
    assert!(left.len() < whole.len());
    let zero = bench.planned(&["--from-pass", "0"]);
    for key in ["air_mm", "time_s", "work_mm"] {
        let of = |report: &Value| report[key].as_f64().expect("a figure");
        assert!((of(&zero) - of(&all)).abs() < 1e-6, "{key}: all is left from the first pass on");
    }
}

/// The rows of a table, without their numbers.
fn acts(text: &str) -> Vec<String> {
    let rows = text.lines().filter(|l| !l.starts_with('#') && l.contains(','));
    rows.map(|l| l.split_once(',').expect("cells").1.to_owned()).collect()
}

/// The rows from where the first output of pass 2 goes on, and so many before it.
fn behind_the_way_in(rows: &[String], before: usize) -> &[String] {
    let begin = rows.iter().position(|l| l.contains("\"pass 2, surface")).expect("the pass begins");
    let on = rows[begin..].iter().position(|l| l.starts_with("output,") && l.ends_with(",1,")).expect("lit");
    &rows[begin + on - before..]
}

#[test]
fn what_is_left_begins_with_the_lead_in() {
    let bench = Bench::new(&[]);
    let job = "[part]\nfile = \"cube.stl\"\n[clean]\nsurfaces = [1, 2, 3, 4, 5, 6]\n[layers]\nspacing_mm = 2.0\n\
        direction = \"z\"\n[path]\nlead_in_mm = 2.0\n[cell]\ndialect = \"csv\"\n";
    let file = bench.folder.path().join("lead.toml");
    std::fs::write(&file, job).expect("writes");
    for variant in [&[][..], &["--from-pass", "2"]] {
        let output = run(&[&["plan", &shown(&file), "--out", &shown(&bench.out())], variant].concat());
        assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    }
    let (whole, left) = (acts(&bench.text("program.csv")), acts(&bench.text("program_P2.csv")));
    let (whole, left) = (behind_the_way_in(&whole, 1), behind_the_way_in(&left, 1));
    assert!(whole[0].starts_with("move,linear") && whole == left, "{} and {}", whole[0], left[0]);
    assert_eq!(bench.verify("program_P2.csv").0, Some(0));
}

#[test]
fn a_pass_that_is_not_there_is_refused_with_those_that_are() {
    let bench = Bench::new(&[]);
    let passes = bench.planned(&[])["passes"].as_u64().expect("a count");
    let before = bench.files();
    let output = bench.plan(&["--from-pass", &passes.to_string()]);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(&format!("passes 0 to {}", passes - 1)), "{said}");
    assert_eq!(bench.files(), before);
    assert_eq!(bench.plan(&["--from-pass", "-1"]).status.code(), Some(2));
}

#[test]
fn a_program_that_lacks_passes_at_its_end_is_never_taken_for_another() {
    for (options, [whole, _, left, _]) in [NAMES[0], NAMES[1]] {
        // Both runs over a surface are alike: without the second the first is no whole program.
        let bench = Bench::new(&[options, &["--passes", "2"]].concat());
        bench.planned(&[]);
        bench.planned(&["--from-pass", "2"]);
        for name in [whole, left] {
            let text = bench.text(name);
            let lines: Vec<&str> = text.lines().collect();
            let last = lines.iter().rposition(|l| l.contains("pass ")).expect("a pass");
            // Without the last pass, home and off as before.
            let off = (last..lines.len()).rev().filter(|i| lines[*i].contains("O3") || lines[*i].contains("$OUT[3]"));
            let tail = off.take(2).last().expect("two times off");
            let cut = [&lines[..last], &lines[tail..]].concat().join("\n") + "\n";
            std::fs::write(bench.out().join(name), cut).expect("writes");
            let (status, verdict) = bench.verify(name);
            assert_eq!(status, Some(3), "{name}: {verdict}");
        }
    }
}

#[test]
fn a_dry_run_that_was_changed_by_hand_does_not_stand_in_the_program_s_way() {
    let bench = Bench::new(&[]);
    bench.planned(&["--dry-run"]);
    std::fs::write(bench.out().join("MZ04-01-A.401"), "by hand").expect("writes");
    bench.planned(&[]);
    assert_eq!(bench.text("MZ04-01-A.401"), "by hand", "it is not touched");
    let output = bench.plan(&["--dry-run"]);
    assert_eq!((output.status.code(), said(&output).contains("changed by hand")), (Some(1), true), "{}", said(&output));
    let output = bench.plan(&["--speed", "5"]);
    assert_eq!(output.status.code(), Some(1), "nor removed unasked: {}", said(&output));
    bench.planned(&["--speed", "5", "--overwrite"]);
    assert!(!bench.files().contains_key("MZ04-01-A.401"));
}
