//! How good a scan is: how dense, how noisy, and which area of the model has no points.
//!
//! Figures only: whether another scan is needed is for the reader to judge.

pub mod coverage;
pub mod point_figures;
