//! Controller programs: the way of the focus over the part, laser off between the lit pieces, and the text that one
//! controller reads.
//!
//! `neutral` is what a program is before any controller: steps, lines, comments as data. `motion` says how moves
//! go: what keeps a lit move to its line, what proves it, and when the arm is where. `connecting` finds the moves
//! between lit pieces, with and without a robot, and `driving` the joints of a whole program; `from_pass` is what is
//! left of one. A [`Dialect`] writes the lines in the words of one controller and reads its text back; all of them
//! stand in [`dialects`]. [`pacing`] gives the moves the times that these words have. Each imports only from those
//! before it.

mod connecting;
pub mod dialect;
pub mod dialects;
mod driving;
mod from_pass;
mod motion;
mod neutral;
pub mod pacing;
mod read_error;
mod write_error;

pub use connecting::pieces::Cuts;
pub use connecting::without_robot::{steps, way_from_home};
pub use dialect::{Dialect, Program, ProgramFile};
pub use driving::{Drive, DriveCache, Undriven};
pub use from_pass::{NoWayIn, steps_from};
pub use motion::curves::{Clearance, CurveSample, clearances, curves};
pub use motion::timeline::{Breakdown, Moment, Timeline, TimelineStop};
pub use motion::{lit, spot, sweep};
pub use neutral::comment::{Caveat, Comment, FileNote, GrindingFigures, ProcessFigures, WITHOUT_WORDS, Wording};
pub use neutral::lines::{Move, ProgramLine, lines};
pub use neutral::shortfall::{ByHand, OffSpeed, Shortfall};
pub use neutral::steps::{Go, Interpolation, MoveTiming, Station, Step, Steps};
pub use neutral::variant::{DRY_RUN_PERCENT, Variant};
pub use read_error::{LineFault, MoveGivenBy, ReadError, RowFault};
pub use write_error::{DialectError, SignalKind, UnknownDialect, WriteError};
