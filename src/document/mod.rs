//! What is saved: the job, and every way to change it.
//!
//! [`Job`] is the document. It changes through [`Edit`] alone, and [`Document`] keeps what undo
//! needs. [`Journal`] holds what is not saved yet, so that a killed program loses nothing. What can be computed from it is `planning`'s.

pub mod bead;
pub mod edit;
pub mod files;
pub mod journal;
pub mod library;
pub mod model;
pub mod parameter;
pub mod recipe;
mod recipe_edit;
pub mod recipe_table;
pub mod save;
mod split;
pub mod start_from;
pub mod undo;
pub mod users_folder;

pub use edit::Edit;
pub use files::JobError;
pub use journal::Journal;
pub use library::Library;
pub use model::{Chosen, Job, Offset, segmented};
pub use parameter::{PARAMETERS, Parameter};
pub use recipe::Recipe;
pub use save::{FileState, IfChanged, JobFile};
pub use start_from::StartFrom;
pub use undo::Document;
