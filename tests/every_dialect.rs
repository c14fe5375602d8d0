//! A plan goes to every controller: what is planned for a dialect is written in it, and read back it is the plan, times
//! included. No dialect refuses a plan for the digits or greatest speeds of its own words.
//!
//! The whole table of shipped jobs, robots and dialects takes hours:
//! `cargo test --release --test every_dialect -- --ignored --nocapture`. `ROBOT=ur5e` and `SAMPLE=workpiece` in the
//! environment pick from it.

use clearbeam::cell::Cell;
use clearbeam::document::{files, segmented};
use clearbeam::part::Part;
use clearbeam::planning::verify::{Verdict, check};
use clearbeam::planning::{self, Plan, PlanCache};
use clearbeam::program::{MoveTiming, Program, ProgramLine, Step, WITHOUT_WORDS, dialects, lines};
use clearbeam::progress::Progress;
use clearbeam::text::Sentence;
use nalgebra::Point3;
use std::path::PathBuf;

const ROBOTS: [&str; 13] = [
    "",
    "mz04",
    "mz07f",
    "kr6-r900",
    "irb120",
    "irb1200",
    "irb2400",
    "lrmate200id",
    "m10ia",
    "tx2-60",
    "gp7",
    "gp8",
    "ur5e",
];

/// A shipped job with its part.
struct Shipped {
    file: PathBuf,
    job: clearbeam::document::Job,
    part: Part,
    cache: PlanCache,
}

impl Shipped {
    fn load(name: &str) -> Shipped {
        let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("assets/samples/{name}.toml"));
        let job = files::read(&file).expect("reads");
        let part = files::load_part(&job, Some(&file)).expect("loads");
        Shipped { file, job, part, cache: PlanCache::default() }
    }

    /// Plans for a robot and a dialect, writes the program and reads it back; why there is none.
    fn driven(&self, robot: &str, dialect: &str) -> Result<(Plan, Verdict), String> {
        self.driven_in(robot, dialect, |_| {})
    }

    fn driven_in(&self, robot: &str, dialect: &str, change: impl FnOnce(&mut Cell)) -> Result<(Plan, Verdict), String> {
        let mut job = self.job.clone();
        (job.cell.robot, job.cell.dialect) = (robot.into(), dialect.into());
        let mut setup = files::load_setup(&job, Some(&self.file)).expect("a set-up");
        change(&mut setup.cell);
        let surfaces = segmented(&self.part, &job);
        let plan = planning::plan(&self.part, &surfaces, &job, &setup, &self.cache, &Progress::default())
            .map_err(|e| e.sentence())?;
        // Whatever is planned is written.
        let lines = lines(&plan.steps, &setup);
        let program = Program { head: Vec::new(), lines: lines.clone(), setup: &setup, wording: WITHOUT_WORDS };
        let files = dialects::known(dialect).expect("known").write(&program).expect("writes what is planned");
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        let (_, verdict) =
            check(&self.part, &plan, &setup, &job, &files[0], &open, false).expect("reads what it has written");
        // A plan that has its paces keeps them: the times are those of the words.
        let paces = dialects::known(dialect).expect("known").paces(&lines, &setup).into_iter();
        let planned = lines.iter().filter_map(|l| if let ProgramLine::Move(m) = l { Some(m.timing) } else { None });
        for (pace, planned) in paces.zip(planned) {
            let (MoveTiming::Seconds(a) | MoveTiming::Percent(a), MoveTiming::Seconds(b) | MoveTiming::Percent(b)) =
                (pace, planned);
            assert!((a - b).abs() <= 1e-9 * b, "{robot} {dialect}: {a} where the plan has {b}");
        }
        Ok((plan, verdict))
    }
}

#[test]
fn a_plan_goes_to_every_controller() {
    let mut shipped = Shipped::load("workpiece");
    shipped.job.settings.choose(vec![1]);
    shipped.job.layers.spacing_mm = 5.0;
    for dialect in dialects::names() {
        for robot in ["", "mz04", "kr6-r900", "ur5e"] {
            let (plan, verdict) = match shipped.driven(robot, dialect) {
                Ok(driven) => driven,
                Err(why) => {
                    assert_eq!((robot, dialect), ("", "yaskawa"), "{why}");
                    continue;
                }
            };
            assert_eq!(verdict.findings, [], "{robot} {dialect}");
            assert!(verdict.lit_moves > 20, "{robot} {dialect}: {}", verdict.lit_moves);
            // What is slower than it was to be is told, and nothing else is.
            let speed_mm_s = shipped.job.beam.speed_mm_s;
            let (mut slow, mut slow_by_more, mut from, mut is_lit) = (0, 0, None::<Point3<f64>>, false);
            let (mut wanted_s, mut seconds) = (0.0, 0.0);
            for step in &plan.steps.list {
                match step {
                    Step::Laser(on) => is_lit = *on,
                    Step::Go(go) => {
                        let spot = go.to.x - go.to.a * shipped.job.beam.defocus_mm;
                        if let (MoveTiming::Seconds(s), Some(before), true) = (go.timing, from, is_lit) {
                            let mm_s = (spot - before).norm() / s;
                            // Between two targets the spot's way is a chord of the frame's turn.
                            let is_slow = mm_s < 0.98 * speed_mm_s - 1e-6;
                            let needs_s = (spot - before).norm() / speed_mm_s;
                            slow += usize::from(is_slow);
                            slow_by_more += usize::from(is_slow && s - needs_s > 0.001);
                            (wanted_s, seconds) = (wanted_s + needs_s, seconds + s);
                            assert!(mm_s <= speed_mm_s * 1.001, "{robot} {dialect}: {mm_s} mm/s");
                        }
                        from = Some(spot);
                    }
                    _ => {}
                }
            }
            let told: usize = plan.steps.off_speed.iter().map(|o| o.moves).sum();
            // Of single moves a millisecond is told, of all together whatever makes a difference.
            let expected = if seconds - wanted_s > 0.02 * seconds { slow } else { slow_by_more };
            assert_eq!(expected, told, "{robot} {dialect}");
        }
    }
}

#[test]
fn pieces_that_a_controller_cannot_take_are_cut_where_the_laser_may_go_off() {
    let mut shipped = Shipped::load("workpiece");
    shipped.job.settings.choose(vec![1]);
    (shipped.job.layers.spacing_mm, shipped.job.path.max_step_mm) = (10.0, 0.5);
    let (whole, _) = shipped.driven("", "fanuc").expect("a plan");
    let (cut, verdict) = shipped.driven_in("", "fanuc", |cell| cell.fanuc.max_lines = 50).expect("a plan");
    assert!(whole.cuts.is_empty() && !cut.cuts.is_empty());
    assert_eq!(verdict.findings, []);
    // The same targets, all of them worked: the passes are as they were.
    assert_eq!((&cut.passes, cut.refusals.len()), (&whole.passes, whole.refusals.len()));
    let mut moves = 0;
    for step in &cut.steps.list {
        match step {
            Step::Laser(_) => moves = 0,
            Step::Go(_) => moves += 1,
            _ => {}
        }
        assert!(moves <= 50 - 8);
    }
}

#[test]
#[ignore = "hours: all shipped jobs, robots and dialects"]
fn every_shipped_job_goes_to_every_controller_with_every_robot() {
    let wanted = |key: &str, value: &str| std::env::var(key).map_or(true, |w| w == value);
    let mut wrong = Vec::new();
    for sample in ["workpiece", "worm_gear"].into_iter().filter(|s| wanted("SAMPLE", s)) {
        let shipped = Shipped::load(sample);
        for robot in ROBOTS.into_iter().filter(|r| wanted("ROBOT", r)) {
            for dialect in dialects::names() {
                let said = match shipped.driven(robot, dialect) {
                    Ok((plan, verdict)) => {
                        let (lit, slow) = (verdict.lit_moves, &plan.steps.off_speed);
                        let first = verdict.findings.first().map(Sentence::sentence);
                        if let Some(first) = &first {
                            wrong.push(format!("{sample} {robot} {dialect}: {first}"));
                        }
                        format!("{lit} lit moves, {} findings, slow: {slow:?}", verdict.findings.len())
                    }
                    Err(why) => {
                        if (robot, dialect) != ("", "yaskawa") {
                            wrong.push(format!("{sample} {robot} {dialect}: {why}"));
                        }
                        why
                    }
                };
                println!("{sample} {robot:12} {dialect:8} {said}");
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
