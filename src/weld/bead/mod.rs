//! A weld bead, measured: its outline, its centre line, and width and height along it (P4 4).
//!
//! The grey image finds the bead, depth outlines it: what stands above the parent surface. The centre line is the middle
//! of both edges across it; each round finds the edges anew from the line of the last. A bead is one open line; of a
//! cross of two the longer way is taken, and a ring is cut open. What leaves the image is refused: no one knows where it
//! ends.

mod crest;
mod edges;
mod feet;
mod histogram;
mod line;
mod measure;
mod model;
mod outline;
mod remaining;
mod rough;
mod traced;

pub use histogram::HeightHistogram;
pub use measure::SeenArea;
pub use model::{AreaKind, BeadPoint, WeldBead, WeldBeadError, WeldSection};
pub use remaining::{BeadState, RemainingBead};

#[cfg(test)]
mod tests;
