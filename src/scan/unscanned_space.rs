//! What lies behind the rims of a scan: space that nobody has looked into. Facets around it keep beam and head out, since
//! what was not scanned is unknown, and never free.
//!
//! A sheet that was scanned from one side throws a shadow away from the scanner: walls from its outer rim on. A hole in
//! it, and every rim of a part that was scanned all round, is closed by a lid. What lies beside a rim towards the scanner
//! was looked through, and is taken as free.

use crate::part::loops::loops;
use crate::part::raw_part::RawFacet;
use crate::part::{Part, topology::FacetDefect};
use nalgebra::{Point3, Vector3};
use std::collections::{BTreeMap, BTreeSet};

/// Below this length of the mean of its normals a sheet was scanned from all sides: that of a closed one is 0, of three
/// quarters round a cylinder 0.3, of a half 0.64.
const ALL_ROUND: f64 = 0.2;
/// Shadows are so long, in diagonals of the part: longer than anything on it.
const SHADOW: f64 = 1.5;

/// Facets around what was not scanned of a part that was meshed from its scan, part frame, mm; none where it is closed.
pub fn unscanned_facets(part: &Part) -> Vec<RawFacet> {
    let mesh = &part.mesh;
    let proper = |f: &usize| mesh.defects[*f] == FacetDefect::None;
    let mut open: BTreeMap<u32, BTreeSet<(u32, u32)>> = BTreeMap::new();
    let mut sums: BTreeMap<u32, (Vector3<f64>, f64)> = BTreeMap::new();
    for f in (0..mesh.facets.len()).filter(proper) {
        let shell = part.orientation.shell_of[f];
        let sum = sums.entry(shell).or_default();
        *sum = (sum.0 + mesh.normals[f] * mesh.areas[f], sum.1 + mesh.areas[f]);
        let corners = mesh.facets[f];
        for k in 0..3 {
            let e = mesh.facet_edges[f][k];
            let ends = [corners[k], corners[(k + 1) % 3]];
            let is_rim = mesh.edges.get(e as usize).is_some() && mesh.edge_facets(e).len() == 1;
            if is_rim {
                open.entry(shell).or_default().insert((ends[0], ends[1]));
            }
        }
    }
    let mut facets = Vec::new();
    for (shell, edges) in open {
        let (sum, area_mm2) = sums.get(&shell).copied().unwrap_or_default();
        let seen_from = sum / area_mm2.max(f64::MIN_POSITIVE);
        for round in loops(edges) {
            let rim: Vec<Point3<f64>> = round.iter().map(|&v| mesh.vertices[v as usize]).collect();
            let is_outer = area(&rim).dot(&seen_from) > 0.0;
            if seen_from.norm() > ALL_ROUND && is_outer {
                walls(&rim, &(seen_from.normalize() * (-SHADOW * mesh.diagonal())), &mut facets);
            } else {
                lid(&rim, &mut facets);
            }
        }
    }
    facets
}

/// Twice the area vector of a rim (Newell): along the outward normal where the sheet is on its left.
fn area(rim: &[Point3<f64>]) -> Vector3<f64> {
    let Some(first) = rim.first() else { return Vector3::zeros() };
    rim.windows(2).map(|w| (w[0] - first).cross(&(w[1] - first))).fold(Vector3::zeros(), |a, b| a + b)
}

fn push(corners: [Point3<f64>; 3], facets: &mut Vec<RawFacet>) {
    facets.push(corners.map(|p| [p.x as f32, p.y as f32, p.z as f32]));
}

/// Walls from a rim away from the scanner.
fn walls(rim: &[Point3<f64>], down: &Vector3<f64>, facets: &mut Vec<RawFacet>) {
    for (i, a) in rim.iter().enumerate() {
        let b = rim[(i + 1) % rim.len()];
        push([*a, a + down, b], facets);
        push([b, a + down, b + down], facets);
    }
}

/// A lid over a rim, triangulated as it is seen along its area.
fn lid(rim: &[Point3<f64>], facets: &mut Vec<RawFacet>) {
    let Some(up) = area(rim).try_normalize(0.0) else { return };
    let x = up.cross(&if up.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() }).normalize();
    let y = up.cross(&x);
    let flat: Vec<[f64; 2]> = rim.iter().map(|p| [p.coords.dot(&x), p.coords.dot(&y)]).collect();
    let mut corners: Vec<u32> = Vec::new();
    earcut::Earcut::new().earcut(flat.iter().copied(), &[], &mut corners);
    for c in corners.chunks_exact(3) {
        push([rim[c[0] as usize], rim[c[1] as usize], rim[c[2] as usize]], facets);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Placement, Units};
    use crate::sample::{Triangles, solids, stl_bytes};

    fn part(triangles: &Triangles) -> Part {
        Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part")
    }

    fn around(of: &Part) -> Part {
        let facets = unscanned_facets(of);
        let solid: Triangles = facets.iter().map(|f| f.map(|c| c.map(f64::from))).collect();
        part(&solid)
    }

    /// Whether a ray from a point in a direction meets what was not scanned.
    fn enters(unknown: &Part, from: [f64; 3], to: [f64; 3]) -> bool {
        unknown.bvh.nearest_hit(&Point3::from(from), &Vector3::from(to).normalize(), 1e-6, f64::INFINITY).is_some()
    }

    #[test]
    fn a_closed_part_leaves_nothing_unknown() {
        assert!(unscanned_facets(&part(&solids::cube(10.0))).is_empty());
    }

    #[test]
    fn a_sheet_throws_a_shadow_away_from_the_scanner() {
        let cube = solids::cube(10.0);
        let top: Triangles = cube.into_iter().filter(|t| t.iter().all(|p| p[2] > 9.0)).collect();
        let unknown = around(&part(&top));
        // From beside it below, into the shadow; from the sheet up and aside, and past it, free.
        assert!(enters(&unknown, [-5.0, 5.0, 5.0], [1.0, 0.0, 0.0]));
        assert!(!enters(&unknown, [5.0, 5.0, 10.1], [0.0, 0.0, 1.0]));
        assert!(!enters(&unknown, [5.0, 5.0, 10.1], [1.0, 0.2, 0.01]));
        assert!(!enters(&unknown, [-5.0, -5.0, 5.0], [0.0, 0.0, -1.0]));
    }

    #[test]
    fn holes_have_lids() {
        // A cube without a face was scanned from five sides: the sixth is closed, and nothing else is in the way.
        let open: Triangles = solids::cube(10.0).into_iter().filter(|t| t.iter().any(|p| p[0] < 9.0)).collect();
        let unknown = around(&part(&open));
        assert!((unknown.mesh.areas.iter().sum::<f64>() - 100.0).abs() < 1e-6);
        assert!(enters(&unknown, [20.0, 5.0, 5.0], [-1.0, 0.0, 0.0]));
        assert!(!enters(&unknown, [5.0, 5.0, 11.0], [1.0, 0.3, 0.1]));
    }
}
