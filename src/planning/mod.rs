//! What is computed from a job: lines, poses, the program's steps, what is proven of them, the dose, the
//! report; and how a program that was read compares with them.
//!
//! `plan` holds a plan and what it is made of: toolpaths, build-ups, surface plans. `proof` proves its lit moves, as
//! they are written and as they are read. `making` and `driving` make a plan with both; `report` and `export` tell and write it;
//! `key`, `stage`, `pool` and `pipeline` keep it current.

pub mod advice;
pub mod cures;
pub mod dose;
mod driving;
mod error;
mod executor;
pub mod export;
mod failure;
mod from_pass;
pub mod key;
mod making;
pub mod pipeline;
pub mod plan;
pub mod planned;
pub mod pool;
pub mod proof;
mod recognised;
pub mod report;
pub mod scanned;
pub mod stage;
#[cfg(test)]
mod stage_tests;
pub mod welded;

pub use dose::dose;
pub use error::{PartError, PlanError, PlanningError};
pub use executor::{Executor, Task};
pub use failure::Failure;
pub use from_pass::{FromPassError, from_pass};
pub use making::plan;
pub use pipeline::Pipeline;
pub use plan::preview::preview;
pub use plan::surface_plan::PlanCache;
pub use plan::taken_by::TakenBy;
pub use plan::{Plan, cell_report, remark, surface_plan, taken_by, toolpath};
pub use planned::PlannedJob;
pub use pool::{AtOnce, Pool};
pub use proof::verify;
pub use recognised::{ComparedProgram, NotCompared, compared};
pub use stage::Stage;
