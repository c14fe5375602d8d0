//! The steps of a program without a robot: as poses of the focus, with connecting moves over the part. Whether an
//! arm could make them is not asked.

use super::lead::Lead;
use super::pieces::{self, Cuts, LitPiece, TransferSpaces};
use super::transfer_space::TransferSpace;
use crate::beam::ProcessSettings;
use crate::cell::Setup;
use crate::cell::motion::Refusal;
use crate::pose::Pass;
use crate::program::motion::lit::StraightFlange;
use crate::program::neutral::shortfall::shortfalls;
use crate::program::neutral::steps::{Go, Interpolation, MoveTiming, Station, Step, Steps};
use rayon::prelude::*;

/// Turns passes into steps. Blocked targets are not gone to. `air_mm_s`: speed of the focus in the air.
///
/// # Errors
/// Targets to which the beam does not keep its line as the flange goes straight, and pieces from which the head
/// cannot be drawn back; the rest has to be tried again without them.
pub fn steps(
    straight: &StraightFlange<'_>,
    setup: &Setup,
    passes: &[Pass],
    cuts: &Cuts,
    air_mm_s: f64,
) -> Result<Steps, Vec<Refusal>> {
    let space = TransferSpace::of(straight, setup, passes);
    let spaces = TransferSpaces::new(&space, &straight.prover, passes);
    let pieces = pieces::pieces(&spaces, passes, cuts);
    let can_go_straight = pieces::can_go_straight(&spaces, passes, &pieces);
    let refused = pieces::blocked_retreats(&spaces, passes, &pieces, &can_go_straight);
    let mut walk = FocusWalk { setup, space: &space, air_mm_s, out: Steps::default(), gaps: Vec::new() };
    let home = Step::Home { percent: setup.cell.air.home_percent };
    walk.out.list.push(home.clone());
    let mut at: Option<Station> = None;
    let mut announced_pass = None;
    for (index, piece) in pieces.iter().enumerate() {
        let pass = &passes[piece.of.pass];
        let here = match at {
            None => walk.push_way_from_home(piece),
            Some(from) => walk.push_way_to(from, piece, can_go_straight[index - 1]),
        };
        if announced_pass != Some(piece.of.pass) {
            walk.out.say_pass(piece.of.pass, pass);
            announced_pass = Some(piece.of.pass);
        }
        let start = walk.push_approach(here, pass, piece);
        let end = walk.push_lit_piece(start, pass, piece);
        at = Some(walk.push_retreat(end, piece.leads.behind));
    }
    if let Some(end) = at {
        walk.push_connecting_move(end, space.on_sphere(&end), None);
    }
    let FocusWalk { mut out, gaps, .. } = walk;
    out.list.push(home);
    let mut refused = refused;
    refused.extend(fill(&mut out, &gaps, straight));
    out.shortfalls = shortfalls(pieces.iter().map(|p| (&passes[p.of.pass], p.leads.left_out)), &setup.cell.outputs);
    if refused.is_empty() { Ok(out) } else { Err(refused) }
}

/// The moves from home to where another one leads: by joints to outside the part, and straight in.
pub fn way_from_home(
    straight: &StraightFlange<'_>,
    setup: &Setup,
    passes: &[Pass],
    entry: &Go,
    air_mm_s: f64,
) -> Vec<Go> {
    let space = TransferSpace::of(straight, setup, passes);
    let outside = from_home(&space, setup, &entry.to);
    let timing = MoveTiming::Seconds(space.seconds(&outside.to, &entry.to, air_mm_s));
    let (to, interpolation) = (entry.to, Interpolation::Linear);
    vec![outside, Go { to, interpolation, joints_deg: None, timing, target: None }]
}

/// The move by joints from home to outside the part, before a station.
fn from_home(space: &TransferSpace<'_>, setup: &Setup, entry: &Station) -> Go {
    let timing = MoveTiming::Percent(setup.cell.air.home_percent);
    Go { to: space.on_sphere(entry), interpolation: Interpolation::Joint, joints_deg: None, timing, target: None }
}

/// Steps as they are added, piece by piece. Stations are turned so that the part need not make half a turn.
struct FocusWalk<'a> {
    setup: &'a Setup,
    space: &'a TransferSpace<'a>,
    air_mm_s: f64,
    out: Steps,
    gaps: Vec<LitGap>,
}

/// A lit move from one target to the next, whose stations between are not known yet.
struct LitGap {
    /// Its place among the steps.
    step: usize,
    from: Station,
    to: Station,
    settings: ProcessSettings,
    seconds: f64,
    /// Pass and point that it leads to.
    target: (usize, usize),
}

/// Puts the stations between targets into the steps: those of one move hang on no other, so all are sought at once. What is
/// refused comes back.
fn fill(out: &mut Steps, gaps: &[LitGap], straight: &StraightFlange<'_>) -> Vec<Refusal> {
    let sought = |gap: &LitGap| straight.stations_between(&gap.from, &gap.to, &gap.settings, gap.seconds);
    let found: Vec<_> = gaps.par_iter().map(sought).collect();
    let mut refused = Vec::new();
    let mut found = gaps.iter().zip(found).peekable();
    let steps = std::mem::take(&mut out.list);
    // Summed again, in the order in which they are driven.
    out.time_s = 0.0;
    for (number, step) in steps.into_iter().enumerate() {
        let Step::Go(mut go) = step else {
            out.list.push(step);
            continue;
        };
        if let Some((gap, between)) = found.next_if(|(gap, _)| gap.step == number) {
            let mut done = 0.0;
            match between {
                Ok(between) => {
                    for (share, to) in between {
                        let timing = MoveTiming::Seconds(gap.seconds * (share - done));
                        out.push_timed(Go { to, timing, target: None, ..go });
                        done = share;
                    }
                }
                Err((cause, why)) => {
                    let (pass, point) = gap.target;
                    refused.push(Refusal { pass, point, cause, why });
                }
            }
            go.timing = MoveTiming::Seconds(gap.seconds * (1.0 - done));
        }
        out.push_timed(go);
    }
    refused
}

impl Steps {
    /// Adds a move and its time, where it has one.
    fn push_timed(&mut self, go: Go) {
        if let MoveTiming::Seconds(seconds) = go.timing {
            self.time_s += seconds;
        }
        self.list.push(Step::Go(go));
    }
}

impl FocusWalk<'_> {
    /// Adds the move by joints from home to outside the first piece. Without a robot its length is not known.
    fn push_way_from_home(&mut self, piece: &LitPiece) -> Station {
        let go = from_home(self.space, self.setup, &piece.entry);
        self.out.list.push(Step::Go(go));
        go.to
    }

    /// Adds the way over the part to a piece, straight if it is a hop.
    fn push_way_to(&mut self, from: Station, piece: &LitPiece, can_go_straight: bool) -> Station {
        let to = piece.entry.nearest_to(&from);
        let mut before = from;
        for via in self.space.between(&from, &to, can_go_straight) {
            let via = via.nearest_to(&before);
            self.push_connecting_move(before, via, None);
            before = via;
        }
        before
    }

    /// Adds the way down to a piece's first target, by its lead-in if it has one.
    fn push_approach(&mut self, here: Station, pass: &Pass, piece: &LitPiece) -> Station {
        let first = Some((piece.of.pass, piece.of.first));
        let start = Station::of(&pass.targets[piece.of.first], &pass.settings).nearest_to(&here);
        match piece.leads.before {
            None => self.push_connecting_move(here, start, first),
            Some(l) => {
                // The way out, backwards.
                let way = l.stations(&start);
                let mut before = Station { o: start.o, ..l.at };
                self.push_connecting_move(here, before, None);
                for (i, (_, seconds)) in way.iter().enumerate().rev() {
                    let (to, target) = match i.checked_sub(1).and_then(|i| way.get(i)) {
                        Some((to, _)) => (Station { o: start.o, ..*to }, None),
                        None => (start, first),
                    };
                    self.out.air_mm += (to.x - before.x).norm();
                    self.push_move(to, *seconds, target);
                    before = to;
                }
            }
        }
        start
    }

    /// Adds a piece with the laser on.
    fn push_lit_piece(&mut self, start: Station, pass: &Pass, piece: &LitPiece) -> Station {
        let mut here = start;
        self.out.set_process(&pass.settings);
        self.out.list.push(Step::Laser(true));
        for i in piece.of.first + 1..=piece.of.last {
            let next = Station::of(&pass.targets[i], &pass.settings).nearest_to(&here);
            let seconds = pass.targets[i].seconds_from(&pass.targets[i - 1], &pass.settings);
            let target = (piece.of.pass, i);
            let (step, settings) = (self.out.list.len(), pass.settings);
            self.gaps.push(LitGap { step, from: here, to: next, settings, seconds, target });
            self.push_move(next, seconds, Some(target));
            here = next;
        }
        self.out.list.push(Step::Laser(false));
        here
    }

    /// Adds the lead-out of a piece, if it has one.
    fn push_retreat(&mut self, end: Station, lead: Option<Lead>) -> Station {
        let Some(lead) = lead else { return end };
        let mut here = end;
        for (to, seconds) in lead.stations(&end) {
            let to = Station { o: end.o, ..to };
            self.out.air_mm += (to.x - here.x).norm();
            self.push_move(to, seconds, None);
            here = to;
        }
        here
    }

    /// Adds a straight move in a given time.
    fn push_move(&mut self, to: Station, seconds: f64, target: Option<(usize, usize)>) {
        let (interpolation, timing) = (Interpolation::Linear, MoveTiming::Seconds(seconds));
        self.out.push_timed(Go { to, interpolation, joints_deg: None, timing, target });
    }

    /// Adds a straight move at the speed of connecting moves.
    fn push_connecting_move(&mut self, from: Station, to: Station, target: Option<(usize, usize)>) {
        self.out.air_mm += (to.x - from.x).norm();
        self.push_move(to, self.space.seconds(&from, &to, self.air_mm_s), target);
    }
}
