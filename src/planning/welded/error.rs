//! Why a job's weld says nothing. Sentences of it stand in `text`.

use crate::cell::hand_eye::file::HandEyeFileError;
use crate::planning::failure::Failure;
use crate::progress::Cancelled;
use crate::scan::registration::RegistrationError;
use crate::weld::bead::WeldBeadError;
use crate::weld::camera::CameraFault;
use crate::weld::camera_file::CameraFileError;
use crate::weld::image_file::{ImageFault, ImageFileError};
use crate::weld::masking::MaskError;
use crate::weld::passes::PassError;
use std::sync::Arc;
use thiserror::Error;

/// Why a weld says nothing.
#[derive(Clone, Debug, Error)]
pub enum WeldError {
    /// An image cannot be used.
    #[error(transparent)]
    Image(Arc<ImageFileError>),
    /// A file is another one than when the job was saved.
    #[error("{file}: changed")]
    Changed {
        /// The file.
        file: String,
        /// SHA-256 of its bytes now, hexadecimal.
        sha256: String,
    },
    /// The two images do not belong together.
    #[error(transparent)]
    Pair(ImageFault),
    /// The images of now are of another size than those before the first pass.
    #[error("{before:?} before, {now:?} now")]
    OtherSize {
        /// Width and height then, px.
        before: [usize; 2],
        /// Width and height now, px.
        now: [usize; 2],
    },
    /// The camera's file cannot be used.
    #[error(transparent)]
    CameraFile(Arc<CameraFileError>),
    /// The camera is another one's.
    #[error("{file}: {fault}")]
    DepthCamera {
        /// The file.
        file: String,
        /// What does not fit.
        fault: CameraFault,
    },
    /// Where the camera stood cannot be told.
    #[error(transparent)]
    HandEye(Arc<HandEyeFileError>),
    /// There is no mask.
    #[error(transparent)]
    Mask(MaskError),
    /// No area stands out from the skin.
    #[error("no area")]
    NoArea,
    /// The greatest area cannot be measured.
    #[error(transparent)]
    Bead(WeldBeadError),
    /// The bead cannot be ground in passes of this depth.
    #[error(transparent)]
    Passes(PassError),
    /// The skin around the areas is no part.
    #[error("no skin")]
    NoSkin,
    /// The camera's points lie nowhere on the part.
    #[error(transparent)]
    Registration(RegistrationError),
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<WeldError> for Failure<WeldError> {
    fn from(e: WeldError) -> Failure<WeldError> {
        match e {
            WeldError::Cancelled
            | WeldError::Mask(MaskError::Cancelled)
            | WeldError::Registration(RegistrationError::Cancelled) => Failure::Cancelled,
            WeldError::Image(source) if matches!(*source, ImageFileError::Cancelled) => Failure::Cancelled,
            other => Failure::Refused(other),
        }
    }
}

impl From<Cancelled> for WeldError {
    fn from(_: Cancelled) -> WeldError {
        WeldError::Cancelled
    }
}
