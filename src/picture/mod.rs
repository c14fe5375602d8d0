//! What is shown of a part and its plan, as plain [`Scene`](crate::view::Scene) data: the part in
//! surface colours, path lines, frames, beams, air moves. The window and `render` share it.

pub mod palette;
pub mod part;
pub mod paths;
pub mod section;

pub use palette::Palette;
pub use part::{PartLook, PartPicture};
pub use paths::{PathLook, paths};
