//! `verify` on the command line: files that a program was made from and that have changed, and programs that cannot be
//! compared.

use clearbeam::sample::{solids, stl_bytes};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

struct Folder(tempfile::TempDir);

impl Folder {
    /// A cube, a cell and a head of its own, and the export of one of its sides.
    fn exported(dialect: &str) -> Folder {
        let folder = Folder(tempfile::tempdir().expect("a folder"));
        std::fs::write(folder.path("part.stl"), stl_bytes(&solids::cube(8.0))).expect("writes");
        let cell = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/cells/mz04.toml");
        std::fs::copy(cell, folder.path("cell.toml")).expect("copies");
        std::fs::write(folder.path("head.toml"), HEAD).expect("writes");
        let [part, cell, head, out] = ["part.stl", "cell.toml", "head.toml", "out"].map(|n| folder.named(n));
        let mut arguments = vec!["plan", &part, "--surfaces", "3", "--spacing", "4", "--out", &out];
        arguments.extend(["--cell", &cell, "--head", &head, "--dialect", dialect]);
        let planned = run(&arguments);
        assert!(matches!(planned.status.code(), Some(0 | 3)), "{}", said(&planned));
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn named(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    /// Puts something in place of words of a file.
    fn edit(&self, name: &str, was: &str, is: &str) {
        let text = std::fs::read_to_string(self.path(name)).expect("reads");
        assert!(text.contains(was), "{name}: {was}");
        std::fs::write(self.path(name), text.replace(was, is)).expect("writes");
    }

    fn verify(&self, program: &str, more: &[&str]) -> Output {
        let (program, job) = (self.named(program), self.named("out/job.toml"));
        let mut arguments = vec!["verify", &program, "--job", &job];
        arguments.extend(more);
        run(&arguments)
    }
}

const HEAD: &str = "[[part]]\nfrom_mm = 60\nto_mm = 120\nr0_mm = 20\nr1_mm = 20\n";
const PROGRAM: &str = "out/MZ04-01-A.001";

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_clearbeam")).args(arguments).output().expect("runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {}", said(output)))
}

#[test]
fn files_that_changed_are_named_before_anything_is_compared() {
    let folder = Folder::exported("nachi");
    let report: Value =
        serde_json::from_slice(&std::fs::read(folder.path("out/report.json")).expect("a report")).expect("JSON");
    let kinds: Vec<&str> =
        report["inputs"].as_array().expect("inputs").iter().filter_map(|i| i["kind"].as_str()).collect();
    assert_eq!(kinds, ["part", "cell", "head"]);
    let clean = folder.verify(PROGRAM, &[]);
    assert_eq!(clean.status.code(), Some(0), "{}", said(&clean));
    assert!(said(&clean).ends_with("nothing found\n") && !said(&clean).contains("report.json"), "{}", said(&clean));

    // Another word in the head, and another home in the cell: one acts, and both are named.
    folder.edit("head.toml", "to_mm = 120", "to_mm = 121");
    folder.edit("cell.toml", "[0.0, 90.0, 0.0, 0.0, 0.0, 0.0]", "[0.0, 80.0, 0.0, 0.0, 0.0, 0.0]");
    let changed = folder.verify(PROGRAM, &[]);
    let text = String::from_utf8_lossy(&changed.stdout).into_owned();
    assert_eq!(changed.status.code(), Some(3), "{}", said(&changed));
    let at = |words: &str| text.find(words).unwrap_or_else(|| panic!("{words}: {text}"));
    assert!(at("cell.toml: the cell has changed") < at("head.toml: the head has changed"));
    assert!(at("head.toml: the head has changed") < at("nachi: "), "{text}");
    assert!(text.contains("J2 stands at 90.000\u{b0}, the plan has 80.000\u{b0}"), "{text}");
    let answer = json(&folder.verify(PROGRAM, &["--json"]));
    assert_eq!((&answer["inputs"][1]["kind"], &answer["inputs"][1]["name"]), (&"head".into(), &"head.toml".into()));
    assert_eq!(answer["inputs"][1]["was"], report["inputs"][2]["sha256"]);
    assert!(answer["inputs"][1]["is"].as_str().is_some_and(|s| s.len() == 64) && answer["inputs_recorded"] == true);

    // Elsewhere without a report, nobody knows; the part is known by the job all the same.
    std::fs::remove_file(folder.path("out/report.json")).expect("goes");
    std::fs::write(folder.path("part.stl"), stl_bytes(&solids::cube(8.5))).expect("writes");
    let unknown = folder.verify(PROGRAM, &[]);
    assert_eq!(unknown.status.code(), Some(3), "{}", said(&unknown));
    assert!(said(&unknown).contains("no report.json with this program"), "{}", said(&unknown));
    assert!(said(&unknown).contains("part.stl: the part has changed"), "{}", said(&unknown));
    assert!(said(&unknown).contains("nachi: "), "compared on: {}", said(&unknown));
}

#[test]
fn what_cannot_be_compared_is_told_by_its_line_and_without_figures() {
    let folder = Folder::exported("nachi");
    let head = "/JOB\n//NAME CLEAN\n//POS\n";
    let groups = format!("{head}///NPOS 1,0,0,1,0,0\n///TOOL 0\n///POSTYPE PULSE\n///PULSE\nC00000=0,0,0,0,0,0\n");
    let pulses =
        format!("{head}///NPOS 1,0,0,0,0,0\n///TOOL 0\n///POSTYPE PULSE\n///PULSE\nC00000=0,0,0,0,0,0\n//INST\n");
    let user = format!("{head}///NPOS 1,0,0,0,0,0\n///USER 1\n///TOOL 0\n///POSTYPE USER\n///RECTAN\n");
    let two = "/PROG CLEAN\n/ATTR\nLINE_COUNT = 1;\nDEFAULT_GROUP = 1,1,*,*,*;\n/MN\n   1:J P[1] 10% FINE ;\n/POS\nP[1]{\n   \
               GP1:\n\tUF : 0, UT : 0,\n\tJ1= 0.0 deg,\tJ2= 0.0 deg,\tJ3= 0.0 deg,\n\tJ4= 0.0 deg,\tJ5= 0.0 deg,\tJ6= 0.0 deg\n   \
               GP2:\n\tUF : 0, UT : 0,\n\tJ1= 0.0 deg\n};\n/END\n";
    for (name, text, line, words) in [
        ("groups.JBI", groups.as_str(), 4, "///NPOS 1,0,0,1,0,0"),
        ("pulses.JBI", &pulses, 8, "yaskawa.pulses_per_deg in the cell file"),
        ("user.JBI", &user, 5, "///USER 1"),
        ("two.LS", two, 13, "a second group of axes"),
    ] {
        std::fs::write(folder.path(name), text).expect("writes");
        let output = folder.verify(name, &[]);
        let told = said(&output);
        assert_eq!(output.status.code(), Some(3), "{name}: {told}");
        assert!(told.contains(&format!("{name}, line {line}: ")) && told.contains(words), "{name}: {told}");
        assert!(!told.contains("--robot") && !told.contains("furthest"), "{name}: {told}");
        let answer = json(&folder.verify(name, &["--json"]));
        assert!(answer["worst_mm"].is_null() && answer["worst_deg"].is_null() && answer["proof"].is_null(), "{answer}");
    }
    // It can be read, and the plan has no robot to be written so.
    let home = "/JOB\n//NAME CLEAN\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\nEND\n";
    std::fs::write(folder.path("CLEAN.JBI"), home).expect("writes");
    let output = folder.verify("CLEAN.JBI", &[]);
    let told = said(&output);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("yaskawa") && told.contains("[cell]") && !told.contains("--robot"), "{told}");
}
