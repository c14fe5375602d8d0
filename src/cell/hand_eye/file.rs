//! The file of a camera: TOML with the poses of its calibration, or with what came of one elsewhere.
//!
//! Sixteen numbers are a matrix row by row, mm. With poses:
//!
//! ```toml
//! camera = "hand"                    # or "fixed"
//! base_from_flange = [...]           # where the images were taken; not needed with "fixed"
//! [[pose]]
//! base_from_flange = [...]
//! camera_from_target = [...]
//! ```
//!
//! With a result: `flange_from_camera` and `base_from_flange`, or `base_from_camera` alone.

use super::{CameraPlace, HandEye, HandEyeError, HandEyePose, solve};
use crate::file::{self, FileError};
use crate::scan::transform_file::{MatrixFault, rigid};
use nalgebra::Isometry3;
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;

/// A camera of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraStand {
    /// The camera in the robot's base while the images were taken, mm; `None`: it is on the hand, and the file does not
    /// say where that was.
    pub base_from_camera: Option<Isometry3<f64>>,
    /// What it was found from; `None`: the file states it.
    pub calibration: Option<HandEye>,
}

/// Why a file tells no camera.
#[derive(Debug, Error)]
pub enum HandEyeFileError {
    /// It cannot be read, or is no TOML of these keys.
    #[error(transparent)]
    File(#[from] FileError),
    /// Neither poses nor one result, or both.
    #[error("{file}: not pose with camera, flange_from_camera or base_from_camera alone")]
    Keys {
        /// The file.
        file: String,
    },
    /// A result on the hand, and not where the hand was.
    #[error("{file}: flange_from_camera without base_from_flange")]
    NoFlange {
        /// The file.
        file: String,
    },
    /// A matrix has not sixteen numbers.
    #[error("{file}: {key}: {count} numbers")]
    Count {
        /// The file.
        file: String,
        /// The key of the matrix.
        key: &'static str,
        /// The pose it belongs to, from 1; `None`: to none.
        pose: Option<usize>,
        /// How many it has.
        count: usize,
    },
    /// Numbers that are no rigid motion.
    #[error("{file}: {key}: {fault:?}")]
    Matrix {
        /// The file.
        file: String,
        /// The key of the matrix.
        key: &'static str,
        /// The pose it belongs to, from 1; `None`: to none.
        pose: Option<usize>,
        /// Why.
        fault: MatrixFault,
    },
    /// The poses tell no camera.
    #[error("{file}: {source}")]
    Poses {
        /// The file.
        file: String,
        /// Why.
        source: HandEyeError,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StandText {
    camera: Option<CameraPlace>,
    #[serde(default)]
    pose: Vec<PoseText>,
    flange_from_camera: Option<Vec<f64>>,
    base_from_camera: Option<Vec<f64>>,
    base_from_flange: Option<Vec<f64>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PoseText {
    base_from_flange: Vec<f64>,
    camera_from_target: Vec<f64>,
}

/// Reads a file.
///
/// # Errors
/// It tells no camera.
pub fn read(path: &Path) -> Result<CameraStand, HandEyeFileError> {
    let name = path.display().to_string();
    let bytes = file::bytes(path)?;
    parse(file::text(&bytes, &name)?, &name)
}

/// Reads a text; `file` is what its file is called.
///
/// # Errors
/// It tells no camera.
pub fn parse(text: &str, file: &str) -> Result<CameraStand, HandEyeFileError> {
    let StandText { camera, pose, flange_from_camera, base_from_camera, base_from_flange } = file::toml(text, file)?;
    let named = || file.to_owned();
    // As lists: TOML's reader takes the first sixteen of more numbers.
    let matrix = |rows: &[f64], key: &'static str, pose: Option<usize>| {
        let sixteen = <&[f64; 16]>::try_from(rows);
        let rows = sixteen.map_err(|_| HandEyeFileError::Count { file: named(), key, pose, count: rows.len() })?;
        rigid(rows).map_err(|fault| HandEyeFileError::Matrix { file: named(), key, pose, fault })
    };
    let flange = base_from_flange.map(|rows| matrix(&rows, "base_from_flange", None)).transpose()?;
    match (camera, flange_from_camera, base_from_camera) {
        (Some(place), None, None) if !pose.is_empty() => {
            let mut poses = Vec::with_capacity(pose.len());
            for (k, p) in pose.iter().enumerate() {
                poses.push(HandEyePose {
                    base_from_flange: matrix(&p.base_from_flange, "base_from_flange", Some(k + 1))?,
                    camera_from_target: matrix(&p.camera_from_target, "camera_from_target", Some(k + 1))?,
                });
            }
            let found = solve(place, &poses).map_err(|source| HandEyeFileError::Poses { file: named(), source })?;
            let base_from_camera = match place {
                CameraPlace::Hand => flange.map(|f| found.base_from_camera(&f)),
                CameraPlace::Fixed => Some(found.mount_from_camera),
            };
            Ok(CameraStand { base_from_camera, calibration: Some(found) })
        }
        (None | Some(CameraPlace::Hand), Some(rows), None) if pose.is_empty() => {
            let camera = matrix(&rows, "flange_from_camera", None)?;
            let flange = flange.ok_or_else(|| HandEyeFileError::NoFlange { file: named() })?;
            Ok(CameraStand { base_from_camera: Some(flange * camera), calibration: None })
        }
        (None | Some(CameraPlace::Fixed), None, Some(rows)) if pose.is_empty() && flange.is_none() => {
            let camera = matrix(&rows, "base_from_camera", None)?;
            Ok(CameraStand { base_from_camera: Some(camera), calibration: None })
        }
        _ => Err(HandEyeFileError::Keys { file: named() }),
    }
}
