//! What is saved, and how a plan is computed from it.
//!
//! [`Job`] is the document. It changes through [`Edit`] alone, and [`Document`] keeps what undo
//! needs. [`plan()`] computes everything else; [`output`] writes it.

pub mod advice;
pub mod bead;
pub mod document;
pub mod dose;
pub mod edit;
pub mod files;
pub mod lay;
pub mod layer;
pub mod library;
pub mod model;
pub mod output;
pub mod parameter;
pub mod plan;
pub mod preview;
pub mod recipe;
mod recipe_edit;
pub mod recipe_table;
pub mod report;
mod split;
pub mod start_from;
pub mod surface_plan;
pub mod verify;
mod written;

pub use crate::progress::Progress;
pub use document::Document;
pub use dose::dose;
pub use edit::Edit;
pub use files::JobError;
pub use library::Library;
pub use model::{Chosen, Job, Offset};
pub use parameter::{PARAMETERS, Parameter};
pub use plan::{Plan, PlanError, plan};
pub use preview::preview;
pub use recipe::Recipe;
pub use start_from::StartFrom;
pub use surface_plan::Cache;
