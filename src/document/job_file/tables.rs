//! Tables and rows of a job file that say something of single surfaces.

use crate::document::chosen::Chosen;
use crate::document::start_from::StartFrom;
use crate::part::SurfaceId;
use crate::pose::Tilt;
use crate::pose::tilt::TiltSide;
use serde::{Deserialize, Serialize};

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
    pub(super) forbidden: Vec<TiltSide>,
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
