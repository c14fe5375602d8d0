//! The panels: each shows a part of the state and sends commands and edits; `context` says how.

pub(super) mod access;
mod bead;
mod bead_section;
mod beam;
mod cell;
mod compare;
pub(super) mod dialogs;
pub(super) mod dose;
mod fields;
mod frames;
mod later;
mod layers;
mod laying;
mod library;
pub(super) mod lists;
pub(super) mod menu;
mod own;
mod parameters;
pub(super) mod plots;
pub(super) mod problems;
pub(super) mod program_text;
pub(super) mod proposal;
pub(super) mod questions;
mod recipe;
mod scrub;
mod spacing;
mod start;
pub(super) mod status;
pub(super) mod timeline;
pub(super) mod toolbar;

pub(super) use compare::Compare;
pub(super) use recipe::Draft;
