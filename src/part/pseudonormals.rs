//! On which side of the part a point is: by the pseudonormal of what is nearest to it (Bærentzen and Aanæs, "Signed
//! distance computation using the angle weighted pseudonormal", 2005). No rays, so no ray can graze an edge.
//!
//! The sign is right wherever the mesh is a closed surface or an open sheet near the foot. Beyond the rim of an open
//! sheet there is no side; [`PseudoNormals::is_on_rim`] tells that a foot lies there.

use super::bvh::closest::{Closest, FootPlace};
use super::topology::{FacetDefect, Mesh, NO_EDGE};
use nalgebra::Vector3;

/// Pseudonormals at the vertices of a mesh, and which of them lie on a rim.
#[derive(Clone, Debug, Default)]
pub struct PseudoNormals {
    of_vertex: Vec<Vector3<f64>>,
    rim_vertex: Vec<bool>,
}

impl PseudoNormals {
    /// Sums the normals at each vertex, weighed by the angle of the facet there.
    pub fn new(mesh: &Mesh) -> PseudoNormals {
        let mut of_vertex = vec![Vector3::zeros(); mesh.vertices.len()];
        for f in (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None) {
            let corners = mesh.corners(f);
            for k in 0..3 {
                let (u, v) = (corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
                let angle = libm::atan2(u.cross(&v).norm(), u.dot(&v));
                of_vertex[mesh.facets[f][k] as usize] += mesh.normals[f] * angle;
            }
        }
        let mut rim_vertex = vec![false; mesh.vertices.len()];
        for (e, ends) in mesh.edges.iter().enumerate() {
            if is_rim(mesh, e as u32) {
                ends.iter().for_each(|&v| rim_vertex[v as usize] = true);
            }
        }
        PseudoNormals { of_vertex, rim_vertex }
    }

    /// The pseudonormal where a foot lies; not of unit length.
    pub fn at(&self, mesh: &Mesh, closest: &Closest) -> Vector3<f64> {
        let f = closest.facet as usize;
        match closest.place {
            FootPlace::Inside => mesh.normals[f],
            FootPlace::Edge(k) => {
                let edge = mesh.facet_edges[f][k as usize];
                let other = mesh.across(closest.facet, edge);
                mesh.normals[f] + other.map_or_else(Vector3::zeros, |g| mesh.normals[g as usize])
            }
            FootPlace::Corner(k) => self.of_vertex[mesh.facets[f][k as usize] as usize],
        }
    }

    /// Whether the foot lies on an edge of a single facet: there is no model beyond.
    pub fn is_on_rim(&self, mesh: &Mesh, closest: &Closest) -> bool {
        let f = closest.facet as usize;
        match closest.place {
            FootPlace::Inside => false,
            FootPlace::Edge(k) => is_rim(mesh, mesh.facet_edges[f][k as usize]),
            FootPlace::Corner(k) => self.rim_vertex[mesh.facets[f][k as usize] as usize],
        }
    }

    /// The distance of a point whose nearest one this is: above 0 outside, below it inside.
    pub fn signed_mm(&self, mesh: &Mesh, point: &nalgebra::Point3<f64>, closest: &Closest) -> f64 {
        let outside = (point - closest.foot).dot(&self.at(mesh, closest)) >= 0.0;
        if outside { closest.distance_mm } else { -closest.distance_mm }
    }
}

fn is_rim(mesh: &Mesh, edge: u32) -> bool {
    edge != NO_EDGE && mesh.edge_facets(edge).len() == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Bvh;
    use crate::sample::solids;
    use nalgebra::Point3;

    #[test]
    fn a_point_beside_an_edge_or_a_corner_of_a_cube_is_on_the_right_side() {
        let part = crate::part::Part::from_bytes(
            &crate::sample::stl_bytes(&solids::cube(10.0)),
            crate::part::Units::Mm,
            &crate::part::Placement::default(),
            &[],
        );
        let mesh = part.expect("a cube is a part").mesh;
        let (bvh, normals) = (Bvh::new(&mesh), PseudoNormals::new(&mesh));
        let (lo, hi) = crate::part::topology::bounds_of(mesh.vertices.iter().copied());
        let step = (hi - lo) / 8.0;
        for (i, j, k) in (-3..12).flat_map(|i| (-3..12).flat_map(move |j| (-3..12).map(move |k| (i, j, k)))) {
            let p: Point3<f64> = lo + Vector3::new(f64::from(i), f64::from(j), f64::from(k)).component_mul(&step);
            let closest = bvh.closest(&p, f64::INFINITY).expect("a cube has facets");
            let within = (p - lo).inf(&(hi - p)).min();
            let outside = Vector3::from_fn(|a, _| (lo[a] - p[a]).max(p[a] - hi[a]).max(0.0)).norm();
            let expected = if outside > 0.0 { outside } else { -within };
            let found = normals.signed_mm(&mesh, &p, &closest);
            assert!((found - expected).abs() < 1e-9, "{p}: {found}, not {expected}");
            assert!(!normals.is_on_rim(&mesh, &closest));
        }
    }
}
