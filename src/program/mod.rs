//! Controller programs. The way of the focus over the part, laser off between the lit pieces, and
//! the text that one controller reads.

pub mod abb;
pub mod air;
pub mod csv;
pub mod dialect;
pub mod drive;
pub mod estun;
pub mod fanuc;
pub mod kuka;
pub mod lines;
pub mod nachi;
mod round;
pub mod series;
pub mod steps;
pub mod timeline;
pub mod trapezoid;
pub mod ur;
pub mod yaskawa;

pub use dialect::{Dialect, Program, ProgramFile};
pub use lines::{Line, Move, lines};
pub use series::{Sample, series};
pub use steps::{Go, Pace, Step, Steps, Way, steps};
pub use timeline::{Breakdown, Moment, Stop, Timeline};
