//! The steps of the tour, and where it is.

use crate::document::Job;

/// A step of the tour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum TourStep {
    /// Look at the part from all sides.
    Turn,
    /// Choose a surface to clean.
    Choose,
    /// Set the spacing of the lines.
    Space,
    /// Step through the plan.
    Watch,
    /// Choose a robot.
    Robot,
    /// Write the program.
    Export,
    /// That was all.
    Done,
}

impl TourStep {
    /// All, in their order.
    pub const ALL: [TourStep; 7] = [
        TourStep::Turn,
        TourStep::Choose,
        TourStep::Space,
        TourStep::Watch,
        TourStep::Robot,
        TourStep::Export,
        TourStep::Done,
    ];

    /// The one after it.
    pub fn next(self) -> TourStep {
        let at = TourStep::ALL.iter().position(|step| *step == self).unwrap_or(0);
        TourStep::ALL[(at + 1).min(TourStep::ALL.len() - 1)]
    }
}

/// Where the tour is, and how all stood when its step began.
#[derive(Clone, Debug)]
pub(in super::super) struct Tour {
    /// The step that is to be done.
    pub step: TourStep,
    /// The job.
    pub job: Option<Job>,
    /// The current target.
    pub at: (usize, usize),
    /// Where the camera stood, once it was still.
    pub yaw_rad: Option<f64>,
    /// How many exports were written.
    pub exports: usize,
}

impl Tour {
    /// A step that begins.
    pub fn at(step: TourStep) -> Tour {
        Tour { step, job: None, at: (0, 0), yaw_rad: None, exports: 0 }
    }
}
