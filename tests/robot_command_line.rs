//! The command line with a robot: options, files, statuses, messages.

use clearbeam::program::dialects;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn sample(name: &str) -> String {
    format!("{}/assets/samples/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

/// Plans the workpiece coarsely with a robot.
fn plan(out: &str, options: &[&str]) -> Output {
    let job = sample("workpiece.toml");
    let mut arguments = vec!["plan", &job, "--spacing", "6", "--out", out, "--robot", "mz04"];
    arguments.extend(options);
    run(&arguments)
}

#[test]
fn joints_csv_follows_path_csv_and_the_report_names_the_cell() {
    let folder = tempfile::tempdir().expect("a folder");
    for mount in ["part-in-hand", "tool-in-hand"] {
        let out = path(folder.path(), mount);
        let output = plan(&out, &["--mount", mount, "--json"]);
        let status = output.status.code();
        assert!(status == Some(0) || status == Some(3), "{}", said(&output));
        let report: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let cell: Vec<&String> = report["cell"].as_object().expect("a cell").keys().collect();
        let frames = if mount == "part-in-hand" {
            ["base_from_laser", "flange_from_part"]
        } else {
            ["base_from_part", "flange_from_tool"]
        };
        assert_eq!(cell, ["robot", "mount", frames[0], frames[1]]);
        assert_eq!((&report["cell"]["robot"], &report["cell"]["mount"]), (&"mz04".into(), &mount.into()));
        assert_eq!(report["cell"][frames[0]].as_array().map(Vec::len), Some(4));

        let read = |name: &str| std::fs::read_to_string(PathBuf::from(&out).join(name)).expect(name);
        let (rows, joints) = (read("path.csv"), read("joints.csv"));
        let mut lines = joints.lines();
        assert_eq!(
            lines.next(),
            Some("pass,point,laser,j1,j2,j3,j4,j5,j6,spin_deg,time_s,singularity,min_limit_margin_deg")
        );
        let reachable = rows.lines().skip(1).filter(|l| !l.contains(",blocked,"));
        let mut last_time = 0.0;
        let mut count = 0;
        for (row, joint) in reachable.zip(lines) {
            let (row, joint): (Vec<&str>, Vec<&str>) = (row.split(',').collect(), joint.split(',').collect());
            assert_eq!((row[0], row[1], row[3]), (joint[0], joint[1], joint[2]));
            assert_eq!(joint.len(), 13);
            let time: f64 = joint[10].parse().expect("a time");
            assert!(time >= last_time);
            last_time = time;
            assert!(joint[12].parse::<f64>().expect("a margin") >= 0.0);
            count += 1;
        }
        assert!(count > 50 && count == joints.lines().count() - 1, "{count} rows");
        assert!(report["time_s"].as_f64().expect("a time") >= last_time);
    }
}

#[test]
fn every_dialect_is_written_and_verified() {
    let folder = tempfile::tempdir().expect("a folder");
    for dialect in dialects::names() {
        let out = path(folder.path(), dialect);
        let output = plan(&out, &["--dialect", dialect]);
        assert!(matches!(output.status.code(), Some(0 | 3)), "{dialect}: {}", said(&output));
        let tables = ["job.toml", "report.json", "path.csv", "joints.csv"];
        let text = String::from_utf8_lossy(&output.stdout);
        let written: Vec<&str> = text.lines().filter_map(|l| l.strip_prefix("wrote ")).collect();
        let program = written.iter().find(|f| tables.iter().all(|t| !f.ends_with(t))).expect("a program");
        let job = path(Path::new(&out), "job.toml");
        let verified = run(&["verify", program, "--job", &job, "--json"]);
        assert_eq!(verified.status.code(), Some(0), "{dialect}: {}", said(&verified));
        let answer: Value = serde_json::from_slice(&verified.stdout).expect("JSON");
        assert_eq!(answer["dialect"], dialect);
        assert_eq!(answer["findings"].as_array().map(Vec::len), Some(0));
        assert!(answer["worst_mm"].as_f64().expect("mm") <= 0.01 && answer["worst_deg"].as_f64().expect("deg") <= 0.01);

        let whole = std::fs::read_to_string(program).expect("text");
        std::fs::write(program, &whole[..whole.len() / 2]).expect("writes");
        let cut = run(&["verify", program, "--job", &job]);
        assert_eq!(cut.status.code(), Some(3), "{dialect}: {}", said(&cut));
    }
}

#[test]
fn bad_input_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = path(folder.path(), "out");
    let cases: &[(&[&str], i32, &str)] = &[
        (&["--robot", "puma560"], 1, "puma560"),
        (&["--dialect", "karel"], 2, "give one of nachi"),
        (&["--mount", "upside-down"], 2, "part-in-hand or tool-in-hand"),
        (&["--spin", "fast"], 2, "free or travel"),
    ];
    for (options, status, words) in cases {
        let job = sample("workpiece.toml");
        let mut arguments = vec!["plan", &job, "--out", &out];
        arguments.extend(*options);
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(*status), "{options:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{options:?}: {}", said(&output));
    }

    let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/robots/mz04.toml");
    let text = std::fs::read_to_string(robots).expect("shipped");
    let mine = path(folder.path(), "mine.toml");
    std::fs::write(&mine, text.replace("c2_mm = 260.0", "c2_mm = 0.26")).expect("writes");
    let output = run(&["plan", &sample("workpiece.toml"), "--out", &out, "--robot", &mine]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("metres instead of mm"), "{}", said(&output));

    let cells = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/cells/mz04.toml");
    let text = std::fs::read_to_string(cells).expect("shipped");
    let cell = path(folder.path(), "cell.toml");
    std::fs::write(&cell, text.replace("position_mm = [380.0, 0.0, 400.0]", "position_mm = [10.0, 0.0, 100.0]"))
        .expect("writes");
    let output = plan(&out, &["--cell", &cell]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(said(&output).contains("inside the robot's base"), "{}", said(&output));

    // Out of reach: everything is refused, and what would help is said.
    std::fs::write(&cell, text.replace("position_mm = [380.0, 0.0, 400.0]", "position_mm = [1500.0, 0.0, 400.0]"))
        .expect("writes");
    let output = plan(&out, &["--cell", &cell]);
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    assert!(said(&output).contains("out of reach") && said(&output).contains("better set-up"), "{}", said(&output));
    let report = std::fs::read(Path::new(&out).join("report.json")).expect("a report");
    let report: Value = serde_json::from_slice(&report).expect("JSON");
    let nothing = &report["findings"][0];
    assert_eq!((&nothing["code"], &nothing["reason"]), (&"nothing_planned".into(), &"all_blocked".into()));
    let blocked = nothing["by"].as_array().expect("a list").iter().filter_map(|b| b["targets"].as_u64()).sum::<u64>();
    assert_eq!(Some(blocked), report["blocked"].as_u64());
    assert!(!Path::new(&out).join("MZ04-01-A.001").exists(), "a program that does nothing is not written");

    let job = path(Path::new(&out), "job.toml");
    let letter = path(folder.path(), "letter.txt");
    std::fs::write(&letter, "dear robot\n").expect("writes");
    let output = run(&["verify", &letter, "--job", &job]);
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("no program of any dialect"), "{}", said(&output));
    let output = run(&["verify", &path(folder.path(), "none.001"), "--job", &job]);
    assert_eq!(output.status.code(), Some(1));
}

/// A robot file of one's own is the shipped one under another name: the same bytes, but for its name.
#[test]
fn a_robot_file_of_ones_own_plans_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let robots = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/robots/mz04.toml");
    let mine = path(folder.path(), "mine.toml");
    std::fs::copy(robots, &mine).expect("copies");
    let cell = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/cells/mz04.toml").display().to_string();
    let job = sample("workpiece.toml");
    let joints = |robot: &str| {
        let out = path(folder.path(), "out");
        let output = run(&["plan", &job, "--spacing", "8", "--out", &out, "--robot", robot, "--cell", &cell]);
        assert!(matches!(output.status.code(), Some(0 | 3)), "{}", said(&output));
        std::fs::read(Path::new(&out).join("joints.csv")).expect("joints.csv")
    };
    assert!(joints("mz04") == joints(&mine));
}
