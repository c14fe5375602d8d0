//! Controller programs. The way of the focus over the part, laser off between the lit pieces, and
//! the text that one controller reads.

pub mod air;
pub mod nachi;
pub mod steps;

pub use steps::{Step, Steps, steps};
