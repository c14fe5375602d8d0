//! What the beam does to the surface: energy per area where it really lands.

pub mod parameters;

pub use parameters::{DoseParameters, Profile};
