//! The pieces of a program that are lit without a break, how they are come to and left, and whether the head can
//! be drawn back from them; without a robot.

use super::lead::{Leads, leads};
use super::transfer_space::TransferSpace;
use crate::cell::motion::{Refusal, RefusalCause, RefusalReason};
use crate::pose::{Blocker, Pass};
use crate::program::motion::sweep::Prover;
use crate::program::neutral::steps::Station;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Which targets are lit without a break.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LitRange {
    /// Number of the pass.
    pub pass: usize,
    /// Its first target.
    pub first: usize,
    /// Its last target.
    pub last: usize,
}

/// A lit piece.
#[derive(Clone, Copy, Debug)]
pub struct LitPiece {
    /// Its targets.
    pub of: LitRange,
    /// Its lead-in and lead-out.
    pub leads: Leads,
    /// Where the connecting move before it ends.
    pub entry: Station,
    /// Where the connecting move after it begins.
    pub exit: Station,
}

/// Targets (pass, point) where one lit piece ends and the next begins though no gap is between them: the controller
/// cannot take both as one.
pub type Cuts = BTreeSet<(usize, usize)>;

/// The targets of the lit pieces, in the order of work.
pub fn lit_ranges(passes: &[Pass], cuts: &Cuts) -> Vec<LitRange> {
    let mut out = Vec::new();
    for (number, pass) in passes.iter().enumerate() {
        for (mut first, last) in pass.lit_pieces() {
            let inner = cuts.range((number, first + 1)..(number, last)).map(|cut| cut.1);
            for end in inner.chain([last]) {
                out.push(LitRange { pass: number, first, last: end });
                first = end;
            }
        }
    }
    out
}

/// The space around a part at every time: by layer, with the beads of that one.
pub struct TransferSpaces<'a>(Vec<TransferSpace<'a>>);

impl<'a> TransferSpaces<'a> {
    /// `whole`: the space around the part with all its layers.
    pub fn new(whole: &TransferSpace<'a>, prover: &Prover<'a>, passes: &[Pass]) -> TransferSpaces<'a> {
        let last = passes.iter().map(|p| p.settings.layer).max().unwrap_or(0);
        TransferSpaces((0..=last).map(|layer| whole.with_part(prover.part_of(layer + 1))).collect())
    }

    fn of_pass(&self, pass: &Pass) -> &TransferSpace<'a> {
        let layer = (pass.settings.layer as usize).min(self.0.len() - 1);
        &self.0[layer]
    }
}

/// The lit pieces, in the order of work.
pub fn pieces(spaces: &TransferSpaces<'_>, passes: &[Pass], cuts: &Cuts) -> Vec<LitPiece> {
    let piece = |of: LitRange| {
        let (pass, first, last) = (&passes[of.pass], of.first, of.last);
        let at = |point: usize| Station::of(&pass.targets[point], &pass.settings);
        let (start, end) = (at(first), at(last));
        let leads = leads(spaces.of_pass(pass), pass, (first, last), [&start, &end]);
        let (entry, exit) = (leads.before.map_or(start, |l| l.at), leads.behind.map_or(end, |l| l.at));
        LitPiece { of, leads, entry, exit }
    };
    lit_ranges(passes, cuts).into_par_iter().map(piece).collect()
}

/// Whether the way from one piece to the next may go straight: it depends on their two ends alone.
pub fn can_go_straight(spaces: &TransferSpaces<'_>, passes: &[Pass], pieces: &[LitPiece]) -> Vec<bool> {
    let straight = |w: &[LitPiece]| spaces.of_pass(&passes[w[1].of.pass]).can_go_straight(&w[0].exit, &w[1].entry);
    pieces.par_windows(2).map(straight).collect()
}

/// Targets of pieces that the head would have to be drawn back from, out to the sphere, and cannot.
pub fn blocked_retreats(
    spaces: &TransferSpaces<'_>,
    passes: &[Pass],
    pieces: &[LitPiece],
    can_go_straight: &[bool],
) -> Vec<Refusal> {
    let drawn_back = |space: &TransferSpace<'_>, at: &Station, can_go_straight: Option<&bool>| match can_go_straight {
        Some(true) => None,
        _ if !space.goes_on() => None,
        _ => space.head_hit(at, &space.on_sphere(at)),
    };
    let refusals = |(i, piece): (usize, &LitPiece)| {
        let before = i.checked_sub(1).and_then(|i| can_go_straight.get(i));
        let space = spaces.of_pass(&passes[piece.of.pass]);
        let hit =
            drawn_back(space, &piece.entry, before).or_else(|| drawn_back(space, &piece.exit, can_go_straight.get(i)));
        hit.map_or_else(Vec::new, |b| refusals_of_hit(piece, &b))
    };
    pieces.par_iter().enumerate().flat_map_iter(refusals).collect()
}

fn refusals_of_hit(piece: &LitPiece, b: &Blocker) -> Vec<Refusal> {
    let why = RefusalReason::HitDrawnBack { hit: *b };
    let refuse = |point| Refusal { pass: piece.of.pass, point, cause: RefusalCause::of_blocker(b), why: why.clone() };
    (piece.of.first..=piece.of.last).map(refuse).collect()
}
