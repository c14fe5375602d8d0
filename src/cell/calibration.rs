//! Frames from what was measured: three points, one tip touched in several poses, points of a model.
//!
//! Each fit keeps its residuals, and refuses points that cannot tell the frame, with what is wrong with them. Where the
//! figures come from and what frame they become is the cell file's business.

use crate::fit::{self, PlacedPair};
use crate::part::rpy;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, SymmetricEigen, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Points nearer than this to each other, or to a line, tell no direction, mm.
const APART_MM: f64 = 5.0;

/// The rotations must move every direction of the tool by this share of its length at least (root
/// of the mean square); two poses that differ by 8° do.
const LEAST_TURN: f64 = 0.07;

/// Three points of a work frame, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ThreePoints {
    /// The frame's origin.
    pub origin: [f64; 3],
    /// A point on its positive x axis.
    pub x: [f64; 3],
    /// A point in its xy plane, on the side of positive y.
    pub xy: [f64; 3],
}

/// A point of a model, and where it was measured, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PointPair {
    /// The point in the frame that is sought, mm.
    pub model: [f64; 3],
    /// In the frame that it is sought in.
    pub measured: [f64; 3],
}

/// A fitted frame and how well it fits.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The frame.
    pub frame: Isometry3<f64>,
    /// Distance of each measurement from what the frame makes of it, mm; empty where nothing is left over.
    pub residuals_mm: Vec<f64>,
}

/// The tip of a tool and how well it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct TipFit {
    /// On the flange, mm.
    pub flange_from_tip: Vector3<f64>,
    /// What it touched, in the base, mm.
    pub base_from_tip: Point3<f64>,
    /// Distance of the tip from there in each pose, mm.
    pub residuals_mm: Vec<f64>,
}

/// How well a frame fits what was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct CalibrationNote {
    /// The frame's key in the cell file.
    pub frame: &'static str,
    /// The key of what it was measured by.
    pub method: &'static str,
    /// Root of the mean square of the residuals, mm; 0 where nothing is left over.
    pub rms_mm: f64,
    /// The largest residual, mm.
    pub worst_mm: f64,
    /// The residual of each measurement, in the order of the file, mm.
    pub residuals_mm: Vec<f64>,
}

impl CalibrationNote {
    /// The note of a fit with these residuals.
    pub fn new(frame: &'static str, method: &'static str, residuals_mm: Vec<f64>) -> CalibrationNote {
        let squares = residuals_mm.iter().fold(0.0, |s, r| s + r * r);
        let rms_mm = (squares / residuals_mm.len().max(1) as f64).sqrt();
        let worst_mm = residuals_mm.iter().copied().fold(0.0, f64::max);
        CalibrationNote { frame, method, rms_mm, worst_mm, residuals_mm }
    }
}

/// Why measurements tell no frame.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FitError {
    /// A figure that nobody can have measured.
    #[error("{value} measured")]
    Figure {
        /// The figure.
        value: f64,
    },
    /// Three points: x lies too near to the origin.
    #[error("three_points: x {off_mm} mm from origin")]
    XNearOrigin {
        /// Distance of the two.
        off_mm: f64,
    },
    /// Three points: xy lies too near to the x axis.
    #[error("three_points: xy {off_mm} mm off the x axis")]
    XyNearAxis {
        /// Distance from the axis.
        off_mm: f64,
    },
    /// Too few poses touch with the tip.
    #[error("tip_poses: {count} poses")]
    FewPoses {
        /// How many there are.
        count: usize,
    },
    /// The poses hardly turn the flange but about one direction of its own.
    #[error("tip_poses: turned about {direction:?} only")]
    OneDirection {
        /// The direction in the flange, of unit length.
        direction: [f64; 3],
    },
    /// No tip fits the poses.
    #[error("tip_poses: no tip")]
    NoTip,
    /// Too few points of a model.
    #[error("points: {count} pairs")]
    FewPairs {
        /// How many there are.
        count: usize,
    },
    /// All points lie on one line.
    #[error("points: {side:?} on one line within {width_mm} mm")]
    OneLine {
        /// The points that do.
        side: CalibrationSide,
        /// How far off the line they are.
        width_mm: f64,
    },
    /// No frame fits the points.
    #[error("points: no frame")]
    NoFrame,
}

/// A side of pairs of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CalibrationSide {
    /// Points of the model.
    Model,
    /// Measured ones.
    Measured,
}

/// The frame of three points.
///
/// # Errors
/// Two points are too near to each other, or all three on one line.
pub fn three_points(t: &ThreePoints) -> Result<Fit, FitError> {
    finite(t.origin.iter().chain(&t.x).chain(&t.xy))?;
    let [origin, x, xy] = [t.origin, t.x, t.xy].map(Vector3::from);
    let (along, aside) = (x - origin, xy - origin);
    if along.norm() < APART_MM {
        return Err(FitError::XNearOrigin { off_mm: along.norm() });
    }
    let x_axis = along.normalize();
    let aside = aside - x_axis * x_axis.dot(&aside);
    if aside.norm() < APART_MM {
        return Err(FitError::XyNearAxis { off_mm: aside.norm() });
    }
    let y_axis = aside.normalize();
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x_axis, y_axis, x_axis.cross(&y_axis)]));
    let frame = Isometry3::from_parts(Translation3::from(origin), UnitQuaternion::from_rotation_matrix(&rotation));
    Ok(Fit { frame, residuals_mm: Vec::new() })
}

/// The tip of a tool that touched one fixed point in every pose of the flange: X, Y, Z mm, then
/// rotation about Z, Y and X in degrees.
///
/// # Errors
/// There are fewer than four poses, or they do not turn enough.
pub fn tool_tip(base_from_flange: &[[f64; 6]]) -> Result<TipFit, FitError> {
    finite(base_from_flange.iter().flatten())?;
    let count = base_from_flange.len();
    if count < 4 {
        return Err(FitError::FewPoses { count });
    }
    let poses: Vec<(Matrix3<f64>, Vector3<f64>)> = base_from_flange
        .iter()
        .map(|&[x, y, z, rz, ry, rx]| (rpy::to_rotation([rz, ry, rx]).into_inner(), Vector3::new(x, y, z)))
        .collect();
    let share = 1.0 / count as f64;
    let (turn, at) = poses.iter().fold((Matrix3::zeros(), Vector3::zeros()), |m, p| (m.0 + p.0, m.1 + p.1));
    let (turn, at) = (turn * share, at * share);
    // R·t + p is the same point c in every pose: (R − mean R)·t = mean p − p.
    let (mut square, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (r, p) in &poses {
        let d = r - turn;
        square += d.transpose() * d * share;
        right += d.transpose() * (at - p) * share;
    }
    let eigen = SymmetricEigen::new(square);
    let weakest = eigen.eigenvalues.imin();
    if eigen.eigenvalues[weakest] < LEAST_TURN * LEAST_TURN {
        let v = eigen.eigenvectors.column(weakest).map(|x| if x.abs() < 5e-3 { 0.0 } else { x });
        return Err(FitError::OneDirection { direction: [v[0], v[1], v[2]] });
    }
    let solved = square.cholesky().ok_or(FitError::NoTip)?;
    let mut tip = solved.solve(&right);
    // Squaring costs half of the digits; this step brings them back.
    let left = poses.iter().fold(Vector3::zeros(), |s: Vector3<f64>, (r, p)| {
        let d = r - turn;
        s + d.transpose() * (at - p - d * tip) * share
    });
    tip += solved.solve(&left);
    let touched = turn * tip + at;
    let residuals_mm = poses.iter().map(|(r, p)| (r * tip + p - touched).norm()).collect();
    Ok(TipFit { flange_from_tip: tip, base_from_tip: Point3::from(touched), residuals_mm })
}

/// The frame that brings points of a model nearest to where they were measured, without a mirror.
///
/// # Errors
/// There are fewer than three points, or they lie on one line.
pub fn best_fit(pairs: &[PointPair]) -> Result<Fit, FitError> {
    finite(pairs.iter().flat_map(|p| p.model.iter().chain(&p.measured)))?;
    if pairs.len() < 3 {
        return Err(FitError::FewPairs { count: pairs.len() });
    }
    let share = 1.0 / pairs.len() as f64;
    let middle = |of: fn(&PointPair) -> [f64; 3]| {
        pairs.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + Vector3::from(of(p))) * share
    };
    let (model, measured) = (middle(|p| p.model), middle(|p| p.measured));
    let from_middle = |p: &PointPair| (Vector3::from(p.model) - model, Vector3::from(p.measured) - measured);
    let mut spreads = [Matrix3::zeros(); 2];
    for (m, d) in pairs.iter().map(from_middle) {
        spreads[0] += m * m.transpose() * share;
        spreads[1] += d * d.transpose() * share;
    }
    for (spread, side) in spreads.into_iter().zip([CalibrationSide::Model, CalibrationSide::Measured]) {
        let mut widths = SymmetricEigen::new(spread).eigenvalues.map(|v| v.max(0.0).sqrt());
        widths.as_mut_slice().sort_by(f64::total_cmp);
        if widths[1] < APART_MM.min(0.01 * widths[2]).max(0.5) {
            return Err(FitError::OneLine { side, width_mm: widths[1] });
        }
    }
    let places: Vec<PlacedPair> = pairs
        .iter()
        .map(|p| PlacedPair { from: Point3::from(p.model), onto: Point3::from(p.measured), weight: 1.0 })
        .collect();
    let frame = fit::rigid(&places).ok_or(FitError::NoFrame)?;
    let off = |p: &PointPair| (frame * Point3::from(p.model) - Point3::from(p.measured)).norm();
    Ok(Fit { frame, residuals_mm: pairs.iter().map(off).collect() })
}

fn finite<'a>(mut numbers: impl Iterator<Item = &'a f64>) -> Result<(), FitError> {
    match numbers.find(|x| !(-1e6..=1e6).contains(*x)) {
        Some(&value) => Err(FitError::Figure { value }),
        None => Ok(()),
    }
}

#[cfg(test)]
#[path = "calibration_tests.rs"]
mod tests;
