//! The robot cell: where laser, part and flange stand, and the robot that moves one of them.

pub mod mounting;
pub mod opw;
pub mod robot;
pub mod rpy;
pub mod ur;

pub use mounting::{Cell, CellError, Mount};
pub use robot::{Joints, Robot, RobotError};
