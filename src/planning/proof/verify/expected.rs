//! What a program should be, and where its targets are.

use crate::cell::Setup;
use crate::part::Part;
use crate::program::dialect::{Goal, ReadLine};
use crate::program::sweep::{Proof, Prover};
use crate::program::{Move, ProgramLine, spot};
use nalgebra::{Isometry3, Point3};

/// A part, the setup, and what the program should be.
pub struct Expected<'a> {
    /// The part.
    pub part: &'a Part,
    /// Cell and robot.
    pub setup: &'a Setup,
    /// D, mm.
    pub defocus_mm: f64,
    /// Proves its lit moves.
    pub prover: Prover<'a>,
    /// What was proven of the plan by the same prover; `None`: the moves are proven anew, whatever the plan says.
    pub known: Option<&'a Proof>,
    /// The plan's moves in order.
    pub moves: Vec<&'a Move>,
    /// The plan as it is written, and read again.
    pub written: &'a [ReadLine],
}

/// The moves of neutral lines, in order.
pub(in super::super) fn moves(lines: &[ProgramLine]) -> Vec<&Move> {
    lines.iter().filter_map(|l| if let ProgramLine::Move(m) = l { Some(m.as_ref()) } else { None }).collect()
}

/// Poses of what was read.
pub(in super::super) struct Poses<'a> {
    pub(in super::super) setup: &'a Setup,
    pub(in super::super) defocus_mm: f64,
}

impl Poses<'_> {
    /// Focus in the part; `None` for joints without a robot.
    pub(super) fn focus(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.focus_for(&self.setup.robot.as_ref()?.forward(joints))),
            Goal::Flange(flange) => Some(self.setup.focus_for(flange)),
            Goal::Focus(focus) => Some(*focus),
        }
    }

    /// Flange in the base; `None` for joints without a robot.
    pub(super) fn flange(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.robot.as_ref()?.forward(joints)),
            Goal::Flange(flange) => Some(*flange),
            Goal::Focus(focus) => Some(self.setup.flange_for(focus)),
        }
    }

    /// Where the spot is.
    pub(super) fn spot(&self, focus: &Isometry3<f64>) -> Point3<f64> {
        spot::planned_spot(focus, self.defocus_mm)
    }
}
