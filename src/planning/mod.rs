//! What is computed from a job: lines, poses, the program's steps, what is proven of them, the dose, the
//! report; and how a program that was read compares with them.

pub mod advice;
pub mod dose;
pub mod export;
pub mod key;
pub mod lay;
pub mod layer;
pub mod pipeline;
pub mod plan;
pub mod planned;
pub mod pool;
pub mod preview;
pub mod report;
pub mod stage;
pub mod surface_plan;
pub mod verify;
mod written;

pub use dose::dose;
pub use pipeline::Pipeline;
pub use plan::{Plan, PlanError, plan};
pub use planned::{PartError, PlannedJob, PlanningError};
pub use pool::{AtOnce, Pool};
pub use preview::preview;
pub use stage::{Executor, Failure, Stage, Task};
pub use surface_plan::Cache;
