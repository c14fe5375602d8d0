//! What is computed from a job: lines, poses, the program's steps, what is proven of them, the dose, the
//! report; and how a program that was read compares with them.

pub mod advice;
pub mod cell_report;
pub mod dose;
mod driving;
mod error;
mod executor;
pub mod export;
mod failure;
pub mod key;
pub mod lay;
pub mod layer;
mod making;
pub mod pipeline;
pub mod plan;
pub mod planned;
pub mod pool;
mod prepared;
pub mod preview;
pub mod proof;
pub mod remark;
pub mod report;
pub mod stage;
#[cfg(test)]
mod stage_tests;
pub mod surface_plan;
pub mod verify;
mod written;

pub use dose::dose;
pub use error::{PartError, PlanError, PlanningError};
pub use executor::{Executor, Task};
pub use failure::Failure;
pub use making::plan;
pub use pipeline::Pipeline;
pub use plan::Plan;
pub use planned::PlannedJob;
pub use pool::{AtOnce, Pool};
pub use preview::preview;
pub use stage::Stage;
pub use surface_plan::Cache;
