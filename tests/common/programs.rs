//! Programs that no planner made, and whether what was read is what was written.
#![allow(dead_code, reason = "each test file uses its own share")]

use clearbeam::beam::ProcessSettings;
use clearbeam::cell::{Robot, Setup};
use clearbeam::program::dialect::{Goal, ReadContext, ReadLine, Statement};
use clearbeam::program::{
    Comment, Dialect, Interpolation, Move, MoveTiming, Program, ProgramFile, ProgramLine, ReadError,
};
use clearbeam::text::program_comment;
use proptest::prelude::*;
use std::f64::consts::PI;

/// Dialects with tests of their own, in `more_dialects.rs`; `dialects.rs` has all others, whichever there are.
pub const IN_MORE: [&str; 4] = ["kuka", "abb", "yaskawa", "estun"];

/// The shipped cell with that robot.
pub fn setup(robot: Option<&str>) -> Setup {
    let mut setup = Setup::shipped().expect("the shipped cell");
    setup.robot = robot.map(|key| Robot::load(key, None).expect("a shipped robot"));
    setup.cell.nachi.analogue = "AOUT {n},{v}".into();
    setup.cell.nachi.group = "GOUT {n},{v}".into();
    setup
}

/// What a line is made of, before a robot makes poses of it.
#[derive(Clone, Debug)]
pub enum Seed {
    Comment(String),
    Output(u32, bool),
    OutputValue(u32, f64, bool),
    Wait(f64),
    Move { joints: [f64; 6], linear: bool, timing: MoveTiming, home: bool },
}

fn seed() -> impl Strategy<Value = Seed> {
    let joints = prop::array::uniform6(-1.0..1.0f64);
    // Straight moves in per cent are made by nobody.
    let timing = prop_oneof![
        (0.001..40.0f64).prop_map(MoveTiming::Seconds),
        (1..100u32).prop_map(|p| MoveTiming::Percent(p.into()))
    ];
    prop_oneof![
        1 => "[ -!#-:<-~é]{0,50}".prop_map(Seed::Comment),
        2 => (1..9u32, any::<bool>()).prop_map(|(n, on)| Seed::Output(n, on)),
        1 => (1..9u32, 0..1000u32, any::<bool>()).prop_map(|(n, v, group)| Seed::OutputValue(n, f64::from(v), group)),
        1 => (1..1000u32).prop_map(|hundredths| Seed::Wait(f64::from(hundredths) / 100.0)),
        8 => (joints, any::<bool>(), timing, prop::bool::weighted(0.1)).prop_map(|(joints, linear, timing, home)| {
            let linear = linear && !home && matches!(timing, MoveTiming::Seconds(_));
            Seed::Move { joints, linear, timing, home }
        }),
    ]
}

/// Any list of lines.
pub fn seeds() -> impl Strategy<Value = Vec<Seed>> {
    prop::collection::vec(seed(), 0..60)
}

/// The lines of a setup: joints and poses agree, as a planner's do.
pub fn lines(seeds: &[Seed], setup: &Setup) -> Vec<ProgramLine> {
    let known = setup.robot.is_some();
    let arm = setup.robot.clone().unwrap_or_else(|| Robot::load("mz04", None).expect("shipped"));
    let mut lit = false;
    let line = |s: &Seed| match s {
        Seed::Comment(text) => ProgramLine::Comment(comment(text)),
        Seed::Output(number, on) => {
            lit = if *number == setup.cell.outputs.laser.number { *on } else { lit };
            ProgramLine::Output { number: *number, on: *on }
        }
        Seed::OutputValue(number, value, group) => {
            ProgramLine::OutputValue { number: *number, value: *value, group: *group }
        }
        Seed::Wait(s) => ProgramLine::Wait(*s),
        Seed::Move { joints, linear, timing, home } => {
            let joints: [f64; 6] = std::array::from_fn(|i| {
                let [low, high] = arm.limits_deg[i];
                0.5 * (low + high) + 0.5 * (high - low) * joints[i]
            });
            let flange = arm.forward(&joints);
            ProgramLine::Move(Box::new(Move {
                interpolation: if *linear { Interpolation::Linear } else { Interpolation::Joint },
                base_from_flange: (known || !home).then_some(flange),
                joints_deg: (known || *home).then_some(joints),
                part_from_focus: (!home).then(|| setup.focus_for(&flange)),
                timing: *timing,
                lit,
                at_work: lit,
                target: None,
                settings: ProcessSettings::default(),
            }))
        }
    };
    seeds.iter().map(line).collect()
}

/// A comment of any text, as [`words`] says it.
pub fn comment(text: &str) -> Comment {
    Comment::Part(text.into())
}

/// The words of a comment: of [`comment`] its text alone.
pub fn words(comment: &Comment) -> String {
    if let Comment::Part(text) = comment { text.clone() } else { program_comment(comment) }
}

/// The text of a line that is such a comment.
pub fn text_of(line: &ProgramLine) -> Option<&str> {
    if let ProgramLine::Comment(Comment::Part(text)) = line { Some(text) } else { None }
}

/// Writes.
pub fn written(dialect: &dyn Dialect, head: &[&str], lines: &[ProgramLine], setup: &Setup) -> Vec<ProgramFile> {
    let head = head.iter().map(|t| comment(t)).collect();
    let files = dialect.write(&Program { head, lines: lines.to_vec(), setup, wording: words }).expect("writes");
    for file in &files {
        assert!(file.text.is_ascii(), "{}", file.name);
        let is_minus_zero = |n: &str| {
            n.strip_prefix('-').is_some_and(|r| r.starts_with('0') && r.bytes().all(|b| b == b'0' || b == b'.'))
        };
        let code = file.text.lines().filter(|l| !l.contains(['!', '#', '"']));
        for line in code {
            assert!(!line.split([',', '(', ')', '=', ' ', '[', ']']).any(is_minus_zero), "{line}");
        }
    }
    files
}

/// Reads the first file, and the others where they are called.
pub fn read(dialect: &dyn Dialect, files: &[ProgramFile], setup: &Setup) -> Result<Vec<ReadLine>, ReadError> {
    let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    dialect.read(&files[0], &ReadContext { setup, open: &open })
}

/// How far a dialect's decimals may carry a number.
pub struct Rounding {
    pub mm: f64,
    pub deg: f64,
    pub seconds: f64,
    pub percent: f64,
    /// Above this many seconds a dialect is coarser; then so many.
    pub long: (f64, f64),
}

/// What the decimals of each dialect promise.
pub fn rounding(dialect: &str) -> Rounding {
    let fine = Rounding { mm: 0.0015, deg: 0.0001, seconds: 0.5001e-4, percent: 1e-4, long: (f64::INFINITY, 0.0) };
    match dialect {
        "csv" => Rounding { mm: 1e-6, deg: 1e-6, seconds: 1e-6, percent: 1e-6, ..fine },
        // Whole milliseconds, above 32 s tenths.
        "fanuc" => Rounding { seconds: 0.5001e-3, long: (32.0, 0.05001), ..fine },
        _ => fine,
    }
}

/// Why what was read is not what was written; `None`: it is.
pub fn difference(dialect: &str, lines: &[ProgramLine], found: &[ReadLine], setup: &Setup) -> Option<String> {
    let r = rounding(dialect);
    let acts: Vec<&Statement> =
        found.iter().map(|l| &l.what).filter(|w| !matches!(w, Statement::Comment(_) | Statement::Other(_))).collect();
    let meant: Vec<&ProgramLine> = lines.iter().filter(|l| !matches!(l, ProgramLine::Comment(_))).collect();
    if acts.len() != meant.len() {
        return Some(format!("{} lines of {}", acts.len(), meant.len()));
    }
    let wrong = |(line, read): &(&ProgramLine, &Statement)| match (line, read) {
        (ProgramLine::Output { number, on }, Statement::Output { number: n, on: o }) => number != n || on != o,
        (
            ProgramLine::OutputValue { number, value, group },
            Statement::OutputValue { number: n, value: v, group: g },
        ) => number != n || (value - v).abs() > 1e-3 || group != g,
        (ProgramLine::Wait(s), Statement::Wait(found)) => (s - found).abs() > 1e-9,
        (ProgramLine::Move(m), Statement::Move(found)) => {
            let off = match (m.timing, found.timing) {
                (MoveTiming::Seconds(a), MoveTiming::Seconds(b)) => {
                    (a - b).abs() > if a > r.long.0 { r.long.1 } else { r.seconds }
                }
                (MoveTiming::Percent(a), MoveTiming::Percent(b)) => (a - b).abs() > r.percent,
                _ => true,
            };
            off || m.interpolation != found.interpolation || is_elsewhere(m, &found.goal, &r, setup)
        }
        _ => true,
    };
    let pairs = meant.into_iter().zip(acts);
    pairs.filter(wrong).map(|(line, read)| format!("{line:?} was read as {read:?}")).next()
}

fn is_elsewhere(m: &Move, goal: &Goal, r: &Rounding, setup: &Setup) -> bool {
    let pose = match goal {
        Goal::Joints(joints) => {
            let meant = m.joints_deg.expect("joints are written where they are known");
            return joints.iter().zip(meant).any(|(a, b)| (a - b).abs() > r.deg);
        }
        Goal::Flange(pose) => *pose,
        Goal::Focus(focus) => setup.flange_for(focus),
    };
    let meant = m.base_from_flange.expect("a pose is written where it is known");
    let off = (pose.translation.vector - meant.translation.vector).norm();
    // Three angles, each rounded.
    off > r.mm || pose.rotation.angle_to(&meant.rotation) * 180.0 / PI > 3.0 * r.deg
}

/// All comments, without blanks.
pub fn said(found: &[ReadLine]) -> String {
    let texts = found.iter().filter_map(|l| if let Statement::Comment(t) = &l.what { Some(t.as_str()) } else { None });
    texts.flat_map(|t| t.chars()).filter(|c| !c.is_whitespace()).collect()
}

/// A text with bytes changed (0), put in (1) or taken out: its place, the byte, and which of these. The shortest
/// program has no more bytes than there are edits.
pub fn damaged(text: &str, edits: &[(prop::sample::Index, u8, u8)]) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for (at, byte, kind) in edits {
        let place = (!bytes.is_empty()).then(|| at.index(bytes.len()));
        match (kind, place) {
            (0, Some(at)) => bytes[at] = *byte,
            (1, at) => bytes.insert(at.unwrap_or(0), *byte),
            (_, Some(at)) => {
                bytes.remove(at);
            }
            (_, None) => {}
        }
    }
    String::from_utf8(bytes).expect("ASCII")
}
