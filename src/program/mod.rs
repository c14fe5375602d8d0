//! Controller programs. The way of the focus over the part, laser off between the lit pieces, and
//! the text that one controller reads.

pub mod abb;
pub mod air;
pub mod arm;
pub mod csv;
pub mod dialect;
pub mod estun;
pub mod fanuc;
pub mod flange;
pub mod kuka;
pub mod lines;
pub mod nachi;
pub mod pages;
pub mod phrases;
pub mod steps;
pub mod ur;
pub mod words;
pub mod yaskawa;

pub use dialect::{Dialect, Program, ProgramFile};
pub use lines::{Line, Move, lines};
pub use steps::{Go, Pace, Step, Steps, Way, steps};
