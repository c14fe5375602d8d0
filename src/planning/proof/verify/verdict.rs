//! What was found of a program: kinds, single findings with their figures, and the verdict. Sentences of it stand in
//! `text`.

use crate::cell::Joints;
use crate::pose::Blocker;
use crate::program::dialect::{Goal, ReadLine, Statement};
use crate::program::sweep::Proof;
use crate::program::{Interpolation, MoveTiming, ReadError};
use nalgebra::Point3;
use serde::Serialize;
use std::sync::Arc;

/// What is wrong with a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DifferenceKind {
    /// The text cannot be read on from here.
    Unreadable,
    /// A line of the plan is not there.
    Missing,
    /// A line that the plan does not have.
    Extra,
    /// The move leads elsewhere.
    Deviation,
    /// The move takes another time.
    Time,
    /// An output, a wait, a setting or a word differs.
    Setting,
    /// A joint beyond its range, or a pose out of reach.
    Limit,
    /// A joint faster than it can go.
    Speed,
    /// The beam hits the part with the laser on.
    Interference,
}

/// One difference between program and plan, or one thing that the robot could not do.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The file.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// What kind it is of.
    pub kind: DifferenceKind,
    /// What, with figures.
    pub what: Difference,
}

/// What is wrong with a line, with figures. Joints count from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// The text cannot be read on from here.
    Unreadable(Arc<ReadError>),
    /// Before this line the plan has another one.
    Missing {
        /// The line that should stand there.
        planned: Statement,
    },
    /// Behind the last line the plan goes on.
    EndMissing {
        /// How many lines are missing.
        lines: usize,
        /// The first of them.
        first: Statement,
    },
    /// The plan does not have this line.
    Extra {
        /// What it does.
        found: Statement,
    },
    /// The plan has ended before this line.
    BehindEnd {
        /// What it does.
        found: Statement,
    },
    /// The line does something else.
    OtherLine {
        /// What it does.
        found: Statement,
        /// What it should do.
        planned: Statement,
    },
    /// The move leads elsewhere.
    Elsewhere {
        /// How far the spot is off, where that is known and more than rounding.
        spot: Option<SpotOff>,
        /// The first joint that stands otherwise, where joints are given.
        joint: Option<JointOff>,
        /// Where it leads and where it should, both in the dialect's terms.
        goals: Option<[Goal; 2]>,
    },
    /// What the dialect's words make of a move goes another way than the plan.
    OtherWay {
        /// How it goes.
        found: Interpolation,
        /// How it should go.
        planned: Interpolation,
    },
    /// What the dialect's words make of a move takes another time than the plan.
    OtherPace {
        /// How fast it is.
        found: MoveTiming,
        /// How fast it should be.
        planned: MoveTiming,
    },
    /// The move is given another time.
    OtherTime {
        /// How fast it is.
        found: MoveTiming,
        /// How fast it should be.
        planned: MoveTiming,
    },
    /// The move has other words beside its target.
    OtherWords {
        /// Its own.
        found: String,
        /// The settings that it should have.
        planned: String,
    },
    /// The robot cannot go there.
    OutOfReach {
        /// Its name.
        robot: String,
    },
    /// A joint would stand beyond its range.
    BeyondRange {
        /// The joint.
        joint: usize,
        /// Where it would stand, degrees.
        at_deg: f64,
        /// Its range, degrees.
        range_deg: [f64; 2],
    },
    /// A joint would turn faster than it can.
    TooFast {
        /// The joint.
        joint: usize,
        /// How fast it would turn, degrees/s.
        deg_s: f64,
        /// How fast it can, degrees/s.
        most_deg_s: f64,
    },
    /// A move by joints with the laser on.
    LitByJoints,
    /// A move from or to joint angles with the laser on, without a robot: nobody knows where it leads.
    LitToUnknown,
    /// The program ends with the laser on.
    EndsLit,
    /// Something is in the way with the laser on.
    Touches(Blocker),
    /// The slow second opinion: the beam hits a facet with the laser on.
    HitsFacet {
        /// Where the spot stands, part frame.
        spot: Point3<f64>,
        /// The facet.
        facet: usize,
    },
}

/// A spot that is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotOff {
    /// How far, mm.
    pub mm: f64,
    /// Angle between the two beams, spin included, degrees.
    pub deg: f64,
}

/// A joint that stands otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointOff {
    /// The joint, from 0.
    pub joint: usize,
    /// The joint's angle in the plan, degrees.
    pub planned_deg: f64,
    /// The joint's angle in the program, degrees.
    pub found_deg: f64,
}

impl JointOff {
    pub(super) fn new(joint: usize, planned: &Joints, found: &Joints) -> JointOff {
        JointOff { joint, planned_deg: planned[joint], found_deg: found[joint] }
    }
}

impl Difference {
    /// What kind of thing is wrong.
    pub fn kind(&self) -> DifferenceKind {
        match self {
            Difference::Unreadable(_) => DifferenceKind::Unreadable,
            Difference::Missing { .. } | Difference::EndMissing { .. } => DifferenceKind::Missing,
            Difference::Extra { .. } | Difference::BehindEnd { .. } => DifferenceKind::Extra,
            Difference::Elsewhere { .. } => DifferenceKind::Deviation,
            Difference::OtherPace { .. } | Difference::OtherTime { .. } => DifferenceKind::Time,
            Difference::OtherLine { .. }
            | Difference::OtherWay { .. }
            | Difference::OtherWords { .. }
            | Difference::EndsLit => DifferenceKind::Setting,
            Difference::OutOfReach { .. } | Difference::BeyondRange { .. } => DifferenceKind::Limit,
            Difference::TooFast { .. } => DifferenceKind::Speed,
            Difference::LitByJoints
            | Difference::LitToUnknown
            | Difference::Touches(_)
            | Difference::HitsFacet { .. } => DifferenceKind::Interference,
        }
    }

    /// At a line that was read.
    pub(super) fn at(self, line: &ReadLine) -> Finding {
        Finding { file: line.file.clone(), line: line.line, kind: self.kind(), what: self }
    }
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Verdict {
    /// Moves that were read.
    pub moves: usize,
    /// Moves with the laser on.
    pub lit_moves: usize,
    /// Largest deviation of the spot from the plan among moves that were found, mm.
    pub worst_mm: f64,
    /// Largest turn from the plan, degrees.
    pub worst_deg: f64,
    /// What is proven of the moves with the laser on.
    pub proof: Proof,
    /// In the order of the program.
    pub findings: Vec<Finding>,
}
