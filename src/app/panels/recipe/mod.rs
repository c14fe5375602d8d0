//! *Recipe of surface N*: the recipe of the selected surfaces, where its values differ from the job's, and the spacing
//! that was achieved with it.

mod achieved;
mod choice;
pub(in super::super) mod draft;
mod panel;
mod typed;
mod values;

pub(super) use panel::ui;
