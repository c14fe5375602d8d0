//! Loops of points in a plane, and their lift into space: circles, arcs, rectangles.
//!
//! All loops run counter-clockwise. Only what the sample parts need; no offsets, no unions.

use super::shell::Point;
use std::f64::consts::PI;

/// A point in a plane, mm.
pub(super) type Flat = [f64; 2];

/// Radians of an angle in degrees.
pub(super) fn radians(deg: f64) -> f64 {
    deg * PI / 180.0
}

/// Degrees of an angle in radians.
pub(super) fn degrees(rad: f64) -> f64 {
    rad * 180.0 / PI
}

/// The point at `angle_deg` on a circle.
pub(super) fn on_circle(centre: Flat, radius: f64, angle_deg: f64) -> Flat {
    let angle = radians(angle_deg);
    [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)]
}

/// A circle as a regular polygon of `sides` corners on it, the first at 0°.
pub(super) fn circle(centre: Flat, radius: f64, sides: usize) -> Vec<Flat> {
    (0..sides).map(|i| on_circle(centre, radius, 360.0 * i as f64 / sides as f64)).collect()
}

/// An arc from `from_deg` to `to_deg` in `segments` chords, both ends included.
pub(super) fn arc(centre: Flat, radius: f64, from_deg: f64, to_deg: f64, segments: usize) -> Vec<Flat> {
    let angle = |i: usize| from_deg + (to_deg - from_deg) * i as f64 / segments as f64;
    (0..=segments).map(|i| on_circle(centre, radius, angle(i))).collect()
}

/// A rectangle from its lower left to its upper right corner.
pub(super) fn rectangle(low: Flat, high: Flat) -> Vec<Flat> {
    vec![low, [high[0], low[1]], high, [low[0], high[1]]]
}

/// (x, y) at height z: counter-clockwise about +z.
pub(super) fn at_z(points: &[Flat], z: f64) -> Vec<Point> {
    points.iter().map(|p| [p[0], p[1], z]).collect()
}

/// (x, z) at depth y: counter-clockwise about −y, as seen from the front.
pub(super) fn at_y(points: &[Flat], y: f64) -> Vec<Point> {
    points.iter().map(|p| [p[0], y, p[1]]).collect()
}

/// (y, z) at x: counter-clockwise about +x.
pub(super) fn at_x(points: &[Flat], x: f64) -> Vec<Point> {
    points.iter().map(|p| [x, p[0], p[1]]).collect()
}

/// A circle about the z axis at height z.
pub(super) fn ring(radius: f64, z: f64, sides: usize) -> Vec<Point> {
    at_z(&circle([0.0, 0.0], radius, sides), z)
}

/// Rings through a profile of (radius, z): the surface of revolution about the z axis.
pub(super) fn revolved(profile: &[Flat], sides: usize) -> Vec<Vec<Point>> {
    profile.iter().map(|p| ring(p[0], p[1], sides)).collect()
}
