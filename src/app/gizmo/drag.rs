//! A hand on a handle: where the pointer's ray meets the handle's line or plane is the motion.

use super::handles::{Handle, Way};
use nalgebra::{Isometry3, Point3, Translation3, Unit, UnitQuaternion, Vector3};

/// Steps that motions snap to, mm and degrees: what somebody would type.
const STEP_MM: f64 = 0.5;
const STEP_DEG: f64 = 1.0;
/// A line that is seen end on, or a ring edge on, cannot be dragged: sine of the least angle.
const FLAT: f64 = 0.05;

/// A ray: a point and a unit direction.
type Ray = (Point3<f64>, Vector3<f64>);

/// A handle that is held.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Drag {
    /// Which.
    pub handle: Handle,
    /// Where all stood when it was taken.
    begun: Isometry3<f64>,
    /// How far along the line, mm, or around the ring, radians, it was taken.
    at: f64,
}

impl Drag {
    /// Takes a handle; nothing where it is seen end on.
    pub fn begin(handle: Handle, pose: &Isometry3<f64>, ray: &Ray) -> Option<Drag> {
        Some(Drag { handle, begun: *pose, at: reached(handle, pose, ray)? })
    }

    /// Where what is moved stands now.
    pub fn pose_at(&self, ray: &Ray) -> Option<Isometry3<f64>> {
        let by = reached(self.handle, &self.begun, ray)? - self.at;
        let axis = Vector3::ith(self.handle.axis, 1.0);
        Some(match self.handle.way {
            Way::Along => {
                let mm = (by / STEP_MM).round() * STEP_MM;
                Translation3::from(self.begun.rotation * axis * mm) * self.begun
            }
            Way::Around => {
                let deg = (by.to_degrees() / STEP_DEG).round() * STEP_DEG;
                let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), deg.to_radians());
                Isometry3::from_parts(self.begun.translation, self.begun.rotation * turn)
            }
        })
    }
}

/// How far along its line, mm, or around its ring, radians, a ray reaches a handle.
fn reached(handle: Handle, pose: &Isometry3<f64>, (from, along): &Ray) -> Option<f64> {
    let origin = Point3::from(pose.translation.vector);
    let axis = pose.rotation * Vector3::ith(handle.axis, 1.0);
    match handle.way {
        Way::Along => {
            // The point of the line that is nearest to the ray.
            let (slope, off) = (axis.dot(along), from - origin);
            let square = 1.0 - slope * slope;
            (square > FLAT * FLAT).then(|| (off.dot(&axis) - slope * off.dot(along)) / square)
        }
        Way::Around => {
            let steep = axis.dot(along);
            if steep.abs() < FLAT {
                return None;
            }
            let hit = from + along * ((origin - from).dot(&axis) / steep);
            let arm = pose.rotation.inverse() * (hit - origin);
            let [u, v] = [arm[(handle.axis + 1) % 3], arm[(handle.axis + 2) % 3]];
            Some(libm::atan2(v, u))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn down_on(x: f64, y: f64) -> Ray {
        (Point3::new(x, y, 500.0), -Vector3::z())
    }

    #[test]
    fn an_arrow_moves_along_its_axis_alone() {
        let pose = Isometry3::translation(10.0, 20.0, 30.0);
        let handle = Handle { axis: 0, way: Way::Along };
        let drag = Drag::begin(handle, &pose, &down_on(30.0, 20.0)).expect("taken");
        let moved = drag.pose_at(&down_on(42.6, 55.0)).expect("moved");
        assert_eq!(moved.translation.vector, Vector3::new(22.5, 20.0, 30.0), "in steps of half a millimetre");
        assert_eq!(moved.rotation, pose.rotation);
        let end_on = Handle { axis: 2, way: Way::Along };
        assert_eq!(Drag::begin(end_on, &pose, &down_on(10.0, 20.0)), None);
    }

    #[test]
    fn a_ring_turns_about_its_axis_alone() {
        let pose = Isometry3::translation(10.0, 20.0, 30.0);
        let handle = Handle { axis: 2, way: Way::Around };
        let drag = Drag::begin(handle, &pose, &down_on(40.0, 20.0)).expect("taken");
        let moved = drag.pose_at(&down_on(10.0, 70.0)).expect("turned");
        assert_eq!(moved.translation, pose.translation);
        let (axis, rad) = moved.rotation.axis_angle().expect("turned");
        assert!((axis.z - 1.0).abs() < 1e-12 && (rad.to_degrees() - 90.0).abs() < 1e-9);
        assert_eq!(Drag::begin(Handle { axis: 0, way: Way::Around }, &pose, &down_on(10.0, 20.0)), None);
    }
}
