//! What both corrections make of the same lines: key `corrections`.

use super::lengths::is_blocked;
use crate::planning::plan::Plan;
use crate::pose::{Correction, Pass, Target, TargetState};
use serde::Serialize;

/// What a correction makes of the same lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CorrectionOutcome {
    /// Its word.
    pub correction: &'static str,
    /// Rows that it corrects.
    pub corrected: usize,
    /// Rows that it leaves blocked.
    pub blocked: usize,
    /// Length that it leaves blocked.
    pub blocked_mm: f64,
    /// Largest angle between beam and normal.
    pub max_tilt_deg: f64,
    /// Fastest turn against the normal.
    pub max_tilt_rate_deg_per_mm: f64,
}

impl CorrectionOutcome {
    fn of<'a>(correction: Correction, passes: impl Iterator<Item = &'a Pass> + Clone) -> CorrectionOutcome {
        let targets = || passes.clone().flat_map(|p| &p.targets);
        let count = |state: TargetState| targets().filter(|t| t.state == state).count();
        CorrectionOutcome {
            correction: correction.word(),
            corrected: count(TargetState::Corrected),
            blocked: count(TargetState::Blocked),
            blocked_mm: passes.clone().map(|p| p.length_mm(is_blocked)).fold(0.0, |a, b| a + b),
            max_tilt_deg: targets()
                .filter(|t| t.state != TargetState::Blocked)
                .map(Target::tilt_deg)
                .fold(0.0, f64::max),
            max_tilt_rate_deg_per_mm: passes.map(Pass::max_tilt_rate_deg_mm).fold(0.0, f64::max),
        }
    }
}

/// Both corrections on the surfaces that were searched.
pub(super) fn corrections(plan: &Plan) -> Vec<CorrectionOutcome> {
    if plan.surfaces.iter().all(|s| s.by_section_plane.is_none()) {
        return Vec::new();
    }
    let searched = plan.surfaces.iter().flat_map(|s| &s.passes);
    let other = plan.surfaces.iter().flat_map(|s| {
        let by_plane = s.by_section_plane.iter().flatten();
        s.passes.iter().zip(by_plane).map(|(own, other)| other.as_ref().unwrap_or(own))
    });
    vec![CorrectionOutcome::of(Correction::Clearance, searched), CorrectionOutcome::of(Correction::SectionPlane, other)]
}
