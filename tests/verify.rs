//! A program that was corrupted is caught; the one that was written is clean.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::cell::{Mount, Robot, Setup};
use clearbeam::planning::verify::{DifferenceKind, MOST_OFF_MM, Verdict, VerifyError, check};
use clearbeam::program::{Comment, Program, ProgramFile, dialects, lines};
use clearbeam::text::{Sentence as _, program_comment};
use parts::{Planned, job, on, part, planned_in, sample};
use proptest::prelude::*;
use std::sync::LazyLock;

struct Case {
    planned: Planned,
    setup: Setup,
    files: Vec<ProgramFile>,
}

/// A plan for a dialect, and its program. `None`: the dialect cannot be written without a robot.
fn case(robot: &str, dialect: &str, mount: Mount) -> Option<Case> {
    let mut setup = Setup::shipped().expect("shipped");
    if !robot.is_empty() {
        setup = Setup { robot: Some(Robot::load(robot, None).expect("shipped")), ..setup };
        setup.mount = mount;
    }
    dialects::check(dialect, &setup).ok()?;
    let mut job = on(job("z", 9.0), &[1, 2]);
    job.cell.dialect = dialect.into();
    let planned = planned_in(part(&sample("workpiece")), job, &setup);
    let lines = lines(&planned.plan.steps, &setup);
    let program =
        Program { head: vec![Comment::Part("a test".into())], lines, setup: &setup, wording: program_comment };
    let files = dialects::by_name(dialect).expect("a dialect").write(&program).expect("writes what is planned");
    Some(Case { planned, setup, files })
}

impl Case {
    fn verdict(&self, files: &[ProgramFile]) -> Result<Verdict, VerifyError> {
        let p = &self.planned;
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        check(&p.part, &p.plan, &self.setup, &p.job, &files[0], &open, true).map(|(_, v)| v)
    }

    /// The program with one file's text changed.
    fn changed(&self, file: usize, text: String) -> Vec<ProgramFile> {
        let mut files = self.files.clone();
        files[file].text = text;
        files
    }
}

static NACHI: LazyLock<Case> = LazyLock::new(|| case("mz04", "nachi", Mount::PartInHand).expect("writes"));

#[test]
fn what_was_written_is_clean_in_every_dialect() {
    for dialect in dialects::DIALECTS {
        let without = ["nachi", "abb", "fanuc", "ur", "csv"].contains(&dialect.name());
        let cases =
            [("", Mount::PartInHand, without), ("mz04", Mount::PartInHand, true), ("mz04", Mount::ToolInHand, true)];
        for (robot, mount, writes) in cases {
            let Some(case) = case(robot, dialect.name(), mount) else {
                assert!(!writes, "{} {robot}", dialect.name());
                continue;
            };
            let verdict = case.verdict(&case.files).expect("reads");
            assert_eq!(verdict.findings, [], "{} {robot}", dialect.name());
            assert!(verdict.moves > 100 && verdict.lit_moves > 50, "{} {robot}", dialect.name());
            assert!(verdict.worst_mm <= MOST_OFF_MM, "{}: {} mm", dialect.name(), verdict.worst_mm);
        }
    }
}

#[test]
fn another_text_is_told_apart() {
    let mut files = NACHI.files.clone();
    files[0].text = "a letter to a friend\n".into();
    let said = NACHI.verdict(&files).expect_err("no program").sentence();
    assert!(said.contains("no program of any dialect") && said.contains("nachi"), "{said}");
}

fn edited(text: &str, line: usize, edit: impl FnOnce(&str) -> String) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines[line] = edit(&lines[line]);
    lines.join("\n") + "\n"
}

/// First line that begins so.
fn line_with(text: &str, start: &str, skip: usize) -> usize {
    text.lines().enumerate().filter(|(_, l)| l.starts_with(start)).nth(skip).expect("such a line").0
}

#[test]
fn each_kind_of_change_is_named() {
    let text = &NACHI.files[0].text;
    let lit = line_with(text, "SET O3", 0) + 1;
    let kinds = |changed: String| -> Vec<DifferenceKind> {
        let verdict = NACHI.verdict(&NACHI.changed(0, changed)).expect("reads");
        verdict.findings.iter().map(|f| f.kind).collect()
    };
    // A joint turned by a degree.
    let bent = kinds(edited(text, lit, |l| {
        let (head, rest) = l.split_once(",(").expect("joints");
        let (first, rest) = rest.split_once(',').expect("joints");
        format!("{head},({:.4},{rest}", first.parse::<f64>().expect("a number") + 1.0)
    }));
    assert!(bent.contains(&DifferenceKind::Deviation), "{bent:?}");
    // Twice as slow.
    let slow = kinds(edited(text, lit, |l| {
        let (head, rest) = l.split_once(",T=").expect("a time");
        let (time, rest) = rest.split_once(',').expect("more");
        format!("{head},T={:.4},{rest}", 2.0 * time.parse::<f64>().expect("a number"))
    }));
    assert_eq!(slow, [DifferenceKind::Time]);
    // So fast that no joint can follow.
    let fast = kinds(edited(text, lit, |l| {
        let (head, rest) = l.split_once(",T=").expect("a time");
        let (_, rest) = rest.split_once(',').expect("more");
        format!("{head},T=0.0010,{rest}")
    }));
    assert!(fast.contains(&DifferenceKind::Time) && fast.contains(&DifferenceKind::Speed), "{fast:?}");
    // The laser on where it must not be.
    let off = line_with(text, "RESET O3", 1);
    assert!(kinds(edited(text, off, |_| "SET O3".into())).contains(&DifferenceKind::Setting));
    let home = line_with(text, "MOVEX", 0);
    let on = kinds(edited(text, home, |l| format!("SET O3\n{l}\nRESET O3")));
    assert!(on.contains(&DifferenceKind::Extra) && on.contains(&DifferenceKind::Interference), "{on:?}");
    // A line gone, a line twice, the end gone.
    let mut lines: Vec<&str> = text.lines().collect();
    lines.remove(lit);
    assert_eq!(kinds(lines.join("\n") + "\n"), [DifferenceKind::Missing]);
    let mut lines: Vec<&str> = text.lines().collect();
    lines.insert(lit, lines[lit]);
    assert!(kinds(lines.join("\n") + "\n").contains(&DifferenceKind::Extra));
    assert_eq!(kinds(text[..text.len() / 2].to_owned()), [DifferenceKind::Unreadable]);
    // Another tool.
    assert_eq!(kinds(edited(text, lit, |l| l.replace(",H=1,", ",H=2,"))), [DifferenceKind::Setting]);
    // A joint beyond its range.
    let beyond = kinds(edited(text, lit, |l| {
        let (head, rest) = l.split_once(",(").expect("joints");
        let (_, rest) = rest.split_once(',').expect("joints");
        format!("{head},(175.0000,{rest}")
    }));
    assert!(beyond.contains(&DifferenceKind::Limit), "{beyond:?}");
}

/// Largest difference of a number in two lines that have the same words.
fn numbers(line: &str) -> Vec<f64> {
    line.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-')).filter_map(|n| n.parse().ok()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    /// A digit changed anywhere but in a comment is caught, unless it is smaller than what is promised:
    /// 0.01 mm, 0.01 degrees, 2 % of a time.
    #[test]
    fn a_changed_digit_is_caught(at in 0.0..1.0f64, by in 1..9u8) {
        let text = &NACHI.files[0].text;
        let digits: Vec<usize> = text.bytes().enumerate().filter(|(_, b)| b.is_ascii_digit()).map(|(i, _)| i).collect();
        let i = digits[(at * digits.len() as f64) as usize];
        let mut bytes = text.clone().into_bytes();
        bytes[i] = b'0' + (bytes[i] - b'0' + by) % 10;
        let changed = String::from_utf8(bytes).expect("ASCII");
        let line = text[..i].matches('\n').count();
        let (was, is) = (text.lines().nth(line).expect("a line"), changed.lines().nth(line).expect("a line"));
        prop_assume!(!was.starts_with("REM"));
        let most = numbers(was).iter().zip(numbers(is)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let caught = NACHI.verdict(&NACHI.changed(0, changed.clone())).map_or(true, |v| !v.findings.is_empty());
        // Joints carry the spot by up to 0.7 m: 0.005 degrees may stay below 0.01 mm and degrees for most
        // joints, never 0.05; times are compared to 2 %.
        let time = was.split_once(",T=").is_some_and(|(head, _)| is.starts_with(head));
        prop_assert!(caught || (if time { most < 0.1 } else { most < 0.05 }), "{was} -> {is}");
    }

    #[test]
    fn a_missing_line_is_caught(at in 0.0..1.0f64) {
        let text = &NACHI.files[0].text;
        let mut lines: Vec<&str> = text.lines().collect();
        let i = (at * lines.len() as f64) as usize;
        // The laser is switched off twice before home: one of them may go.
        let twice = lines[i].starts_with("RESET") && lines.get(i + 1).is_some_and(|l| l.starts_with("RESET"));
        prop_assume!(!lines[i].starts_with("REM") && !twice);
        lines.remove(i);
        let changed = lines.join("\n") + "\n";
        let caught = NACHI.verdict(&NACHI.changed(0, changed)).map_or(true, |v| !v.findings.is_empty());
        prop_assert!(caught, "line {i}");
    }

    #[test]
    fn a_truncated_file_is_caught(at in 0.0..0.999f64) {
        let text = &NACHI.files[0].text;
        let cut = (at * (text.len() - 5) as f64) as usize;
        let caught = NACHI.verdict(&NACHI.changed(0, text[..cut].to_owned())).map_or(true, |v| !v.findings.is_empty());
        prop_assert!(caught, "cut at {cut}");
    }
}
