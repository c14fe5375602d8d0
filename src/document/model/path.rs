//! The `[path]` table of a job: which points of a line become targets, and how the beam may stand there.

use super::declare::parameters;
use crate::path::AxisSource;
use crate::pose::Correction;
use serde::{Deserialize, Serialize};

parameters! {
    /// Which points of a line become targets.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct PathParameters in "path" {
        /// Distance of a dropped point from the chord that spans it (dε of P2), mm.
        pub chord_error_mm: f64,
        /// Longest chord, mm.
        pub max_step_mm: f64,
        /// Largest turn of the normal between two targets, degrees.
        pub max_turn_deg: f64,
        /// What the beam stands along where nothing is in its way.
        pub axis: AxisSource = AxisSource::Mesh,
        /// What is done about interference.
        pub correction: Correction = Correction::SectionPlane,
        /// Greatest angle between beam and normal, degrees.
        pub max_tilt_deg: f64,
        /// How fast the search may turn the beam against the normal along the line, degrees/mm.
        pub tilt_rate_deg_mm: f64,
        /// How fast the beam may turn against the normal at the programmed speed, degrees/s.
        pub tilt_rate_deg_s: f64,
        /// How far the head may be drawn back or pushed forward on a line that is blocked otherwise, mm.
        pub standoff_mm: f64,
        /// How far before the line the spot starts, the laser off, at the speed of the work, mm.
        pub lead_in_mm: f64,
        /// How far the spot goes on behind the end of the line, the laser off, mm.
        pub lead_out_mm: f64,
    }
}
