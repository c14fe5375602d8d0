//! The recipes at hand: of the job, the user's own, and shipped ones. They are given by a button, or
//! dragged onto a row of the lists.

mod dragged;
mod panel;
pub(in super::super) mod shelf;
mod shelves;

pub(in super::super) use dragged::at_cursor;
pub(super) use dragged::{DraggedRecipe, draggable, edit_giving};
pub(super) use panel::ui;
