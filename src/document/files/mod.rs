//! Files of a job on disk: the job itself, the part, and what its set-up is made of. What a job's file says is
//! `job_file`'s.

mod atomic;
mod depth_part;
mod error;
mod inputs;
pub mod package;
mod part_file;
mod part_source;
mod paths;
pub mod save;
mod scanned_part_error;
mod setup;
pub mod stamps;

pub use atomic::write_atomic;
pub use error::JobError;
pub use inputs::{InputDigest, InputKind, inputs};
pub use part_file::{build_part, load_part, part_file, read_part};
pub use part_source::read_source;
pub(in crate::document) use paths::{absolute, with_whole_paths};
pub use paths::{rebased, relative_to, resolved};
pub use save::{is_job, read, to_toml};
pub use scanned_part_error::ScannedPartError;
pub use setup::{load_cell, load_robot, load_setup, load_tool, set_up};
