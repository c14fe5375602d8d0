//! Lines that are laid ahead of their plan. While a number is dragged each edit would end the lines of the one before,
//! and none would ever be seen: those that were begun first go on beside the newest, and are shown until these are there.

use super::super::error::PlanError;
use super::super::executor::Executor;
use super::super::failure::Failure;
use super::super::stage::Stage;
use super::super::toolpath::Toolpath;
use crate::part::Digest;
use crate::progress::{Activity, Progress};
use std::sync::Arc;

/// One for each surface.
pub(super) type Lines = Vec<Arc<Toolpath>>;

/// The lines of the newest job, and those of one before that are still being laid.
#[derive(Default)]
pub(super) struct LineStage {
    newest: Stage<Lines, PlanError>,
    earlier: Stage<Lines, PlanError>,
    /// Key of the surfaces that all of them lie on.
    on: Option<Digest>,
    arrived: Option<(Digest, Arc<Lines>)>,
}

impl LineStage {
    /// What arrived last, of whichever job; all of it lies on the surfaces that lines were begun on last.
    pub fn arrived(&self) -> Option<(Digest, &Arc<Lines>)> {
        self.arrived.as_ref().map(|(key, lines)| (*key, lines))
    }

    /// Whether nothing is known of this key, and nothing is being done for it.
    pub fn lacks(&self, key: Digest) -> bool {
        self.newest.lacks(key)
    }

    /// Whether lines of the newest job are being laid.
    pub fn is_running(&self) -> bool {
        self.newest.is_running()
    }

    /// How far these are.
    pub fn progress(&self) -> Option<&Progress> {
        self.newest.progress()
    }

    /// Takes what has arrived; what failed leaves what was there before.
    pub fn poll(&mut self) {
        if self.earlier.poll() {
            self.arrived = current(&self.earlier).or(self.arrived.take());
        }
        if self.newest.poll() {
            self.take_newest();
        }
    }

    fn take_newest(&mut self) {
        if !self.newest.is_running() {
            self.earlier.stop();
            self.arrived = current(&self.newest).or(self.arrived.take());
        }
    }

    /// Begins lines on these surfaces.
    pub fn start(
        &mut self,
        (on, key): (Digest, Digest),
        executor: &dyn Executor,
        work: impl FnOnce(&Progress) -> Result<Lines, Failure<PlanError>> + Send + 'static,
    ) {
        if self.on != Some(on) {
            self.clear();
            self.on = Some(on);
        }
        if self.newest.is_running() && !self.earlier.is_running() {
            std::mem::swap(&mut self.newest, &mut self.earlier);
        }
        self.newest.start(key, Activity::LayingLines, executor, work);
        // An executor that works at once has the result by now.
        self.take_newest();
    }

    /// Forgets failures, so that the same is tried again.
    pub fn try_again(&mut self) {
        self.newest.try_again();
    }

    /// Asks all work to end.
    pub fn cancel(&mut self) {
        self.earlier.stop();
        self.newest.cancel();
    }

    /// Ends all work and forgets everything.
    pub fn clear(&mut self) {
        self.earlier.clear();
        self.newest.clear();
        (self.on, self.arrived) = (None, None);
    }
}

/// What a stage came to last; `None` where that failed, or is not there yet.
fn current(stage: &Stage<Lines, PlanError>) -> Option<(Digest, Arc<Lines>)> {
    let (key, _) = stage.newest()?;
    Some((key, stage.of(key)?.clone()))
}

#[cfg(test)]
mod tests {
    use super::super::super::stage_tests::{Held, key};
    use super::*;

    fn start(stage: &mut LineStage, by: &Held, on: u32, of: u32) {
        stage.start((key(on), key(of)), by, |progress| {
            progress.check()?;
            Ok(Vec::new())
        });
    }

    #[test]
    fn the_lines_that_were_begun_first_are_seen_while_a_number_is_dragged() {
        let (mut stage, by) = (LineStage::default(), Held::default());
        for edit in 1..=4 {
            start(&mut stage, &by, 0, edit);
        }
        // The first go on; of the others only the last.
        by.run(0);
        stage.poll();
        assert_eq!(stage.arrived().map(|(key, _)| key), Some(key(1)));
        assert!(stage.is_running() && !stage.lacks(key(4)));
        for _ in 0..3 {
            by.run(0);
        }
        stage.poll();
        assert_eq!(stage.arrived().map(|(key, _)| key), Some(key(4)));
        assert!(!stage.is_running() && stage.lacks(key(3)));
    }

    #[test]
    fn late_lines_of_an_earlier_job_do_not_hide_the_newest() {
        let (mut stage, by) = (LineStage::default(), Held::default());
        start(&mut stage, &by, 0, 1);
        start(&mut stage, &by, 0, 2);
        by.run(1);
        stage.poll();
        by.run(0);
        stage.poll();
        assert_eq!(stage.arrived().map(|(key, _)| key), Some(key(2)));
    }

    #[test]
    fn lines_on_other_surfaces_are_forgotten() {
        let (mut stage, by) = (LineStage::default(), Held::default());
        start(&mut stage, &by, 0, 1);
        start(&mut stage, &by, 9, 2);
        by.run(0);
        stage.poll();
        assert!(stage.arrived().is_none());
        by.run(0);
        stage.poll();
        assert!(stage.arrived().is_some());
        stage.cancel();
        assert!(stage.arrived().is_some());
        stage.clear();
        assert!(stage.arrived().is_none() && stage.lacks(key(2)));
    }
}
