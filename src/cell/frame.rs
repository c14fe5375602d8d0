//! A frame of the cell file: figures, or the measurements that they are fitted to.
//!
//! What the operator wrote is kept and written back.

use super::calibration::{self, CalibrationNote, Fit, FitError, PointPair, ThreePoints};
use crate::part::{Hasher, Keyed, rpy};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A frame in another frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "FrameText", into = "FrameText")]
pub struct Frame {
    /// Origin, mm.
    pub position_mm: [f64; 3],
    /// Rotation about Z, Y and X, degrees.
    pub rz_ry_rx_deg: [f64; 3],
    /// What the figures were fitted to; it counts while they are still those of its fit.
    measured: Option<Measured>,
}

impl Keyed for Frame {
    fn feed(&self, into: &mut Hasher) {
        // The figures are those of the fit: the measurements behind them move nothing.
        let Frame { position_mm, rz_ry_rx_deg, measured: _ } = self;
        position_mm.feed(into);
        rz_ry_rx_deg.feed(into);
    }
}

/// The measurements of a frame.
#[derive(Clone, Debug, PartialEq)]
enum Measured {
    ThreePoints(ThreePoints),
    Points(Vec<PointPair>),
    /// The tip's place is fitted, the tool's orientation is the operator's.
    TipPoses(Vec<[f64; 6]>, [f64; 3]),
}

/// A frame of a file that cannot be told from what stands there.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{frame}: {fault}")]
pub struct FrameError {
    /// The frame's key.
    pub frame: &'static str,
    /// Why.
    pub fault: FrameFault,
}

/// Why a frame cannot be told from what a file has of it.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FrameFault {
    /// Neither figures nor one kind of measurements, or both.
    #[error("not figures, three_points, points or tip_poses alone")]
    Keys,
    /// A figure is out of its range.
    #[error("{key}: {value} is not from −{most} to {most}")]
    Range {
        /// Its key in the frame.
        key: &'static str,
        /// What stands there.
        value: f64,
        /// Its greatest value, to either side.
        most: f64,
    },
    /// The measurements tell no frame.
    #[error(transparent)]
    Fit(#[from] FitError),
}

/// A frame as it stands in a file.
#[derive(Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct FrameText {
    #[serde(skip_serializing_if = "Option::is_none")]
    position_mm: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rz_ry_rx_deg: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    three_points: Option<ThreePoints>,
    #[serde(skip_serializing_if = "Option::is_none")]
    points: Option<Vec<PointPair>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_poses: Option<Vec<[f64; 6]>>,
}

/// An origin lies no further than this from its base, mm: a hundred metres hold the longest track.
pub const FARTHEST_ORIGIN_MM: f64 = 100_000.0;

/// What is placed, a frame, a part or a clamp, is turned ten times round at most, to either side, degrees: of far more the turn within 360° is lost in its digits.
pub const MOST_TURNS_DEG: f64 = 3600.0;

/// Keys of the frames of a cell, and of a job's own.
pub const KEYS: [&str; 4] = ["base_from_laser", "flange_from_part", "base_from_part", "flange_from_tool"];

/// Keys of the frame of a scanner, in the scan of a job.
pub const OF_SCANNER: [&str; 2] = ["base_from_scan", "flange_from_scan"];

impl Frame {
    /// The frame of these figures: mm, and degrees about Z, Y and X.
    pub fn new(position_mm: [f64; 3], rz_ry_rx_deg: [f64; 3]) -> Frame {
        Frame { position_mm, rz_ry_rx_deg, measured: None }
    }

    /// The frame that these pairs tell, three at least; they stay with it.
    ///
    /// # Errors
    /// They tell none.
    pub fn of_points(pairs: Vec<PointPair>) -> Result<Frame, FitError> {
        Measured::Points(pairs).frame()
    }

    /// The pairs that it was fitted to; `None`: it comes from something else.
    pub fn points(&self) -> Option<&[PointPair]> {
        match self.fitted_to()? {
            Measured::Points(pairs) => Some(pairs),
            Measured::ThreePoints(_) | Measured::TipPoses(..) => None,
        }
    }

    /// The frame of a transformation.
    pub fn of(motion: &Isometry3<f64>) -> Frame {
        let rotation = motion.rotation.to_rotation_matrix();
        Frame::new(motion.translation.vector.into(), rpy::from_rotation(&rotation))
    }

    /// As a transformation.
    pub fn isometry(&self) -> Isometry3<f64> {
        let rotation = UnitQuaternion::from_rotation_matrix(&rpy::to_rotation(self.rz_ry_rx_deg));
        Isometry3::from_parts(Translation3::from(Vector3::from(self.position_mm)), rotation)
    }

    /// How well it fits what was measured; `None`: it is given by figures.
    pub fn calibration(&self, name: &'static str) -> Option<CalibrationNote> {
        let measured = self.fitted_to()?;
        Some(CalibrationNote::new(name, measured.method(), measured.fit().ok()?.residuals_mm))
    }

    /// Whether it was fitted to poses that touch with the tip of a tool.
    pub fn is_of_a_tip(&self) -> bool {
        matches!(self.measured, Some(Measured::TipPoses(..)))
    }

    /// The measurements, unless the figures were changed since.
    fn fitted_to(&self) -> Option<&Measured> {
        let same = |f: &Frame| f.position_mm == self.position_mm && f.rz_ry_rx_deg == self.rz_ry_rx_deg;
        self.measured.as_ref().filter(|m| m.frame().is_ok_and(|f| same(&f)))
    }
}

impl Measured {
    fn method(&self) -> &'static str {
        match self {
            Measured::ThreePoints(_) => "three_points",
            Measured::Points(_) => "points",
            Measured::TipPoses(..) => "tip_poses",
        }
    }

    fn fit(&self) -> Result<Fit, FitError> {
        match self {
            Measured::ThreePoints(t) => calibration::three_points(t),
            Measured::Points(pairs) => calibration::best_fit(pairs),
            Measured::TipPoses(poses, turned) => {
                let tip = calibration::tool_tip(poses)?;
                let frame = Frame::new(tip.flange_from_tip.into(), *turned).isometry();
                Ok(Fit { frame, residuals_mm: tip.residuals_mm })
            }
        }
    }

    fn frame(&self) -> Result<Frame, FitError> {
        let Fit { frame, .. } = self.fit()?;
        let rz_ry_rx_deg = match self {
            Measured::TipPoses(_, turned) => *turned,
            _ => rpy::from_rotation(&frame.rotation.to_rotation_matrix()),
        };
        Ok(Frame { measured: Some(self.clone()), ..Frame::new(frame.translation.vector.into(), rz_ry_rx_deg) })
    }
}

impl TryFrom<FrameText> for Frame {
    type Error = FrameFault;

    fn try_from(text: FrameText) -> Result<Frame, FrameFault> {
        let FrameText { position_mm, rz_ry_rx_deg, three_points, points, tip_poses } = text;
        match (position_mm, rz_ry_rx_deg, three_points, points, tip_poses) {
            (Some(position_mm), Some(turned), None, None, None) => {
                within("position_mm", &position_mm, FARTHEST_ORIGIN_MM)?;
                within("rz_ry_rx_deg", &turned, MOST_TURNS_DEG)?;
                Ok(Frame::new(position_mm, turned))
            }
            (None, None, Some(three), None, None) => Ok(Measured::ThreePoints(three).frame()?),
            (None, None, None, Some(points), None) => Ok(Measured::Points(points).frame()?),
            (None, Some(turned), None, None, Some(poses)) => {
                within("rz_ry_rx_deg", &turned, MOST_TURNS_DEG)?;
                Ok(Measured::TipPoses(poses, turned).frame()?)
            }
            _ => Err(FrameFault::Keys),
        }
    }
}

fn within(key: &'static str, figures: &[f64; 3], most: f64) -> Result<(), FrameFault> {
    match figures.iter().find(|x| !(-most..=most).contains(*x)) {
        Some(&value) => Err(FrameFault::Range { key, value, most }),
        None => Ok(()),
    }
}

/// Looks at the frames of a table, before its file is read as a whole. What is no table of a frame at all is left to
/// that reader, which knows the line.
///
/// # Errors
/// The first frame that cannot be told from what stands there.
pub fn check(table: &toml::Table) -> Result<(), FrameError> {
    for frame in KEYS.into_iter().chain(OF_SCANNER) {
        let text = table.get(frame).and_then(|value| value.clone().try_into::<FrameText>().ok());
        text.map_or(Ok(()), |text| Frame::try_from(text).map(drop)).map_err(|fault| FrameError { frame, fault })?;
    }
    Ok(())
}

impl From<Frame> for FrameText {
    fn from(frame: Frame) -> FrameText {
        let turned = Some(frame.rz_ry_rx_deg);
        match frame.fitted_to().cloned() {
            None => FrameText { position_mm: Some(frame.position_mm), rz_ry_rx_deg: turned, ..FrameText::default() },
            Some(Measured::ThreePoints(t)) => FrameText { three_points: Some(t), ..FrameText::default() },
            Some(Measured::Points(p)) => FrameText { points: Some(p), ..FrameText::default() },
            Some(Measured::TipPoses(p, _)) => {
                FrameText { tip_poses: Some(p), rz_ry_rx_deg: turned, ..FrameText::default() }
            }
        }
    }
}
