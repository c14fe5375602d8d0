//! The beam's axis from the points of the path alone (P3 4.2): at a point it stands square to the travel and
//! to the line from a neighbouring pass to the other. No facet's normal enters but for the sign, so a rough
//! mesh, as scans give them, does not shake the beam.
//!
//! P3 takes the points before and behind; sections of a mesh have theirs where its edges happen to lie, so
//! here the path half a spacing before and behind is looked at. Spirals have no neighbouring passes and keep
//! the mesh's normals.

use super::section::{SectionPoint, TransversalLine};
use crate::part::angle;
use crate::part::topology::bounds_of;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Where the axis of the beam comes from where nothing is in its way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AxisSource {
    /// The normal of the mesh, between those of its vertices (P2 4.2.3).
    #[default]
    Mesh,
    /// Square to the travel and to the line between the neighbouring passes (P3 4.2).
    Neighbours,
}

crate::part::keyed_words!(AxisSource: Mesh, Neighbours);

/// A neighbouring pass is looked for within so many spacings.
const REACH: f64 = 2.0;
/// A pass that ends so far before the plane is met all the same, as a share of that reach.
const SHORT: f64 = 0.05;
/// Distance of two neighbours, as a share of the spacing, below which they give no direction.
const APART: f64 = 0.1;
/// Greatest angle to the mesh's normal, degrees; beyond it the neighbours are not those of one surface.
const MOST_OFF_DEG: f64 = 45.0;
/// Segments that share a box.
const BLOCK: usize = 16;

/// Puts the axes of P3 in place of the normals of a surface's lines, which lie about `spacing_mm` apart.
///
/// Where the plane across the travel meets no neighbouring pass within two spacings the normal stays.
pub fn neighbour_axes(lines: &mut [TransversalLine], spacing_mm: f64) {
    let blocks: Vec<Vec<SideBlock>> = lines.iter().map(blocks).collect();
    let of_rank = |rank: usize| lines.iter().zip(&blocks).filter(move |(l, _)| l.plane == rank).map(|(_, b)| b);
    let axes: Vec<Vec<Vector3<f64>>> = lines
        .par_iter()
        .map(|line| {
            let before: Vec<_> = line.plane.checked_sub(1).into_iter().flat_map(of_rank).flatten().collect();
            let behind: Vec<_> = of_rank(line.plane + 1).flatten().collect();
            let tangents = tangents(line, 0.5 * spacing_mm);
            let axis = |(q, t): (&SectionPoint, Option<Vector3<f64>>)| {
                let t = t?;
                let met = [&before, &behind].map(|blocks| nearest_crossing(blocks, q, &t, REACH * spacing_mm));
                let across = met[1].unwrap_or(q.p) - met[0].unwrap_or(q.p);
                let axis = angle::unit(t.cross(&across)).filter(|_| across.norm() > APART * spacing_mm)?;
                let axis = if axis.dot(&q.n) < 0.0 { -axis } else { axis };
                (angle::between_deg(&axis, &q.n) <= MOST_OFF_DEG).then_some(axis)
            };
            line.points.iter().zip(tangents).map(|(q, t)| axis((q, t)).unwrap_or(q.n)).collect()
        })
        .collect();
    for (line, axes) in lines.iter_mut().zip(axes) {
        line.points.iter_mut().zip(axes).for_each(|(q, n)| q.n = n);
    }
}

/// Unit directions of travel: from the path `step_mm` before to that behind, or the end of the lit piece.
fn tangents(line: &TransversalLine, step_mm: f64) -> Vec<Option<Vector3<f64>>> {
    let mut out = Vec::with_capacity(line.points.len());
    for piece in line.pieces() {
        let mut points: Vec<Point3<f64>> = piece.iter().map(|q| q.p).collect();
        points.extend(line.points.first().filter(|_| line.closed).map(|q| q.p));
        let mut at_mm = vec![0.0];
        for w in points.windows(2) {
            at_mm.push(at_mm.last().copied().unwrap_or(0.0) + (w[1] - w[0]).norm());
        }
        let whole_mm = at_mm.last().copied().unwrap_or(0.0);
        let step_mm = step_mm.min(0.25 * whole_mm);
        let at = |mm: f64| {
            let mm = if line.closed && whole_mm > 0.0 { mm.rem_euclid(whole_mm) } else { mm.clamp(0.0, whole_mm) };
            let i = at_mm.partition_point(|x| *x <= mm).saturating_sub(1).min(points.len().saturating_sub(2));
            let (Some(a), Some(b)) = (points.get(i), points.get(i + 1)) else { return points.first().copied() };
            let side_mm = at_mm[i + 1] - at_mm[i];
            Some(if side_mm > 0.0 { a + (b - a) * ((mm - at_mm[i]) / side_mm) } else { *a })
        };
        let tangent = |mm: &f64| angle::unit(at(mm + step_mm)? - at(mm - step_mm)?);
        out.extend(at_mm.iter().take(piece.len()).map(tangent));
    }
    out
}

/// Some neighbouring sides of a line, and the box around them.
struct SideBlock {
    low: Point3<f64>,
    high: Point3<f64>,
    sides: Vec<(SectionPoint, SectionPoint)>,
}

fn blocks(line: &TransversalLine) -> Vec<SideBlock> {
    let sides: Vec<_> = line.sides().collect();
    let block = |sides: &[(SectionPoint, SectionPoint)]| {
        let (low, high) = bounds_of(sides.iter().flat_map(|(a, b)| [a.p, b.p]));
        SideBlock { low, high, sides: sides.to_vec() }
    };
    sides.chunks(BLOCK).map(block).collect()
}

/// Where the plane through a point, square to its travel, cuts neighbouring passes: the nearest crossing on the
/// same side of the part.
fn nearest_crossing(
    blocks: &[&SideBlock],
    q: &SectionPoint,
    travel: &Vector3<f64>,
    reach_mm: f64,
) -> Option<Point3<f64>> {
    let mut best = (reach_mm, None);
    for block in blocks {
        let off_mm = (block.low - q.p).sup(&(q.p - block.high)).sup(&Vector3::zeros()).norm();
        if off_mm > best.0 {
            continue;
        }
        for (a, b) in block.sides.iter().filter(|(a, _)| a.n.dot(&q.n) > 0.0) {
            let (from, to) = (travel.dot(&(a.p - q.p)), travel.dot(&(b.p - q.p)));
            let crossing = ((from < 0.0) != (to < 0.0)).then(|| a.p + (b.p - a.p) * (from / (from - to)));
            // Passes end side by side at a rim: what ends just short of the plane counts as met.
            let end = |p: Point3<f64>, off: f64| (off.abs() <= SHORT * reach_mm).then(|| p - travel * off);
            for p in [crossing, end(a.p, from), end(b.p, to)].into_iter().flatten() {
                let mm = (p - q.p).norm();
                if mm <= best.0 {
                    best = (mm, Some(p));
                }
            }
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines of `count` points each, from a point and its true normal by rank and share of the way.
    fn raster(
        ranks: usize,
        count: usize,
        closed: bool,
        at: impl Fn(usize, f64) -> (Point3<f64>, Vector3<f64>),
    ) -> Vec<TransversalLine> {
        // Points stand unevenly, as the edges of a mesh cut them.
        let share = |i: usize| (i as f64 + 0.3 * libm::sin(7.0 * i as f64)) / count as f64;
        let point = |rank: usize, i: usize| {
            let (p, n) = at(rank, share(i));
            // A rough mesh's normal: twenty degrees off.
            let rough = angle::turned(&n, &angle::any_square_to(&n), 20.0 * libm::sin((rank * count + i) as f64));
            SectionPoint { p, n: rough }
        };
        let line = |rank| TransversalLine {
            plane: rank,
            points: (0..count).map(|i| point(rank, i)).collect(),
            closed,
            dark: vec![],
        };
        (0..ranks).map(line).collect()
    }

    /// The greatest angle between the axes found and the true normals, degrees: on all passes, on inner ones.
    fn worst_deg(
        mut lines: Vec<TransversalLine>,
        spacing_mm: f64,
        truth: impl Fn(&Point3<f64>) -> Vector3<f64>,
    ) -> [f64; 2] {
        neighbour_axes(&mut lines, spacing_mm);
        let last = lines.len() - 1;
        let off =
            |l: &TransversalLine| l.points.iter().map(|q| angle::between_deg(&q.n, &truth(&q.p))).fold(0.0, f64::max);
        [lines.iter().map(off).fold(0.0, f64::max), lines[1..last].iter().map(off).fold(0.0, f64::max)]
    }

    #[test]
    fn a_plane_has_its_own_normal() {
        let n = Vector3::new(0.36, 0.48, 0.8);
        let (u, v) = (Vector3::new(0.8, -0.6, 0.0), n.cross(&Vector3::new(0.8, -0.6, 0.0)));
        let lines = raster(5, 40, false, |rank, t| (Point3::from(u * (30.0 * t) + v * rank as f64), n));
        let [all, _] = worst_deg(lines, 1.0, |_| n);
        assert!(all < 1e-6, "{all}");
    }

    #[test]
    fn a_cylinder_has_its_radii() {
        let out = |turn: f64| Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        let truth = |p: &Point3<f64>| Vector3::new(p.x, p.y, 0.0).normalize();
        // Round it: neighbours lie straight above.
        let lines = raster(5, 200, true, |rank, t| {
            let n = out(t * std::f64::consts::TAU);
            (Point3::from(n * 20.0 + Vector3::z() * rank as f64), n)
        });
        let [all, _] = worst_deg(lines, 1.0, truth);
        assert!(all < 0.6, "{all}");
        // Along it, 1 mm apart: the first and last pass see one neighbour, half of 1/20 to the side.
        let lines = raster(9, 30, false, |rank, t| {
            let n = out(0.05 * rank as f64);
            (Point3::from(n * 20.0 + Vector3::z() * (30.0 * t)), n)
        });
        let [all, inner] = worst_deg(lines, 1.0, truth);
        assert!(inner < 1e-6 && (all - (0.5f64 * 0.05).to_degrees()).abs() < 1e-6, "{inner} {all}");
    }

    #[test]
    fn a_sphere_has_its_radii() {
        let lines = raster(20, 300, true, |rank, t| {
            let (height, turn) = (rank as f64 - 9.5, t * std::f64::consts::TAU);
            let flat = (900.0 - height * height).sqrt();
            let p = Point3::new(flat * libm::cos(turn), flat * libm::sin(turn), height);
            (p, p.coords / 30.0)
        });
        let [all, inner] = worst_deg(lines, 1.0, |p| p.coords / 30.0);
        assert!(inner < 0.5, "{inner}");
        // One neighbour, 1 mm of the height away where the slope is 18 degrees: half of 2 degrees.
        assert!(all < 1.1, "{all}");
    }

    #[test]
    fn without_a_neighbour_the_normal_stays() {
        let n = Vector3::z();
        let lines = raster(2, 10, false, |rank, t| (Point3::new(10.0 * t, 3.0 * rank as f64, 0.0), n));
        let mut moved = lines.clone();
        neighbour_axes(&mut moved, 1.0);
        assert_eq!(moved, lines, "three spacings away is no neighbour");
        neighbour_axes(&mut moved, 2.0);
        assert!(moved.iter().flat_map(|l| &l.points).all(|q| angle::between_deg(&q.n, &n) < 1e-6));
        let mut spiral = raster(1, 100, false, |_, t| (Point3::new(t, t * t, 0.0), n));
        let before = spiral.clone();
        neighbour_axes(&mut spiral, 1.0);
        assert_eq!(spiral, before);
        neighbour_axes(&mut [], 1.0);
    }
}
