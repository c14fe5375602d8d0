//! Weld beads and ground areas in the images of a depth camera (P4, 3 and 4): from a grey image and a depth image to the
//! pixels of the defect and to their points.
//!
//! [`image_file`] reads both images, [`camera_file`] the [`DepthCamera`] they were taken with; [`masking`] finds the bright
//! areas of the grey image, step by step; [`points()`] carries the pixels of a mask into space. All points are in the
//! *camera frame*: mm, x right, y down, z forwards, the origin in the pinhole. Pixels are counted from 0, u to the right
//! and v down; a pixel's middle has whole numbers. What stands on a robot's flange or on the part is for other rooms.

pub mod area_samples;
pub mod bead;
pub mod camera;
pub mod camera_file;
mod cubic_fit;
pub mod depth_mesh;
pub mod image_file;
pub mod masking;
pub mod outline_distance;
pub mod parent;
pub mod passes;
pub mod pixel_distance;
pub mod points;
pub mod raster;
pub mod skin;

pub use camera::DepthCamera;
pub use masking::{MaskError, MaskRules, MaskedImage, masked};
pub use points::{PixelPoint, points};
pub use raster::{DepthImage, GreyImage, Mask, Raster};
