//! How dense a cloud is at each place, and how noisy as a whole: what widths of bands and gaps are told by.
//!
//! Asked at a few points of each piece of the cloud, since a slice needs no more.

use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::{Neighbour, Neighbours, Piece};
use crate::scan::upper_median;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Points of a piece: at 10 a mm² it is 4 mm wide.
const PIECE_POINTS: usize = 128;
/// Points of a piece that are asked, and neighbours of each; the middle one of three is no outlier's.
const PROBES: usize = 3;
const NEIGHBOURS: usize = 20;
/// Spacings beyond these shares of the middle of all pieces are taken for them: a band about stray points would be as wide
/// as the part, and one about points that a file has twice as narrow as their rounding.
const RANGE: [f64; 2] = [1.0 / 64.0, 8.0];
/// A spacing is taken for no less than so many standard deviations of the noise: closer together points have no order.
const NOISE_SPACINGS: f64 = 3.0;

/// A piece of the cloud and the unit of length there.
#[derive(Clone, Debug)]
pub(super) struct ScaledPiece<'a> {
    pub(super) piece: Piece<'a>,
    /// Spacing of points as if on a square grid, but no less than three standard deviations of the noise, mm.
    pub(super) scale_mm: f64,
}

/// Pieces of a cloud with their scales. `normals`: one for each point, zero where there is none.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub(super) fn scaled_pieces<'a>(
    cloud: &Cloud,
    neighbours: &'a Neighbours,
    normals: &[[f32; 3]],
    progress: &Progress,
) -> Result<Vec<ScaledPiece<'a>>, Cancelled> {
    let pieces: Vec<Piece<'_>> = neighbours.pieces(PIECE_POINTS).collect();
    let probed = |piece: &Piece<'_>| {
        progress.check()?;
        let mut near = Vec::new();
        let last = piece.indices.len().saturating_sub(1);
        let probes = (0..PROBES).filter_map(|k| piece.indices.get(k * last / (PROBES - 1)));
        let found: Vec<Probe> =
            probes.filter_map(|&i| probe(cloud, neighbours, normals, i as usize, &mut near)).collect();
        let spacing_mm = median(found.iter().map(|p| p.spacing_mm));
        Ok((spacing_mm, median(found.iter().map(|p| p.noise_mm))))
    };
    let probed: Vec<(f64, f64)> = pieces.par_iter().map(probed).collect::<Result<_, Cancelled>>()?;
    let middle_mm = median(probed.iter().map(|p| p.0).filter(|s| *s > 0.0));
    let noise_mm = median(probed.iter().filter(|p| p.0 > 0.0).map(|p| p.1));
    let scaled = |(piece, (spacing_mm, _)): (Piece<'a>, (f64, f64))| ScaledPiece {
        piece,
        scale_mm: spacing_mm.min(RANGE[1] * middle_mm).max(RANGE[0] * middle_mm).max(NOISE_SPACINGS * noise_mm),
    };
    Ok(pieces.into_iter().zip(probed).map(scaled).collect())
}

struct Probe {
    spacing_mm: f64,
    noise_mm: f64,
}

/// Spacing and noise at a point of the cloud; `None` where it is no number or too lonely.
fn probe(
    cloud: &Cloud,
    neighbours: &Neighbours,
    normals: &[[f32; 3]],
    index: usize,
    near: &mut Vec<Neighbour>,
) -> Option<Probe> {
    let at = cloud.point(index);
    let normal = Vector3::from(normals.get(index)?.map(f64::from));
    neighbours.nearest(&at, NEIGHBOURS + 1, near);
    let reach2 = near.last().map_or(0.0, |n| f64::from(n.squared));
    if near.len() < 4 || !(reach2 > 0.0 && reach2.is_finite()) {
        return None;
    }
    let spacing_mm = (PI * reach2 / (near.len() - 1) as f64).sqrt();
    let offs = near.iter().map(|n| off(&at, &normal, &cloud.point(n.index as usize)));
    Some(Probe { spacing_mm, noise_mm: scatter_mm(&offs.collect::<Vec<_>>()) })
}

/// How far a place lies from a point, squared, and how high above its tangent plane.
fn off(at: &Point3<f64>, normal: &Vector3<f64>, place: &Point3<f64>) -> (f64, f64) {
    ((place - at).norm_squared(), (place - at).dot(normal))
}

/// What heights scatter by about a + b·r²: what is round is no noise.
fn scatter_mm(offs: &[(f64, f64)]) -> f64 {
    let count = offs.len() as f64;
    let mean = offs.iter().fold((0.0, 0.0), |m, o| (m.0 + o.0 / count, m.1 + o.1 / count));
    let sums = offs.iter().fold([0.0; 3], |s, o| {
        let (r, h) = (o.0 - mean.0, o.1 - mean.1);
        [s[0] + r * r, s[1] + r * h, s[2] + h * h]
    });
    let explained = if sums[0] > 0.0 { sums[1] * sums[1] / sums[0] } else { 0.0 };
    ((sums[2] - explained).max(0.0) / (count - 2.0).max(1.0)).sqrt()
}

/// The middle one of some numbers; 0 without any.
pub(super) fn median(all: impl Iterator<Item = f64>) -> f64 {
    let mut all: Vec<f64> = all.collect();
    upper_median(&mut all).unwrap_or(0.0)
}
