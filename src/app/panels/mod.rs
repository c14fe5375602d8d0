//! The panels: each shows a part of the state and sends commands and edits; `context` says how.

mod access;
mod bead;
mod bead_section;
mod beam;
mod cell;
mod compare;
mod dialogs;
mod dose;
mod fields;
mod frames;
mod later;
mod layers;
mod laying;
mod library;
mod lists;
pub(super) mod menu;
mod own;
mod parameters;
mod plots;
mod problems;
mod program_text;
mod proposal;
mod questions;
mod recipe;
mod scrub;
mod spacing;
mod start;
pub(super) mod status;
mod timeline;
pub(super) mod toolbar;

pub(super) use compare::Compare;
pub(super) use recipe::Draft;
