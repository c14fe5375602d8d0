//! The stages of a job's weld: its images read, masked, measured, the part with the areas that are ground, and what is
//! reported of it. Each waits for the one before; without a weld they are idle.

use super::super::executor::Executor;
use super::super::failure::Failure;
use super::super::key::WeldKeys;
use super::super::stage::Stage;
use super::super::welded::{
    MeasuredWeld, ReadWeld, WeldError, WeldOnPart, WeldReport, Welded, mask_weld, measure_weld, read_weld, weld_on_part,
};
use crate::document::Job;
use crate::part::{Digest, Part, Surfaces};
use crate::progress::{Activity, Progress};
use crate::weld::masking::MaskedImage;
use std::path::Path;
use std::sync::Arc;

/// The stages of a weld.
#[derive(Default)]
pub(super) struct WeldStages {
    pub(super) read: Stage<ReadWeld, WeldError>,
    pub(super) masked: Stage<MaskedImage, WeldError>,
    pub(super) measured: Stage<MeasuredWeld, WeldError>,
    pub(super) ground: Stage<WeldOnPart, WeldError>,
    pub(super) reported: Stage<WeldReport, WeldError>,
}

impl WeldStages {
    /// Takes what has arrived and starts what can be. Work that is done at once brings the next stage along.
    pub(super) fn sync(
        &mut self,
        part: &Arc<Part>,
        surfaces: &Arc<Surfaces>,
        job: &Job,
        job_file: Option<&Path>,
        (keys, report): (&WeldKeys, Digest),
        executor: &dyn Executor,
    ) {
        let read = self.read.sync(keys.read, Activity::ReadingImages, executor, || {
            let (weld, job_file) = (job.weld.clone(), job_file.map(Path::to_path_buf));
            move |progress: &Progress| Ok(read_weld(&weld, job_file.as_deref(), progress)?)
        });
        let Some(read) = read else { return };
        let masked = self.masked.sync(keys.masked, Activity::MaskingImage, executor, || {
            let (weld, read) = (job.weld.clone(), read.clone());
            move |progress: &Progress| Ok(mask_weld(&read, &weld, progress)?)
        });
        let Some(masked) = masked else { return };
        let measured = self.measured.sync(keys.measured, Activity::MeasuringBead, executor, || {
            let (read, masked, weld) = (read.clone(), masked.clone(), job.weld.clone());
            move |progress: &Progress| Ok(measure_weld(&read, &masked, &weld, progress)?)
        });
        let Some(measured) = measured else { return };
        let ground = self.ground.sync(keys.ground, Activity::CuttingAreas, executor, || {
            let (job, read, measured) = (job.clone(), read.clone(), measured.clone());
            let (part, surfaces) = (part.clone(), surfaces.clone());
            move |progress: &Progress| Ok(weld_on_part((&read, &measured), (&part, &surfaces), &job, progress)?)
        });
        let Some(ground) = ground else { return };
        self.reported.sync(report, Activity::ComparingStrategies, executor, || {
            let (job, ground) = (job.clone(), ground.clone());
            move |progress: &Progress| Ok(WeldReport::new(&ground, &job, progress).map_err(WeldError::from)?)
        });
    }

    /// What there is for these keys; `None` while nothing was read.
    pub(super) fn of(&self, (keys, report): (&WeldKeys, Digest)) -> Option<Welded> {
        Some(Welded {
            read: self.read.of(keys.read)?.clone(),
            masked: self.masked.of(keys.masked).cloned(),
            measured: self.measured.of(keys.measured).cloned(),
            ground: self.ground.of(keys.ground).cloned(),
            report: self.reported.of(report).cloned(),
        })
    }

    /// Why the weld says nothing.
    pub(super) fn failure(&self, (keys, report): (&WeldKeys, Digest)) -> Option<&Failure<WeldError>> {
        let before = self.read.failure(keys.read).or_else(|| self.masked.failure(keys.masked));
        let then = before.or_else(|| self.measured.failure(keys.measured)).or_else(|| self.ground.failure(keys.ground));
        then.or_else(|| self.reported.failure(report))
    }

    /// Whether work is going on.
    pub(super) fn is_running(&self) -> bool {
        self.progress().is_some()
    }

    /// How far it is.
    pub(super) fn progress(&self) -> Option<&Progress> {
        let before = self.read.progress().or(self.masked.progress());
        before.or(self.measured.progress()).or(self.ground.progress()).or(self.reported.progress())
    }

    /// Ends the work.
    pub(super) fn cancel(&mut self) {
        self.read.cancel();
        self.masked.cancel();
        self.measured.cancel();
        self.ground.cancel();
        self.reported.cancel();
    }

    /// Ends the work, and lets go of what there is: the job grinds nothing.
    pub(super) fn stop(&mut self) {
        if self.read.newest().is_some() || self.is_running() {
            self.cancel();
            *self = WeldStages::default();
        }
    }

    /// Tries again what failed.
    pub(super) fn try_again(&mut self) {
        self.read.try_again();
        self.masked.try_again();
        self.measured.try_again();
        self.ground.try_again();
        self.reported.try_again();
    }
}
