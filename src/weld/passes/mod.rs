//! Grinding a bead down in passes (P4 4): how many, to which level each, and what is left for each to take.
//!
//! Levels are heights above the parent surface. This is the plan from one measurement: after each pass the bead is measured
//! again, and planned anew. How fast and with what force a pass takes its depth is for others.

use super::bead::WeldSection;
use serde::Serialize;
use thiserror::Error;

/// More passes than this are none that anyone wants.
pub const MOST_PASSES: usize = 1000;
/// A height this near above a whole number of passes asks for no further one, mm: digits, nothing measured.
const WHOLE_MM: f64 = 1e-9;

/// How a bead is ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrindingRules {
    /// What one pass takes off, mm; above 0.
    pub depth_per_pass_mm: f64,
    /// The height that is left standing, mm; 0: down to the parent surface.
    pub residual_mm: f64,
}

impl Default for GrindingRules {
    fn default() -> Self {
        GrindingRules { depth_per_pass_mm: 0.5, residual_mm: 0.0 }
    }
}

/// A pass.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GrindingPass {
    /// Height above the parent surface that the bead has after it, mm.
    pub level_mm: f64,
    /// What it takes off the highest place, mm: the depth of a pass, or less in the last.
    pub infeed_mm: f64,
    /// Where the bead stands above that level, mm² on the parent surface: what it has to go over.
    pub area_mm2: f64,
}

/// The passes of a bead as it was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PassSchedule {
    /// From the first to the last; none: there is nothing to take off.
    pub passes: Vec<GrindingPass>,
}

/// Figures that no bead can be ground by.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum PassError {
    /// A rule is out of its range.
    #[error("{key} = {value}")]
    Rule {
        /// Its name.
        key: &'static str,
        /// What it is.
        value: f64,
    },
    /// The height is no number.
    #[error("height {height_mm} mm")]
    Height {
        /// What it is.
        height_mm: f64,
    },
    /// There would be more than [`MOST_PASSES`].
    #[error("{passes} passes")]
    ManyPasses {
        /// How many.
        passes: f64,
    },
}

impl GrindingRules {
    /// Whether a bead can be ground by them.
    ///
    /// # Errors
    /// The first that is out of its range.
    pub fn check(&self) -> Result<(), PassError> {
        let GrindingRules { depth_per_pass_mm, residual_mm } = *self;
        if !(depth_per_pass_mm > 0.0 && depth_per_pass_mm.is_finite()) {
            return Err(PassError::Rule { key: "depth_per_pass_mm", value: depth_per_pass_mm });
        }
        if !(residual_mm >= 0.0 && residual_mm.is_finite()) {
            return Err(PassError::Rule { key: "residual_mm", value: residual_mm });
        }
        Ok(())
    }
}

/// Plans the passes from a height down to the residual one: as many as the depth of a pass goes into what stands above it,
/// rounded up. All but the last take that depth. `area_above_mm2`: where the bead stands above a level.
///
/// # Errors
/// The rules or the height are none, or there would be too many passes.
pub fn schedule(
    height_mm: f64,
    rules: &GrindingRules,
    area_above_mm2: impl Fn(f64) -> f64,
) -> Result<PassSchedule, PassError> {
    rules.check()?;
    if !height_mm.is_finite() {
        return Err(PassError::Height { height_mm });
    }
    let passes = ((height_mm - rules.residual_mm - WHOLE_MM) / rules.depth_per_pass_mm).ceil().max(0.0);
    if passes > MOST_PASSES as f64 {
        return Err(PassError::ManyPasses { passes });
    }
    let level = |k: usize| (height_mm - k as f64 * rules.depth_per_pass_mm).max(rules.residual_mm);
    let pass = |k: usize| GrindingPass {
        level_mm: level(k + 1),
        infeed_mm: level(k) - level(k + 1),
        area_mm2: area_above_mm2(level(k + 1)),
    };
    Ok(PassSchedule { passes: (0..passes as usize).map(pass).collect() })
}

/// Where a bead stands above a level, mm² on the parent surface: the widths of its sections above it, times their distance.
/// `length_mm`: of its centre line.
pub fn area_above_mm2(sections: &[WeldSection], length_mm: f64, level_mm: f64) -> f64 {
    let step_mm = length_mm / sections.len().max(1) as f64;
    let width = |profile: &[[f64; 2]], width_mm: f64| {
        let edge = 0.5 * width_mm;
        // The bead stands at 0 on its edges.
        let corners = std::iter::once([-edge, 0.0]).chain(profile.iter().copied()).chain(std::iter::once([edge, 0.0]));
        let corners: Vec<[f64; 2]> = corners.collect();
        corners.windows(2).map(|w| above(w[0], w[1], level_mm)).sum::<f64>()
    };
    sections.iter().map(|s| width(&s.profile_mm, s.width_mm) * step_mm).sum()
}

/// How much of the way from one corner to the next lies above a level.
fn above([x, a]: [f64; 2], [y, b]: [f64; 2], level: f64) -> f64 {
    let way = (y - x).max(0.0);
    let (low, high) = (a.min(b), a.max(b));
    if low >= level {
        // On the level itself counts, or a bead without flanks would have no area above 0.
        way
    } else if high <= level {
        0.0
    } else {
        way * (high - level) / (high - low)
    }
}

#[cfg(test)]
mod tests;
