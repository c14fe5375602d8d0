//! How good a scan is: how dense and how noisy. Figures only: whether another scan is needed is for the reader to judge.
//! Which area of the model has no points is told by [`unscanned`](super::deviation::unscanned), once the scan is compared.

pub mod point_figures;
