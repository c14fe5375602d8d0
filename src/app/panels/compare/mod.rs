//! Compares recipes side by side: the rows in which they differ, or all.

pub(in super::super) mod state;
mod window;

pub(in super::super) use window::ui;
