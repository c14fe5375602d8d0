//! clearbeam
pub mod app;
pub mod cell;
pub mod cli;
pub mod job;
pub mod part;
pub mod path;
pub mod picture;
pub mod pose;
pub mod program;
pub mod sample;
pub mod view;
