//! How long a grinding path takes (P4 Table 1): speed, acceleration, entries, exits, corners and lifts.
//!
//! Each piece is entered and left once, along a quarter circle that touches the surface; between pieces the tool is lifted
//! and moves through the air from rest to rest. Along a piece speeds are trapezoids: the tool brakes for a corner and
//! speeds up behind it. A corner is rounded by an arc that stays within a tolerance of it (junction deviation, as
//! controllers of machine tools and Jeon's grbl have it) and ends in the middle of its sides at the latest; on that arc
//! the acceleration bounds the speed. So a curve of many chords is bounded by its own radius. Along and across the
//! acceleration is the same, each for itself; joints, jerk and blending of a controller's own are none of this model.

use nalgebra::{Point3, Vector3};
use std::f64::consts::FRAC_PI_2;
use thiserror::Error;

/// From this turn on a corner is a stop whatever the tolerance, degrees: the ends of zigzag lines, where the tool's load
/// changes sides. Corners of 90° that are computed come out a little below.
const STOP_FROM_DEG: f64 = 89.9;
/// A turn below this is none, radians: digits of a straight line.
const STRAIGHT: f64 = 1e-7;

/// How a grinding tool moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrindingMotion {
    /// On the surface, mm/s.
    pub speed_mm_s: f64,
    /// Along and across, mm/s².
    pub acceleration_mm_s2: f64,
    /// Radius of the arcs of entry and exit, mm; 0: straight down onto the surface, and up.
    pub arc_radius_mm: f64,
    /// Height of moves through the air above the surface, mm.
    pub lift_mm: f64,
    /// Speed through the air, mm/s.
    pub air_speed_mm_s: f64,
    /// How far off a corner the tool may pass, mm.
    pub corner_tolerance_mm: f64,
}

/// Where the time of a path goes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GrindingTimes {
    /// All of it, s.
    pub total_s: f64,
    /// On the pieces, s.
    pub contact_s: f64,
    /// On the arcs of entry and exit, s.
    pub arcs_s: f64,
    /// Up, through the air, and down, s.
    pub air_s: f64,
    /// Length of the pieces, mm.
    pub length_mm: f64,
    /// Pieces that are entered and left; those without length are none.
    pub pieces: usize,
    /// Corners at which the tool stops.
    pub stops: usize,
}

/// Figures that tell no time.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum GrindingMotionError {
    /// A figure of the motion is out of its range.
    #[error("{key} = {value}")]
    Figure {
        /// Its name.
        key: &'static str,
        /// What it is.
        value: f64,
    },
    /// A point of a piece is not finite.
    #[error("piece {piece}: point {point}")]
    Point {
        /// The piece, from 0.
        piece: usize,
        /// The point, from 0.
        point: usize,
    },
}

impl GrindingMotion {
    /// Whether all figures are in their ranges.
    ///
    /// # Errors
    /// The first that is not.
    pub fn check(&self) -> Result<(), GrindingMotionError> {
        let GrindingMotion {
            speed_mm_s,
            acceleration_mm_s2,
            arc_radius_mm,
            lift_mm,
            air_speed_mm_s,
            corner_tolerance_mm,
        } = *self;
        let above_0 = [
            ("speed_mm_s", speed_mm_s),
            ("acceleration_mm_s2", acceleration_mm_s2),
            ("air_speed_mm_s", air_speed_mm_s),
        ];
        let not_below =
            [("arc_radius_mm", arc_radius_mm), ("lift_mm", lift_mm), ("corner_tolerance_mm", corner_tolerance_mm)];
        let wrong = above_0.into_iter().find(|(_, x)| !(*x > 0.0 && x.is_finite()));
        let wrong = wrong.or_else(|| not_below.into_iter().find(|(_, x)| !(*x >= 0.0 && x.is_finite())));
        wrong.map_or(Ok(()), |(key, value)| Err(GrindingMotionError::Figure { key, value }))
    }

    /// The time of the pieces in their order.
    ///
    /// # Errors
    /// A figure is out of its range, or a point is not finite.
    pub fn times(&self, pieces: &[Vec<Point3<f64>>]) -> Result<GrindingTimes, GrindingMotionError> {
        self.check()?;
        let mut times = GrindingTimes::default();
        let mut left_at: Option<Point3<f64>> = None;
        for (piece, points) in pieces.iter().enumerate() {
            if let Some(point) = points.iter().position(|p| !p.coords.iter().all(|x| x.is_finite())) {
                return Err(GrindingMotionError::Point { piece, point });
            }
            let mut corners = points.clone();
            corners.dedup();
            let (Some(first), Some(last)) = (corners.first(), corners.last()) else { continue };
            if corners.len() < 2 {
                continue;
            }
            // From one arc's end over to the next one's start: as far as the pieces are apart.
            times.air_s += left_at.map_or(0.0, |from| self.in_air_s((first - from).norm()));
            times.air_s += 2.0 * self.in_air_s((self.lift_mm - self.arc_radius_mm).max(0.0));
            left_at = Some(*last);
            self.add_piece(&corners, &mut times);
        }
        times.total_s = times.contact_s + times.arcs_s + times.air_s;
        Ok(times)
    }

    /// A piece with its arcs, from rest to rest.
    fn add_piece(&self, corners: &[Point3<f64>], times: &mut GrindingTimes) {
        let sides: Vec<Vector3<f64>> = corners.windows(2).map(|w| w[1] - w[0]).collect();
        let arc_mm = FRAC_PI_2 * self.arc_radius_mm;
        let on_arc = self.speed_mm_s.min((self.acceleration_mm_s2 * self.arc_radius_mm).sqrt());
        let inner = sides.iter().map(|s| (s.norm(), self.speed_mm_s));
        let stretches: Vec<(f64, f64)> =
            std::iter::once((arc_mm, on_arc)).chain(inner).chain(std::iter::once((arc_mm, on_arc))).collect();
        let bounds: Vec<f64> = sides.windows(2).map(|w| self.at_corner_mm_s(&w[0], &w[1])).collect();
        times.stops += bounds.iter().filter(|v| **v <= 0.0).count();
        // From rest, over the arc's end, the corners, and the other arc's start, to rest.
        let ends = std::iter::once::<f64>;
        let mut speeds: Vec<f64> =
            ends(0.0).chain(ends(on_arc)).chain(bounds).chain(ends(on_arc)).chain(ends(0.0)).collect();
        let reached = |from: f64, length: f64| (from * from + 2.0 * self.acceleration_mm_s2 * length).sqrt();
        for k in 1..speeds.len() {
            speeds[k] = speeds[k].min(reached(speeds[k - 1], stretches[k - 1].0));
        }
        for k in (0..speeds.len() - 1).rev() {
            speeds[k] = speeds[k].min(reached(speeds[k + 1], stretches[k].0));
        }
        let last = stretches.len() - 1;
        for (k, (length, speed)) in stretches.iter().enumerate() {
            let time = trapezoid_s(*length, speeds[k], speeds[k + 1], *speed, self.acceleration_mm_s2);
            if k == 0 || k == last {
                times.arcs_s += time;
            } else {
                times.contact_s += time;
                times.length_mm += length;
            }
        }
        times.pieces += 1;
    }

    /// The greatest speed at a corner.
    fn at_corner_mm_s(&self, before: &Vector3<f64>, after: &Vector3<f64>) -> f64 {
        let turn = libm::atan2(before.cross(after).norm(), before.dot(after));
        if turn.to_degrees() >= STOP_FROM_DEG {
            return 0.0;
        }
        if turn < STRAIGHT {
            return self.speed_mm_s;
        }
        let (half_sine, half_cosine) = (libm::sin(0.5 * turn), libm::cos(0.5 * turn));
        // An arc of radius r passes a corner at r·(1/cos(φ/2) − 1) and touches its sides r·tan(φ/2) off it.
        let by_tolerance = self.corner_tolerance_mm * half_cosine / (1.0 - half_cosine);
        let by_sides = 0.5 * before.norm().min(after.norm()) * half_cosine / half_sine;
        self.speed_mm_s.min((self.acceleration_mm_s2 * by_tolerance.min(by_sides)).sqrt())
    }

    /// Through the air, from rest to rest.
    fn in_air_s(&self, length_mm: f64) -> f64 {
        trapezoid_s(length_mm, 0.0, 0.0, self.air_speed_mm_s, self.acceleration_mm_s2)
    }
}

/// The time of a straight way from one speed to another with a greatest speed between them.
fn trapezoid_s(length: f64, from: f64, to: f64, greatest: f64, acceleration: f64) -> f64 {
    if length <= 0.0 {
        return 0.0;
    }
    let peak = (acceleration * length + 0.5 * (from * from + to * to)).sqrt().min(greatest).max(from).max(to);
    let ramps = (2.0 * peak * peak - from * from - to * to) / (2.0 * acceleration);
    (2.0 * peak - from - to) / acceleration + (length - ramps).max(0.0) / peak
}

#[cfg(test)]
mod tests;
