//! A lit piece as the arm makes it: joints at every target, stations in between where the spot would leave its
//! line, and the leads. How it is come to and left is told elsewhere.

use super::air::Space;
use super::drive::{Drive, Piece, Stand};
use super::lead::{self, Lead, Leads};
use super::steps::Station;
use crate::beam::Work;
use crate::cell::motion::{Cause, Choice, Refusal, Why};
use crate::pose::Pass;

/// A lit piece as the arm makes it, or what refuses it.
pub(super) type Driven = Result<DrivenPiece, Refusal>;

/// A lit piece as the arm makes it.
#[derive(Clone)]
pub(super) struct DrivenPiece {
    pub(super) start: Stand,
    pub(super) lit: Vec<Lit>,
    pub(super) leads: DrivenLeads,
}

/// Its leads, where they are wanted and the arm can make them.
#[derive(Clone, Default)]
pub(super) struct DrivenLeads {
    /// To where the lead-in begins.
    pub(super) before: Option<Lit>,
    /// To where the lead-out ends.
    pub(super) behind: Option<Lit>,
    pub(super) left_out: usize,
}

impl DrivenLeads {
    pub(super) fn any(&self) -> bool {
        self.before.is_some() || self.behind.is_some()
    }

    pub(super) fn leave_out(&mut self) {
        self.left_out += usize::from(self.before.take().is_some()) + usize::from(self.behind.take().is_some());
    }
}

impl DrivenPiece {
    pub(super) fn entry(&self) -> Stand {
        self.leads.before.map_or(self.start, |l| l.to)
    }

    pub(super) fn last(&self) -> Stand {
        self.lit.last().map_or(self.start, |lit| lit.to)
    }

    pub(super) fn exit(&self) -> Stand {
        self.leads.behind.map_or(self.last(), |l| l.to)
    }
}

/// A move at the speed of the work.
#[derive(Clone, Copy)]
pub(super) struct Lit {
    pub(super) to: Stand,
    pub(super) seconds: f64,
    pub(super) target: Option<(usize, usize)>,
}

impl Drive<'_> {
    pub(super) fn piece(
        &self,
        space: &Space<'_>,
        passes: &[Pass],
        choice: &Choice,
        (number, first, last): Piece,
    ) -> Driven {
        let pass = &passes[number];
        let refuse = |point, (cause, why)| Refusal { pass: number, point, cause, why };
        let stand = |point: usize| {
            let chosen = choice.rows[number][point].as_ref();
            chosen
                .map(|c| Stand {
                    at: Station::spun(&pass.targets[point], &pass.work, c.spin_deg),
                    joints_deg: c.joints_deg,
                })
                .ok_or_else(|| refuse(point, (Cause::Reach, Why::NotChosen)))
        };
        let start = stand(first)?;
        let mut here = start;
        let mut lit = Vec::new();
        for point in first + 1..=last {
            let to = stand(point)?;
            let seconds = (pass.targets[point].p - pass.targets[point - 1].p).norm() / pass.work.speed_mm_s;
            let before = lit.len();
            self.between(&here, &to, (&pass.work, seconds), &mut lit).map_err(|reason| refuse(point, reason))?;
            if let Some(l) = lit[before..].last_mut() {
                l.target = Some((number, point));
            }
            here = to;
        }
        let leads = self.leads(lead::leads(space, pass, (first, last), [&start.at, &here.at]), &start, &here);
        Ok(DrivenPiece { start, lit, leads })
    }

    /// The leads that the arm can make.
    fn leads(&self, wanted: Leads, start: &Stand, end: &Stand) -> DrivenLeads {
        let led = |lead: Lead, from: &Stand| {
            let joints_deg = self.robot.near(&self.mounted.flange_for(&lead.at.frame()), &from.joints_deg)?;
            let to = Stand { at: lead.at, joints_deg };
            let mut made = Vec::new();
            self.lit(from, &to, lead.seconds, &mut made).ok()?;
            made.pop()
        };
        let before = wanted.before.map(|l| led(l, start));
        let behind = wanted.behind.map(|l| led(l, end));
        let left_out = wanted.left_out + [before, behind].iter().filter(|l| matches!(l, Some(None))).count();
        DrivenLeads { before: before.flatten(), behind: behind.flatten(), left_out }
    }

    /// Lit moves from one stand to the next, with stations in between where the spot needs them.
    fn between(
        &self,
        from: &Stand,
        to: &Stand,
        (work, seconds): (&Work, f64),
        out: &mut Vec<Lit>,
    ) -> Result<(), (Cause, Why)> {
        let (mut here, mut done) = (*from, 0.0);
        for (share, at) in self.straight.between(&from.at, &to.at, work)? {
            let guess = std::array::from_fn(|j| from.joints_deg[j] + (to.joints_deg[j] - from.joints_deg[j]) * share);
            let Some(joints_deg) = self.robot.near(&self.mounted.flange_for(&at.frame()), &guess) else {
                return Err((Cause::Limit, Why::LimitBetween));
            };
            let next = Stand { at, joints_deg };
            self.lit(&here, &next, seconds * (share - done), out)?;
            (here, done) = (next, share);
        }
        self.lit(&here, to, seconds * (1.0 - done), out)
    }

    /// One lit move, if arm and part keep clear and no joint is too fast.
    fn lit(&self, from: &Stand, to: &Stand, seconds: f64, out: &mut Vec<Lit>) -> Result<(), (Cause, Why)> {
        let touched = self.collision.and_then(|c| c.first_between(&from.joints_deg, &to.joints_deg));
        if let Some((_, contact)) = touched {
            return Err(Why::contact(contact));
        }
        for j in 0..6 {
            let moved = (to.joints_deg[j] - from.joints_deg[j]).abs();
            let can_deg_s = self.robot.speeds_deg_s[j];
            // The ends were chosen by the mean speed; between them a joint may go faster.
            if moved > can_deg_s * seconds + 1e-6 {
                let needs_deg_s = moved / seconds.max(1e-9);
                return Err((Cause::Speed, Why::JointSpeed { joint: j + 1, needs_deg_s, can_deg_s }));
            }
        }
        out.push(Lit { to: *to, seconds, target: None });
        Ok(())
    }
}
