//! A spiral without lifting: where the rim cuts it into pieces, the way from the end of one to the beginning of the next goes
//! along the rim (P4 5: the tool enters and leaves once). Only lines in working order are joined, and none is turned.

use super::ends::rim::{RimLoop, rim};
use super::normals::{VertexNormals, between};
use super::section::{SectionPoint, TransversalLine, linked};
use crate::part::{Mesh, surfaces::Surface};
use nalgebra::Point3;

/// An end lies on the rim when it is so near, mm: lines end where facets do, to a rounding.
const ON_RIM_MM: f64 = 0.05;

/// Joins open lines, in the order in which they are run, along the rim of their surface by the shorter way. What does not end
/// on one loop of the rim stays apart. A joined line has the rank of its first.
pub fn along_rim(
    mesh: &Mesh,
    surface: &Surface,
    normals: &VertexNormals,
    lines: Vec<TransversalLine>,
) -> Vec<TransversalLine> {
    let loops: Vec<RimWay> = rim(mesh, surface).loops.iter().map(|l| RimWay::new(mesh, normals, l)).collect();
    linked(lines, |from, to| loops.iter().find_map(|l| l.way(from, to)))
}

/// A loop of the rim as a way around.
struct RimWay {
    /// Its corners in order, with the surface's normals there.
    corners: Vec<SectionPoint>,
    /// How far along it each corner lies, and its whole length behind them, mm.
    along_mm: Vec<f64>,
}

impl RimWay {
    fn new(mesh: &Mesh, normals: &VertexNormals, of: &RimLoop) -> RimWay {
        let (mut corners, mut along_mm) = (Vec::new(), vec![0.0]);
        for ([from, to], &edge) in of.segments.iter().zip(&of.edges) {
            let vertex = mesh.edges[edge as usize].into_iter().find(|&v| mesh.vertices[v as usize] == *from);
            corners.push(SectionPoint { p: *from, n: vertex.map_or_else(Default::default, |v| normals.at(v)) });
            along_mm.push(along_mm.last().copied().unwrap_or(0.0) + (to - from).norm());
        }
        RimWay { corners, along_mm }
    }

    fn length_mm(&self) -> f64 {
        self.along_mm.last().copied().unwrap_or(0.0)
    }

    /// How far along it a point lies; `None`: it does not lie on it.
    fn place_mm(&self, p: &Point3<f64>) -> Option<f64> {
        let count = self.corners.len();
        let on = |i: usize| {
            let (from, to) = (self.corners[i].p, self.corners[(i + 1) % count].p);
            let side = to - from;
            let share = ((p - from).dot(&side) / side.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            ((p - (from + side * share)).norm(), self.along_mm[i] + share * side.norm())
        };
        let nearest = (0..count).map(on).min_by(|a, b| a.0.total_cmp(&b.0))?;
        (nearest.0 <= ON_RIM_MM).then_some(nearest.1)
    }

    /// The corners between two points of it by the shorter way; `None`: one does not lie on it.
    fn way(&self, from: &SectionPoint, to: &SectionPoint) -> Option<Vec<SectionPoint>> {
        let (start, end) = (self.place_mm(&from.p)?, self.place_mm(&to.p)?);
        let forward_mm = (end - start).rem_euclid(self.length_mm());
        let is_forward = 2.0 * forward_mm <= self.length_mm();
        let way_mm = if is_forward { forward_mm } else { self.length_mm() - forward_mm };
        let passed = |(corner, at): (&SectionPoint, &f64)| {
            let off = if is_forward { at - start } else { start - at };
            let off_mm = off.rem_euclid(self.length_mm());
            // Ends are points of the lines already.
            (off_mm > 1e-9 && off_mm < way_mm - 1e-9).then(|| {
                let n = if corner.n.norm() > 0.5 { corner.n } else { between(&from.n, &to.n, off_mm / way_mm) };
                (off_mm, SectionPoint { p: corner.p, n })
            })
        };
        let mut between: Vec<(f64, SectionPoint)> =
            self.corners.iter().zip(&self.along_mm).filter_map(passed).collect();
        between.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some(between.into_iter().map(|b| b.1).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Job, segmented};
    use crate::part::{Part, Placement, Units};
    use crate::path::SurfacePlanes;
    use crate::path::strategy::{Layout, Strategy, lines};
    use crate::sample::{solids, stl_bytes};
    use nalgebra::Vector3;

    #[test]
    fn a_spiral_on_a_square_is_one_line_that_runs_along_the_rim_where_it_would_leave() {
        let part =
            Part::from_bytes(&stl_bytes(&solids::cube(40.0)), Units::Mm, &Placement::default(), &[]).expect("a cube");
        let surfaces = segmented(&part, &Job::default());
        let (low, high) = part.mesh.bounds();
        let top = (0..part.mesh.facets.len()).find(|&f| part.mesh.normals[f].z > 0.9).expect("a top");
        let surface = surfaces.get(surfaces.of_facet[top]).expect("a surface");
        let normals = VertexNormals::new(&part.mesh, &surfaces, surface);
        let family = SurfacePlanes { surface: surface.number, normal: Vector3::x(), heights_mm: vec![low.x + 1.0] };
        let laid = lines(&part.mesh, surface, &normals, &Layout::new(Strategy::Spiral, 4.0), &family, 1e-6).lines;
        assert!(laid.len() > 3, "the corners cut it: {}", laid.len());
        let length = |lines: &[TransversalLine]| lines.iter().map(TransversalLine::length_mm).sum::<f64>();
        let before_mm = length(&laid);
        let joined = along_rim(&part.mesh, surface, &normals, laid);
        assert_eq!(joined.len(), 1);
        assert!(length(&joined) > before_mm && length(&joined) < before_mm + 4.0 * 40.0 * 2.0);
        for q in &joined[0].points {
            let inside = |x: f64, low: f64, high: f64| (low - 1e-9..=high + 1e-9).contains(&x);
            assert!(inside(q.p.x, low.x, high.x) && inside(q.p.y, low.y, high.y) && (q.p.z - high.z).abs() < 1e-9);
            assert!((q.n - Vector3::z()).norm() < 1e-9);
        }
    }
}
