//! How a plan stands in a few numbers: what is not proven, what is left out, what is done.

use super::{NothingReason, PlanFinding, Report};

/// What matters most of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// Moves with the laser on that are not proven to touch nothing.
    Unproven,
    /// Nothing is worked at all.
    Nothing,
    /// Targets are left out.
    LeftOut,
    /// All is worked, and proven.
    Free,
}

/// How a plan stands.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanStatus {
    /// Its targets.
    pub targets: usize,
    /// Targets that are left out.
    pub left_out: usize,
    /// Its moves with the laser on.
    pub lit_moves: usize,
    /// Moves with the laser on that are not proven to be free of contact.
    pub unproven: usize,
    /// Why nothing is worked, where there is no line at all.
    pub nothing: Option<NothingReason>,
}

impl PlanStatus {
    /// What matters most.
    pub fn grade(&self) -> Grade {
        match (self.lit_moves, self.unproven, self.left_out) {
            (0, ..) => Grade::Nothing,
            (_, 1.., _) => Grade::Unproven,
            (_, 0, 1..) => Grade::LeftOut,
            (_, 0, 0) => Grade::Free,
        }
    }

    /// Moves with the laser on that are proven to touch nothing.
    pub fn proven(&self) -> usize {
        self.lit_moves.saturating_sub(self.unproven)
    }
}

impl Report {
    /// How the plan stands; `None` before its moves are looked at.
    pub fn status(&self) -> Option<PlanStatus> {
        let proof = self.proof.as_ref()?;
        let unproven = proof.refuted.len();
        let (targets, left_out, lit_moves) = (self.points, self.blocked, proof.lit_moves);
        let nothing = self.findings.iter().find_map(|finding| match finding {
            PlanFinding::NothingPlanned { reason } => Some(reason.clone()),
            _ => None,
        });
        Some(PlanStatus { targets, left_out, lit_moves, unproven, nothing })
    }
}
