//! Angles between directions, from `libm`, so that they are the same on every machine.

use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector3};

/// Angle between two vectors of any length, degrees in `[0, 180]`; 0 if one of them is zero.
///
/// `atan2` of cross and dot product: exact near 0° and 180°, where `acos` loses half the digits.
pub fn between_deg(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    libm::atan2(a.cross(b).norm(), a.dot(b)).to_degrees()
}

/// `v` turned about the unit `axis` by `angle_deg` (right-hand rule).
pub fn turned(v: &Vector3<f64>, axis: &Vector3<f64>, angle_deg: f64) -> Vector3<f64> {
    let (s, c) = (libm::sin(angle_deg.to_radians()), libm::cos(angle_deg.to_radians()));
    v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1.0 - c))
}

/// Unit directions between `a` (t = 0) and `b` (t = 1) on the great circle, at constant rate.
///
/// Opposite directions have no great circle of their own; then a fixed one is taken.
pub fn slerp(a: &Vector3<f64>, b: &Vector3<f64>, t: f64) -> Vector3<f64> {
    GreatCircle::new(a, b).at(t)
}

/// The great circle of [`slerp`], prepared for many `t`.
#[derive(Clone, Copy, Debug)]
pub struct GreatCircle {
    from: Vector3<f64>,
    /// Axis of the turn and its whole angle, degrees; `None`: no turn.
    turn: Option<(Vector3<f64>, f64)>,
}

impl GreatCircle {
    /// From `a` to `b`, unit both.
    pub fn new(a: &Vector3<f64>, b: &Vector3<f64>) -> GreatCircle {
        let angle_deg = between_deg(a, b);
        let axis = a.cross(b);
        let axis = || if axis.norm() > 1e-9 { axis.normalize() } else { any_square_to(a) };
        GreatCircle { from: *a, turn: (angle_deg >= 1e-9).then(|| (axis(), angle_deg)) }
    }

    /// The direction at the share `t` of the way.
    pub fn at(&self, t: f64) -> Vector3<f64> {
        self.turn.map_or(self.from, |(axis, angle_deg)| turned(&self.from, &axis, angle_deg * t))
    }
}

/// A unit vector square to `v`, always the same for the same `v`.
pub fn any_square_to(v: &Vector3<f64>) -> Vector3<f64> {
    let other = if v.z.abs() < 0.9 * v.norm() { Vector3::z() } else { Vector3::x() };
    v.cross(&other).normalize()
}

/// `v` of length 1, or `None` where its length is below `1e-12` or not a number.
pub fn unit(v: Vector3<f64>) -> Option<Vector3<f64>> {
    Unit::try_new(v, 1e-12).map(Unit::into_inner).filter(|u| u.iter().all(|x| x.is_finite()))
}

/// The whole angle of a rotation, degrees in `[0, 180]`.
pub fn turned_deg(r: &Rotation3<f64>) -> f64 {
    let twice_sine = Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]).norm();
    libm::atan2(twice_sine, r.matrix().trace() - 1.0).to_degrees()
}

/// The rotation that turns `from` onto `onto` the short way.
pub fn rotation_between(from: &Vector3<f64>, onto: &Vector3<f64>) -> UnitQuaternion<f64> {
    let axis = unit(from.cross(onto)).unwrap_or_else(|| any_square_to(from));
    UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), between_deg(from, onto).to_radians())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_of_the_axes() {
        assert_eq!(between_deg(&Vector3::x(), &Vector3::y()), 90.0);
        assert_eq!(between_deg(&Vector3::x(), &-Vector3::x()), 180.0);
        assert_eq!(between_deg(&Vector3::x(), &Vector3::zeros()), 0.0);
    }

    #[test]
    fn slerp_goes_at_constant_rate_even_between_opposites() {
        for b in [Vector3::y(), -Vector3::x(), Vector3::new(0.6, 0.8, 0.0)] {
            let whole = between_deg(&Vector3::x(), &b);
            let third = slerp(&Vector3::x(), &b, 1.0 / 3.0);
            assert!((between_deg(&Vector3::x(), &third) - whole / 3.0).abs() < 1e-9);
            assert!((slerp(&Vector3::x(), &b, 1.0) - b).norm() < 1e-12);
        }
    }

    #[test]
    fn the_short_rotation_maps_one_onto_the_other() {
        let (a, b) = (Vector3::new(0.0, 0.6, 0.8), -Vector3::z());
        assert!((rotation_between(&a, &b) * a - b).norm() < 1e-12);
        assert!((rotation_between(&a, &-a) * a + a).norm() < 1e-12);
    }
}
