//! stub
use nalgebra::Isometry3;
use std::path::Path;
#[derive(Debug, thiserror::Error)]
#[error("x")]
pub struct HandEyeFileError;
#[derive(Clone, Debug)]
pub struct SeenFrom;
impl SeenFrom {
    pub fn base_from_camera(&self) -> Isometry3<f64> {
        Isometry3::identity()
    }
}
pub fn read(_: &Path) -> Result<SeenFrom, HandEyeFileError> {
    Err(HandEyeFileError)
}
