//! Where the camera stands, from poses of the robot and what the camera saw of one target in each: A X = X B.
//!
//! The rotation to begin with is Park and Martin's (1994), the place follows from it by least squares; then all poses at
//! once: with G the flange in the base, C the target in the camera, X the camera on the flange and Y the target in the
//! base, log(Y⁻¹·G·X·C) would be nothing in every pose, and Levenberg and Marquardt's steps make it least, turns and
//! shifts each by their noise. That is twice as good as any closed form. A camera that stands fixed with the target on the
//! hand is the same with G⁻¹ for G.
//!
//! No residual shows that poses turned about one axis alone, or hardly: such sets are refused. What they are taken from is
//! [`mod@file`]'s business.

mod error;
pub mod file;
mod refine;
mod start;
mod turns;

use nalgebra::Isometry3;
use serde::{Deserialize, Serialize};
use turns::turn;

pub use error::HandEyeError;

/// Fewer poses are told: ten come within 1.2 mm nine times of ten, five within 2.7, three within 15.
pub const ENOUGH_POSES: usize = 5;
/// Two motions tell a rotation, three poses have them.
const LEAST_POSES: usize = 3;
/// Where the camera is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum CameraPlace {
    /// On the hand; the target lies still.
    Hand,
    /// It stands fixed; the hand holds the target.
    Fixed,
}

/// One pose of the robot, and what the camera saw of the target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandEyePose {
    /// The flange in the robot's base, mm.
    pub base_from_flange: Isometry3<f64>,
    /// The target in the camera's frame, mm.
    pub camera_from_target: Isometry3<f64>,
}

/// A camera that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct HandEye {
    /// Where the camera is.
    pub place: CameraPlace,
    /// The camera in the flange's frame (on the hand) or in the base's (fixed), mm.
    pub mount_from_camera: Isometry3<f64>,
    /// The target in the base's frame (camera on the hand) or in the flange's (camera fixed), mm.
    pub other_from_target: Isometry3<f64>,
    /// What is left over in each pose.
    pub residuals: Vec<PoseResidual>,
}

impl HandEye {
    /// The camera in the base's frame while the flange stands somewhere.
    pub fn base_from_camera(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self.place {
            CameraPlace::Hand => base_from_flange * self.mount_from_camera,
            CameraPlace::Fixed => self.mount_from_camera,
        }
    }

    /// Whether it comes from fewer poses than it should.
    pub fn is_of_few_poses(&self) -> bool {
        self.residuals.len() < ENOUGH_POSES
    }
}

/// How far the target of a pose lies from where it ought to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseResidual {
    /// Distance of the origins, mm.
    pub off_mm: f64,
    /// Angle between the two, degrees.
    pub turned_deg: f64,
}

/// Finds the camera from poses.
///
/// # Errors
/// There are too few poses, or they do not turn enough, or about one axis alone.
pub fn solve(place: CameraPlace, poses: &[HandEyePose]) -> Result<HandEye, HandEyeError> {
    let count = poses.len();
    if count < LEAST_POSES {
        return Err(HandEyeError::FewPoses { count });
    }
    let moved = |p: &HandEyePose| match place {
        CameraPlace::Hand => p.base_from_flange,
        CameraPlace::Fixed => p.base_from_flange.inverse(),
    };
    let pairs: Vec<[Isometry3<f64>; 2]> = poses.iter().map(|p| [moved(p), p.camera_from_target]).collect();
    let motions = start::motions(&pairs);
    start::check_turns(&motions)?;
    let mount_from_camera = start::park_martin(&motions).ok_or(HandEyeError::NoFit)?;
    let solved = refine::refined(&pairs, &mount_from_camera).ok_or(HandEyeError::NoFit)?;
    let residual = |[g, c]: &[Isometry3<f64>; 2]| {
        let off = solved.other_from_target.inverse() * g * solved.mount_from_camera * c;
        let turned = turn(&off.rotation);
        PoseResidual { off_mm: off.translation.vector.norm(), turned_deg: turned.norm().to_degrees() }
    };
    let residuals = pairs.iter().map(residual).collect();
    Ok(HandEye {
        place,
        mount_from_camera: solved.mount_from_camera,
        other_from_target: solved.other_from_target,
        residuals,
    })
}

#[cfg(test)]
mod tests;
