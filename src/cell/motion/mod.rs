//! How the arm does the passes: spin and branch for every target, chosen together.
//!
//! The spot is round, so the part (or the tool) may be turned about the beam axis by any *spin*. A
//! *state* is one spin with one solution of the arm and its turns ([`states`]). The cheapest [`chain`] of
//! states is found by dynamic programming over all of them, and one that touches nothing is chosen ([`choice`]);
//! where there is none, a [`refusal`] says why, and [`advice`] what would help. Connecting moves are not chosen here.

pub mod advice;
pub mod chain;
pub mod choice;
mod clusters;
mod connecting_step;
mod lit_step;
mod reason;
pub mod refusal;
pub mod rules;
pub mod states;
pub mod target_state_cache;

pub use choice::{Choice, ChosenPose, SearchHooks, choose, choose_again};
pub use refusal::{Refusal, RefusalCause, RefusalReason};
pub use states::{Arm, ArmState};
pub use target_state_cache::TargetStateCache;
