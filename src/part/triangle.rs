//! Normal and area of one triangle, and when it counts as having none.

use nalgebra::{Point3, Vector3};

/// Unit normal and area of a triangle; `None` where its corners lie on one line or in one point.
pub(super) fn normal_and_area([a, b, c]: &[Point3<f64>; 3]) -> Option<(Vector3<f64>, f64)> {
    let cross = (b - a).cross(&(c - a));
    let longest = (b - a).norm_squared().max((c - a).norm_squared()).max((c - b).norm_squared());
    let twice_area = cross.norm();
    // Relative height 1e-9: below what f32 coordinates can tell from a line (1e-7), above the rounding of this product.
    let flat = twice_area <= 1e-9 * longest || !twice_area.is_normal();
    (!flat).then(|| (cross / twice_area, 0.5 * twice_area))
}
