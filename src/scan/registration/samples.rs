//! Places all over the model, one a voxel: what coverage and symmetry are measured with.

use crate::part::{Mesh, topology::FacetDefect};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Edge of the pieces that facets are cut into, in voxels: so that none is passed over.
const PIECE: f64 = 0.5;

/// A place on the model, and its facet's normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) place: Point3<f64>,
    pub(super) normal: Vector3<f64>,
}

/// One place of each voxel that the model passes, in the order of the voxels: of the lowest facet there.
pub(super) fn one_a_voxel(mesh: &Mesh, cell_mm: f64) -> Vec<Sample> {
    let (lo, _) = mesh.bounds();
    let live: Vec<usize> = (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None).collect();
    let of_facet = |&f: &usize| {
        let pieces = middles(mesh.corners(f), PIECE * cell_mm);
        pieces.into_iter().map(move |p| (((p - lo) / cell_mm).map(|x| x as i64), f, p))
    };
    let mut all: Vec<(Vector3<i64>, usize, Point3<f64>)> = live.par_iter().flat_map_iter(of_facet).collect();
    // Stable, so that of a facet the first piece comes first.
    all.par_sort_by_key(|(cell, f, _)| (cell.x, cell.y, cell.z, *f));
    all.dedup_by_key(|(cell, ..)| *cell);
    all.into_iter().map(|(_, f, place)| Sample { place, normal: mesh.normals[f] }).collect()
}

/// Middles of the pieces of a triangle, halved at the longest edge until none is longer than `edge_mm`. Needles get a row
/// of them, not a field.
fn middles(corners: [Point3<f64>; 3], edge_mm: f64) -> Vec<Point3<f64>> {
    let (mut out, mut left) = (Vec::new(), vec![corners]);
    while let Some(c) = left.pop() {
        let lengths = [0, 1, 2].map(|k| (c[(k + 1) % 3] - c[k]).norm());
        let longest = (0..3).fold(0, |l, k| if lengths[k] > lengths[l] { k } else { l });
        let [a, b, o] = [0, 1, 2].map(|k| c[(longest + k) % 3]);
        if lengths[longest] <= edge_mm {
            out.push(a + ((b - a) + (o - a)) / 3.0);
        } else {
            let half = a + (b - a) * 0.5;
            left.extend([[a, half, o], [half, b, o]]);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::part_of;
    use super::*;
    use crate::sample::solids;

    #[test]
    fn every_voxel_of_a_cubes_skin_has_its_place() {
        let mesh = part_of(&solids::cube(10.0)).mesh;
        let all = one_a_voxel(&mesh, 1.0 + 1e-9);
        // Ten cells along each edge, without those inside.
        assert_eq!(all.len(), 1000 - 512);
        assert!(all.iter().all(|s| (s.normal.norm() - 1.0).abs() < 1e-9));
    }
}
