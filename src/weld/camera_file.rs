//! A camera's figures in a file: TOML with the keys `fx fy cx cy s k1 k2 p1 p2 k3 width height`, or the intrinsics that
//! Open3D writes as JSON. Which of them is told by the first sign, not by the name.
//!
//! Open3D's file has no depth scale; its routines take 1000 units for a metre unless told otherwise, so s is 1.

use super::camera::{CameraFault, DepthCamera};
use crate::file::{self, FileError, Step, line_of};
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;

/// Why a file tells no camera.
#[derive(Debug, Error)]
pub enum CameraFileError {
    /// It cannot be read, is no text, or no TOML with these keys.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no JSON as Open3D writes it.
    #[error("{file}: line {line}: {reason}")]
    Json {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// What the reader says, in English.
        reason: String,
    },
    /// The matrix is none of a camera, column by column.
    #[error("{file}: {fault:?}")]
    Matrix {
        /// The file.
        file: String,
        /// Why.
        fault: IntrinsicMatrixFault,
    },
    /// A figure cannot be right.
    #[error("{file}: line {line:?}: {fault}")]
    Figure {
        /// The file.
        file: String,
        /// The line, from 1; `None` in JSON.
        line: Option<usize>,
        /// Which, and what it is.
        fault: CameraFault,
    },
}

/// Why nine numbers are no camera's matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IntrinsicMatrixFault {
    /// It stands row by row; Open3D writes it column by column.
    RowByRow,
    /// Its axes are not square to each other, or its last row is not 0 0 1.
    NotPinhole,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraToml {
    width: Option<usize>,
    height: Option<usize>,
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
    #[serde(default = "one")]
    s: f64,
    #[serde(default)]
    k1: f64,
    #[serde(default)]
    k2: f64,
    #[serde(default)]
    p1: f64,
    #[serde(default)]
    p2: f64,
    #[serde(default)]
    k3: f64,
}

fn one() -> f64 {
    1.0
}

#[derive(Deserialize)]
struct Open3dIntrinsics {
    width: usize,
    height: usize,
    intrinsic_matrix: [f64; 9],
}

/// Reads a camera file.
///
/// # Errors
/// It tells no camera.
pub fn read(path: &Path) -> Result<DepthCamera, CameraFileError> {
    from_bytes(&file::bytes(path)?, &path.display().to_string())
}

/// The camera of a file's bytes; `name` is what the file is called.
///
/// # Errors
/// They tell no camera.
pub fn from_bytes(bytes: &[u8], name: &str) -> Result<DepthCamera, CameraFileError> {
    let text = file::text(bytes, name)?;
    let is_json = text.trim_start().starts_with('{');
    let camera = if is_json { of_open3d(text, name)? } else { of_toml(text, name)? };
    camera.check().map_err(|fault| {
        let key = if let CameraFault::Figure { key, .. } = fault { key } else { "" };
        let line = if is_json { None } else { line_of(text, &[Step::Key(key)]) };
        CameraFileError::Figure { file: name.to_owned(), line, fault }
    })?;
    Ok(camera)
}

fn of_toml(text: &str, name: &str) -> Result<DepthCamera, FileError> {
    let CameraToml { width, height, fx, fy, cx, cy, s, k1, k2, p1, p2, k3 } = file::toml(text, name)?;
    Ok(DepthCamera { width, height, fx, fy, cx, cy, units_per_mm: s, k1, k2, p1, p2, k3 })
}

fn of_open3d(text: &str, name: &str) -> Result<DepthCamera, CameraFileError> {
    let read: Open3dIntrinsics = serde_json::from_str(text).map_err(|e| CameraFileError::Json {
        file: name.to_owned(),
        line: e.line(),
        reason: e.to_string(),
    })?;
    let [fx, skew_v, w0, skew_u, fy, w1, cx, cy, w2] = read.intrinsic_matrix;
    let fault = match [skew_v, w0, skew_u, w1, w2 - 1.0].iter().all(|x| *x == 0.0) {
        true => None,
        false if [skew_v, skew_u, cx, cy, w2 - 1.0].iter().all(|x| *x == 0.0) => Some(IntrinsicMatrixFault::RowByRow),
        false => Some(IntrinsicMatrixFault::NotPinhole),
    };
    if let Some(fault) = fault {
        return Err(CameraFileError::Matrix { file: name.to_owned(), fault });
    }
    Ok(DepthCamera { width: Some(read.width), height: Some(read.height), ..DepthCamera::pinhole(fx, fy, cx, cy) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::TomlFault;

    fn refused(text: &str) -> CameraFileError {
        from_bytes(text.as_bytes(), "camera.toml").expect_err(text)
    }

    #[test]
    fn toml_has_defaults_for_scale_and_distortion() {
        let text = "fx = 600\nfy = 601.5\ncx = 320\ncy = 240\n";
        let camera = from_bytes(text.as_bytes(), "camera.toml").expect("a camera");
        assert_eq!(camera, DepthCamera::pinhole(600.0, 601.5, 320.0, 240.0));
        let more =
            format!("{text}s = 10\nk1 = -0.1\nk2 = 0.2\np1 = 0.3\np2 = 0.4\nk3 = 0.5\nwidth = 640\nheight = 480\n");
        let camera = from_bytes(more.as_bytes(), "camera.toml").expect("a camera");
        let figures = camera.figures().map(|f| f.1);
        assert_eq!(figures, [600.0, 601.5, 320.0, 240.0, 10.0, -0.1, 0.2, 0.3, 0.4, 0.5]);
        assert_eq!((camera.width, camera.height), (Some(640), Some(480)));
    }

    #[test]
    fn wrong_toml_is_refused_with_its_line() {
        let unknown = refused("fx = 600\nfy = 600\ncx = 1\ncy = 1\nk4 = 0\n");
        let CameraFileError::File(FileError::Toml { source, .. }) = unknown else { panic!("{unknown}") };
        assert!(source.line == 5 && matches!(source.fault, TomlFault::UnknownKey { .. }), "{source}");
        let zero = refused("fx = 600\nfy = 600\ncx = 1\ncy = 1\n\ns = 0\n");
        assert!(matches!(
            zero,
            CameraFileError::Figure { line: Some(6), fault: CameraFault::Figure { key: "s", .. }, .. }
        ));
        assert!(matches!(refused("fx = 600\n"), CameraFileError::File(_)));
        assert!(matches!(refused("fx = nan\nfy = 1\ncx = 1\ncy = 1\n"), CameraFileError::File(_)));
    }

    #[test]
    fn open3d_writes_column_by_column() {
        let json = |m: &str| format!("{{\"width\": 640, \"height\": 480, \"intrinsic_matrix\": [{m}]}}");
        let camera = from_bytes(json("525,0,0,0,526,0,319.5,239.5,1").as_bytes(), "c.json").expect("a camera");
        let expected =
            DepthCamera { width: Some(640), height: Some(480), ..DepthCamera::pinhole(525.0, 526.0, 319.5, 239.5) };
        assert_eq!(camera, expected);
        let fault = |m: &str| match refused(&json(m)) {
            CameraFileError::Matrix { fault, .. } => Some(fault),
            _ => None,
        };
        assert_eq!(fault("525,0,319.5,0,525,239.5,0,0,1"), Some(IntrinsicMatrixFault::RowByRow));
        assert_eq!(fault("525,0,0,1,525,0,319.5,239.5,1"), Some(IntrinsicMatrixFault::NotPinhole));
        assert!(matches!(refused(&json("525,0")), CameraFileError::Json { line: 1, .. }));
        assert!(matches!(refused(&json("-5,0,0,0,5,0,3,2,1")), CameraFileError::Figure { line: None, .. }));
    }
}
