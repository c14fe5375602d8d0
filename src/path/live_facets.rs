//! The proper facets of a surface, how far they go along a direction, and when planes lie along one.

use crate::part::{Mesh, surfaces::Surface, topology::FacetDefect};
use nalgebra::Vector3;

/// Within this angle of the planes a facet counts as parallel to them: lines would be 5.8 times as
/// far apart as wanted.
pub(super) const PARALLEL_DEG: f64 = 10.0;

/// The proper facets of a surface.
pub(super) fn live<'a>(mesh: &'a Mesh, s: &'a Surface) -> impl Iterator<Item = usize> + 'a {
    s.facets.iter().map(|&f| f as usize).filter(|&f| mesh.defects[f] == FacetDefect::None)
}

/// Least and greatest height of a surface along a direction, mm.
pub(super) fn extent(mesh: &Mesh, s: &Surface, normal: &Vector3<f64>) -> Option<(f64, f64)> {
    live(mesh, s)
        .flat_map(|f| mesh.corners(f))
        .map(|p| p.coords.dot(normal))
        .map(|h| (h, h))
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// Whether every proper facet of a surface lies along planes with this unit normal.
pub fn lies_along(mesh: &Mesh, s: &Surface, normal: &Vector3<f64>) -> bool {
    let parallel_sine = libm::sin(PARALLEL_DEG.to_radians());
    live(mesh, s).all(|f| mesh.normals[f].cross(normal).norm() < parallel_sine)
}
