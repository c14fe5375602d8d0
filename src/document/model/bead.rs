//! The `[bead]` table of a job: the bead that is clad, and its layers.

use super::declare::{count, parameters};
use serde::{Deserialize, Serialize};

parameters! {
    /// The bead that is clad, and its layers.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct BeadParameters in "bead" {
        /// Width at its foot (ω of P3), mm; 0: nothing is laid.
        pub width_mm: f64,
        /// Height (h of P3), mm; 0: nothing is laid. Each layer stands so high.
        pub height_mm: f64,
        /// Layers on top of each other.
        #[serde(deserialize_with = "count")]
        pub layers: u32,
        /// How far closed lines begin behind where they begin in the layer before, mm.
        pub start_shift_mm: f64,
        /// Every second layer runs across the others.
        pub alternate: bool = false,
    }
}
