//! The weld in the window: how its images are asked for, what of them is shown and how the hand works on them, and where
//! its bead lies in the view. What is asked of them is `panels::weld`'s.

mod asking;
mod images;
mod taking;
mod textures;
mod view;

pub(super) use asking::WeldAsking;
pub(super) use images::{ImageHand, ImagesView, MaskStep};
pub(super) use textures::ImageTextures;
pub(super) use view::WeldView;
