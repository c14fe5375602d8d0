//! The circle through points of a plane, by least squares of x² + y² (Kåsa): closed form, exact for points on a circle.
//! On a short arc with noise it comes out too small; it is a start there, and no more.

use nalgebra::{Matrix3, Vector3};

/// Middle and radius of the circle; `None` where the points lie on a line or are too few.
pub fn fitted_circle(points: impl Iterator<Item = [f64; 2]>) -> Option<([f64; 2], f64)> {
    // x² + y² = 2·cx·x + 2·cy·y + k, linear in (cx, cy, k).
    let (mut m, mut r) = (Matrix3::zeros(), Vector3::zeros());
    for [x, y] in points {
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        m += row * row.transpose();
        r += row * (x * x + y * y);
    }
    let c = m.lu().solve(&r)?;
    let radius = (c[2] + c[0] * c[0] + c[1] * c[1]).sqrt();
    radius.is_finite().then_some(([c[0], c[1]], radius))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_a_circle_tell_it_and_those_of_a_line_none() {
        let turn = |k: i32| 0.4 * f64::from(k);
        let on = |k: i32| [3.0 + 5.0 * libm::cos(turn(k)), -2.0 + 5.0 * libm::sin(turn(k))];
        let ([x, y], radius) = fitted_circle((0..5).map(on)).expect("a circle");
        assert!((x - 3.0).abs() + (y + 2.0).abs() + (radius - 5.0).abs() < 1e-9);
        assert!(fitted_circle((0..3).map(|k| [f64::from(k), 0.0])).is_none());
    }
}
