//! The window in which a head is put together from cylinders and cones, drawn to scale.

mod drawing;
pub(in super::super) mod state;
mod window;

pub(in super::super) use window::ui;
