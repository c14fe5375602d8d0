//! What the beam does to the surface: energy per area where it really lands, and what that leaves
//! unclean, damages, or hits outside the chosen surfaces.
//!
//! Part frame, mm; energy per area J/mm² inside, J/cm² in what is handed out. The laser runs evenly:
//! pulses, heat and reflected light are not modelled.

pub mod bead;
pub mod dose;
pub mod dose_map;
pub mod dose_spacing;
mod facet_polygon;
mod landed;
pub mod light;
pub mod light_piece;
mod lit_facets;
mod occluder_height;
pub mod parameters;
pub mod patches;
pub mod samples;
pub mod shade;
pub mod spot;
pub mod statistics;
mod way_time;

pub use dose::{DoseInput, dose};
pub use dose_map::{DoseMap, SpotHit};
pub use light::Light;
pub use parameters::{DoseParameters, Profile, Thresholds};
pub use patches::{Patch, PatchCause};
pub use samples::DoseSample;
pub use spot::Spot;
pub use statistics::{Collateral, DoseVerdict, Shares};
pub use way_time::WayTime;
