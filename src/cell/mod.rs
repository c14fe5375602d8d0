//! The robot cell: where laser, part and flange stand, and the robot that moves one of them.

pub mod bodies;
pub mod calibration;
pub mod collision;
pub mod controllers;
pub mod frame;
pub mod motion;
pub mod mounting;
pub mod opw;
pub mod outputs;
pub mod robot;
pub mod rpy;
pub mod setup;
pub mod timing;
pub mod ur;

pub use collision::{Collision, Contact};
pub use frame::Frame;
pub use mounting::{Cell, CellError, Mount, Spin};
pub use outputs::Outputs;
pub use robot::{Joints, Robot, RobotError};
pub use setup::Setup;
pub use timing::Timing;
