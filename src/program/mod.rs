//! Controller programs. The way of the focus over the part, laser off between the lit pieces, and
//! the text that one controller reads.

pub mod air;
pub mod dialect;
pub mod lines;
pub mod nachi;
pub mod steps;

pub use dialect::{Dialect, Program, ProgramFile};
pub use lines::{Line, Move, lines};
pub use steps::{Go, Pace, Step, Steps, Way, steps};
