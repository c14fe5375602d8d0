//! A path straight from a cloud, without a model (P3 4.1): where planes cut what was scanned, as curves of points with
//! tangent and normal.
//!
//! Points of a band about each plane are carried onto it along the surface (`band`), put in order (`order`), fitted by a
//! spline (`curve_fit`) and sampled (`sampling`). Where the planes stand is given, and what is done with the curves is
//! not known here. Gaps in the scan are gaps of the curves.

mod band;
mod banded;
mod chain;
mod curve_fit;
mod grid;
mod order;
mod oriented;
mod rules;
mod sampling;
mod scale;
mod slice;
mod spline;
#[cfg(test)]
mod tests;

pub use rules::{OutwardSide, SlicePlane, SliceRules};
pub use slice::{CloudSlice, SliceCurve, SlicePoint};

use super::cloud::Cloud;
use super::neighbours::Neighbours;
use crate::progress::{Cancelled, Progress};
use band::PlaneFrame;
use nalgebra::Point3;
use rayon::prelude::*;
use scale::ScaledPiece;

/// Cuts a cloud by planes; one slice for each, in their order. `neighbours` are the cloud's; `normals`, one for each point,
/// those of [`fitted_normals`](super::normals::fitted_normals): a point whose normal is zero, or that has none, takes
/// no part, nor does one where plane and surface meet under less than 15°.
///
/// The same input gives the same bytes, on any number of threads.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn slices(
    cloud: &Cloud,
    neighbours: &Neighbours,
    normals: &[[f32; 3]],
    planes: &[SlicePlane],
    rules: &SliceRules,
    progress: &Progress,
) -> Result<Vec<CloudSlice>, Cancelled> {
    let pieces = scale::scaled_pieces(cloud, neighbours, normals, progress)?;
    let whole = (cloud.origin, normals, pieces.as_slice());
    planes.par_iter().map(|plane| slice(cloud, whole, plane, rules, progress)).collect()
}

fn slice(
    cloud: &Cloud,
    (near, normals, pieces): (Point3<f64>, &[[f32; 3]], &[ScaledPiece<'_>]),
    plane: &SlicePlane,
    rules: &SliceRules,
    progress: &Progress,
) -> Result<CloudSlice, Cancelled> {
    progress.check()?;
    let frame = PlaneFrame::new(plane, &near);
    let band = band::band(cloud, normals, pieces, plane, &frame);
    progress.check()?;
    let chains = order::chains(&band, rules.outward == OutwardSide::OfNormals);
    let mut left_over = band.len();
    let mut curves = Vec::with_capacity(chains.len());
    for chain in &chains {
        progress.check()?;
        let points = oriented::ordered(&band, chain, &rules.outward, &frame);
        let Some(fit) = curve_fit::fitted(&points, rules.tolerance_mm) else { continue };
        left_over -= chain.points.len();
        let (squares, max_residual_mm) =
            fit.residuals.iter().fold((0.0, 0.0f64), |(s, m), r| (s + r.1 * r.1, m.max(r.1.abs())));
        curves.push(SliceCurve {
            points: sampling::sampled(&fit, &points, rules, &frame),
            closed: chain.round_mm.is_some(),
            fitted_points: fit.residuals.len(),
            max_residual_mm,
            rms_mm: (squares / fit.residuals.len().max(1) as f64).sqrt(),
        });
    }
    Ok(CloudSlice { curves, left_over })
}
