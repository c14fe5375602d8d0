//! What happens at the rim of a surface: lines that keep off it or run on over it, pieces joined over holes,
//! pieces too short to be worth their way.
//!
//! Distances from the rim are straight ones in space. That is exact on flat surfaces and a little less than the
//! way on curved ones (on a cylinder of radius R by the share (w/R)²/24 at the distance w).
//!
//! The order is: cut lines (on [`ExtendedSurface::surface`] to run over), [`inset`] or [`run_over`], [`joined`],
//! [`without_short`]. Which of the lines comes first is not decided here.

mod clip;
mod extended_surface;
mod join;
pub mod rim;
mod tree;

#[cfg(test)]
mod tests;

pub use clip::{inset, run_over};
pub use extended_surface::{ExtendedSurface, extended};
pub use join::{DroppedLines, joined, without_short};
pub use rim::{Rim, RimLoop, rim};
