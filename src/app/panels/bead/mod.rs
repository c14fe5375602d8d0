//! *Bead*: what the beam lays, for the job and for a recipe: its size and layers, the section that they give, and P3's
//! relation between a bead's size and the distance of centres.

mod fill;
mod group;
pub(super) mod job;
pub(super) mod recipe;
mod section;
