//! What is saved: the job, and every way to change it.
//!
//! [`Job`] is the document. It changes through [`Edit`] alone, and [`Document`] keeps what undo
//! needs. What can be computed from it is `planning`'s.

pub mod bead;
pub mod edit;
pub mod files;
mod keys;
pub mod library;
pub mod model;
pub mod parameter;
pub mod recipe;
mod recipe_edit;
pub mod recipe_table;
mod split;
pub mod start_from;
pub mod undo;

pub use edit::Edit;
pub use files::JobError;
pub use library::Library;
pub use model::{Chosen, Job, Offset, segmented};
pub use parameter::{PARAMETERS, Parameter};
pub use recipe::Recipe;
pub use start_from::StartFrom;
pub use undo::Document;
