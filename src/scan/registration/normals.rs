//! Normals of the model between its vertices: at each corner of a facet that of its feature surface, mixed over the
//! facet by the foot's place.
//!
//! A cylinder of n facets has corners all round in its facets' own normals, and a fit would hold on to them; with these
//! it turns freely, as it should. Across a crease nothing is mixed (a cube's edge would get a normal at 45°).

use crate::part::bvh::closest::{Closest, FootPlace};
use crate::part::{Mesh, Part, SurfaceRule, Surfaces, topology::FacetDefect};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// From which dihedral angle an edge is a crease where nobody has chosen surfaces, degrees: the default of P1. Facets of
/// a coarse cylinder (24 sides: 15°) stay one surface, a chamfer of 30° is one of its own.
const CREASE_DEG: f64 = 20.0;

/// A unit normal for each corner of each facet, and where surfaces end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceNormals {
    of_corner: Vec<[Vector3<f64>; 3]>,
    /// Of each facet which edges and which corners lie on creases.
    creases: Vec<[[bool; 3]; 2]>,
}

impl SurfaceNormals {
    /// Within surfaces given by the number of each facet: facets are weighed by their angle at the vertex, so that it
    /// does not matter how a face was cut into triangles.
    pub fn new(mesh: &Mesh, surface_of_facet: &[u32]) -> SurfaceNormals {
        let is_live = |f: usize| mesh.defects[f] == FacetDefect::None;
        let weighed: Vec<[Vector3<f64>; 3]> =
            (0..mesh.facets.len()).into_par_iter().map(|f| weighed_normals(mesh, f)).collect();
        let of_corner = |f: usize, k: usize| {
            let vertex = mesh.facets[f][k];
            let same = |g: &usize| is_live(*g) && surface_of_facet.get(*g) == surface_of_facet.get(f);
            let mut sum = Vector3::zeros();
            for g in mesh.vertex_facets(vertex).iter().map(|&g| g as usize).filter(same) {
                let at = mesh.facets[g].iter().position(|&v| v == vertex);
                sum += at.map_or_else(Vector3::zeros, |at| weighed[g][at]);
            }
            // Facets that cancel out (a blade's edge): each keeps its own.
            sum.try_normalize(1e-6).unwrap_or(mesh.normals[f])
        };
        let same = |f: usize, g: &u32| surface_of_facet.get(*g as usize) == surface_of_facet.get(f);
        let edge = |f: usize, k: usize| !mesh.across(f as u32, mesh.facet_edges[f][k]).is_some_and(|g| same(f, &g));
        let is_crease: Vec<[bool; 3]> =
            (0..mesh.facets.len()).into_par_iter().map(|f| [0, 1, 2].map(|k| edge(f, k))).collect();
        let at_vertex = |v: u32| {
            mesh.vertex_facets(v).iter().any(|&g| {
                let k = mesh.facets[g as usize].iter().position(|&w| w == v).unwrap_or(0);
                is_crease[g as usize][k] || is_crease[g as usize][(k + 2) % 3]
            })
        };
        let facets = (0..mesh.facets.len()).into_par_iter();
        let creases = facets.clone().map(|f| [is_crease[f], mesh.facets[f].map(at_vertex)]).collect();
        SurfaceNormals { of_corner: facets.map(|f| [0, 1, 2].map(|k| of_corner(f, k))).collect(), creases }
    }

    /// Within the part's surfaces at the usual angle.
    pub fn at_usual_creases(part: &Part) -> SurfaceNormals {
        let rule = SurfaceRule { angle_deg: CREASE_DEG, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
        let surfaces = Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule, &[], &[]);
        SurfaceNormals::new(&part.mesh, &surfaces.of_facet)
    }

    /// The unit normal at a foot, outward.
    pub fn at(&self, mesh: &Mesh, closest: &Closest) -> Vector3<f64> {
        let f = closest.facet as usize;
        let shares = shares_of(&mesh.corners(f), &closest.foot);
        let [a, b, c] = &self.of_corner[f];
        (a * shares[0] + b * shares[1] + c * shares[2]).try_normalize(1e-6).unwrap_or(mesh.normals[f])
    }
}

impl SurfaceNormals {
    /// Whether a foot lies where its surface ends: on a crease or a rim, where no one plane tells what is next to it.
    pub(super) fn is_on_crease(&self, closest: &Closest) -> bool {
        let [edges, corners] = &self.creases[closest.facet as usize];
        match closest.place {
            FootPlace::Inside => false,
            FootPlace::Edge(k) => edges[k as usize],
            FootPlace::Corner(k) => corners[k as usize],
        }
    }

    /// How far a foot is from the nearest edge or corner of its own facet that lies on a crease or rim, mm; infinite where
    /// it has none.
    pub(super) fn to_crease_mm(&self, mesh: &Mesh, closest: &Closest) -> f64 {
        if self.is_on_crease(closest) {
            return 0.0;
        }
        let corners = mesh.corners(closest.facet as usize);
        let off = |k: usize| {
            let (from, along) = (corners[k], corners[(k + 1) % 3] - corners[k]);
            (closest.foot - from).cross(&along).norm() / along.norm()
        };
        let [edges, ends] = &self.creases[closest.facet as usize];
        let to_edges = (0..3).filter(|&k| edges[k]).map(off);
        let to_ends = (0..3).filter(|&k| ends[k]).map(|k| (closest.foot - corners[k]).norm());
        to_edges.chain(to_ends).fold(f64::INFINITY, f64::min)
    }
}

/// A facet's normal, once for each corner, as long as the angle there.
fn weighed_normals(mesh: &Mesh, facet: usize) -> [Vector3<f64>; 3] {
    let corners = mesh.corners(facet);
    [0, 1, 2].map(|k| {
        let (u, v) = (corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
        mesh.normals[facet] * libm::atan2(u.cross(&v).norm(), u.dot(&v))
    })
}

/// How much each corner has of a point on a triangle (barycentric; a triangle without area: all the first).
fn shares_of([a, b, c]: &[Point3<f64>; 3], p: &Point3<f64>) -> [f64; 3] {
    let n = (b - a).cross(&(c - a));
    let whole = n.norm_squared();
    if whole <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let share = |q: &Point3<f64>, r: &Point3<f64>| (q - p).cross(&(r - p)).dot(&n) / whole;
    [share(b, c), share(c, a), share(a, b)]
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::part_of;
    use super::*;
    use crate::sample::solids;

    #[test]
    fn a_faceted_cylinder_has_the_normals_of_a_round_one_and_its_ends_stay_flat() {
        let part = part_of(&solids::cylinder(10.0, 30.0, 24));
        let normals = SurfaceNormals::at_usual_creases(&part);
        for i in 0..360 {
            let (s, c) = (libm::sin(f64::from(i).to_radians()), libm::cos(f64::from(i).to_radians()));
            let wall = part.bvh.closest(&Point3::new(12.0 * c, 12.0 * s, 11.0), f64::INFINITY).expect("facets");
            let radial = Vector3::new(wall.foot.x, wall.foot.y, 0.0).normalize();
            assert!((normals.at(&part.mesh, &wall) - radial).norm() < 1e-4, "{i}");
            let end = part.bvh.closest(&Point3::new(9.0 * c, 9.0 * s, 31.0), f64::INFINITY).expect("facets");
            assert!((normals.at(&part.mesh, &end) - Vector3::z()).norm() < 1e-12);
            assert!(!normals.is_on_crease(&wall) && !normals.is_on_crease(&end));
            let rim = part.bvh.closest(&Point3::new(12.0 * c, 12.0 * s, 31.0), f64::INFINITY).expect("facets");
            assert!(normals.is_on_crease(&rim) && normals.to_crease_mm(&part.mesh, &rim) == 0.0);
        }
    }
}
