//! A file with the motion that lays a scan on the model: JSON with `model_from_scan`, sixteen numbers row by row, mm.
//! `clearbeam register --json` writes it, and other programs' matrices are soon made one.

use crate::file::{self, FileError};
use nalgebra::{Isometry3, Matrix4, Rotation3, Translation3, UnitQuaternion, Vector3};
use serde::Deserialize;
use std::path::Path;
use thiserror::Error;

/// How far the rows of a rotation may be from unit length and right angles. Matrices of other programs have seven
/// digits (f32) or more; one that was rounded to four has 1e-4, and would lay a point 300 mm away off by 0.03 mm.
const RIGID: f64 = 1e-5;

/// Why a file tells no motion.
#[derive(Debug, Error)]
pub enum TransformError {
    /// It cannot be read, or is no text.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no JSON with `model_from_scan`.
    #[error("{file}: {reason}")]
    Json {
        /// The file.
        file: String,
        /// The line, from 1.
        line: usize,
        /// What the reader says, in English.
        reason: String,
    },
    /// The numbers are no rigid motion.
    #[error("{file}: {fault:?}")]
    Matrix {
        /// The file.
        file: String,
        /// Why.
        fault: MatrixFault,
    },
}

/// Why sixteen numbers are no rigid motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MatrixFault {
    /// One is not finite.
    NotFinite,
    /// The last row is not 0 0 0 1: perhaps the matrix stands column by column.
    LastRow,
    /// It scales, by this factor.
    Scales(f64),
    /// It shears.
    Shears,
    /// It mirrors.
    Mirrors,
}

/// The sixteen numbers of a text, as other programs show a matrix: apart by anything that belongs to no number. `None`: it
/// has another count of numbers.
pub fn numbers(text: &str) -> Option<[f64; 16]> {
    let belongs = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E');
    let words = text.split(|c| !belongs(c)).filter(|w| w.contains(|c: char| c.is_ascii_digit()));
    let all: Vec<f64> = words.map(str::parse).collect::<Result<_, _>>().ok()?;
    all.try_into().ok()
}

#[derive(Deserialize)]
struct TransformText {
    model_from_scan: [f64; 16],
}

/// Reads the motion of a file.
///
/// # Errors
/// There is none in it.
pub fn read(path: &Path) -> Result<Isometry3<f64>, TransformError> {
    let name = path.display().to_string();
    let bytes = file::bytes(path)?;
    let parsed: Result<TransformText, _> = serde_json::from_str(file::text(&bytes, &name)?);
    let text =
        parsed.map_err(|e| TransformError::Json { file: name.clone(), line: e.line(), reason: e.to_string() })?;
    rigid(&text.model_from_scan).map_err(|fault| TransformError::Matrix { file: name, fault })
}

/// The motion of a matrix, row by row, mm.
///
/// # Errors
/// It is no rigid one.
pub fn rigid(rows: &[f64; 16]) -> Result<Isometry3<f64>, MatrixFault> {
    if !rows.iter().all(|x| x.is_finite()) {
        return Err(MatrixFault::NotFinite);
    }
    let matrix = Matrix4::from_row_slice(rows);
    if (matrix.row(3) - Matrix4::identity().row(3)).amax() > RIGID {
        return Err(MatrixFault::LastRow);
    }
    let turn = matrix.fixed_view::<3, 3>(0, 0).into_owned();
    let scale = turn.norm() / f64::sqrt(3.0);
    let skew = (turn.transpose() * turn) / (scale * scale).max(1e-300) - nalgebra::Matrix3::identity();
    if skew.amax() > 2.0 * RIGID {
        return Err(MatrixFault::Shears);
    }
    if (scale - 1.0).abs() > RIGID {
        return Err(MatrixFault::Scales(scale));
    }
    if turn.determinant() < 0.0 {
        return Err(MatrixFault::Mirrors);
    }
    let mut rotation = Rotation3::from_matrix_unchecked(turn);
    rotation.renormalize();
    let shift = Translation3::from(Vector3::new(matrix[(0, 3)], matrix[(1, 3)], matrix[(2, 3)]));
    Ok(Isometry3::from_parts(shift, UnitQuaternion::from_rotation_matrix(&rotation)))
}

/// The matrix of a motion, row by row.
pub fn rows(motion: &Isometry3<f64>) -> [f64; 16] {
    let matrix = motion.to_homogeneous();
    std::array::from_fn(|k| matrix[(k / 4, k % 4)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_motion_is_found_again_in_its_rows() {
        let motion = Isometry3::new(Vector3::new(1.0, -2.0, 300.0), Vector3::new(0.3, -1.2, 0.7));
        let back = rigid(&rows(&motion)).expect("rigid");
        assert!((back.to_homogeneous() - motion.to_homogeneous()).amax() < 1e-12);
        let coarse = rows(&motion).map(|x| f64::from(x as f32));
        assert!((rigid(&coarse).expect("rigid").to_homogeneous() - motion.to_homogeneous()).amax() < 1e-4);
    }

    #[test]
    fn a_matrix_is_taken_as_other_programs_show_it() {
        let shown = "1.0 0.0  -0.5e1 3\n0,1,0,4;\n[0 0 1 5]\n0 0 0 1";
        assert_eq!(numbers(shown).map(|n| [n[2], n[3], n[7], n[11]]), Some([-5.0, 3.0, 4.0, 5.0]));
        for text in ["", "1 0 0", "e e e", &"1 ".repeat(17), "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1.2.3"] {
            assert_eq!(numbers(text), None, "{text}");
        }
    }

    #[test]
    fn what_is_no_motion_is_told_by_what_it_does() {
        let with = |change: &[(usize, f64)]| {
            let mut rows = rows(&Isometry3::identity());
            change.iter().for_each(|&(k, x)| rows[k] = x);
            rigid(&rows).expect_err("no motion")
        };
        assert_eq!(with(&[(3, f64::NAN)]), MatrixFault::NotFinite);
        assert_eq!(with(&[(12, 5.0)]), MatrixFault::LastRow);
        assert_eq!(with(&[(1, 0.1)]), MatrixFault::Shears);
        assert_eq!(with(&[(0, -1.0)]), MatrixFault::Mirrors);
        assert!(matches!(with(&[(0, 25.4), (5, 25.4), (10, 25.4)]), MatrixFault::Scales(s) if (s - 25.4).abs() < 1e-9));
    }
}
