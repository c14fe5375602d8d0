//! What is computed from a job: lines, poses, the program's steps, what is proven of them, the dose, the
//! report; and how a program that was read compares with them.

pub mod advice;
pub mod dose;
pub mod export;
pub mod lay;
pub mod layer;
pub mod plan;
pub mod preview;
pub mod report;
pub mod surface_plan;
pub mod verify;
mod written;

pub use dose::dose;
pub use plan::{Plan, PlanError, plan};
pub use preview::preview;
pub use surface_plan::Cache;
