//! What is saved: the job, and every way to change it.
//!
//! [`Job`] is the document. It changes through [`Edit`] alone, and [`Document`] keeps what undo
//! needs. [`Journal`] holds what is not saved yet, so that a killed program loses nothing. What can be computed from
//! the job is `planning`'s.

pub mod bead;
pub mod changed_part;
mod check;
mod chosen;
mod cutting;
pub mod edit;
pub mod files;
pub mod job_file;
pub mod job_recipes;
pub mod journal;
mod landmarks;
pub mod library;
pub mod line_change;
pub mod model;
mod offset_start;
mod order;
pub mod parameter;
pub mod recipe;
mod recipe_edit;
pub mod recipe_table;
pub mod recut;
pub mod remembered;
pub mod renumber;
mod reshape;
pub mod reweld;
mod scan_carried;
pub mod scan_edit;
pub mod settings;
pub mod start_from;
pub mod undo;
pub mod users_folder;
pub mod value_error;
pub mod weld_edit;

pub use changed_part::{CarriedOver, LostSurface};
pub use chosen::Chosen;
pub use edit::Edit;
pub use files::save::{self, FileState, IfChanged, JobFile};
pub use files::{JobError, stamps};
pub use job_file::JobFileError;
pub use journal::Journal;
pub use library::{Forgotten, Library};
pub use line_change::LineChange;
pub use model::{FirstPlane, Job, segmented};
pub use parameter::{PARAMETERS, Parameter, ParameterError};
pub use recipe::Recipe;
pub use recut::RecutAnchor;
pub use remembered::Remembered;
pub use renumber::{LostSettings, Renumbering};
pub use reshape::Cut;
pub use scan_edit::ScanEdit;
pub use settings::{Settings, SurfaceSettings};
pub use start_from::StartFrom;
pub use undo::{Document, UndoStep};
pub use value_error::{BeadError, RecipeError, ValueError};
pub use weld_edit::WeldEdit;
