//! How facets become feature surfaces: in memory, and in the file, where the table also lists what is said of single
//! surfaces.

use super::declare::parameters;
use crate::document::settings::Settings;
use crate::part::{SurfaceEdit, SurfaceId, SurfaceRule};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

parameters! {
    /// How facets become feature surfaces.
    #[derive(Clone, Debug, PartialEq)]
    pub struct SurfaceParameters in "surfaces" {
        /// Dihedral angle from which an edge is a crease (α), degrees.
        pub angle_deg: f64,
        /// Islands below this area are absorbed, mm²; 0 = off.
        pub min_area_mm2: f64,
        /// Lower angle of the hysteresis, degrees; 0 = off.
        pub hysteresis_deg: f64,
        /// Merges and splits in the order made.
        pub edits: Vec<SurfaceEdit> = Vec::new(),
    }
}

impl SurfaceParameters {
    /// The rule without the operator's edits.
    pub fn rule(&self) -> SurfaceRule {
        SurfaceRule { angle_deg: self.angle_deg, min_area_mm2: self.min_area_mm2, hysteresis_deg: self.hysteresis_deg }
    }
}

/// The `[surfaces]` table of a job file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(in crate::document) struct SurfaceTable {
    angle_deg: f64,
    min_area_mm2: f64,
    hysteresis_deg: f64,
    /// Surfaces whose other side is worked on.
    pub flipped: Vec<SurfaceId>,
    /// Names by the numbers of surfaces.
    pub names: BTreeMap<String, String>,
    edits: Vec<SurfaceEdit>,
}

impl Default for SurfaceTable {
    fn default() -> Self {
        SurfaceTable::new(&SurfaceParameters::default(), &Settings::default())
    }
}

impl SurfaceTable {
    /// The table of a job.
    pub fn new(parameters: &SurfaceParameters, settings: &Settings) -> SurfaceTable {
        let SurfaceParameters { angle_deg, min_area_mm2, hysteresis_deg, edits } = parameters.clone();
        let named = settings.iter().filter(|(_, s)| !s.name.is_empty());
        SurfaceTable {
            angle_deg,
            min_area_mm2,
            hysteresis_deg,
            flipped: settings.having(|s| s.flipped),
            names: named.map(|(id, s)| (id.to_string(), s.name.clone())).collect(),
            edits,
        }
    }

    /// What it says of all surfaces.
    pub fn into_parameters(self) -> SurfaceParameters {
        let SurfaceTable { angle_deg, min_area_mm2, hysteresis_deg, flipped: _, names: _, edits } = self;
        SurfaceParameters { angle_deg, min_area_mm2, hysteresis_deg, edits }
    }
}
