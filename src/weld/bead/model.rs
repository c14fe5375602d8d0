//! What is known of a bead, and why nothing is.

use super::histogram::HeightHistogram;
use crate::weld::parent::{ParentError, ParentSurface};
use crate::weld::raster::Mask;
use nalgebra::{Point3, Vector3};
use serde::Serialize;
use thiserror::Error;

/// A bead.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldBead {
    /// The surface that it stands on.
    pub parent: ParentSurface,
    /// Its pixels.
    pub outline: Mask,
    /// Sections at even steps along its centre line, from end to end.
    pub sections: Vec<WeldSection>,
    /// Length of its centre line on the parent surface, mm.
    pub length_mm: f64,
    /// Median of the widths of its sections, mm.
    pub width_mm: f64,
    /// The greatest height of its sections, mm.
    pub max_height_mm: f64,
    /// The heights of its points.
    pub heights: HeightHistogram,
    /// Its points.
    pub points: Vec<BeadPoint>,
}

/// A section of a bead.
#[derive(Clone, Debug, PartialEq)]
pub struct WeldSection {
    /// Way along the centre line, mm.
    pub along_mm: f64,
    /// Where the centre line is, on the parent surface, camera frame, mm.
    pub centre: Point3<f64>,
    /// Of the parent surface, towards the camera.
    pub normal: Vector3<f64>,
    /// Along the centre line.
    pub tangent: Vector3<f64>,
    /// From edge to edge, mm.
    pub width_mm: f64,
    /// Of its crest above the parent surface, mm; not smoothed further along than noise asks for.
    pub height_mm: f64,
    /// Heights across: distance from the centre to the left of the tangent (normal × tangent), and height, mm.
    pub profile_mm: Vec<[f64; 2]>,
}

/// A point of a bead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeadPoint {
    /// Its pixel.
    pub pixel: [u32; 2],
    /// Camera frame, mm.
    pub point: Point3<f64>,
    /// Its foot on the parent surface, camera frame, mm.
    pub foot: Point3<f64>,
    /// Above the parent surface, mm.
    pub height_mm: f64,
}

/// What a masked area is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum AreaKind {
    /// It stands above the parent surface.
    #[serde(rename = "bead")]
    Bead,
    /// It does not: a ground or scratched area.
    #[serde(rename = "defect")]
    Flat,
}

/// Why a bead cannot be measured.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum WeldBeadError {
    /// It has no parent surface.
    #[error(transparent)]
    Parent(#[from] ParentError),
    /// Nothing under the mask stands above the parent surface.
    #[error("nothing stands {threshold_mm} mm above the parent surface")]
    NothingStands {
        /// What it would have to be, mm.
        threshold_mm: f64,
    },
    /// It reaches the rim of the image, or of what was measured.
    #[error("the bead leaves the image")]
    LeavesImage,
    /// It is too short to have a centre line.
    #[error("{length_mm} mm long")]
    Short {
        /// Its length, mm.
        length_mm: f64,
    },
    /// Its edges were not found: it runs into something beside it, or has none.
    #[error("no edges")]
    NoEdges,
}
