//! Roll, pitch and yaw as NACHI and KUKA print them: `R = Rz(α)·Ry(β)·Rx(γ)` (P2 Eqs 7–9).

use nalgebra::{Rotation3, Vector3};

/// Angles about Z, Y and X in degrees.
///
/// Where β = ±90° only α ∓ γ is determined; there γ = 0 (the MZ04 stands so at J = 0, 90, 0, 0, 0, 0).
pub fn from_rotation(r: &Rotation3<f64>) -> [f64; 3] {
    let flat = libm::hypot(r[(0, 0)], r[(1, 0)]);
    let beta = libm::atan2(-r[(2, 0)], flat);
    let (alpha, gamma) = if flat < 1e-9 {
        (libm::atan2(-r[(0, 1)], r[(1, 1)]), 0.0)
    } else {
        (libm::atan2(r[(1, 0)], r[(0, 0)]), libm::atan2(r[(2, 1)], r[(2, 2)]))
    };
    [alpha, beta, gamma].map(f64::to_degrees)
}

/// The rotation of angles about Z, Y and X in degrees.
pub fn to_rotation([rz, ry, rx]: [f64; 3]) -> Rotation3<f64> {
    let about = |axis: Vector3<f64>, deg: f64| Rotation3::from_scaled_axis(axis * deg.to_radians());
    about(Vector3::z(), rz) * about(Vector3::y(), ry) * about(Vector3::x(), rx)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn there_and_back(a in prop::array::uniform3(-180.0..180.0f64), pole in prop::bool::ANY) {
            let a = if pole { [a[0], 90.0, a[2]] } else { a };
            let r = to_rotation(a);
            prop_assert!((to_rotation(from_rotation(&r)).matrix() - r.matrix()).norm() < 1e-7);
        }
    }

    #[test]
    fn the_quarter_turns() {
        assert_eq!(from_rotation(&to_rotation([90.0, 0.0, 0.0])).map(f64::round), [90.0, 0.0, 0.0]);
        assert_eq!(from_rotation(&to_rotation([0.0, 0.0, 90.0])).map(f64::round), [0.0, 0.0, 90.0]);
        assert_eq!(from_rotation(&to_rotation([30.0, 90.0, 10.0])).map(f64::round), [20.0, 90.0, 0.0]);
    }
}
