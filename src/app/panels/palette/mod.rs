//! The search for a command by words of its name; `state` is what the session keeps of it.

pub(in super::super) mod state;
mod window;

pub(in super::super) use window::ui;
