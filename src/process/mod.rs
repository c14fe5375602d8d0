//! What the beam does to the surface: energy per area where it really lands, and what that leaves
//! unclean, harms, or hits beside what was chosen.
//!
//! Part frame, mm; energy per area J/mm² inside, J/cm² in what is handed out. The laser runs evenly:
//! pulses, heat and reflected light are not looked at.

pub mod bead;
mod cell;
pub mod closeness;
pub mod dose;
mod floor;
pub mod light;
pub mod parameters;
pub mod patches;
mod reach;
pub mod samples;
pub mod shade;
pub mod spot;
pub mod statistics;

pub use dose::{DoseMap, SpotHit, Task, dose};
pub use light::Light;
pub use parameters::{DoseParameters, Profile, Thresholds};
pub use patches::{Cause, Patch};
pub use samples::Sample;
pub use spot::Spot;
pub use statistics::{Collateral, Shares, Verdict};
