//! The plane through each point and its neighbours: a first normal, and who stands beside whom.
//!
//! Sides are not told here: see [`super::orientation`].

use crate::progress::{Cancelled, Progress};
use crate::scan::cleaning::VoxelMeans;
use crate::scan::neighbours::{Neighbour, Neighbours};
use crate::scan::normals::plane_weighted;
use nalgebra::Vector3;

/// Neighbours of a plane: with the voxels that points are thinned to they lie within one and a half cells.
const NEIGHBOURS: usize = 16;
/// Neighbours that a normal's side is handed on to; Hoppe (1992) takes about as many.
pub(super) const BESIDE: usize = 8;

/// A point's plane.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FirstPlane {
    /// Unit; zero where the points tell no plane.
    pub normal: Vector3<f64>,
    /// The nearest other points, nearest first; only the first `count` are there.
    pub beside: [u32; BESIDE],
    /// How many.
    pub count: u8,
}

/// The planes of all points of a thinned cloud. What is further off than `reach_mm` is no neighbour.
pub(super) fn first_planes(
    means: &VoxelMeans,
    neighbours: &Neighbours,
    reach_mm: f64,
    progress: &Progress,
) -> Result<Vec<FirstPlane>, Cancelled> {
    let reach2 = (reach_mm * reach_mm) as f32;
    neighbours.map_nearest(NEIGHBOURS, progress, |index, near| plane_of(means, index, near, reach2))
}

fn plane_of(means: &VoxelMeans, index: u32, near: &[Neighbour], reach2: f32) -> FirstPlane {
    let mut near: Vec<(f32, u32)> = near.iter().filter(|n| n.squared <= reach2).map(|n| (n.squared, n.index)).collect();
    near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let all = std::iter::once(index).chain(near.iter().map(|n| n.1));
    let counted = all.map(|i| (means.cloud.point(i as usize), f64::from(means.count[i as usize])));
    let Some(plane) = plane_weighted(counted) else { return FirstPlane::default() };
    let mut first = FirstPlane { normal: plane.normal, ..FirstPlane::default() };
    for (slot, n) in first.beside.iter_mut().zip(&near) {
        *slot = n.1;
        first.count += 1;
    }
    first
}
