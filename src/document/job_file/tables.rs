//! Tables and rows of a job file that say something of single surfaces.

use crate::document::chosen::Chosen;
use crate::document::model::SurfaceParameters;
use crate::document::settings::Settings;
use crate::document::start_from::StartFrom;
use crate::part::{SurfaceEdit, SurfaceId};
use crate::pose::Tilt;
use crate::pose::tilt::Side;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How facets become surfaces, and what is said of single surfaces beside the order of work.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct SurfaceTable {
    pub(super) angle_deg: f64,
    pub(super) min_area_mm2: f64,
    pub(super) hysteresis_deg: f64,
    pub(super) flipped: Vec<SurfaceId>,
    pub(super) names: BTreeMap<String, String>,
    pub(super) edits: Vec<SurfaceEdit>,
}

impl Default for SurfaceTable {
    fn default() -> Self {
        SurfaceTable::new(&SurfaceParameters::default(), &Settings::default())
    }
}

impl SurfaceTable {
    pub(super) fn new(parameters: &SurfaceParameters, settings: &Settings) -> SurfaceTable {
        let named = settings.iter().filter(|(_, s)| !s.name.is_empty());
        SurfaceTable {
            angle_deg: parameters.angle_deg,
            min_area_mm2: parameters.min_area_mm2,
            hysteresis_deg: parameters.hysteresis_deg,
            flipped: settings.having(|s| s.flipped),
            names: named.map(|(id, s)| (id.to_string(), s.name.clone())).collect(),
            edits: parameters.edits.clone(),
        }
    }
}

/// Which surfaces are cleaned, and which are put aside.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct CleanTable {
    pub(super) surfaces: Chosen,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) later: Vec<SurfaceId>,
}

/// What one surface asks of the tilt.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct TiltRow {
    pub(super) surface: SurfaceId,
    pub(super) preferred: Tilt,
    pub(super) least_deg: f64,
    pub(super) forbidden: Vec<Side>,
}

/// A tilt that is set on a line of one surface.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct PinRow {
    pub(super) surface: SurfaceId,
    pub(super) line: u32,
    pub(super) at_mm: f64,
    pub(super) tilt: Tilt,
}

/// Where the lines of one surface start.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StartRow {
    pub(super) surface: SurfaceId,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) border: Option<StartFrom>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) centre_mm: Option<[f64; 3]>,
}
