//! Where the part stands: P2's model transformation. Turn, scale and move the file's coordinates
//! into the part frame; put the origin on a picked face, edge or hole; lay a face on a plane.

use super::angle;
use crate::number_fields::number_fields;
use nalgebra::{Isometry3, Matrix4, Point3, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

/// Scale about the file's origin, then rotation, then translation: `p = R·(s·q) + t`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Placement {
    /// Factor on all three axes, on top of the unit.
    pub scale: f64,
    /// Turn about X, then Y, then Z of the part frame, degrees.
    pub rotation_deg: [f64; 3],
    /// Move in the part frame, mm.
    pub translation_mm: [f64; 3],
}

impl Default for Placement {
    fn default() -> Self {
        Placement::DEFAULT
    }
}

impl Placement {
    /// As the file has it.
    pub const DEFAULT: Placement = Placement { scale: 1.0, rotation_deg: [0.0; 3], translation_mm: [0.0; 3] };

    /// Rotation and translation.
    pub fn isometry(&self) -> Isometry3<f64> {
        let [x, y, z] = self.rotation_deg.map(f64::to_radians);
        let about = |axis: Vector3<f64>, by: f64| UnitQuaternion::from_scaled_axis(axis * by);
        let rotation = about(Vector3::z(), z) * about(Vector3::y(), y) * about(Vector3::x(), x);
        Isometry3::from_parts(Translation3::from(Vector3::from(self.translation_mm)), rotation)
    }

    /// Point of the file (in mm) in the part frame. The identity leaves every bit as it is.
    pub fn apply(&self, p: &Point3<f64>) -> Point3<f64> {
        if *self == Placement::default() {
            return *p;
        }
        self.isometry() * (p * self.scale)
    }

    /// As a matrix, `part_from_file`.
    pub fn matrix(&self) -> Matrix4<f64> {
        self.isometry().to_homogeneous() * Matrix4::new_scaling(self.scale)
    }

    /// Followed by a further motion in the part frame.
    #[must_use]
    pub fn then(&self, motion: &Isometry3<f64>) -> Placement {
        let all = motion * self.isometry();
        let (x, y, z) = all.rotation.euler_angles();
        let clean = |v: f64| if v.abs() < 1e-12 { 0.0 } else { v };
        Placement {
            scale: self.scale,
            rotation_deg: [x, y, z].map(|r| clean(r.to_degrees())),
            translation_mm: [all.translation.x, all.translation.y, all.translation.z].map(clean),
        }
    }

    /// Moved so that this point of the part frame becomes the origin.
    #[must_use]
    pub fn with_origin_at(&self, point: &Point3<f64>) -> Placement {
        self.then(&Isometry3::translation(-point.x, -point.y, -point.z))
    }

    /// Turned so that a face at `point` with outward `normal` lies on the plane z = 0, looking down.
    #[must_use]
    pub fn with_face_down(&self, point: &Point3<f64>, normal: &Vector3<f64>) -> Placement {
        let turn = angle::rotation_between(normal, &-Vector3::z());
        let z = (turn * point).z;
        self.then(&Isometry3::from_parts(Translation3::new(0.0, 0.0, -z), turn))
    }

    /// A turn by 90° about an axis (0 = X) through the part frame's origin.
    #[must_use]
    pub fn quarter_turn(&self, axis: usize) -> Placement {
        let mut about = Vector3::zeros();
        about[axis.min(2)] = std::f64::consts::FRAC_PI_2;
        self.then(&Isometry3::rotation(about))
    }
}

super::keyed!(Placement { scale, rotation_deg, translation_mm });
number_fields!(Placement { scale, rotation_deg: _, translation_mm: _ });

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn composing_is_applying_in_turn(r in prop::array::uniform3(-170.0..170.0f64), t in prop::array::uniform3(-50.0..50.0f64),
                                         q in prop::array::uniform3(-50.0..50.0f64), s in 0.1..4.0f64) {
            let first = Placement { scale: s, rotation_deg: r, translation_mm: t };
            let p = Point3::from(Vector3::from(q));
            let motion = Placement { scale: 1.0, rotation_deg: [t[0], r[1], q[2]], translation_mm: q }.isometry();
            prop_assert!((first.then(&motion).apply(&p) - motion * first.apply(&p)).norm() < 1e-9);
            let by_matrix = first.matrix().transform_point(&p);
            prop_assert!((by_matrix - first.apply(&p)).norm() < 1e-9);
        }

        #[test]
        fn a_face_laid_down_looks_down_at_height_zero(n in prop::array::uniform3(-1.0..1.0f64), q in prop::array::uniform3(-50.0..50.0f64)) {
            let n = Vector3::from(n);
            prop_assume!(n.norm() > 0.1);
            let (n, p) = (n.normalize(), Point3::from(Vector3::from(q)));
            let placed = Placement::default().with_face_down(&p, &n);
            prop_assert!((placed.isometry() * n + Vector3::z()).norm() < 1e-9);
            prop_assert!(placed.apply(&p).z.abs() < 1e-9);
        }
    }

    #[test]
    fn the_origin_goes_where_it_was_picked() {
        let p = Point3::new(3.0, -4.0, 5.0);
        let placed = Placement::default().quarter_turn(2);
        let picked = placed.apply(&p);
        assert!(placed.with_origin_at(&picked).apply(&p).coords.norm() < 1e-12);
    }
}
