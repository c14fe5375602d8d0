//! Normals from the points themselves: of each point the normal of the plane through it and its nearest others, by
//! least squares (smallest eigenvector of their scatter), closed form.
//!
//! At a sharp edge the plane lies across it. Which side is outward the points do not tell; the normals that a cloud has
//! decide, and without them there is only a guess.

use super::cloud::Cloud;
use super::neighbours::{Neighbour, Neighbours};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Matrix3, Point3, Vector3};
use std::f64::consts::TAU;

/// A plane through points, by least squares of the distances to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedPlane {
    /// Middle of the points.
    pub middle: Point3<f64>,
    /// Unit normal; its side says nothing.
    pub normal: Vector3<f64>,
    /// Weighted mean squared distance of the points, mm².
    pub variance_mm2: f64,
}

/// Unit normals of all points of a cloud, each by the plane through it and its `k` nearest others; zero where those lie
/// on a line or are fewer than two. On the side of the cloud's own normal where it has one, else away from the middle
/// of the cloud's box: outward on a convex part only.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn fitted_normals(
    cloud: &Cloud,
    neighbours: &Neighbours,
    k: usize,
    progress: &Progress,
) -> Result<Vec<[f32; 3]>, Cancelled> {
    let middle = cloud.bounds().map_or_else(Point3::origin, |(lo, hi)| lo + (hi - lo) * 0.5);
    neighbours.map_nearest(k, progress, |index, near| {
        let Some(plane) = plane_around(cloud, index, near) else { return [0.0; 3] };
        let outward = cloud.normal(index as usize).unwrap_or_else(|| cloud.point(index as usize) - middle);
        let n = if plane.normal.dot(&outward) < 0.0 { -plane.normal } else { plane.normal };
        [n.x as f32, n.y as f32, n.z as f32]
    })
}

/// The plane through a point of the cloud and its neighbours.
pub fn plane_around(cloud: &Cloud, index: u32, near: &[Neighbour]) -> Option<FittedPlane> {
    let all = std::iter::once(index).chain(near.iter().map(|n| n.index));
    plane_through(all.map(|i| cloud.point(i as usize)))
}

/// The plane through points; `None` where they lie on a line, within the rounding of f32 places, or are too few.
pub fn plane_through(points: impl Iterator<Item = Point3<f64>>) -> Option<FittedPlane> {
    plane_weighted(points.map(|p| (p, 1.0)))
}

/// The plane through points that count with their weights, 0 or more.
pub fn plane_weighted(points: impl Iterator<Item = (Point3<f64>, f64)>) -> Option<FittedPlane> {
    let (mut whole, mut sum, mut squares) = (0.0, Vector3::zeros(), Matrix3::zeros());
    let mut first = None;
    for (p, weight) in points {
        // From one of them: far from nought squares would lose all digits.
        let d: Vector3<f64> = p - *first.get_or_insert(p);
        let weighed = d * weight;
        whole += weight;
        sum += weighed;
        squares += d * weighed.transpose();
    }
    let (first, middle) = (first?, sum / whole);
    let scatter = squares / whole - middle * middle.transpose();
    let (normal, variance_mm2) = smallest(&scatter)?;
    Some(FittedPlane { middle: first + middle, normal, variance_mm2 })
}

/// Points are on a line where the middle eigenvalue is so small a share of the largest: their width is then a
/// thousandth of their length. Scan lines half a point spacing apart are far above (0.01), rounding of f32 places far
/// below (1e-9).
const ON_A_LINE: f64 = 1e-6;

/// The eigenvector of the smallest eigenvalue, and that eigenvalue; `None` where the two smaller ones are next to
/// nothing, or all three the same (Eberly, "A robust eigensolver for 3 × 3 symmetric matrices", 2014: the best
/// separated one first, then those of the 2 × 2 matrix across it).
fn smallest(a: &Matrix3<f64>) -> Option<(Vector3<f64>, f64)> {
    let scale = a.amax();
    if !(scale > 0.0 && scale.is_finite()) {
        return None;
    }
    let m = a / scale;
    let mean = m.trace() / 3.0;
    let centred = m - Matrix3::from_diagonal_element(mean);
    let spread = (centred.norm_squared() / 6.0).sqrt();
    if spread < 1e-12 {
        return None;
    }
    let half_determinant = (centred / spread).determinant() * 0.5;
    let angle = libm::acos(half_determinant.clamp(-1.0, 1.0)) / 3.0;
    // Below 0 the smallest one stands apart, else the largest.
    let turned = if half_determinant < 0.0 { angle + TAU / 3.0 } else { angle };
    let apart = mean + 2.0 * spread * libm::cos(turned);
    let v = across(&(m - Matrix3::from_diagonal_element(apart)));
    // A frame across it, and the two eigenvalues there.
    let u = if v.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() };
    let u = (u - v * v.dot(&u)).normalize();
    let w = v.cross(&u);
    let (mu, mw) = (m * u, m * w);
    let (p, q, r) = (u.dot(&mu), u.dot(&mw), w.dot(&mw));
    let half = 0.5 * (p - r);
    let root = (half * half + q * q).sqrt();
    let (low, high) = (0.5 * (p + r) - root, 0.5 * (p + r) + root);
    if half_determinant < 0.0 {
        return Some((v, (apart * scale).max(0.0)));
    }
    // Of the two rows of (m − low) the one that is not next to nothing tells the vector.
    let lowest = if half >= 0.0 { u * -q + w * (half + root) } else { u * (root - half) - w * q };
    let lowest = if root > 0.0 { lowest.normalize() } else { u };
    (high > ON_A_LINE * apart).then_some((lowest, (low * scale).max(0.0)))
}

/// A unit vector across the rows of a matrix of rank 2.
fn across(m: &Matrix3<f64>) -> Vector3<f64> {
    let [a, b, c] = [0, 1, 2].map(|k| m.column(k).into_owned());
    let crossed = [a.cross(&b), b.cross(&c), c.cross(&a)];
    crossed
        .into_iter()
        .fold(Vector3::zeros(), |best: Vector3<f64>, v| if v.norm_squared() > best.norm_squared() { v } else { best })
        .normalize()
}

#[cfg(test)]
mod tests;
