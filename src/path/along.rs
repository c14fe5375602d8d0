//! Lines along the centre line of a long, narrow surface, such as a weld bead (P4 Fig. 17): the centre line, and lines beside
//! it at the spacing, each dropped onto the surface along the normal.
//!
//! The spacing is measured across the centre line on its own surface. Where that bends by a radius `R` across the line, it is
//! kept on the surface to within `s³/(24·R²)`: a hundredth of a per cent for 8 mm on a skin of 500 mm.

use super::section::{SectionPoint, TransversalLine, merged};
use crate::part::ground::CentrePoint;
use crate::part::{Bvh, Surfaces, angle};
use nalgebra::Vector3;

/// Ends of lines at the rim are found to this, mm.
const RIM_MM: f64 = 0.01;
/// Points so near to each other are one, mm: a rim's that was found where a point lies already.
const REPEATED_MM: f64 = 1e-6;

/// What lines along a centre line are dropped onto.
#[derive(Clone, Copy, Debug)]
pub struct AlongSurface<'a> {
    /// Facets of the part.
    pub bvh: &'a Bvh,
    /// Its surfaces.
    pub surfaces: &'a Surfaces,
    /// Number of the one that is worked.
    pub number: u32,
    /// How far above the centre line it may lie, mm.
    pub highest_mm: f64,
}

/// The lines along a centre line, from its left to its right as seen from outside; each piece of one has its rank. Points
/// have the normals of the centre line. None where the spacing is not above 0 or the centre line has no length.
pub fn along_lines(on: &AlongSurface<'_>, centre: &[CentrePoint], spacing_mm: f64) -> Vec<TransversalLine> {
    if !(spacing_mm.is_finite() && spacing_mm > 0.0) || centre.len() < 2 {
        return Vec::new();
    }
    let across: Vec<Vector3<f64>> = (0..centre.len()).map(|i| across(centre, i)).collect();
    let line = |rank: i32| -> Vec<Vec<SectionPoint>> {
        let aside_mm = f64::from(rank) * spacing_mm;
        let raised: Vec<SectionPoint> =
            centre.iter().zip(&across).map(|(c, b)| SectionPoint { p: c.p + b * aside_mm, n: c.n }).collect();
        on.dropped(&raised)
    };
    // Outwards from the centre line, to both sides, until a line misses the surface.
    let side = |sign: i32| (1..).map(move |k| sign * k).map(line).take_while(|pieces| !pieces.is_empty());
    let left: Vec<Vec<Vec<SectionPoint>>> = side(-1).collect();
    let all = left.into_iter().rev().chain([line(0)]).chain(side(1));
    let ranked = all.enumerate().flat_map(|(plane, pieces)| pieces.into_iter().map(move |points| (plane, points)));
    ranked.map(|(plane, points)| TransversalLine { plane, points, closed: false, dark: Vec::new() }).collect()
}

/// The direction across the centre line at a point, to its right as seen from outside, unit.
fn across(centre: &[CentrePoint], i: usize) -> Vector3<f64> {
    let (before, behind) = (i.saturating_sub(1), (i + 1).min(centre.len() - 1));
    let along = centre[behind].p - centre[before].p;
    angle::unit(along.cross(&centre[i].n)).unwrap_or_else(|| angle::any_square_to(&centre[i].n))
}

impl AlongSurface<'_> {
    /// Where a point beside the centre line lies on the surface, if it does.
    fn dropped_point(&self, q: &SectionPoint) -> Option<SectionPoint> {
        let from = q.p + q.n * (self.highest_mm + 1.0);
        let hit = self.bvh.nearest_hit(&from, &-q.n, 0.0, 2.0 * (self.highest_mm + 1.0))?;
        let is_own = self.surfaces.of_facet.get(hit.facet as usize) == Some(&self.number);
        is_own.then(|| SectionPoint { p: from - q.n * hit.t_mm, n: q.n })
    }

    /// The pieces of a line that lie on the surface, drawn to its rim.
    fn dropped(&self, line: &[SectionPoint]) -> Vec<Vec<SectionPoint>> {
        let mut pieces: Vec<Vec<SectionPoint>> = Vec::new();
        let mut open: Option<Vec<SectionPoint>> = None;
        let mut last: Option<(&SectionPoint, bool)> = None;
        for q in line {
            let on = self.dropped_point(q);
            if let Some((before, was_on)) = last
                && was_on != on.is_some()
            {
                let rim = if was_on { self.rim(before, q) } else { self.rim(q, before) };
                match (&mut open, was_on) {
                    (Some(piece), true) => {
                        piece.extend(rim);
                        pieces.extend(open.take());
                    }
                    _ => open = Some(rim.into_iter().collect()),
                }
            }
            if let Some(on) = on {
                open.get_or_insert_default().push(on);
            }
            last = Some((q, on.is_some()));
        }
        pieces.extend(open);
        pieces.into_iter().filter_map(|points| merged(points, false, REPEATED_MM)).map(|(points, _)| points).collect()
    }

    /// The last point on the surface from one that is on it towards one that is not.
    fn rim(&self, on: &SectionPoint, off: &SectionPoint) -> Option<SectionPoint> {
        let at = |t: f64| SectionPoint {
            p: on.p + (off.p - on.p) * t,
            n: angle::unit(on.n + (off.n - on.n) * t).unwrap_or(on.n),
        };
        let step = RIM_MM / (off.p - on.p).norm().max(RIM_MM);
        let (mut low, mut high) = (0.0, 1.0);
        while high - low > step {
            let middle = 0.5 * (low + high);
            if self.dropped_point(&at(middle)).is_some() { low = middle } else { high = middle }
        }
        self.dropped_point(&at(low))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Job, segmented};
    use crate::part::{Part, Placement, Units};
    use crate::sample::{solids, stl_bytes};
    use nalgebra::Point3;

    #[test]
    fn lines_run_beside_the_centre_line_to_the_rim_and_no_farther() {
        let part =
            Part::from_bytes(&stl_bytes(&solids::cube(40.0)), Units::Mm, &Placement::default(), &[]).expect("a cube");
        let surfaces = segmented(&part, &Job::default());
        let (low, high) = part.mesh.bounds();
        let top = (0..part.mesh.facets.len()).find(|&f| part.mesh.normals[f].z > 0.9).expect("a top");
        let number = surfaces.of_facet[top];
        // Below the top, since a bead stands above its centre line, and longer than it is.
        let centre: Vec<CentrePoint> = (0..12)
            .map(|i| {
                let x = low.x - 5.0 + f64::from(i) * 5.0;
                CentrePoint { p: Point3::new(x, 0.5 * (low.y + high.y), high.z - 3.0), n: Vector3::z() }
            })
            .collect();
        let on = AlongSurface { bvh: &part.bvh, surfaces: &surfaces, number, highest_mm: 4.0 };
        let lines = along_lines(&on, &centre, 6.0);
        assert_eq!(lines.len(), 7, "three to either side of the middle");
        for (rank, line) in lines.iter().enumerate() {
            assert_eq!(line.plane, rank);
            let y = 0.5 * (low.y + high.y) + 6.0 * (3.0 - rank as f64);
            assert!(line.points.iter().all(|q| (q.p.y - y).abs() < 1e-9 && (q.p.z - high.z).abs() < 1e-9));
            let (first, last) = (line.points[0].p.x, line.points[line.points.len() - 1].p.x);
            assert!((first - low.x).abs() < 0.02 && (last - high.x).abs() < 0.02, "{first} to {last}");
        }
        assert!(along_lines(&on, &centre, 0.0).is_empty() && along_lines(&on, &centre[..1], 6.0).is_empty());
        assert!(along_lines(&AlongSurface { highest_mm: 1.0, ..on }, &centre, 6.0).is_empty(), "out of reach");
    }
}
