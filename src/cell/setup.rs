//! What stands in the hall for one job: the cell, the robot in it, and what the robot carries.

use super::mounting::Mounted;
use super::{Cell, CellError, Joints, Mount, Robot};
use nalgebra::Isometry3;

/// Cell, robot and mount.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Frames, bodies, outputs, templates.
    pub cell: Cell,
    /// The robot; `None`: poses only, nothing is known of reach.
    pub robot: Option<Robot>,
    /// What it carries.
    pub mount: Mount,
}

impl Setup {
    /// The cell that is taken when none is named, without a robot.
    ///
    /// # Errors
    /// Never, as shipped.
    pub fn shipped() -> Result<Setup, CellError> {
        Ok(Setup { cell: Cell::shipped("mz04")?, robot: None, mount: Mount::PartInHand })
    }

    /// Pose of the flange in the base for a path frame of the part.
    pub fn flange_for(&self, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
        self.mounted().flange_for(part_from_focus)
    }

    /// The path frame at a pose of the flange.
    pub fn focus_for(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        self.mounted().focus_for(base_from_flange)
    }

    /// The frames in use, ready to be asked for many poses.
    pub fn mounted(&self) -> Mounted {
        self.cell.mounted(self.mount)
    }

    /// Where programs begin and end.
    pub fn home_joints_deg(&self) -> Joints {
        self.cell.air.home_joints_deg
    }

    /// The word of the robot's name for people, and `no robot`.
    pub fn robot_name(&self) -> &str {
        self.robot.as_ref().map_or("no robot", |r| &r.name)
    }
}
