//! The clearance of arm, head and part over a program: measured on a thread once the curves are shown, and kept for
//! one plan.

use super::playback_data::PlaybackData;
use crate::cell::Collision;
use crate::part::{Digest, GrownPart};
use crate::planning::{Executor, PlannedJob, Stage};
use crate::program::{Clearance, clearances};
use crate::progress::{Activity, Cancelled, Progress};
use std::convert::Infallible;
use std::sync::Arc;

/// A curve of clearance.
#[derive(Debug, Default)]
pub struct ClearanceCurve {
    /// Over the time of the program.
    pub samples: Vec<Clearance>,
    /// The margin that all bodies have to keep, mm.
    pub margin_mm: f64,
}

/// Measures clearances, one plan at a time: of plans that come while one is measured, only the newest follows.
#[derive(Default)]
pub struct ClearanceSearch(Stage<ClearanceCurve, Infallible>);

impl ClearanceSearch {
    /// Takes what has arrived, and starts to measure a plan in motion unless that is known.
    pub fn sync(&mut self, current: Option<(Arc<PlannedJob>, Arc<PlaybackData>)>, executor: &dyn Executor) {
        self.0.poll();
        let Some((planned, data)) = current.filter(|(planned, _)| !self.0.is_running() && self.0.lacks(planned.key))
        else {
            return;
        };
        self.0.start(planned.key, Activity::MeasuringClearances, executor, move |progress| {
            Ok(ClearanceCurve::new(&planned, &data, progress)?)
        });
    }

    /// The clearance over a plan; `None`: it is not known yet.
    pub fn of(&self, plan: Digest) -> Option<&Arc<ClearanceCurve>> {
        self.0.of(plan)
    }

    /// Ends the work.
    pub fn cancel(&mut self) {
        self.0.cancel();
    }

    /// Tries again what was cancelled.
    pub fn try_again(&mut self) {
        self.0.try_again();
    }

    /// Whether nothing is being measured.
    pub fn is_at_rest(&self) -> bool {
        !self.0.is_running()
    }
}

impl ClearanceCurve {
    /// Empty without a robot.
    fn new(planned: &PlannedJob, data: &PlaybackData, progress: &Progress) -> Result<ClearanceCurve, Cancelled> {
        // As the plan asks for arm and head: with all that will be laid, from the first layer on.
        let whole = GrownPart::largest(&planned.part, &planned.plan.grown);
        let collision = data.timeline.as_ref().and_then(|timeline| Collision::new(timeline.setup(), whole));
        let Some(collision) = collision else { return Ok(ClearanceCurve::default()) };
        let samples = clearances(&data.curves, &collision, progress)?;
        Ok(ClearanceCurve { samples, margin_mm: collision.margin_mm() })
    }
}
