//! What is shown of a part and its plan, as plain [`Scene`](crate::view::Scene) data: the part in
//! surface colours, path lines, frames, beams, air moves, the robot cell, scans. The window and `render` share it.

mod arm;
pub mod beads;
pub mod border;
pub mod cell;
mod colormap;
pub mod deviation;
pub mod dose;
pub mod legend;
pub mod palette;
pub mod part;
pub mod patches;
pub mod paths;
pub mod regions;
pub mod scan;
mod scan_on_part;
pub mod section;
pub mod solid;
pub mod spacing;
mod still;
mod tool;
pub mod trail;
pub mod weld;
pub mod weld_image;

pub use cell::CellPicture;
pub use colormap::viridis;
pub use deviation::DeviationScale;
pub use dose::{DoseLook, dose_item};
pub use legend::{Legend, LegendEntry, Quantity};
pub use palette::Palette;
pub use part::{PartLook, PartPicture};
pub use paths::{PathLook, paths};
pub use scan::{ScanLook, ScanPicture};
pub use scan_on_part::{deviation_on_model, deviation_points, deviation_scale};
pub use still::{part_with_lines, png, still};
pub use tool::{LIGHT, ToolPicture};
pub use trail::Trail;
