//! The passes of a weld: those that were ground, with what they took off, and those that are left by the last measurement
//! (P4 4).

use super::report_rows::{GroundPassReport, HeldReason};
use super::{MeasuredWeld, WeldError};
use crate::document::model::JobWeld;
use crate::weld::passes::{GrindingPass, GrindingRules, area_above_mm2, schedule};

/// Passes done and passes to come.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WeldProgress {
    /// The passes that were ground.
    pub done: Vec<GroundPassReport>,
    /// The passes that are left, from the next one on.
    pub left: Vec<GrindingPass>,
    /// Why the next one is not given out; `None`: it is.
    pub held: Option<HeldReason>,
}

impl WeldProgress {
    /// The passes of the bead of a job. Without a bead there are none. `open`: why the place of all areas is open.
    ///
    /// # Errors
    /// There would be too many.
    pub fn new(measured: &MeasuredWeld, weld: &JobWeld, open: Option<HeldReason>) -> Result<WeldProgress, WeldError> {
        let height_mm = measured.bead().map_or(0.0, |bead| bead.max_height_mm);
        let after = weld.history.iter().skip(1).map(|pass| pass.height_mm).chain([height_mm]);
        let ground = weld.history.iter().zip(after);
        let done: Vec<GroundPassReport> = ground
            .map(|(pass, left_mm)| GroundPassReport { before_mm: pass.height_mm, planned_mm: pass.planned_mm, left_mm })
            .collect();
        let below_mm = measured.below_mm;
        let open = open.filter(|_| !weld.goes_on);
        let Some(bead) = measured.bead() else { return Ok(WeldProgress { done, left: Vec::new(), held: open }) };
        let held = done.last().and_then(|last| off_plan(last, weld.removal_share / 100.0));
        let held = held.or((below_mm > weld.below_mm).then_some(HeldReason::Below { below_mm }));
        let held = open.or(held.filter(|_| !weld.goes_on));
        let rules = GrindingRules { depth_per_pass_mm: weld.pass_depth_mm, residual_mm: weld.residual_mm };
        let planned = schedule(height_mm, &rules, |level_mm| area_above_mm2(&bead.sections, bead.length_mm, level_mm))
            .map_err(WeldError::Passes)?;
        Ok(WeldProgress { done, left: planned.passes, held })
    }

    /// The heights that the passes of a program of so many grind down to, mm, falling.
    pub fn levels_mm(&self, at_once: u32) -> Vec<f64> {
        self.left.iter().take(at_once as usize).map(|pass| pass.level_mm).collect()
    }
}

/// Whether a pass took off more or less than it should, by more than this share.
fn off_plan(pass: &GroundPassReport, most_share: f64) -> Option<HeldReason> {
    let (removed_mm, planned_mm) = (pass.before_mm - pass.left_mm, pass.before_mm - pass.planned_mm);
    ((removed_mm - planned_mm).abs() > most_share * planned_mm)
        .then_some(HeldReason::Removal { removed_mm, planned_mm })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pass_that_took_off_half_or_twice_is_held_and_one_by_the_plan_is_not() {
        let pass = |left_mm: f64| GroundPassReport { before_mm: 4.0, planned_mm: 3.5, left_mm };
        assert_eq!(off_plan(&pass(3.55), 0.3), None);
        let little = off_plan(&pass(3.75), 0.3);
        assert_eq!(little, Some(HeldReason::Removal { removed_mm: 0.25, planned_mm: 0.5 }));
        assert_eq!(off_plan(&pass(3.0), 0.3), Some(HeldReason::Removal { removed_mm: 1.0, planned_mm: 0.5 }));
    }
}
