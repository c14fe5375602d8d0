//! The steps of a program with a robot: joints for every move, targets put in between where the spot
//! would leave its line, and connecting moves that the arm can make.
//!
//! Asked for a straight move, a controller moves the flange straight and turns it about one axis; the
//! spot then leaves the planned line between two targets by the lever from flange to spot. What cannot
//! be driven is refused with its reason; spins and branches are not chosen here.

use super::air::Space;
use super::driven::{Driven, DrivenPiece};
use super::lit::Straight;
use super::remarks::remarks;
use super::steps::{Go, Pace, Station, Step, Steps, Way, space};
use super::{pieces, round};
use crate::cell::collision::Collision;
use crate::cell::motion::{Cause, Choice, Refusal, Why};
use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Robot, Setup};
use crate::part::Part;
use crate::pose::Pass;
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

/// What the driven program is made from.
pub struct Drive<'a> {
    /// The part.
    pub part: &'a Part,
    /// The cell, with a robot in it.
    pub setup: &'a Setup,
    /// Its frames.
    pub mounted: Mounted,
    /// The robot of the setup.
    pub robot: &'a Robot,
    /// Speed of the focus in the air, mm/s.
    pub air_mm_s: f64,
    /// What keeps the spot to its line, and clear.
    pub straight: Straight<'a>,
    /// What the arm and all it carries may touch; `None`: nothing.
    pub collision: Option<&'a Collision<'a>>,
    /// Whether to go on; the steps of a stopped drive are refused without a reason.
    pub go_on: &'a (dyn Fn() -> bool + Sync),
    /// What was found out so far.
    pub known: Known,
}

/// Ways and pieces that were worked out: when targets are refused, or others chosen, most of the rest stays
/// as it is. A pose is told by its joints, to the last bit.
#[derive(Default)]
pub struct Known {
    ways: Mutex<BTreeMap<Ends, Option<Vec<Go>>>>,
    pieces: Mutex<BTreeMap<(Piece, Vec<Bits>), Driven>>,
    /// Ways in from home or a gate.
    ways_in: Mutex<BTreeMap<[Bits; 2], Option<WayIn>>>,
    /// Whether a move by joints is clear.
    clear: Mutex<BTreeMap<[Bits; 2], bool>>,
}

impl Known {
    /// The way in from a stand to another one.
    pub fn way_in(&self, from: &Stand, to: &Stand, make: impl FnOnce() -> Option<WayIn>) -> Option<WayIn> {
        known(&self.ways_in, [from, to].map(|s| bits(&s.joints_deg)), make)
    }

    /// Whether the move by joints from one pose to another is clear.
    pub fn is_clear(&self, from: &Joints, to: &Joints, make: impl FnOnce() -> bool) -> bool {
        known(&self.clear, [from, to].map(bits), make)
    }
}

/// Stands on the way to straight above a piece's end, and that one.
pub type WayIn = (Vec<Stand>, Stand);

/// Joints as a key.
type Bits = [u64; 6];

fn bits(joints_deg: &Joints) -> Bits {
    joints_deg.map(f64::to_bits)
}

/// The end of a piece (or home) and the start of the next (or home).
type Ends = [Option<Bits>; 2];

/// Pass, first and last point of a lit piece.
pub(super) type Piece = (usize, usize, usize);

/// A value that was worked out before, or is now.
fn known<K: Ord, V: Clone>(all: &Mutex<BTreeMap<K, V>>, key: K, make: impl FnOnce() -> V) -> V {
    if let Some(value) = all.lock().ok().and_then(|all| all.get(&key).cloned()) {
        return value;
    }
    let value = make();
    if let Ok(mut all) = all.lock() {
        all.insert(key, value.clone());
    }
    value
}

/// Where the arm stands: the focus in the part, and the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Focus, beam and spin in the part.
    pub at: Station,
    /// Degrees.
    pub joints_deg: Joints,
}

/// What could not be driven.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Undriven {
    /// Targets, and why.
    pub refused: Vec<Refusal>,
    /// Passes in branches that no way leads to: another branch may do the same targets.
    pub closed: Vec<(usize, u8)>,
}

impl Drive<'_> {
    /// The steps of what was chosen.
    ///
    /// # Errors
    /// What cannot be driven after all; the rest has to be tried again without it.
    pub fn steps(&self, passes: &[Pass], choice: &Choice) -> Result<Steps, Undriven> {
        let pieces: Vec<Piece> = pieces::lit(passes);
        if let Some(contact) = self.collision.and_then(|c| c.first(&self.setup.home_joints_deg())) {
            let why = Why::ContactAtHome(contact);
            let refuse = |(pass, point)| Refusal { pass, point, cause: Cause::Robot, why: why.clone() };
            let all = pieces.iter().flat_map(|&(pass, first, last)| (first..=last).map(move |point| (pass, point)));
            let refused: Vec<Refusal> = all.map(refuse).collect();
            return if refused.is_empty() {
                Ok(Steps::default())
            } else {
                Err(Undriven { refused, ..Undriven::default() })
            };
        }
        let space = space(&self.straight, self.setup, passes);
        let driven: Vec<Driven> = pieces
            .par_iter()
            .take_any_while(|_| (self.go_on)())
            .map(|&piece| self.known_piece(&space, passes, choice, piece))
            .collect();
        if !(self.go_on)() {
            return Err(Undriven::default());
        }
        let mut refused = Vec::new();
        let mut whole = Vec::new();
        for piece in driven {
            match piece {
                Ok(piece) => whole.push(piece),
                Err(refusal) => refused.push(refusal),
            }
        }
        if !refused.is_empty() {
            return Err(Undriven { refused, ..Undriven::default() });
        }
        let ways = loop {
            let ways = self.ways(&space, &whole);
            // Where nothing leads to the far end of a lead, the piece does without.
            let closed = (0..ways.len()).filter(|&i| ways[i].is_none());
            let beside: Vec<usize> = closed.flat_map(|i| [i.checked_sub(1), Some(i)]).flatten().collect();
            let led = whole.iter_mut().enumerate().filter(|(i, p)| beside.contains(i) && p.leads.any());
            if led.map(|(_, piece)| piece.leads.leave_out()).count() == 0 {
                break ways;
            }
        };
        let end = |i: usize| whole[i].exit();
        if !(self.go_on)() {
            return Err(Undriven::default());
        }
        if let (Some(None), false) = (ways.first(), whole.is_empty()) {
            // Nothing begins here: refuse all pieces up to the first that can be gone to.
            let reachable = |i: &usize| self.known_way(&space, None, Some(&whole[*i].entry())).is_some();
            let begin = (1..whole.len()).into_par_iter().find_first(reachable).unwrap_or(whole.len());
            return Err(self.unreached(&pieces[..begin], choice));
        }
        let mut closed = Vec::new();
        let mut out = Steps::default();
        out.list.push(Step::Home);
        let mut said = None;
        let mut at: Option<Station> = None;
        for (i, (way, &(number, first, last))) in ways.iter().zip(&pieces).enumerate() {
            let Some(way) = way else {
                // Home is on every way that is tried last: the piece that has none to it is in a pocket.
                let stuck = i > 0 && self.known_way(&space, Some(&end(i - 1)), None).is_none();
                closed.push(if stuck { pieces[i - 1] } else { (number, first, last) });
                continue;
            };
            let Some((down, way)) = way.split_last() else { continue };
            let (piece, begin) = (&whole[i], Some((number, first)));
            for go in way {
                out.driven(go, at.as_ref());
                at = Some(go.to);
            }
            if said != Some(number) {
                out.list.push(Step::Say(passes[number].title(number)));
                said = Some(number);
            }
            let target = begin.filter(|_| piece.leads.before.is_none());
            out.driven(&Go { target, ..*down }, at.as_ref());
            if let Some(lead) = &piece.leads.before {
                out.led(&piece.start, lead.seconds, (&lead.to.at, begin));
            }
            out.with(&passes[number].work);
            out.list.push(Step::Laser(true));
            for l in &piece.lit {
                out.time_s += l.seconds;
                out.list.push(Step::Go(Go {
                    to: l.to.at,
                    way: Way::Linear,
                    joints_deg: Some(l.to.joints_deg),
                    pace: Pace::Seconds(l.seconds),
                    target: l.target,
                }));
            }
            out.list.push(Step::Laser(false));
            if let Some(lead) = &piece.leads.behind {
                out.led(&lead.to, lead.seconds, (&piece.last().at, None));
            }
            at = Some(piece.exit().at);
        }
        if let (Some(Some(way)), true) = (ways.last(), !whole.is_empty()) {
            for go in way {
                out.driven(go, at.as_ref());
                at = Some(go.to);
            }
        }
        if let (Some(None), Some(&(number, first, last))) = (ways.last(), pieces.last()) {
            closed.push((number, first, last));
        }
        out.list.push(Step::Home);
        let left_out = pieces.iter().zip(&whole).map(|(p, w)| (&passes[p.0], w.leads.left_out));
        out.remarks = remarks(left_out, &self.setup.cell.outputs);
        if closed.is_empty() { Ok(out) } else { Err(self.unreached(&closed, choice)) }
    }

    /// The way to each piece from the one before or home, and from the last one home.
    fn ways(&self, space: &Space<'_>, whole: &[DrivenPiece]) -> Vec<Option<Vec<Go>>> {
        (0..=whole.len())
            .into_par_iter()
            .map(|i| {
                if !(self.go_on)() {
                    return None;
                }
                let from = i.checked_sub(1).map(|i| whole[i].exit());
                let to = whole.get(i).map(DrivenPiece::entry);
                self.known_way(space, from.as_ref(), to.as_ref())
            })
            .collect()
    }

    /// Pieces that nothing leads to: their branches are closed, and if they stay so, all their targets
    /// are refused.
    fn unreached(&self, pieces: &[Piece], choice: &Choice) -> Undriven {
        let mut out = Undriven::default();
        // The ways to a piece and from it may both be missing: it is refused once.
        for &(pass, first, last) in BTreeSet::from_iter(pieces) {
            out.closed.extend(choice.rows[pass][first].as_ref().map(|c| (pass, c.branch)));
            let refuse = |point| Refusal { pass, point, cause: Cause::Robot, why: Why::NoWay };
            out.refused.extend((first..=last).map(refuse));
        }
        out
    }

    fn known_way(&self, space: &Space<'_>, from: Option<&Stand>, to: Option<&Stand>) -> Option<Vec<Go>> {
        let ends = [from, to].map(|s| s.map(|s| bits(&s.joints_deg)));
        known(&self.known.ways, ends, || round::way(self, space, from, to))
    }

    fn known_piece(&self, space: &Space<'_>, passes: &[Pass], choice: &Choice, piece: Piece) -> Driven {
        let (number, first, last) = piece;
        let chosen = choice.rows[number][first..=last].iter().flatten().map(|c| bits(&c.joints_deg)).collect();
        known(&self.known.pieces, (piece, chosen), || self.piece(space, passes, choice, piece))
    }
}

impl Steps {
    /// A move along a lead, from a station.
    fn led(&mut self, to: &Stand, seconds: f64, (from, target): (&Station, Option<(usize, usize)>)) {
        let pace = Pace::Seconds(seconds);
        let go = Go { to: to.at, way: Way::Linear, joints_deg: Some(to.joints_deg), pace, target };
        self.driven(&go, Some(from));
    }

    /// A connecting move.
    fn driven(&mut self, go: &Go, from: Option<&Station>) {
        if let Some(from) = from {
            self.air_mm += (go.to.x - from.x).norm();
        }
        if let Pace::Seconds(s) = go.pace {
            self.time_s += s;
        }
        self.list.push(Step::Go(*go));
    }
}
