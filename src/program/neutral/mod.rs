//! What a program is before any controller's words: steps and lines, comments as data, and what of it is not as it
//! was wanted. How moves go in detail, and how they are written, is told elsewhere.

pub mod comment;
pub mod lines;
pub mod shortfall;
pub mod steps;
pub mod variant;
