//! The pose of the flange for a pose of the beam on the part, and the other way round, for either mount.
//!
//! Part in hand (P1 4, P2 4.3): the laser is fixed and points down, the robot carries the part.

use super::cell_file::Cell;
use super::mount::Mount;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

impl Cell {
    /// The frames of a mount, ready to be asked for many poses.
    pub fn mounted(&self, mount: Mount) -> Mounted {
        match mount {
            Mount::PartInHand => {
                Mounted { mount, fixed: self.base_from_laser.isometry(), carried: self.flange_from_part.isometry() }
            }
            Mount::ToolInHand => {
                Mounted { mount, fixed: self.base_from_part.isometry(), carried: self.flange_from_focus() }
            }
        }
    }

    /// Tool in hand: the laser frame on the flange, its origin in the focus, z against the light.
    pub fn flange_from_focus(&self) -> Isometry3<f64> {
        self.flange_from_tool.isometry() * half_turn()
    }
}

/// The frames of a mount: what stands in the base, and what hangs on the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounted {
    mount: Mount,
    /// Laser in the base, or part in the base.
    fixed: Isometry3<f64>,
    /// Part on the flange, or laser frame on the flange.
    carried: Isometry3<f64>,
}

impl Mounted {
    /// Pose of the flange in the base that brings focus and beam to a path frame of the part.
    ///
    /// Part in hand `T = L·(G·F)⁻¹`, tool in hand `T = B·F·Rot_o(180°)·H⁻¹`.
    pub fn flange_for(&self, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => self.fixed * (self.carried * part_from_focus).inverse(),
            Mount::ToolInHand => self.fixed * part_from_focus * self.carried.inverse(),
        }
    }

    /// Part in the base at a pose of the flange.
    pub fn part_at(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => base_from_flange * self.carried,
            Mount::ToolInHand => self.fixed,
        }
    }

    /// Focus in the base at a pose of the flange, z against the light.
    pub fn focus_at(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => self.fixed,
            Mount::ToolInHand => base_from_flange * self.carried,
        }
    }

    /// The path frame at a pose of the flange: the inverse of [`Mounted::flange_for`].
    pub fn focus_for(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        self.part_at(base_from_flange).inverse() * self.focus_at(base_from_flange)
    }
}

/// Half a turn about y: a tool's z points with the light, a path frame's against it.
pub fn half_turn() -> Isometry3<f64> {
    let half = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(0.0, 0.0, 1.0, 0.0));
    Isometry3::from_parts(Translation3::identity(), half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::target::frame;
    use nalgebra::{Point3, Vector3};

    /// P2 Eqs 4–6: with G = 1, `P = L − D − V'`, `V' = [n o a]ᵀ·v`.
    #[test]
    fn the_flange_stands_where_p2_says() {
        let mut cell = Cell::shipped("mz04").expect("the shipped cell is valid");
        cell.flange_from_part.position_mm = [0.0; 3];
        let a = Vector3::new(0.6, 0.0, 0.8);
        let o = Vector3::new(0.0, 1.0, 0.0);
        let (v, d) = (Point3::new(10.0, -4.0, 7.0), 15.0);
        let t = cell.mounted(Mount::PartInHand).flange_for(&frame(&(v + a * d), &a, &o));
        let n = o.cross(&a);
        let v_prime = Vector3::new(n.dot(&v.coords), o.dot(&v.coords), a.dot(&v.coords));
        let expected = Vector3::from(cell.base_from_laser.position_mm) - Vector3::new(0.0, 0.0, d) - v_prime;
        assert!((t.translation.vector - expected).norm() < 1e-12);
        assert!((t.rotation * a - Vector3::z()).norm() < 1e-12, "the beam axis points up at the laser");
    }
}
