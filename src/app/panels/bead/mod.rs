//! *Bead*: what the beam lays, for the job and for a recipe: its size and layers, the section that comes of it,
//! and P3's way between a bead's size and the distance of centres, both ways.

mod fill;
mod group;
pub(super) mod job;
pub(super) mod recipe;
mod section;
