//! Times and speeds of a program as its controller's words have them, and what is told of it: where the spot is slower
//! than it was to be, and moves that are very short. Whoever asks for the program's time or dose gets these times.

use super::connecting::pieces::Cuts;
use super::dialect::Dialect;
use super::neutral::lines::lines;
use super::neutral::shortfall::{OffSpeed, Shortfall};
use super::neutral::steps::{Go, MoveTiming, Step, Steps};
use crate::cell::Setup;
use crate::pose::Pass;
use std::collections::BTreeMap;

/// A speed that is off by less is told by nobody: a fiftieth more or less of the energy is within what any laser keeps to.
const TOLD_SHARE: f64 = 0.02;

/// A single move that takes longer by less than this, seconds, is not told either: that is the last digit of the words of
/// most controllers, and at 3 mm/s three thousandths of a millimetre of way.
const TOLD_S: f64 = 0.001;

/// Gives the moves of a program the paces that the dialect has words for, and tells where that is not the speed that
/// was set, or a lit move is shorter than the cell's least.
pub fn pace(steps: &mut Steps, passes: &[Pass], setup: &Setup, dialect: &dyn Dialect) {
    let mut paces = dialect.paces(&lines(steps, setup), setup).into_iter();
    let mut lit: Vec<LitPace> = Vec::new();
    let mut is_lit = false;
    for step in &mut steps.list {
        match step {
            Step::Laser(on) => is_lit = *on,
            Step::Home { percent } => {
                if let Some(MoveTiming::Percent(p)) = paces.next() {
                    *percent = p;
                }
            }
            Step::Go(go) => {
                let Some(pace) = paces.next() else { continue };
                if let (MoveTiming::Seconds(wanted_s), MoveTiming::Seconds(seconds)) = (go.timing, pace) {
                    steps.time_s += seconds - wanted_s;
                    if is_lit {
                        lit.push(LitPace { go: *go, wanted_s, seconds });
                    }
                }
                go.timing = pace;
            }
            Step::Comment(_) | Step::Process(_) => {}
        }
    }
    let lit = with_targets(lit);
    steps.off_speed = off_speed(&lit, passes);
    steps.shortfalls.extend(short_moves(&lit, passes, setup.cell.timing.least_move_s));
    steps.shortfalls.sort_by_key(|s| s.0);
}

/// Targets in the middle of pieces with more lit moves than the dialect's controller takes: there they have to be cut.
/// None in pieces that have no target inside.
pub fn cuts(steps: &Steps, setup: &Setup, dialect: &dyn Dialect) -> Cuts {
    let Some(most) = dialect.most_lit_moves(setup) else { return Cuts::new() };
    let mut out = Cuts::new();
    let mut piece: Vec<Option<(usize, usize)>> = Vec::new();
    for step in &steps.list {
        match step {
            Step::Go(go) => piece.push(go.target),
            Step::Laser(false) => {
                let inner = &piece[..piece.len().saturating_sub(1)];
                let (before, behind) = inner.split_at(inner.len() / 2);
                let middle = behind.iter().flatten().next().or(before.iter().flatten().next_back());
                out.extend(middle.filter(|_| piece.len() > most));
                piece.clear();
            }
            Step::Laser(true) => piece.clear(),
            Step::Comment(_) | Step::Process(_) | Step::Home { .. } => {}
        }
    }
    out
}

/// A lit move.
struct LitPace {
    go: Go,
    /// What it was to take.
    wanted_s: f64,
    /// What it takes.
    seconds: f64,
}

/// Each move with the target that it leads to: one that ends between two targets with the second of them.
fn with_targets(lit: Vec<LitPace>) -> Vec<(LitPace, (usize, usize))> {
    let mut target = None;
    let mut out: Vec<(LitPace, (usize, usize))> = Vec::with_capacity(lit.len());
    for pace in lit.into_iter().rev() {
        target = pace.go.target.or(target);
        out.extend(target.map(|target| (pace, target)));
    }
    out.reverse();
    out
}

fn off_speed(lit: &[(LitPace, (usize, usize))], passes: &[Pass]) -> Vec<OffSpeed> {
    // Many small differences are one that counts.
    let mut sums = BTreeMap::<u32, (f64, f64)>::new();
    for (pace, of) in lit.iter().filter_map(|(pace, (pass, _))| Some((pace, passes.get(*pass)?))) {
        let (wanted_s, seconds) = sums.entry(of.surface).or_default();
        (*wanted_s, *seconds) = (*wanted_s + pace.wanted_s, *seconds + pace.seconds);
    }
    let is_off = |wanted_s: f64, seconds: f64| (wanted_s - seconds).abs() > TOLD_SHARE * seconds;
    let mut out = BTreeMap::<u32, OffSpeed>::new();
    for (pace, (pass, point)) in lit {
        // A move that takes no time goes nowhere.
        let ratio = if pace.seconds > 0.0 { pace.wanted_s / pace.seconds } else { 1.0 };
        let (Some(of), true) = (passes.get(*pass), is_off(pace.wanted_s, pace.seconds)) else { continue };
        let counts = sums.get(&of.surface).is_some_and(|(wanted_s, seconds)| is_off(*wanted_s, *seconds));
        if !counts && (pace.seconds - pace.wanted_s).abs() <= TOLD_S {
            continue;
        }
        let wanted_mm_s = of.settings.speed_mm_s;
        let this = OffSpeed {
            surface: of.surface,
            moves: 1,
            wanted_mm_s,
            possible_mm_s: wanted_mm_s * ratio,
            pass: *pass,
            point: *point,
        };
        let off = |o: &OffSpeed| (o.possible_mm_s / o.wanted_mm_s - 1.0).abs();
        out.entry(of.surface)
            .and_modify(|o| *o = OffSpeed { moves: o.moves + 1, ..if off(&this) > off(o) { this } else { *o } })
            .or_insert(this);
    }
    out.into_values().collect()
}

fn short_moves(lit: &[(LitPace, (usize, usize))], passes: &[Pass], least_s: f64) -> Vec<(u32, Shortfall)> {
    let mut short = BTreeMap::<u32, (usize, f64)>::new();
    // A move of a stretch that fits the least time a whole number of times is not short by rounding.
    for (pace, (pass, _)) in lit.iter().filter(|(pace, _)| pace.seconds < least_s * (1.0 - 1e-9)) {
        let Some(of) = passes.get(*pass) else { continue };
        let (moves, shortest_s) = short.entry(of.surface).or_insert((0, f64::INFINITY));
        (*moves, *shortest_s) = (*moves + 1, shortest_s.min(pace.seconds));
    }
    let told = |(surface, (moves, shortest_s))| (surface, Shortfall::ShortMoves { moves, shortest_s, least_s });
    short.into_iter().map(told).collect()
}

#[cfg(test)]
mod tests {
    use super::super::dialects;
    use super::super::neutral::steps::{Interpolation, Station};
    use super::*;
    use crate::beam::ProcessSettings;
    use nalgebra::{Point3, Vector3};

    /// A pass at 3 mm/s whose one lit move turns the part by so many degrees about the beam, in so many seconds.
    fn paced(dialect: &str, turn_deg: f64, seconds: f64) -> Steps {
        let mut setup = Setup::shipped().expect("shipped");
        // The part's middle on the flange, so that a turn moves the flange little.
        setup.cell.flange_from_part.position_mm = [0.0; 3];
        let station = |deg: f64, z: f64| {
            let (sin, cos) = libm::sincos(deg.to_radians());
            Station { x: Point3::new(30.0, 0.0, z), a: Vector3::x(), o: Vector3::new(0.0, cos, sin) }
        };
        let go =
            |to, interpolation, timing, target| Step::Go(Go { to, interpolation, joints_deg: None, timing, target });
        let home = Step::Home { percent: 10.5 };
        let list = vec![
            home.clone(),
            go(station(0.0, 0.0), Interpolation::Joint, MoveTiming::Percent(10.5), Some((0, 0))),
            Step::Laser(true),
            go(station(turn_deg, 0.5), Interpolation::Linear, MoveTiming::Seconds(seconds), Some((0, 1))),
            Step::Laser(false),
            home,
        ];
        let mut steps = Steps { list, time_s: seconds, ..Steps::default() };
        let pass = Pass {
            surface: 7,
            settings: ProcessSettings { speed_mm_s: 3.0, ..ProcessSettings::default() },
            plane_normal: Vector3::z(),
            closed: false,
            targets: Vec::new(),
            line_points: 0,
            dense_points: 0,
            chord_error_mm: 0.0,
            splits: Vec::new(),
        };
        pace(&mut steps, &[pass], &setup, dialects::by_name(dialect).expect("a dialect"));
        steps
    }

    #[test]
    fn a_turn_that_the_words_do_not_have_takes_longer_and_is_told() {
        // KUKA's 200 degrees per second make 0.2 s of 40 degrees, and ESTUN's 360 a ninth.
        for (dialect, needs_s) in [("kuka", 0.2), ("estun", 40.0 / 360.0), ("nachi", 0.1), ("csv", 0.1)] {
            let steps = paced(dialect, 40.0, 0.1);
            let off = steps.off_speed.first().copied();
            assert!((steps.time_s - needs_s).abs() < 1e-4, "{dialect}: {} s", steps.time_s);
            match off {
                None => assert_eq!(needs_s, 0.1, "{dialect}"),
                Some(off) => {
                    assert_eq!((off.surface, off.moves, off.wanted_mm_s, off.pass, off.point), (7, 1, 3.0, 0, 1));
                    assert!((off.possible_mm_s - 0.3 / needs_s).abs() < 1e-3, "{dialect}: {off:?}");
                }
            }
            assert_eq!(steps.shortfalls, []);
        }
    }

    #[test]
    fn short_moves_are_told_and_per_cents_are_whole_where_words_are() {
        let steps = paced("fanuc", 0.0, 0.0123);
        let short = Shortfall::ShortMoves { moves: 1, shortest_s: 0.013, least_s: 0.02 };
        assert_eq!(steps.shortfalls, [(7, short)]);
        // A millisecond in thirteen is told as well.
        assert!(steps.off_speed.iter().all(|off| (off.possible_mm_s - 3.0 * 12.3 / 13.0).abs() < 1e-9));
        assert_eq!((steps.list[0].clone(), steps.off_speed.len()), (Step::Home { percent: 10.0 }, 1));
        let Step::Go(go) = &steps.list[1] else { panic!("a move") };
        assert_eq!(go.timing, MoveTiming::Percent(10.0));
        assert_eq!(paced("nachi", 0.0, 0.0123).list[0], Step::Home { percent: 10.5 });
    }
}
