//! Rotations as vectors: axis times angle, radians.

use nalgebra::{UnitQuaternion, Vector3};

/// A rotation as axis times angle, up to half a turn.
pub(super) fn turn(rotation: &UnitQuaternion<f64>) -> Vector3<f64> {
    let q = if rotation.w < 0.0 { -rotation.into_inner() } else { rotation.into_inner() };
    let sine = q.imag().norm();
    let half = libm::atan2(sine, q.w);
    if sine > 0.0 { q.imag() * (2.0 * half / sine) } else { Vector3::zeros() }
}

/// The rotation of an axis times an angle.
pub(super) fn rotation_of(turn: &Vector3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(*turn)
}
