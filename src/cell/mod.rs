//! The robot cell: where laser, part and flange stand. Kinematics and limits are not here yet:
//! a program states poses of the flange, and says so.

pub mod mounting;
pub mod rpy;

pub use mounting::{Cell, CellError};
