//! clearbeam
pub mod part;
