//! KUKA, ABB, Yaskawa and ESTUN: what is written is read back to where it was planned, as fast; what
//! was cut or changed is refused or differs; and one small program of each is exactly this.

#[path = "common/programs.rs"]
mod programs;

use clearbeam::beam::ProcessSettings;
use clearbeam::cell::{Mount, Robot, Setup};
use clearbeam::program::dialect::{Goal, ReadContext, ReadLine, Statement};
use clearbeam::program::dialects::abb::AbbDialect;
use clearbeam::program::dialects::estun::EstunDialect;
use clearbeam::program::dialects::kuka::KukaDialect;
use clearbeam::program::dialects::yaskawa::YaskawaDialect;
use clearbeam::program::{
    Dialect, Interpolation, Move, MoveTiming, Program, ProgramFile, ProgramLine, ReadError, WriteError,
};
use clearbeam::text::Sentence;
use nalgebra::Isometry3;
use programs::{IN_MORE, comment, damaged, words};
use proptest::prelude::*;

const DIALECTS: [(&dyn Dialect, &str); 4] =
    [(&KukaDialect, "kr6-r900"), (&AbbDialect, "irb120"), (&YaskawaDialect, "gp7"), (&EstunDialect, "mz04")];

#[test]
fn these_are_the_dialects_that_the_other_tests_leave_to_this_file() {
    assert_eq!(DIALECTS.map(|(d, _)| d.name()), IN_MORE);
}

/// Made up; one axis counts the other way.
const PULSES: [f64; 6] = [1341.4, 1341.4, -1341.4, 1000.0, 1000.0, 622.0];

/// Joints (degrees) from which no robot here is far from a straight wrist or its limits.
fn rest(robot: &str) -> [f64; 6] {
    match robot {
        "kr6-r900" => [10.0, -70.0, 100.0, 20.0, 50.0, -30.0],
        "mz04" => [10.0, 60.0, 30.0, 20.0, 50.0, -30.0],
        _ => [10.0, 20.0, 10.0, 20.0, 50.0, -30.0],
    }
}

fn setup(robot: &str, with_robot: bool, mount: Mount) -> Setup {
    let mut setup = Setup::shipped().expect("shipped");
    setup.robot = with_robot.then(|| Robot::load(robot, None).expect("shipped"));
    setup.mount = mount;
    setup.cell.flange_from_part.rz_ry_rx_deg = [20.0, -30.0, 40.0];
    setup.cell.base_from_part.rz_ry_rx_deg = [-15.0, 5.0, 100.0];
    setup.cell.flange_from_tool.rz_ry_rx_deg = [10.0, 35.0, -20.0];
    setup.cell.air.home_joints_deg = rest(robot);
    setup
}

/// A line before there is a robot.
#[derive(Clone, Debug)]
enum Seed {
    Comment(String),
    Output(u32, bool),
    OutputValue(u32, u32, bool),
    Wait(u32),
    /// How far each joint is from rest, and per cent.
    Joint([f64; 6], u32),
    /// The same, and the greatest speeds, mm/s and degrees per second.
    Linear([f64; 6], f64, f64),
}

fn seeds() -> impl Strategy<Value = Vec<Seed>> {
    let away = || prop::array::uniform6(-25.0..25.0f64);
    // The laser is output 3.
    let output = prop_oneof![Just(3u32), 1..9u32];
    let seed = prop_oneof![
        1 => "[ -~é]{0,120}".prop_map(Seed::Comment),
        3 => (output, any::<bool>()).prop_map(|(n, on)| Seed::Output(n, on)),
        1 => (1..9u32, 0..1000u32, any::<bool>()).prop_map(|(n, v, group)| Seed::OutputValue(n, v, group)),
        1 => (0..1000u32).prop_map(Seed::Wait),
        1 => (away(), 1..=100u32).prop_map(|(j, p)| Seed::Joint(j, p)),
        8 => (away(), 0.5..1000.0f64, 1.0..150.0f64).prop_map(|(j, v, w)| Seed::Linear(j, v, w)),
    ];
    prop::collection::vec(seed, 0..60)
}

/// The lines: home, a way in by joints, and what the seeds say.
fn lines(seeds: &[Seed], robot: &str, setup: &Setup) -> Vec<ProgramLine> {
    let arm = Robot::load(robot, None).expect("shipped");
    let known = setup.robot.is_some();
    let home = setup.cell.air.home_joints_deg;
    let mut lit = false;
    let mut at = arm.forward(&home);
    let mut out = vec![ProgramLine::Output { number: 3, on: false }];
    out.push(ProgramLine::Move(Box::new(Move {
        interpolation: Interpolation::Joint,
        base_from_flange: known.then_some(at),
        joints_deg: Some(home),
        part_from_focus: None,
        timing: MoveTiming::Percent(10.0),
        lit: false,
        at_work: false,
        target: None,
        settings: ProcessSettings::default(),
    })));
    let way_in = Seed::Joint([1.0, -2.0, 3.0, -4.0, 5.0, -6.0], 10);
    for seed in std::iter::once(&way_in).chain(seeds) {
        let mut go = |away: &[f64; 6], interpolation, timing: &dyn Fn(f64, f64) -> MoveTiming| {
            let joints: [f64; 6] = std::array::from_fn(|i| home[i] + away[i]);
            let flange = arm.forward(&joints);
            let mm = (flange.translation.vector - at.translation.vector).norm();
            let deg = flange.rotation.angle_to(&at.rotation).to_degrees();
            at = flange;
            ProgramLine::Move(Box::new(Move {
                interpolation,
                base_from_flange: Some(flange),
                joints_deg: known.then_some(joints),
                part_from_focus: Some(setup.focus_for(&flange)),
                timing: timing(mm, deg),
                lit,
                at_work: lit,
                target: None,
                settings: ProcessSettings::default(),
            }))
        };
        out.push(match seed {
            Seed::Comment(text) => ProgramLine::Comment(comment(text)),
            Seed::Output(number, on) => {
                lit = if *number == 3 { *on } else { lit };
                ProgramLine::Output { number: *number, on: *on }
            }
            Seed::OutputValue(number, value, group) => {
                ProgramLine::OutputValue { number: *number, value: f64::from(*value), group: *group }
            }
            Seed::Wait(hundredths) => ProgramLine::Wait(f64::from(*hundredths) / 100.0),
            Seed::Joint(away, percent) => {
                go(away, Interpolation::Joint, &|_, _| MoveTiming::Percent(f64::from(*percent)))
            }
            Seed::Linear(away, mm_s, deg_s) => {
                go(away, Interpolation::Linear, &|mm, deg| MoveTiming::Seconds((mm / mm_s).max(deg / deg_s).max(0.001)))
            }
        });
    }
    out
}

fn written(dialect: &dyn Dialect, lines: &[ProgramLine], setup: &Setup) -> Vec<ProgramFile> {
    let files = dialect
        .write(&Program { head: vec![comment("a head")], lines: lines.to_vec(), setup, wording: words })
        .expect("writes");
    for file in &files {
        assert!(file.text.is_ascii() && file.text.ends_with("\r\n"), "{}", file.name);
        let is_minus_zero =
            |n: &str| n.strip_prefix("-0").is_some_and(|rest| rest.bytes().all(|b| matches!(b, b'0' | b'.')));
        let acts = file.text.lines().filter(|l| !l.trim().starts_with([';', '!', '\'', '/']));
        for line in acts {
            assert!(!line.split([',', '{', '[', ' ', '=', ']', '}']).any(is_minus_zero), "{line}");
        }
    }
    files
}

fn read(dialect: &dyn Dialect, files: &[ProgramFile], setup: &Setup) -> Result<Vec<ReadLine>, ReadError> {
    let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    dialect.read(&files[0], &ReadContext { setup, open: &open })
}

/// How far two poses of the focus in the part are from each other.
fn near(meant: &Isometry3<f64>, found: &Isometry3<f64>) -> bool {
    (meant.translation.vector - found.translation.vector).norm() < 0.01
        && meant.rotation.angle_to(&found.rotation).to_degrees() < 0.01
}

fn same_goal(dialect: &str, m: &Move, goal: &Goal, setup: &Setup, robot: &str) -> bool {
    if let (Goal::Joints(joints), Some(meant), "yaskawa") = (goal, &m.joints_deg, dialect) {
        // Pulses are whole.
        return (0..6).all(|i| (joints[i] - meant[i]).abs() <= 0.5 / PULSES[i].abs() + 1e-9);
    }
    let arm = Robot::load(robot, None).expect("shipped");
    let meant = m.base_from_flange.unwrap_or_else(|| arm.forward(&m.joints_deg.expect("home")));
    let found = match goal {
        Goal::Joints(joints) => setup.focus_for(&arm.forward(joints)),
        Goal::Flange(flange) => setup.focus_for(flange),
        Goal::Focus(focus) => *focus,
    };
    near(&setup.focus_for(&meant), &found)
}

/// Why what was read is not what was written.
fn difference(dialect: &str, robot: &str, lines: &[ProgramLine], found: &[ReadLine], setup: &Setup) -> Option<String> {
    let acts: Vec<&Statement> =
        found.iter().map(|l| &l.what).filter(|r| !matches!(r, Statement::Comment(_) | Statement::Other(_))).collect();
    let meant: Vec<&ProgramLine> = lines.iter().filter(|l| !matches!(l, ProgramLine::Comment(_))).collect();
    if acts.len() != meant.len() {
        return Some(format!("{} lines of {}", acts.len(), meant.len()));
    }
    let mut at: Option<Isometry3<f64>> = None;
    for (line, read) in meant.into_iter().zip(acts) {
        let same = match (line, read) {
            (ProgramLine::Output { number, on }, Statement::Output { number: n, on: o }) => number == n && on == o,
            (
                ProgramLine::OutputValue { number, value, group },
                Statement::OutputValue { number: n, value: v, group: g },
            ) => number == n && value == v && group == g,
            (ProgramLine::Wait(a), Statement::Wait(b)) => (a - b).abs() < 1e-9,
            (ProgramLine::Move(m), Statement::Move(r)) => {
                let same = match (m.timing, r.timing) {
                    (MoveTiming::Percent(a), MoveTiming::Percent(b)) => (a - b).abs() < 1e-4,
                    (MoveTiming::Seconds(a), MoveTiming::Seconds(b)) => {
                        // The rounding of speeds: INFORM has tenths of mm/s and of degrees per second.
                        let (from, to) = (at.expect("a pose before"), m.base_from_flange.expect("known"));
                        let mm = (from.translation.vector - to.translation.vector).norm();
                        let fastest =
                            (mm / a).max(from.rotation.angle_to(&to.rotation).to_degrees().min(180.0 * a) / a);
                        let share = match dialect {
                            "yaskawa" => 0.051 / (fastest - 0.05).max(0.05) + 1e-4,
                            "abb" => 0.51e-4 / a,
                            _ => 1e-3,
                        };
                        (a - b).abs() <= a * share + 1e-9
                    }
                    _ => false,
                };
                at = m.base_from_flange.or(at);
                same && m.interpolation == r.interpolation && same_goal(dialect, m, &r.goal, setup, robot)
            }
            _ => false,
        };
        if !same {
            return Some(format!("{line:?} was read as {read:?}"));
        }
    }
    None
}

fn mounts() -> impl Strategy<Value = Mount> {
    prop_oneof![Just(Mount::PartInHand), Just(Mount::ToolInHand)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn what_is_written_is_read(
        seeds in seeds(), mount in mounts(), with_robot in any::<bool>(), pulses in any::<bool>(), height in 0..400u32,
    ) {
        for (dialect, robot) in DIALECTS {
            let mut setup = setup(robot, with_robot, mount);
            // Without a robot home is known to INFORM by pulses only, and after them only a joint move.
            setup.cell.yaskawa.pulses_per_deg =
                (pulses || !with_robot).then_some(PULSES);
            setup.cell.yaskawa.base_height_mm = f64::from(height);
            let lines = lines(&seeds, robot, &setup);
            let files = written(dialect, &lines, &setup);
            prop_assert!(dialect.claims(&files[0].text));
            let found = read(dialect, &files, &setup);
            prop_assert!(found.is_ok(), "{}: {:?}\n{}", dialect.name(), found, files[0].text);
            let off = difference(dialect.name(), robot, &lines, &found.unwrap_or_default(), &setup);
            prop_assert!(off.is_none(), "{}: {}\n{}", dialect.name(), off.unwrap_or_default(), files[0].text);
        }
    }

    #[test]
    fn subprograms_are_read_where_they_are_called(seeds in prop::collection::vec(seeds(), 12)) {
        let seeds: Vec<Seed> = seeds.concat();
        for (dialect, robot) in DIALECTS {
            let mut setup = setup(robot, true, Mount::PartInHand);
            let c = &mut setup.cell;
            (c.kuka.max_lines, c.abb.max_moves, c.yaskawa.max_lines) = (100, 50, 100);
            let lines = lines(&seeds, robot, &setup);
            let files = written(dialect, &lines, &setup);
            let found = read(dialect, &files, &setup);
            prop_assert!(found.is_ok(), "{}: {:?}", dialect.name(), found);
            let off = difference(dialect.name(), robot, &lines, &found.unwrap_or_default(), &setup);
            prop_assert!(off.is_none(), "{}: {}", dialect.name(), off.unwrap_or_default());
        }
    }

    /// Cut anywhere before its last word is whole, a program is refused.
    #[test]
    fn a_cut_program_is_refused(seeds in seeds(), at in 0.0..1.0f64) {
        for (dialect, robot) in DIALECTS {
            let setup = setup(robot, true, Mount::ToolInHand);
            let mut files = written(dialect, &lines(&seeds, robot, &setup), &setup);
            let whole = files[0].text.trim_end().len();
            files[0].text.truncate((at * whole as f64) as usize);
            let found = read(dialect, &files, &setup);
            prop_assert!(found.is_err(), "{}: {}", dialect.name(), files[0].text);
        }
    }

    /// A line that is missing is refused, or misses in what was read.
    #[test]
    fn a_missing_line_is_seen(seeds in seeds(), which in any::<prop::sample::Index>()) {
        for (dialect, robot) in DIALECTS {
            let setup = setup(robot, true, Mount::PartInHand);
            let mut files = written(dialect, &lines(&seeds, robot, &setup), &setup);
            let before = read(dialect, &files, &setup).expect("whole");
            let mut kept: Vec<&str> = files[0].text.lines().collect();
            let gone = kept.remove(which.index(kept.len())).to_string();
            files[0].text = kept.join("\n");
            let same = read(dialect, &files, &setup)
                .is_ok_and(|after| after.iter().map(|l| &l.what).eq(before.iter().map(|l| &l.what)));
            prop_assert!(!same, "{}: {gone}", dialect.name());
        }
    }

    #[test]
    fn nothing_panics(
        seeds in seeds(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0..128u8, 0..3u8), 1..8),
        second in any::<bool>(),
    ) {
        for (dialect, robot) in DIALECTS {
            let setup = setup(robot, true, Mount::PartInHand);
            let mut files = written(dialect, &lines(&seeds, robot, &setup), &setup);
            let which = usize::from(second).min(files.len() - 1);
            files[which].text = damaged(&files[which].text, &edits);
            let _ = read(dialect, &files, &setup);
            for (other, _) in DIALECTS {
                let _ = read(other, &files, &setup);
            }
        }
    }

    #[test]
    fn any_text_is_answered(text in "(\\PC|\\n){0,200}") {
        let file = ProgramFile { name: "a".into(), text };
        for (dialect, robot) in DIALECTS {
            let _ = read(dialect, std::slice::from_ref(&file), &setup(robot, false, Mount::PartInHand));
            let _ = dialect.claims(&file.text);
        }
    }
}

/// A way in, a lit piece of two moves, a turn on the spot, and home.
fn small(robot: &str, setup: &Setup) -> Vec<ProgramLine> {
    let go = |j5: f64, seconds| Seed::Linear([0.0, 0.0, 0.0, 0.0, j5, 0.0], seconds, 90.0);
    let seeds = [
        Seed::OutputValue(1, 500, false),
        Seed::Comment("pass 0, surface 4".into()),
        go(5.0, 100.0),
        Seed::Output(3, true),
        Seed::Wait(50),
        go(6.0, 3.0),
        go(7.0, 3.0),
        Seed::Output(3, false),
        Seed::Linear([0.0, 0.0, 0.0, 0.0, 7.0, 40.0], 100.0, 20.0),
        Seed::Joint([0.0; 6], 10),
    ];
    lines(&seeds, robot, setup)
}

fn all_texts(files: &[ProgramFile]) -> String {
    files.iter().map(|f| format!("=== {}\n{}", f.name, f.text.replace("\r\n", "\n"))).collect()
}

#[test]
fn small_programs_are_this() {
    let cases = [
        ("kuka", "kr6-r900", true, Mount::PartInHand),
        ("abb", "irb120", true, Mount::PartInHand),
        ("abb_tool_in_hand", "irb120", true, Mount::ToolInHand),
        ("yaskawa", "gp7", true, Mount::PartInHand),
        ("yaskawa_pulses", "gp7", true, Mount::PartInHand),
        ("estun", "mz04", false, Mount::PartInHand),
    ];
    for (name, robot, with_robot, mount) in cases {
        let (dialect, _) = DIALECTS.into_iter().find(|(d, _)| name.starts_with(d.name())).expect("one of them");
        let mut setup = setup(robot, with_robot, mount);
        if name.ends_with("pulses") {
            setup.cell.yaskawa.pulses_per_deg = Some([1341.4, 1341.4, 1341.4, 1000.0, 1000.0, 622.0]);
        }
        let files = written(dialect, &small(robot, &setup), &setup);
        insta::assert_snapshot!(format!("{name}_small"), all_texts(&files));
    }
}

#[test]
fn a_dialect_knows_its_own_text_and_no_other() {
    for (dialect, robot) in DIALECTS {
        let setup = setup(robot, true, Mount::PartInHand);
        let files = written(dialect, &small(robot, &setup), &setup);
        for (other, _) in DIALECTS {
            assert_eq!(other.claims(&files[0].text), other.name() == dialect.name());
            assert_eq!(read(other, &files, &setup).is_ok(), other.name() == dialect.name());
        }
    }
    let foreign =
        ["", "/PROG CLEAN\n/ATTR\n", "def clean():\n  movej([0])\nend\n", "REM \"a\"\nSET O3\nEND\n", "x,y\n1,2\n"];
    assert!(foreign.iter().all(|text| DIALECTS.iter().all(|(d, _)| !d.claims(text))));
}

/// With the module's own tool and work object, and no word of the cell, its targets are the flange's
/// poses: the tool stands in the target, seen from the work object.
#[test]
fn rapid_targets_are_where_tool_and_work_object_say() {
    let frame = |text: &str| -> Isometry3<f64> {
        let numbers: Vec<f64> = text.replace(['[', ']'], "").split(',').map(|n| n.parse().expect("a number")).collect();
        let [x, y, z, w, i, j, k] = numbers.try_into().expect("a pose");
        let turn = nalgebra::UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, i, j, k));
        Isometry3::from_parts(nalgebra::Translation3::new(x, y, z), turn)
    };
    let between = |line: &str, from: &str, to: &str| -> Isometry3<f64> {
        let rest = &line[line.find(from).expect("there") + from.len()..];
        frame(&rest[..rest.find(to).expect("there")])
    };
    for mount in [Mount::PartInHand, Mount::ToolInHand] {
        let setup = setup("irb120", true, mount);
        let lines = small("irb120", &setup);
        let text = written(&AbbDialect, &lines, &setup)[0].text.clone();
        let find = |word: &str| text.lines().find(|l| l.contains(word)).expect("there");
        let tool = between(find("tooldata"), "E,", "]],[1.000");
        let part = between(find("wobjdata"), "\"\",", "]],[[0,0,0]");
        let targets = text.lines().filter(|l| l.contains("MoveL ")).map(|l| between(l, "MoveL [", "],[0,0,"));
        let meant = lines.iter().filter_map(|l| match l {
            ProgramLine::Move(m) if m.interpolation == Interpolation::Linear => m.base_from_flange,
            _ => None,
        });
        let holds = find("tooldata").contains(":=[TRUE");
        assert_eq!(holds, mount == Mount::ToolInHand);
        let mut count = 0;
        for (target, meant) in targets.zip(meant) {
            // The robot holds one of the two: base_from_tool = base_from_part * target.
            let flange = if holds { part * target * tool.inverse() } else { tool * target.inverse() * part.inverse() };
            assert!(near(&meant, &flange), "{meant} {flange}");
            count += 1;
        }
        assert_eq!(count, 4);
    }
}

/// 30 lit pieces: a main program calls parts, and no piece is cut.
#[test]
fn long_programs_are_paged() {
    for (dialect, robot) in DIALECTS.into_iter().take(3) {
        let mut setup = setup(robot, true, Mount::PartInHand);
        let c = &mut setup.cell;
        (c.kuka.max_lines, c.abb.max_moves, c.yaskawa.max_lines) = (100, 40, 100);
        let piece = small(robot, &setup);
        let lines: Vec<ProgramLine> = std::iter::repeat_n(piece, 30).flatten().collect();
        let files = written(dialect, &lines, &setup);
        let found = read(dialect, &files, &setup).expect("reads");
        assert_eq!(difference(dialect.name(), robot, &lines, &found, &setup), None);
        let name = dialect.name();
        let calls = match name {
            "kuka" => files[0].text.matches("\r\nclearbeam_").count(),
            "abb" => files[0].text.matches("\r\n    main_").count(),
            _ => files[0].text.matches("CALL JOB:CLEAN").count(),
        };
        assert!(calls >= 4, "{name}: {calls}");
        let longest =
            files.iter().map(|f| f.text.lines().filter(|l| l.contains("LIN ") || l.contains("MOVL")).count()).max();
        assert!(name == "abb" || longest.is_some_and(|l| l <= 100), "{name}: {longest:?}");
        if name == "abb" {
            continue;
        }
        let last = files.iter().rposition(|f| !f.name.ends_with(".dat")).expect("some");
        let gone = read(dialect, &files[..last], &setup);
        assert!(matches!(gone, Err(ReadError::Gone { .. })), "{name}: {gone:?}");
    }
}

#[test]
fn what_a_controller_cannot_take_is_said() {
    let without = setup("gp7", false, Mount::PartInHand);
    let lines = lines(&[], "gp7", &without);
    let program =
        |lines: &[ProgramLine]| Program { head: Vec::new(), lines: lines.to_vec(), setup: &without, wording: words };
    let said = YaskawaDialect.write(&program(&lines)).expect_err("home is unknown").sentence();
    assert!(said.contains("pulses_per_deg") && said.contains("--robot"), "{said}");
    // Straight from home, without knowing where that is.
    let ProgramLine::Move(mut m) = lines[2].clone() else { panic!("the way in") };
    (m.interpolation, m.timing) = (Interpolation::Linear, MoveTiming::Seconds(1.0));
    let straight = [lines[1].clone(), ProgramLine::Move(m)];
    for dialect in [&KukaDialect as &dyn Dialect, &EstunDialect] {
        let said = dialect.write(&program(&straight)).expect_err("no speed");
        assert!(matches!(said, WriteError::FromUnknownPose(name) if name == dialect.name()), "{said}");
        assert!(said.sentence().contains("--robot"), "{}", said.sentence());
    }
    assert!(AbbDialect.write(&program(&straight)).is_ok(), "RAPID has times");
}
