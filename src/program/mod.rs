//! Controller programs. The way of the focus over the part, laser off between the lit pieces, and
//! the text that one controller reads.

pub mod abb;
pub mod air;
mod arm;
pub mod csv;
mod csv_reader;
pub mod dialect;
pub mod dialects;
pub mod drive;
mod driven;
pub mod estun;
pub mod fanuc;
mod fanuc_reader;
mod flange;
pub mod kuka;
mod lead;
pub mod lines;
pub mod lit;
pub mod nachi;
mod nachi_reader;
pub mod pages;
mod phrases;
mod pieces;
mod reading;
mod remarks;
mod round;
pub mod series;
pub mod steps;
pub mod sweep;
pub mod timeline;
pub mod trapezoid;
pub mod ur;
mod ur_reader;
pub mod yaskawa;

pub use dialect::{Dialect, Program, ProgramFile};
pub use lines::{Line, Move, lines};
pub use series::{Clearance, Sample, clearances, series};
pub use steps::{Go, Pace, Step, Steps, Way, steps};
pub use timeline::{Breakdown, Moment, Stop, Timeline};
