//! Every dialect reads what it writes, refuses what was cut or changed, and writes one small
//! program exactly so.

#[path = "common/programs.rs"]
mod programs;

use clearbeam::cell::Setup;
use clearbeam::document::{Job, segmented};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::planning::{self, PlanCache};
use clearbeam::program;
use clearbeam::program::dialect::Statement;
use clearbeam::program::dialects::{DIALECTS, by_name, of_text};
use clearbeam::program::{Dialect, MoveTiming, ProgramLine, ReadError, WriteError};
use clearbeam::progress::Progress;
use clearbeam::sample::{solids, stl_bytes};
use clearbeam::text::Sentence;
use programs::{IN_MORE, Seed, damaged, difference, lines, read, said, seeds, setup, text_of, words, written};
use proptest::prelude::*;

/// Those that take any program; `more_dialects.rs` has the others.
fn dialects() -> Vec<&'static &'static dyn Dialect> {
    DIALECTS.iter().filter(|d| !IN_MORE.contains(&d.name())).collect()
}

/// The robot whose controller speaks it.
fn robot_of(dialect: &str) -> &'static str {
    match dialect {
        "fanuc" => "lrmate200id",
        "ur" => "ur5e",
        _ => "mz04",
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn what_is_written_is_read(seeds in seeds(), with_robot in any::<bool>(), pose_form in any::<bool>(), crlf in any::<bool>()) {
        for dialect in dialects() {
            let mut setup = setup(with_robot.then(|| robot_of(dialect.name())));
            let c = &mut setup.cell;
            (c.nachi.crlf, c.fanuc.crlf, c.ur.crlf) = (crlf, crlf, crlf);
            if pose_form {
                c.nachi.form = clearbeam::cell::controllers::NachiForm::Pose;
            }
            let lines = lines(&seeds, &setup);
            let files = written(*dialect, &["a head, \"said\""], &lines, &setup);
            prop_assert_eq!(files.len(), 1);
            let found = read(*dialect, &files, &setup);
            prop_assert!(found.is_ok(), "{}: {:?}\n{}", dialect.name(), found, files[0].text);
            let found = found.unwrap_or_default();
            let off = difference(dialect.name(), &lines, &found, &setup);
            prop_assert!(off.is_none(), "{}: {}\n{}", dialect.name(), off.unwrap_or_default(), files[0].text);
            let meant: String = lines.iter().filter_map(text_of)
                .flat_map(|t| t.chars()).filter(|c| !c.is_whitespace()).collect();
            let told = said(&found).len();
            prop_assert_eq!(told, "ahead,\"said\"".len() + meant.chars().count(), "{}: all is said", dialect.name());
        }
    }

    #[test]
    fn subprograms_are_read_where_they_are_called(seeds in prop::collection::vec(seeds(), 6)) {
        let seeds: Vec<Seed> = seeds.concat();
        for dialect in dialects() {
            let mut setup = setup(Some(robot_of(dialect.name())));
            let c = &mut setup.cell;
            (c.nachi.max_moves, c.ur.max_moves, c.fanuc.max_lines) = (10, 10, 500);
            let lines = lines(&seeds, &setup);
            let files = written(*dialect, &["head"], &lines, &setup);
            let found = read(*dialect, &files, &setup);
            prop_assert!(found.is_ok(), "{}: {:?}", dialect.name(), found);
            let off = difference(dialect.name(), &lines, &found.unwrap_or_default(), &setup);
            prop_assert!(off.is_none(), "{}: {}", dialect.name(), off.unwrap_or_default());
        }
    }

    /// Cut anywhere, a program is refused, or nothing but the last line's end is gone.
    #[test]
    fn a_cut_program_is_refused(seeds in seeds(), at in 0.0..1.0f64) {
        for dialect in dialects() {
            let setup = setup(Some(robot_of(dialect.name())));
            let mut files = written(*dialect, &["head"], &lines(&seeds, &setup), &setup);
            let whole = files[0].text.trim_end().len();
            files[0].text.truncate((at * whole as f64) as usize);
            let found = read(*dialect, &files, &setup);
            prop_assert!(found.is_err(), "{}: {found:?}\n{}", dialect.name(), files[0].text);
        }
    }

    /// A line that is missing is refused, or is missing in what was read.
    #[test]
    fn a_missing_line_is_seen(seeds in seeds(), which in any::<prop::sample::Index>()) {
        for dialect in dialects() {
            let setup = setup(Some(robot_of(dialect.name())));
            let mut files = written(*dialect, &["head"], &lines(&seeds, &setup), &setup);
            let before = read(*dialect, &files, &setup).expect("whole");
            let mut kept: Vec<String> = files[0].text.lines().map(String::from).collect();
            let gone = kept.remove(which.index(kept.len()));
            // What a listing says of its owner moves nothing.
            let idle = dialect.name() == "fanuc" && gone.contains(['=', ',']) && (!gone.contains(':') || gone.starts_with("TCD:")) && !gone.contains("deg") && !gone.contains("DEFAULT_GROUP");
            files[0].text = kept.join("\n");
            let same = read(*dialect, &files, &setup).is_ok_and(|after| {
                after.iter().map(|l| &l.what).eq(before.iter().map(|l| &l.what))
            });
            // Nor does the head of a list of places that has none.
            let moves = before.iter().any(|l| matches!(l.what, Statement::Move(_)));
            let holds_nothing = !moves && gone == "/POS";
            prop_assert!(!same || holds_nothing || (idle && !gone.contains("LINE_COUNT")), "{}: {gone}", dialect.name());
        }
    }

    /// Whatever is done to the bytes, readers answer.
    #[test]
    fn nothing_panics(
        seeds in seeds(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0..128u8, 0..3u8), 1..8),
        reader in any::<prop::sample::Index>(),
    ) {
        for dialect in dialects() {
            let setup = setup(Some(robot_of(dialect.name())));
            let mut files = written(*dialect, &[], &lines(&seeds, &setup), &setup);
            files[0].text = damaged(&files[0].text, &edits);
            let _ = (read(*dialect, &files, &setup), of_text(&files[0].text));
            let _ = read(**reader.get(&dialects()), &files, &setup);
        }
    }

    #[test]
    fn any_text_is_answered(text in "(\\PC|\\n){0,200}") {
        let file = clearbeam::program::ProgramFile { name: "a".into(), text };
        for dialect in dialects() {
            let _ = read(*dialect, std::slice::from_ref(&file), &setup(None));
        }
    }
}

/// A planner's own joints, poses and times: a cube's side in the hand of an MZ04.
#[test]
fn a_planned_program_is_read_as_it_was_meant() {
    let part = Part::from_bytes(&stl_bytes(&solids::cube(8.0)), Units::Mm, &Placement::default(), &[]).expect("a part");
    let mut job = Job::default();
    let surfaces = segmented(&part, &job);
    job.settings.choose(vec![1]);
    job.layers.spacing_mm = 1.5;
    job.layers.direction = "auto".parse().expect("a direction");
    for robot in [None, Some("mz04")] {
        let setup = setup(robot);
        let plan = planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default())
            .expect("a plan");
        let lines = program::lines(&plan.steps, &setup);
        let lit = lines.iter().filter(|l| matches!(l, ProgramLine::Move(m) if m.lit)).count();
        let known = lines.iter().filter(|l| matches!(l, ProgramLine::Move(m) if m.joints_deg.is_some())).count();
        assert!(lit > 5 && (robot.is_none() || known > lit), "{lit} lit moves, {known} with joints");
        for dialect in dialects() {
            let files = written(*dialect, &["head"], &lines, &setup);
            let found = read(*dialect, &files, &setup).unwrap_or_else(|e| panic!("{}: {e}", dialect.name()));
            let off = difference(dialect.name(), &lines, &found, &setup);
            assert!(off.is_none(), "{}: {}", dialect.name(), off.unwrap_or_default());
        }
    }
}

/// One move on the way, one lit, and all the outputs.
fn small() -> Vec<Seed> {
    let go = |joints, linear, timing| Seed::Move { joints, linear, timing, home: false };
    vec![
        Seed::Output(3, false),
        Seed::OutputValue(1, 500.0, false),
        Seed::OutputValue(2, 128.0, true),
        Seed::Move {
            joints: [0.0, 0.1, 0.0, 0.0, 0.0, 0.0],
            linear: false,
            timing: MoveTiming::Percent(10.0),
            home: true,
        },
        Seed::Comment("pass 0, surface 4; a comment that is longer than remarks are".into()),
        go([0.1, 0.1, -0.1, 0.2, 0.3, 0.0], false, MoveTiming::Percent(10.0)),
        go([0.1, 0.1, -0.1, 0.2, 0.31, 0.0], true, MoveTiming::Seconds(0.3107)),
        Seed::Output(3, true),
        Seed::Wait(0.5),
        go([0.1, 0.1, -0.1, 0.2, 0.315, 0.0], true, MoveTiming::Seconds(1.0)),
        go([0.1, 0.1, -0.1, 0.2, 0.32, 0.0], true, MoveTiming::Seconds(1.25)),
        Seed::Output(3, false),
        go([0.1, 0.1, -0.1, 0.2, 0.33, 0.0], true, MoveTiming::Seconds(45.0)),
    ]
}

fn all_texts(dialect: &dyn Dialect, robot: Option<&str>, change: impl Fn(&mut clearbeam::cell::Cell)) -> String {
    let mut setup = setup(robot);
    change(&mut setup.cell);
    let files = written(dialect, &["a small program"], &lines(&small(), &setup), &setup);
    files.iter().map(|f| format!("=== {}\n{}", f.name, f.text)).collect()
}

#[test]
fn each_dialect_writes_exactly_this() {
    for dialect in dialects() {
        let name = dialect.name();
        insta::assert_snapshot!(format!("{name}_small"), all_texts(*dialect, Some(robot_of(name)), |_| {}));
    }
    for name in ["nachi", "fanuc", "ur"] {
        let dialect = by_name(name).expect("there");
        insta::assert_snapshot!(format!("{name}_small_without_robot"), all_texts(dialect, None, |_| {}));
    }
}

#[test]
fn a_dialect_knows_its_own_text_and_no_other() {
    for dialect in dialects() {
        for robot in [None, Some(robot_of(dialect.name()))] {
            let setup = setup(robot);
            let files = written(*dialect, &["head"], &lines(&small(), &setup), &setup);
            assert_eq!(of_text(&files[0].text).map(|d| d.name()), Some(dialect.name()));
            for other in dialects().into_iter().filter(|d| d.name() != dialect.name()) {
                let foreign = read(*other, &files, &setup);
                assert!(foreign.is_err(), "{} reads {}: {foreign:?}", other.name(), dialect.name());
            }
        }
    }
    assert!(of_text("").is_none() && of_text("hello").is_none());
}

/// 25 lit pieces of one move: main programs call subprograms that no piece is cut by.
#[test]
fn long_programs_are_paged() {
    let piece = &small()[6..];
    let seeds: Vec<Seed> = std::iter::repeat_n(piece, 25).flatten().cloned().collect();
    let setup_of = |robot| {
        let mut setup = setup(Some(robot));
        let c = &mut setup.cell;
        (c.nachi.max_moves, c.nachi.number, c.ur.max_moves, c.fanuc.max_lines) = (10, 7, 10, 50);
        setup
    };
    let nachi = by_name("nachi").expect("there");
    let setup = setup_of("mz04");
    let files = written(nachi, &["head"], &lines(&seeds, &setup), &setup);
    let names: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names[..3], ["MZ04-01-A.007", "MZ04-01-A.008", "MZ04-01-A.009"]);
    assert!(files[0].text.starts_with("REM \"head\"\nCALLP 8\nCALLP 9\n") && files[0].text.ends_with("\nEND\n"));
    for page in &files[1..] {
        assert!(page.text.matches("MOVEX").count() <= 10);
        let count = |line: &str| page.text.lines().filter(|l| *l == line).count();
        assert_eq!(count("SET O3"), count("RESET O3"), "{}", page.text);
    }
    let gone = read(nachi, &files[..2], &setup);
    let called = "MZ04-01-A.009".to_owned();
    assert_eq!(gone, Err(ReadError::Gone { file: "MZ04-01-A.007".into(), line: 3, called }));
    let mut circle = files.clone();
    circle[1].text = "CALLP 7\nEND\n".into();
    assert!(read(nachi, &circle, &setup).is_err_and(|e| e.sentence().contains("circle")));

    let fanuc = by_name("fanuc").expect("there");
    let setup = setup_of("lrmate200id");
    let files = written(fanuc, &["head"], &lines(&seeds, &setup), &setup);
    assert!(files.len() > 3 && files[1].name == "CLEAN1.LS" && files[0].text.contains("CALL CLEAN1 ;"));
    let found = read(fanuc, &files, &setup).expect("reads");
    assert_eq!(found.iter().filter(|l| matches!(l.what, Statement::Move(_))).count(), 100);
    let mut long = seeds.clone();
    long.retain(|s| !matches!(s, Seed::Output(_, false)));
    let lines = lines(&long, &setup);
    let refused = fanuc.write(&clearbeam::program::Program { head: vec![], lines, setup: &setup, wording: words });
    let refused = refused.expect_err("a lit piece of 124 lines");
    assert!(matches!(refused, WriteError::PieceTooLong { most: 50, .. }), "{refused}");
    assert!(refused.sentence().contains("fanuc.max_lines"), "{}", refused.sentence());
}

#[test]
fn the_controllers_joint_three_is_less_joint_two() {
    let fanuc = by_name("fanuc").expect("there");
    let mut setup = setup(Some("lrmate200id"));
    let seeds = [Seed::Move { joints: [0.0; 6], linear: false, timing: MoveTiming::Percent(10.0), home: true }];
    let lines = lines(&seeds, &setup);
    let text = |setup: &Setup| written(fanuc, &[], &lines, setup)[0].text.clone();
    // Middles of the limits: J2 22.5, J3 67.5.
    assert!(text(&setup).contains("J2= 22.5000 deg,\tJ3= 45.0000 deg"), "{}", text(&setup));
    if let Some(robot) = &mut setup.robot {
        robot.couples_j2_j3 = false;
    }
    assert!(text(&setup).contains("J2= 22.5000 deg,\tJ3= 67.5000 deg"));
}

/// What an operator may have changed by hand, and what of it is refused.
#[test]
fn hand_edits_are_read_or_refused_by_their_line() {
    let nachi = by_name("nachi").expect("there");
    let setup = setup(Some("mz04"));
    let text = |line: &str| {
        let file = clearbeam::program::ProgramFile { name: "A.001".into(), text: format!("' note\n{line}\nEND\n") };
        read(nachi, &[file], &setup)
    };
    let good = text("MOVEX A=6,M1X,P,( 10.00, 80.00,-20.00,0.00,30.00,0.00),T=0.1,H=3,MS,CONF=0001").expect("reads");
    assert!(matches!(&good[1].what, Statement::Move(m) if m.rest == "A=6,H=3,MS,CONF=0001"));
    for (bad, why) in [
        ("MOVEX A=1,M1J,L,(1,2,3,4,5,6),S=60.0,H=1,MS", "T="),
        ("MOVEX A=1,M1X,C1,(1,2,3,4,5,6),T=1,H=1,MS", "arc"),
        ("MOVEX A=1,M1J,L,(1,2,3,4,5),T=1,H=1,MS", "six numbers"),
        ("MOVEX A=1,M1J,L,(1,2,3,4,5,nan),T=1,H=1,MS", "six numbers"),
        ("MOVEX A=1,M1J,L,(1,2,3,4,5,6),T=1,H=1", "MS"),
        ("MOVEX A=1,Q=2,M1J,L,(1,2,3,4,5,6),T=1,H=1,MS", "Q=2"),
        ("SETT O3", "SETT O3"),
        ("SET O-3", "SET O-3"),
        ("DELAY -1", "DELAY -1"),
        ("END\nRESET O3", "behind END"),
    ] {
        let said = text(bad).expect_err(bad).sentence();
        assert!(said.starts_with("A.001, line ") && said.contains(why), "{said}");
    }
}
