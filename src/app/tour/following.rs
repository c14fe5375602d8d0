//! How the tour is begun, and goes on where a step was done.

use super::super::App;
use super::super::context::Context;
use super::state::{Tour, TourStep};

/// The sample that the tour works on.
const SAMPLE: &str = "workpiece";

impl App {
    /// Begins the tour, on the sample.
    pub(in super::super) fn begin_tour(&mut self) {
        self.open_sample(SAMPLE);
        self.session.tour = Some(Tour::at(TourStep::Turn));
    }

    /// Goes on where a step was done.
    pub(in super::super) fn follow_tour(&mut self) {
        let Some(mut tour) = self.session.tour.take() else { return };
        if self.derived.part.is_some() {
            let yaw_rad = self.viewport.camera.yaw_rad;
            let is_begun = tour.job.is_some();
            if !is_begun {
                tour.job = Some(self.document.job().clone());
                tour.at = self.session.playback.at;
                tour.exports = self.session.exports;
            }
            // The view of a part that was just opened is not the operator's.
            let is_still = !self.viewport.is_gliding() && !self.session.fit_pending;
            if is_still && tour.yaw_rad.is_none() {
                tour.yaw_rad = Some(yaw_rad);
            }
            if is_begun && self.context().has_done(&tour, yaw_rad) {
                tour = Tour::at(tour.step.next());
            }
        }
        self.session.tour = Some(tour);
    }
}

impl Context<'_> {
    fn has_done(self, tour: &Tour, yaw_rad: f64) -> bool {
        let (Some(before), now) = (&tour.job, self.document.job()) else { return false };
        match tour.step {
            TourStep::Turn => tour.yaw_rad.is_some_and(|before| (before - yaw_rad).abs() > 0.02),
            TourStep::Choose => !self.clean_list().is_empty(),
            TourStep::Space => before.layers.spacing_mm != now.layers.spacing_mm,
            TourStep::Watch => self.derived.plan().is_some() && self.session.playback.at != tour.at,
            TourStep::Robot => !now.cell.robot.is_empty(),
            TourStep::Export => self.session.exports > tour.exports,
            TourStep::Done => false,
        }
    }
}
