//! How moves go: what keeps a lit move to its planned line, what proves that it is free, and the program over time.

pub mod curves;
pub mod lit;
pub mod spot;
pub mod sweep;
pub mod timeline;
mod trapezoid;
