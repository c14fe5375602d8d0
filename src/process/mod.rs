//! What the beam does to the surface: energy per area where it really lands, and what that leaves
//! unclean, damages, or hits outside the chosen surfaces.
//!
//! Part frame, mm; energy per area J/mm² inside, J/cm² in what is handed out. The laser runs evenly:
//! pulses, heat and reflected light are not modelled.

pub mod bead;
pub mod closeness;
pub mod dose;
mod facet_polygon;
mod floor;
pub mod light;
pub mod parameters;
pub mod patches;
mod reach;
pub mod samples;
pub mod shade;
pub mod spot;
pub mod statistics;

pub use dose::{DoseInput, DoseMap, SpotHit, dose};
pub use light::Light;
pub use parameters::{DoseParameters, Profile, Thresholds};
pub use patches::{Patch, PatchCause};
pub use samples::DoseSample;
pub use spot::Spot;
pub use statistics::{Collateral, DoseVerdict, Shares};
