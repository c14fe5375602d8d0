//! The journal: what is not saved yet, written beside the user's data after every edit, so that a
//! killed program loses nothing.
//!
//! Each window has a slot: a lock that the system gives back when its process ends, however it ends,
//! and a state that is there only while the document is dirty. A state whose lock is free was left
//! behind ([`left_behind`]). States are replaced by rename and not synced to the disk: they outlive
//! the process, not a power cut; one that a power cut has torn is told, and not taken for a job.

mod error;
mod leftover;
mod recording;
mod slot;
mod state;

pub use error::{JournalError, StateError};
pub use leftover::{LeftBehind, Leftover, left_behind};
pub use recording::Journal;

#[cfg(test)]
mod tests;
