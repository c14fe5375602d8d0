//! The robot cell: where laser, part and flange stand, and the robot that moves one of them.

/// The files of a folder of `assets` by the keys of the shipped robots, the only list of them.
macro_rules! shipped_files {
    ($folder:literal) => {
        $crate::cell::shipped_files!(
            $folder: "mz04" "mz07f" "kr6-r900" "irb120" "irb1200" "irb2400" "lrmate200id" "m10ia" "tx2-60" "gp7" "gp8" "ur5e"
        )
    };
    ($folder:literal: $($key:literal)+) => {
        &[$(($key, include_str!(concat!("../../assets/", $folder, "/", $key, ".toml")))),+]
    };
}
use shipped_files;

pub mod bodies;
pub mod calibration;
mod cell_error;
pub mod cell_file;
pub mod check;
pub mod collision;
pub mod controllers;
pub mod frame;
pub mod hand_eye;
pub mod motion;
pub mod mount;
pub mod mounting;
pub mod opw;
pub mod outputs;
pub mod robot;
pub mod setup;
pub mod timing;
pub mod ur_kinematics;

pub use cell_error::{CellError, PlaceError};
pub use cell_file::{Air, Cell};
pub use collision::{BodyId, Collision, Contact};
pub use frame::Frame;
pub use mount::{Mount, Spin};
pub use outputs::Outputs;
pub use robot::{Joints, Link, Robot, RobotError};
pub use setup::Setup;
pub use timing::Timing;
