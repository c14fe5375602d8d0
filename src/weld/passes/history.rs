//! What was ground so far: after each pass the bead is measured again, and the next pass follows from that (P4 4).
//!
//! The next pass is held back where the last took much more or less than planned, or where something was ground below the
//! parent surface: then it needs the operator's word, which is not kept here.

use super::{GrindingPass, GrindingRules, PassError, PassSchedule, schedule};
use crate::weld::bead::BeadState;

/// A pass that was ground, between two measurements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundPass {
    /// What it should take off the highest place, mm.
    pub planned_mm: f64,
    /// The bead before it.
    pub before: BeadState,
    /// The bead after it.
    pub after: BeadState,
}

impl GroundPass {
    /// What it took off the highest place, mm; below 0 where the bead was measured higher than before.
    pub fn removed_mm(&self) -> f64 {
        self.before.height_mm - self.after.height_mm
    }

    /// How far that is off the planned, as a share of the planned.
    pub fn off_share(&self) -> f64 {
        (self.removed_mm() - self.planned_mm) / self.planned_mm
    }
}

/// Why the next pass is held back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HoldReason {
    /// The last pass took another depth than planned, by more than the share that is allowed.
    Removal {
        /// Planned, mm.
        planned_mm: f64,
        /// Measured, mm.
        removed_mm: f64,
    },
    /// Something lies below the parent surface by more than is allowed.
    BelowParent {
        /// By how much, mm.
        below_mm: f64,
    },
}

/// What comes next.
#[derive(Clone, Debug, PartialEq)]
pub enum NextPass {
    /// The residual height is reached.
    Done,
    /// This pass.
    Grind(GrindingPass),
    /// This pass, once the operator says so.
    Held {
        /// The pass.
        pass: GrindingPass,
        /// Why it is held back; one reason at least.
        reasons: Vec<HoldReason>,
    },
}

/// The passes of a bead so far, and what is left.
#[derive(Clone, Debug, PartialEq)]
pub struct GrindingHistory {
    rules: GrindingRules,
    state: BeadState,
    ground: Vec<GroundPass>,
    left: PassSchedule,
}

impl GrindingHistory {
    /// Begins with the first measurement. `area_above_mm2`: where the bead stands above a level.
    ///
    /// # Errors
    /// Nothing can be planned by these figures.
    pub fn begin(
        rules: GrindingRules,
        state: BeadState,
        area_above_mm2: impl Fn(f64) -> f64,
    ) -> Result<GrindingHistory, PassError> {
        let left = schedule(state.height_mm, &rules, area_above_mm2)?;
        Ok(GrindingHistory { rules, state, ground: Vec::new(), left })
    }

    /// The measurement after the pass that was next; what is left is planned from it. Where nothing was left to grind the
    /// measurement is only the newer one.
    ///
    /// # Errors
    /// Nothing can be planned from it; then all stays as it was.
    pub fn measured(&mut self, after: BeadState, area_above_mm2: impl Fn(f64) -> f64) -> Result<(), PassError> {
        let left = schedule(after.height_mm, &self.rules, area_above_mm2)?;
        if let Some(pass) = self.left.passes.first() {
            self.ground.push(GroundPass { planned_mm: pass.infeed_mm, before: self.state, after });
        }
        (self.state, self.left) = (after, left);
        Ok(())
    }

    /// What comes next.
    pub fn next(&self) -> NextPass {
        let Some(pass) = self.left.passes.first().copied() else { return NextPass::Done };
        let mut reasons = Vec::new();
        if let Some(last) = self.ground.last().filter(|last| last.off_share().abs() > self.rules.most_off_share) {
            reasons.push(HoldReason::Removal { planned_mm: last.planned_mm, removed_mm: last.removed_mm() });
        }
        if self.state.below_mm > self.rules.below_parent_mm {
            reasons.push(HoldReason::BelowParent { below_mm: self.state.below_mm });
        }
        if reasons.is_empty() { NextPass::Grind(pass) } else { NextPass::Held { pass, reasons } }
    }

    /// The passes that were ground.
    pub fn ground(&self) -> &[GroundPass] {
        &self.ground
    }

    /// The passes that are left, as planned from the last measurement.
    pub fn left(&self) -> &PassSchedule {
        &self.left
    }

    /// The last measurement.
    pub fn state(&self) -> BeadState {
        self.state
    }
}
