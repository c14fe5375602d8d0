//! The steps of all lit pieces in their order, with the ways between them, or what of it cannot be driven.

use super::lit_pieces::DrivenPiece;
use super::{Drive, Undriven};
use crate::cell::motion::{Choice, Refusal, RefusalCause, RefusalReason};
use crate::pose::Pass;
use crate::program::connecting::pieces::{LitRange, lit_ranges};
use crate::program::connecting::pose_cache::{ArmStand, bits};
use crate::program::connecting::transfer_space::TransferSpace;
use crate::program::connecting::with_robot;
use crate::program::neutral::shortfall::shortfalls;
use crate::program::neutral::steps::{Go, Interpolation, MoveTiming, Station, Step, Steps};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// The way to each piece from the one before or home, and from the last one home; `None`: there is none.
type WaysBetween = Vec<Option<Vec<Go>>>;

impl Drive<'_> {
    /// The steps of what was chosen.
    ///
    /// # Errors
    /// What cannot be driven after all; the rest has to be tried again without it.
    pub fn steps(&self, passes: &[Pass], choice: &Choice) -> Result<Steps, Undriven> {
        let ranges = lit_ranges(passes, self.cuts);
        if let Some(refused) = self.refused_by_contact_at_home(&ranges) {
            let is_empty = refused.is_empty();
            return if is_empty { Ok(Steps::default()) } else { Err(Undriven { refused, ..Undriven::default() }) };
        }
        let space = TransferSpace::of(&self.straight, self.setup, passes);
        let mut whole = self.pieces(&space, passes, choice, &ranges)?;
        let ways = self.ways_without_leads(&space, &mut whole);
        if !self.progress.goes_on() {
            return Err(Undriven::default());
        }
        if let (Some(None), false) = (ways.first(), whole.is_empty()) {
            // Nothing begins here: refuse all pieces up to the first that can be gone to.
            let reachable = |i: &usize| self.known_way(&space, None, Some(&whole[*i].entry())).is_some();
            let begin = (1..whole.len()).into_par_iter().find_first(reachable).unwrap_or(whole.len());
            return Err(unreached(&ranges[..begin], choice));
        }
        let closed = self.unreachable_pieces(&space, &ranges, &whole, &ways);
        if !closed.is_empty() {
            return Err(unreached(&closed, choice));
        }
        let home = Step::Home { percent: self.setup.cell.air.home_percent };
        let mut out = sequence(passes, &ranges, &whole, &ways, home);
        let left_out = ranges.iter().zip(&whole).map(|(of, w)| (&passes[of.pass], w.leads.left_out));
        out.shortfalls = shortfalls(left_out, &self.setup.cell.outputs);
        Ok(out)
    }

    /// The moves from home to where another one leads; `None`: there is no way.
    pub fn way_from_home(&self, passes: &[Pass], entry: &Go) -> Option<Vec<Go>> {
        let space = TransferSpace::of(&self.straight, self.setup, passes);
        let to = ArmStand { at: entry.to, joints_deg: entry.joints_deg? };
        self.known_way(&space, None, Some(&to))
    }

    /// All targets, where something is touched at home.
    fn refused_by_contact_at_home(&self, ranges: &[LitRange]) -> Option<Vec<Refusal>> {
        let contact = self.collision.and_then(|c| c.first_contact(&self.setup.home_joints_deg()))?;
        let why = RefusalReason::ContactAtHome(contact);
        let refuse = |(pass, point)| Refusal { pass, point, cause: RefusalCause::Robot, why: why.clone() };
        let all = ranges.iter().flat_map(|of| (of.first..=of.last).map(move |point| (of.pass, point)));
        Some(all.map(refuse).collect())
    }

    /// The lit pieces as the arm makes them.
    fn pieces(
        &self,
        space: &TransferSpace<'_>,
        passes: &[Pass],
        choice: &Choice,
        ranges: &[LitRange],
    ) -> Result<Vec<DrivenPiece>, Undriven> {
        let driven: Vec<Result<DrivenPiece, Refusal>> = ranges
            .par_iter()
            .take_any_while(|_| self.progress.goes_on())
            .map(|&of| self.driven_piece(space, passes, choice, of))
            .collect();
        if !self.progress.goes_on() {
            return Err(Undriven::default());
        }
        let (mut whole, mut refused) = (Vec::new(), Vec::new());
        for piece in driven {
            match piece {
                Ok(piece) => whole.push(piece),
                Err(refusal) => refused.push(refusal),
            }
        }
        if refused.is_empty() { Ok(whole) } else { Err(Undriven { refused, ..Undriven::default() }) }
    }

    /// The ways between the pieces. Where none leads to the far end of a lead, the lead is left out.
    fn ways_without_leads(&self, space: &TransferSpace<'_>, whole: &mut [DrivenPiece]) -> WaysBetween {
        loop {
            let ways = self.ways(space, whole);
            let closed = (0..ways.len()).filter(|&i| ways[i].is_none());
            let beside: Vec<usize> = closed.flat_map(|i| [i.checked_sub(1), Some(i)]).flatten().collect();
            let with_leads = whole.iter_mut().enumerate().filter(|(i, p)| beside.contains(i) && p.leads.has_any());
            if with_leads.map(|(_, piece)| piece.leads.leave_out()).count() == 0 {
                return ways;
            }
        }
    }

    fn ways(&self, space: &TransferSpace<'_>, whole: &[DrivenPiece]) -> WaysBetween {
        (0..=whole.len())
            .into_par_iter()
            .map(|i| {
                if !self.progress.goes_on() {
                    return None;
                }
                let from = i.checked_sub(1).map(|i| whole[i].exit());
                let to = whole.get(i).map(DrivenPiece::entry);
                self.known_way(space, from.as_ref(), to.as_ref())
            })
            .collect()
    }

    fn known_way(&self, space: &TransferSpace<'_>, from: Option<&ArmStand>, to: Option<&ArmStand>) -> Option<Vec<Go>> {
        let ends = [from, to].map(|s| s.map(|s| bits(&s.joints_deg)));
        self.cache.ways.get(ends, || with_robot::connecting_moves(&self.arm(space), from, to))
    }

    /// Pieces that nothing leads to, or from.
    fn unreachable_pieces(
        &self,
        space: &TransferSpace<'_>,
        ranges: &[LitRange],
        whole: &[DrivenPiece],
        ways: &WaysBetween,
    ) -> Vec<LitRange> {
        let mut out = Vec::new();
        for (i, _) in ways.iter().enumerate().take(ranges.len()).filter(|(_, way)| way.is_none()) {
            // Home is on every way that is tried last: the piece that has none to it is in a pocket.
            let cannot_retract = i > 0 && self.known_way(space, Some(&whole[i - 1].exit()), None).is_none();
            out.push(if cannot_retract { ranges[i - 1] } else { ranges[i] });
        }
        if let (Some(None), Some(last)) = (ways.last(), ranges.last()) {
            out.push(*last);
        }
        out
    }
}

/// Pieces that nothing leads to: their branches are closed, and if they stay so, all their targets are refused.
fn unreached(pieces: &[LitRange], choice: &Choice) -> Undriven {
    let mut out = Undriven::default();
    // The ways to a piece and from it may both be missing: it is refused once.
    for &LitRange { pass, first, last } in BTreeSet::from_iter(pieces) {
        out.closed.extend(choice.rows[pass][first].as_ref().map(|c| (pass, c.branch)));
        let refuse = |point| Refusal { pass, point, cause: RefusalCause::Robot, why: RefusalReason::NoWay };
        out.refused.extend((first..=last).map(refuse));
    }
    out
}

/// Home, all pieces with the ways to them, and home.
fn sequence(passes: &[Pass], ranges: &[LitRange], whole: &[DrivenPiece], ways: &WaysBetween, home: Step) -> Steps {
    let mut out = Steps::default();
    out.list.push(home.clone());
    let mut announced_pass = None;
    let mut at: Option<Station> = None;
    for ((way, of), piece) in ways.iter().zip(ranges).zip(whole) {
        let Some((down, way)) = way.as_ref().and_then(|way| way.split_last()) else { continue };
        for go in way {
            out.push_connecting_move(go, at.as_ref());
            at = Some(go.to);
        }
        let pass = &passes[of.pass];
        if announced_pass != Some(of.pass) {
            out.say_pass(of.pass, pass);
            announced_pass = Some(of.pass);
        }
        let begin = Some((of.pass, of.first));
        let target = begin.filter(|_| piece.leads.before.is_empty());
        out.push_connecting_move(&Go { target, ..*down }, at.as_ref());
        let led_in = &piece.leads.before;
        for (i, lead) in led_in.iter().enumerate().rev() {
            // The way out, backwards.
            let inner = i.checked_sub(1).and_then(|i| led_in.get(i));
            let to = inner.map_or(&piece.start, |inner| &inner.to);
            out.push_lead(to, lead.seconds, (&lead.to.at, begin.filter(|_| i == 0)));
        }
        out.set_process(&pass.settings);
        out.push_lit_piece(piece);
        let mut from = piece.last().at;
        for lead in &piece.leads.behind {
            out.push_lead(&lead.to, lead.seconds, (&from, None));
            from = lead.to.at;
        }
        at = Some(piece.exit().at);
    }
    if let (Some(Some(way)), true) = (ways.last(), !whole.is_empty()) {
        for go in way {
            out.push_connecting_move(go, at.as_ref());
            at = Some(go.to);
        }
    }
    out.list.push(home);
    out
}

impl Steps {
    /// Adds a piece with the laser on.
    fn push_lit_piece(&mut self, piece: &DrivenPiece) {
        self.list.push(Step::Laser(true));
        for l in &piece.lit {
            self.time_s += l.seconds;
            self.list.push(Step::Go(Go {
                to: l.to.at,
                interpolation: Interpolation::Linear,
                joints_deg: Some(l.to.joints_deg),
                timing: MoveTiming::Seconds(l.seconds),
                target: l.target,
            }));
        }
        self.list.push(Step::Laser(false));
    }

    /// Adds a move along a lead, from a station.
    fn push_lead(&mut self, to: &ArmStand, seconds: f64, (from, target): (&Station, Option<(usize, usize)>)) {
        let (interpolation, timing) = (Interpolation::Linear, MoveTiming::Seconds(seconds));
        let go = Go { to: to.at, interpolation, joints_deg: Some(to.joints_deg), timing, target };
        self.push_connecting_move(&go, Some(from));
    }

    /// Adds a connecting move.
    fn push_connecting_move(&mut self, go: &Go, from: Option<&Station>) {
        if let Some(from) = from {
            self.air_mm += (go.to.x - from.x).norm();
        }
        if let MoveTiming::Seconds(s) = go.timing {
            self.time_s += s;
        }
        self.list.push(Step::Go(*go));
    }
}
