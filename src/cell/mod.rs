//! The robot cell: where laser, part and flange stand, and the robot that moves one of them.

pub mod controllers;
pub mod motion;
pub mod mounting;
pub mod opw;
pub mod robot;
pub mod rpy;
pub mod setup;
pub mod timing;
pub mod ur;

pub use mounting::{Cell, CellError, Mount, Spin};
pub use robot::{Joints, Robot, RobotError};
pub use setup::Setup;
pub use timing::Timing;
