//! The free set: the directions at one point in which nothing is in the way, on the coarse grid, and down to
//! half a degree where the coarse grid finds none.

use super::grid;
use super::track::{Site, TiltVector, Track};
use crate::part::{Part, bvh};
use crate::pose::tilt::Tilt;
use crate::pose::{BeamInterference, Obstruction};
use nalgebra::{Point3, Vector3};

/// Half the side of the first squares of the search, degrees.
const HALF_SQUARE_DEG: f64 = 4.0;
/// Half the side of the last ones, degrees: their middles are half a degree apart.
const HALF_LEAST_DEG: f64 = 0.25;
/// Factor by which a square is enlarged before it counts as behind a facet: its sides are not quite great circles.
const INFLATED: f64 = 1.15;
/// A facet nearer than this may be one that the point stands on, mm.
const NEAR_MM: f64 = 0.05;
/// Number of openings at which the search stops.
const ENOUGH: usize = 64;

/// A direction of the coarse grid, and whether it is free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TestedDirection {
    /// Its tilt against the normal.
    pub tilt: Tilt,
    /// Unit axis.
    pub axis: Vector3<f64>,
    /// Whether nothing is in the way.
    pub is_free: bool,
}

/// The free set at a point `p` with the unit normal `n`, travelling along `tangent`: all cells of the
/// coarse grid up to the greatest tilt.
pub fn free_set(
    beam: &BeamInterference<'_>,
    p: &Point3<f64>,
    n: &Vector3<f64>,
    tangent: &Vector3<f64>,
    max_tilt_deg: f64,
) -> Vec<TestedDirection> {
    let cells = grid::disc(max_tilt_deg, grid::coarse_spacing_deg(max_tilt_deg));
    let direction = |c: TiltVector| {
        let tilt = Tilt { lead_deg: c.x, lean_deg: c.y };
        let axis = tilt.axis(n, tangent);
        TestedDirection { tilt, axis, is_free: beam.is_free(p, &axis) }
    };
    cells.into_iter().map(direction).collect()
}

/// Free tilts at a point, on a grid of half a degree; empty only if none of that grid is free. Squares that lie
/// behind a single facet are skipped as a whole.
pub fn openings(part: &Part, beam: &BeamInterference<'_>, track: &Track<'_>, site: &Site) -> Vec<TiltVector> {
    let mut out = Vec::new();
    let search = Openings { part, beam, track, site };
    let count = (track.max_tilt_deg / (2.0 * HALF_SQUARE_DEG)).ceil() as i32;
    for row in -count..=count {
        for column in -count..=count {
            // Shifted so that the middles of the last squares are multiples of half a degree.
            let middle = TiltVector::new(f64::from(column), f64::from(row)) * (2.0 * HALF_SQUARE_DEG)
                + TiltVector::repeat(HALF_LEAST_DEG);
            search.within(&middle, HALF_SQUARE_DEG, &mut out);
        }
    }
    out
}

struct Openings<'a> {
    part: &'a Part,
    beam: &'a BeamInterference<'a>,
    track: &'a Track<'a>,
    site: &'a Site,
}

impl Openings<'_> {
    fn within(&self, middle: &TiltVector, half_deg: f64, out: &mut Vec<TiltVector>) {
        let corner_deg = half_deg * std::f64::consts::SQRT_2;
        if out.len() >= ENOUGH || self.beam.check().is_err() || middle.norm() - corner_deg > self.track.max_tilt_deg {
            return;
        }
        let p = &self.site.q.p;
        if half_deg <= HALF_LEAST_DEG {
            let tilt = grid::at_rim(*middle, self.track.max_tilt_deg, 2.0 * HALF_LEAST_DEG);
            let is_free = |t: &TiltVector| self.track.allows(self.site, t) && self.beam.is_free(p, &self.site.axis(t));
            out.extend(tilt.filter(is_free));
            return;
        }
        let corners = |half: f64| {
            [(-half, -half), (-half, half), (half, -half), (half, half)].map(|(x, y)| TiltVector::new(x, y))
        };
        if let Some(Obstruction::Facet(facet)) = self.beam.passes_near(p, &self.site.axis(middle), NEAR_MM, 0.0) {
            let facet = self.part.mesh.corners(facet as usize);
            let is_behind =
                |c: TiltVector| bvh::ray_hit_mm(&facet, p, &self.site.axis(&(middle + c))).is_some_and(|t| t > NEAR_MM);
            if corners(half_deg * INFLATED).into_iter().all(is_behind) {
                return;
            }
        }
        for c in corners(0.5 * half_deg) {
            self.within(&(middle + c), 0.5 * half_deg, out);
        }
    }
}
