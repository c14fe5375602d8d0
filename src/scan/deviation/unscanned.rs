//! How much of the model was not scanned: its facets are looked at in pieces not larger than the scan resolves.

use super::SmoothedDepths;
use crate::part::Part;
use crate::part::topology::FacetDefect;
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;

/// Pieces of all facets together, about: beyond it they are made larger.
const MOST: f64 = 2e6;

/// Area of the model without points, mm². Exact to the size of a piece along the rims of what was scanned.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn unscanned_mm2(part: &Part, depths: &SmoothedDepths, progress: &Progress) -> Result<f64, Cancelled> {
    let mesh = &part.mesh;
    let proper: Vec<usize> = (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None).collect();
    let whole: f64 = proper.iter().map(|&f| mesh.areas[f]).sum();
    // Two triangles a square.
    let side_mm = depths.reach_mm().max((2.0 * whole / MOST).sqrt());
    let of_facet = |near: &mut Vec<_>, &f: &usize| {
        let corners = mesh.corners(f);
        let longest = (0..3).map(|k| (corners[(k + 1) % 3] - corners[k]).norm()).fold(0.0, f64::max);
        // As many parts of a side as are needed, and never more than what the area asks for a hundred times over: a
        // needle is long, and has no area.
        let parts = if side_mm > 0.0 { (longest / side_mm).ceil().clamp(1.0, 2000.0) as usize } else { 1 };
        let mut open = 0usize;
        for centre in centres(&corners, parts) {
            if open % 256 == 0 {
                progress.check()?;
            }
            open += usize::from(!depths.is_scanned(&centre, &mesh.normals[f], near));
        }
        Ok(mesh.areas[f] * open as f64 / (parts * parts) as f64)
    };
    let areas: Vec<f64> = proper.par_iter().map_init(Vec::new, of_facet).collect::<Result<_, Cancelled>>()?;
    Ok(areas.iter().sum())
}

/// Middles of the `parts`² equal triangles that a triangle is cut into.
fn centres([a, b, c]: &[Point3<f64>; 3], parts: usize) -> impl Iterator<Item = Point3<f64>> {
    let (u, v) = ((b - a) / parts as f64, (c - a) / parts as f64);
    let a = *a;
    (0..parts).flat_map(move |i| {
        (0..parts - i).flat_map(move |j| {
            let third = [Some(1.0 / 3.0), (i + j + 1 < parts).then_some(2.0 / 3.0)];
            third.into_iter().flatten().map(move |t| a + u * (i as f64 + t) + v * (j as f64 + t))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_share_the_middle_of_the_whole_and_are_as_many_as_they_should_be() {
        let corners = [[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 6.0, 3.0]].map(Point3::from);
        for parts in [1, 2, 7] {
            let all: Vec<Point3<f64>> = centres(&corners, parts).collect();
            assert_eq!(all.len(), parts * parts);
            let mean = all.iter().map(|p| p.coords).sum::<nalgebra::Vector3<f64>>() / all.len() as f64;
            assert!((mean - nalgebra::Vector3::new(3.0, 2.0, 1.0)).norm() < 1e-12);
        }
    }
}
