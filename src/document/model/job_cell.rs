//! The `[cell]` table of a job: the robot cell, and what the job says of it in place of the cell's file.

use super::declare::parameters;
use crate::cell::{Cell, Frame, Mount, Spin};
use serde::{Deserialize, Serialize};

parameters! {
    /// The robot cell of a job: its files, and what stands otherwise than they say.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct JobCell in "cell" {
        /// Cell file, relative to the job file; empty: the shipped cell of the robot.
        pub file: String = String::new(),
        /// Key of a shipped robot, or a robot file relative to the job file; empty: poses only.
        pub robot: String = String::new(),
        /// What the robot carries; as the cell file says where it is not given.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub mount: Option<Mount> = None,
        /// Dialect of the program.
        pub dialect: String = "nachi".into(),
        /// Rotation about the beam axis.
        pub spin: Spin = Spin::Free,
        /// How far the spot may leave the planned line between two targets, mm.
        pub deviation_mm: f64,
        /// Part in hand: how this part is held, in place of the cell's frame.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub flange_from_part: Option<Frame> = None,
        /// Part in hand: where the laser stands for this job, in place of the cell's frame.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub base_from_laser: Option<Frame> = None,
        /// Tool in hand: where this part lies, in place of the cell's frame.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub base_from_part: Option<Frame> = None,
    }
}

impl JobCell {
    /// Takes over where part and laser stand in another.
    pub(in crate::document) fn take_frames(&mut self, other: &JobCell) {
        self.flange_from_part.clone_from(&other.flange_from_part);
        self.base_from_laser.clone_from(&other.base_from_laser);
        self.base_from_part.clone_from(&other.base_from_part);
    }

    /// Puts the job's own frames in place of the cell's.
    pub fn put_frames(&self, cell: &mut Cell) {
        for (own, frame) in [
            (&self.flange_from_part, &mut cell.flange_from_part),
            (&self.base_from_laser, &mut cell.base_from_laser),
            (&self.base_from_part, &mut cell.base_from_part),
        ] {
            if let Some(own) = own {
                frame.clone_from(own);
            }
        }
    }
}
