//! Shared by the tests of the window.
pub mod glow_renderer;
pub mod held;
pub mod scanned;
pub mod window;
