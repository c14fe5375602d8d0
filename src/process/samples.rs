//! Samples of the surface: facets cut in halves until no side is longer than a quarter of the spot,
//! where light comes; a facet, or a piece of one, that no light comes near stays one sample.
//!
//! The longest side is halved each time, so that a sliver gives as few samples as its area needs.

use super::light::Light;
use super::reach::Near;
use crate::pose::Theirs;
use nalgebra::Point3;

/// So many samples at most, then they are cut more coarsely: 300 MB.
pub const MOST_SAMPLES: usize = 4_000_000;

/// A triangle of the surface and what lands on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Its corners, mm, part frame.
    pub corners: [[f32; 3]; 3],
    /// Its area, mm².
    pub area_mm2: f32,
    /// The facet that it is cut from.
    pub facet: u32,
    /// Energy per area, J/cm².
    pub fluence_j_cm2: f32,
    /// What it would be if nothing shaded it.
    pub unshaded_j_cm2: f32,
    /// Angle between light and normal, degrees, weighed by energy; −1 where nothing lands.
    pub incidence_deg: f32,
    /// How many passes went over it with their spot.
    pub passes: u16,
    /// What keeps most off.
    pub shaded_by: Option<Theirs>,
}

/// A triangle that is to be cut, and the light that comes near it.
pub struct Plot {
    /// Its facet.
    pub facet: u32,
    /// Its corners.
    pub corners: [Point3<f64>; 3],
    /// In the order of the program.
    pub near: Vec<Near>,
}

/// Centre and radius of a circle around a triangle's corners (about its centroid), and its longest
/// side: number and length.
fn measures([a, b, c]: &[Point3<f64>; 3]) -> (Point3<f64>, f64, usize, f64) {
    let centre = centroid(&[*a, *b, *c]);
    let radius = [a, b, c].map(|p| (p - centre).norm_squared()).into_iter().fold(0.0, f64::max).sqrt();
    let sides = [(b - a).norm_squared(), (c - b).norm_squared(), (a - c).norm_squared()];
    let longest = if sides[0] >= sides[1] && sides[0] >= sides[2] { 0 } else if sides[1] >= sides[2] { 1 } else { 2 };
    (centre, radius, longest, sides[longest].sqrt())
}

/// The middle of a triangle.
pub fn centroid([a, b, c]: &[Point3<f64>; 3]) -> Point3<f64> {
    a + ((b - a) + (c - a)) / 3.0
}

/// The two halves of a triangle, cut at the middle of a side. Neighbours cut at the same point.
fn halves(corners: &[Point3<f64>; 3], side: usize) -> [[Point3<f64>; 3]; 2] {
    let [a, b, c] = [0, 1, 2].map(|k| corners[(side + k) % 3]);
    let middle = Point3::from((a.coords + b.coords) * 0.5);
    [[a, middle, c], [middle, b, c]]
}

/// Cuts a triangle until its sides are no longer than `limit_mm` or no light comes near, and hands
/// every piece on with the light that does.
pub fn cut(light: &Light, limit_mm: f64, plot: &Plot, mut leaf: impl FnMut(&[Point3<f64>; 3], &[Near])) {
    let mut lists = plot.near.clone();
    let whole = lists.len();
    halve(light, limit_mm, &plot.corners, (&mut lists, 0, whole), &mut leaf);
}

/// `lists`: those of all triangles that this one is a half of, one behind the other; its own whole's is
/// from `start` to `end`.
fn halve(
    light: &Light,
    limit_mm: f64,
    corners: &[Point3<f64>; 3],
    (lists, start, end): (&mut Vec<Near>, usize, usize),
    leaf: &mut impl FnMut(&[Point3<f64>; 3], &[Near]),
) {
    let (centre, radius, side, length) = measures(corners);
    for i in start..end {
        let near = lists[i];
        if light.reaches(&light.pieces[near.piece as usize], &centre, radius) {
            lists.push(near);
        }
    }
    let all = lists.len();
    if all == end || length <= limit_mm {
        leaf(corners, &lists[end..]);
    } else {
        for half in halves(corners, side) {
            halve(light, limit_mm, &half, (lists, end, all), leaf);
        }
    }
    lists.truncate(end);
}

/// Cuts a plot into ones of sides below `limit_mm`, so that many hands may work on it.
pub fn parcel(light: &Light, limit_mm: f64, plot: Plot) -> Vec<Plot> {
    let mut out = Vec::new();
    cut(light, limit_mm, &plot, |corners, near| {
        out.push(Plot { facet: plot.facet, corners: *corners, near: near.to_vec() });
    });
    out
}
