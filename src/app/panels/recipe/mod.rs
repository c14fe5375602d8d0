//! *Recipe of surface N*: what the selected surfaces are worked with, where that differs from the job's
//! own values, and the spacing that came of it.

mod achieved;
mod choice;
pub(in super::super) mod draft;
mod panel;
mod typed;
mod values;

pub(super) use panel::ui;
