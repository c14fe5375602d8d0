//! The `[beam]` table of a job: the beam, its speeds and its head.

use super::declare::parameters;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

parameters! {
    /// The beam and its speeds (P1 Table 1).
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct BeamParameters in "beam" {
        /// D: the focus stands at `p + D·a`, mm.
        pub defocus_mm: f64,
        /// Laser power, W.
        pub power_w: f64,
        /// Diameter of the spot on the part, mm.
        pub spot_mm: f64,
        /// Speed of the spot on the part, mm/s.
        pub speed_mm_s: f64,
        /// Frequency of the laser's pulses, kHz; 0: none, or as it is set at the laser.
        pub frequency_khz: f64,
        /// Speed of the focus with the laser off, mm/s.
        pub air_speed_mm_s: f64,
        /// Head: a TOML stack or an STL, relative to the job file; empty: the beam is a ray.
        pub head: String = String::new(),
        /// What cone and head keep from everything, mm.
        pub margin_mm: f64,
    }
}

impl BeamParameters {
    /// Area of the spot on the part, mm².
    pub fn spot_area_mm2(&self) -> f64 {
        0.25 * PI * self.spot_mm * self.spot_mm
    }
}
