//! A lit piece as the arm makes it: joints at every target, stations in between where the spot would leave its
//! line, and the leads. How it is come to and left is told elsewhere.

use super::Drive;
use crate::beam::ProcessSettings;
use crate::cell::motion::{Choice, Refusal, RefusalCause, RefusalReason};
use crate::pose::Pass;
use crate::program::connecting::lead::{self, Lead, Leads};
use crate::program::connecting::pieces::LitRange;
use crate::program::connecting::pose_cache::ArmStand;
use crate::program::connecting::transfer_space::TransferSpace;
use crate::program::neutral::steps::Station;

/// A lit piece as the arm makes it.
#[derive(Clone)]
pub(super) struct DrivenPiece {
    pub(super) start: ArmStand,
    pub(super) lit: Vec<WorkMove>,
    pub(super) leads: DrivenLeads,
}

/// Its leads, where they are wanted and the arm can make them: moves from the piece's end outwards, none where there is
/// no lead.
#[derive(Clone, Default)]
pub(super) struct DrivenLeads {
    /// To where the lead-in begins.
    pub(super) before: Vec<WorkMove>,
    /// To where the lead-out ends.
    pub(super) behind: Vec<WorkMove>,
    pub(super) left_out: usize,
}

impl DrivenLeads {
    pub(super) fn has_any(&self) -> bool {
        !self.before.is_empty() || !self.behind.is_empty()
    }

    pub(super) fn leave_out(&mut self) {
        for lead in [&mut self.before, &mut self.behind] {
            self.left_out += usize::from(!std::mem::take(lead).is_empty());
        }
    }
}

impl DrivenPiece {
    pub(super) fn entry(&self) -> ArmStand {
        self.leads.before.last().map_or(self.start, |l| l.to)
    }

    pub(super) fn last(&self) -> ArmStand {
        self.lit.last().map_or(self.start, |lit| lit.to)
    }

    pub(super) fn exit(&self) -> ArmStand {
        self.leads.behind.last().map_or(self.last(), |l| l.to)
    }
}

/// A move at the speed of the work.
#[derive(Clone, Copy)]
pub(super) struct WorkMove {
    pub(super) to: ArmStand,
    pub(super) seconds: f64,
    pub(super) target: Option<(usize, usize)>,
}

impl Drive<'_> {
    pub(super) fn drive_piece(
        &self,
        space: &TransferSpace<'_>,
        passes: &[Pass],
        choice: &Choice,
        of: LitRange,
    ) -> Result<DrivenPiece, Refusal> {
        let (number, first, last) = (of.pass, of.first, of.last);
        let pass = &passes[number];
        let refuse = |point, (cause, why)| Refusal { pass: number, point, cause, why };
        let arm_stand = |point: usize| {
            let chosen = choice.rows[number][point].as_ref();
            chosen
                .map(|c| ArmStand {
                    at: Station::spun(&pass.targets[point], &pass.settings, c.spin_deg),
                    joints_deg: c.joints_deg,
                })
                .ok_or_else(|| refuse(point, (RefusalCause::Reach, RefusalReason::NotChosen)))
        };
        let start = arm_stand(first)?;
        let mut here = start;
        let mut lit = Vec::new();
        for point in first + 1..=last {
            let to = arm_stand(point)?;
            let seconds = pass.targets[point].seconds_from(&pass.targets[point - 1], &pass.settings);
            let before = lit.len();
            self.push_work_moves(&here, &to, (&pass.settings, seconds), &mut lit)
                .map_err(|reason| refuse(point, reason))?;
            if let Some(l) = lit[before..].last_mut() {
                l.target = Some((number, point));
            }
            here = to;
        }
        let leads = self.drive_leads(lead::leads(space, pass, (first, last), [&start.at, &here.at]), &start, &here);
        Ok(DrivenPiece { start, lit, leads })
    }

    /// The leads that the arm can make.
    fn drive_leads(&self, wanted: Leads, start: &ArmStand, end: &ArmStand) -> DrivenLeads {
        let drive_lead = |lead: Lead, from: &ArmStand| {
            let (mut here, mut made) = (*from, Vec::new());
            for (at, seconds) in lead.stations(&from.at) {
                let flange = self.mounted.flange_for(&at.frame());
                let joints_deg = self.robot.nearest_inverse(&flange, &here.joints_deg)?;
                let to = ArmStand { at, joints_deg };
                self.push_lit_move(&here, &to, seconds, &mut made).ok()?;
                here = to;
            }
            Some(made)
        };
        let before = wanted.before.map(|l| drive_lead(l, start));
        let behind = wanted.behind.map(|l| drive_lead(l, end));
        let left_out = wanted.left_out + [&before, &behind].iter().filter(|l| matches!(l, Some(None))).count();
        let made = |lead: Option<Option<Vec<WorkMove>>>| lead.flatten().unwrap_or_default();
        DrivenLeads { before: made(before), behind: made(behind), left_out }
    }

    /// Moves at the speed of the work from one stand to the next, with stations in between where the spot needs them.
    fn push_work_moves(
        &self,
        from: &ArmStand,
        to: &ArmStand,
        (settings, seconds): (&ProcessSettings, f64),
        out: &mut Vec<WorkMove>,
    ) -> Result<(), (RefusalCause, RefusalReason)> {
        let (mut here, mut done) = (*from, 0.0);
        for (share, at) in self.straight.stations_between(&from.at, &to.at, settings, seconds)? {
            let guess = std::array::from_fn(|j| from.joints_deg[j] + (to.joints_deg[j] - from.joints_deg[j]) * share);
            let Some(joints_deg) = self.robot.nearest_inverse(&self.mounted.flange_for(&at.frame()), &guess) else {
                return Err((RefusalCause::Limit, RefusalReason::LimitBetween));
            };
            let next = ArmStand { at, joints_deg };
            self.push_lit_move(&here, &next, seconds * (share - done), out)?;
            (here, done) = (next, share);
        }
        self.push_lit_move(&here, to, seconds * (1.0 - done), out)
    }

    /// Adds one lit move, if arm and part keep clear and no joint is too fast.
    fn push_lit_move(
        &self,
        from: &ArmStand,
        to: &ArmStand,
        seconds: f64,
        out: &mut Vec<WorkMove>,
    ) -> Result<(), (RefusalCause, RefusalReason)> {
        let touched = self.collision.and_then(|c| c.first_contact_between(&from.joints_deg, &to.joints_deg));
        if let Some((_, contact)) = touched {
            return Err(RefusalReason::contact(contact));
        }
        for j in 0..6 {
            let moved = (to.joints_deg[j] - from.joints_deg[j]).abs();
            let can_deg_s = self.robot.speeds_deg_s[j];
            // The ends were chosen by the mean speed; between them a joint may go faster.
            if moved > can_deg_s * seconds + 1e-6 {
                let needs_deg_s = moved / seconds.max(1e-9);
                return Err((RefusalCause::Speed, RefusalReason::JointSpeed { joint: j + 1, needs_deg_s, can_deg_s }));
            }
        }
        out.push(WorkMove { to: *to, seconds, target: None });
        Ok(())
    }
}
