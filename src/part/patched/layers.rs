//! How many beads on top of each other fill a patch, and where each of them is needed: the contour of the depth at every
//! bead's height. What lies between them, and how a bead is laid, is not told here.

use super::contour::{NO_PATCH, Piece, Pieces};
use super::{PatchCut, RefinedFacets};
use crate::part::loops::loops;
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use std::collections::BTreeSet;
use thiserror::Error;

/// As many layers as a bead can have in a job.
const MOST_LAYERS: f64 = 1000.0;

/// Depths that are this share of a bead above a whole number of beads need no bead more: 1.1 / 0.1 is not quite 11.
const ROUNDING: f64 = 1e-9;

/// One layer of the beads that fill a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchLayer {
    /// It is needed where the patch is deeper than this, mm: so many beads fill it already. For the first layer what
    /// counts as a patch.
    pub above_mm: f64,
    /// What it has to fill where the patch is deepest, mm: the bead's height, and in the last layer what is left.
    pub height_mm: f64,
    /// Where it is needed: closed polylines on the model, the area on their left seen from outside; the last point is
    /// not the first again. Part frame, mm.
    pub outlines: Vec<Vec<Point3<f64>>>,
    /// Area within them, mm².
    pub area_mm2: f64,
}

/// Why there are no layers.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum LayersError {
    /// The bead has no height.
    #[error("bead height {height_mm}")]
    NoHeight {
        /// The height, mm.
        height_mm: f64,
    },
    /// There would be more than any job has.
    #[error("{count} layers")]
    TooMany {
        /// How many.
        count: f64,
    },
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for LayersError {
    fn from(_: Cancelled) -> LayersError {
        LayersError::Cancelled
    }
}

/// The layers that fill a patch, in the order in which they are laid: each follows the worn surface, and each is needed
/// within the one before. There are `depth_mm / height_mm` of them, rounded up.
///
/// `triangles`: those that the patch lies in; `above_mm`: what is deeper is in the patch; `depth_mm`: how deep it is.
///
/// # Errors
/// A bead without height, or one so low that there would be more than 1000 layers; [`LayersError::Cancelled`] when
/// `progress` says so.
pub fn patch_layers(
    refined: &RefinedFacets<'_>,
    triangles: &[u32],
    above_mm: f64,
    depth_mm: f64,
    height_mm: f64,
    progress: &Progress,
) -> Result<Vec<PatchLayer>, LayersError> {
    let count = layer_count(depth_mm, height_mm)?;
    let triangles = [triangles.to_vec()];
    let layer = |k: u32| {
        progress.check()?;
        let filled_mm = f64::from(k) * height_mm;
        let above_mm = above_mm.max(filled_mm);
        let Pieces { cut_points, pieces } =
            Pieces::new(refined, &PatchCut { above_mm, levels_mm: &[], triangles: &triangles });
        let at = |v: u32| {
            let v = v as usize;
            refined.vertices.get(v).copied().unwrap_or_else(|| cut_points[v - refined.vertices.len()])
        };
        let within = || pieces.iter().filter(|p| p.patch != NO_PATCH);
        let outlines = rims(within()).into_iter().map(|rim| rim.into_iter().map(at).collect());
        let area = |p: &Piece| {
            let [a, b, c] = p.corners.map(at);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        Ok(PatchLayer {
            above_mm,
            height_mm: height_mm.min(depth_mm - filled_mm),
            outlines: outlines.collect(),
            area_mm2: within().map(area).sum(),
        })
    };
    (0..count).map(layer).collect()
}

/// How many beads on top of each other fill a depth: `depth_mm / height_mm`, rounded up; none where nothing is missing.
///
/// # Errors
/// A bead without height, or one so low that there would be more than 1000 layers.
pub fn layer_count(depth_mm: f64, height_mm: f64) -> Result<u32, LayersError> {
    if !height_mm.is_finite() || height_mm <= 0.0 {
        return Err(LayersError::NoHeight { height_mm });
    }
    let count = (depth_mm / height_mm - ROUNDING).ceil();
    if count > MOST_LAYERS || count.is_nan() {
        return Err(LayersError::TooMany { count });
    }
    // Below 0 it becomes 0.
    Ok(count as u32)
}

/// The rims of pieces: edges that one of them alone has, chained as the pieces run through them.
fn rims<'a>(pieces: impl Iterator<Item = &'a Piece>) -> Vec<Vec<u32>> {
    let mut open: BTreeSet<(u32, u32)> = BTreeSet::new();
    for piece in pieces {
        for k in 0..3 {
            let (a, b) = (piece.corners[k], piece.corners[(k + 1) % 3]);
            if !open.remove(&(b, a)) {
                open.insert((a, b));
            }
        }
    }
    loops(open)
}
