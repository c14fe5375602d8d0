//! How far the part as it is lies off the model.

pub mod depth_field;

pub use depth_field::DepthField;
