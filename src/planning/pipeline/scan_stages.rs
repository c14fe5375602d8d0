//! The stages of a job's scan: read, cleaned, laid on the part, compared with it, and the part with what is worn. Each
//! waits for the one before; without a scan they are idle.

use super::super::executor::Executor;
use super::super::failure::Failure;
use super::super::key::ScanKeys;
use super::super::scanned::{
    ComparedScan, LaidScan, ReadScan, ScanError, Scanned, WornPart, compare, lay, read_scan, worn,
};
use super::super::stage::Stage;
use crate::document::Job;
use crate::part::{Part, Surfaces};
use crate::progress::{Activity, Progress};
use crate::scan::cleaning::{Cleaned, clean};
use std::path::Path;
use std::sync::Arc;

/// The stages of a scan.
#[derive(Default)]
pub(super) struct ScanStages {
    pub(super) read: Stage<ReadScan, ScanError>,
    pub(super) cleaned: Stage<Cleaned, ScanError>,
    pub(super) laid: Stage<LaidScan, ScanError>,
    pub(super) compared: Stage<ComparedScan, ScanError>,
    pub(super) worn: Stage<WornPart, ScanError>,
}

impl ScanStages {
    /// Takes what has arrived and starts what can be. Work that is done at once brings the next stage along.
    pub(super) fn sync(
        &mut self,
        part: &Arc<Part>,
        surfaces: &Arc<Surfaces>,
        job: &Job,
        job_file: Option<&Path>,
        keys: &ScanKeys,
        executor: &dyn Executor,
    ) {
        let scan = || job.scan.clone();
        let read = self.read.sync(keys.read, Activity::ReadingScan, executor, || {
            let (scan, job_file) = (scan(), job_file.map(Path::to_path_buf));
            move |progress: &Progress| Ok(read_scan(&scan, job_file.as_deref(), progress)?)
        });
        let Some(read) = read else { return };
        let cleaned = self.cleaned.sync(keys.cleaned, Activity::CleaningScan, executor, || {
            let (scan, read) = (scan(), read.clone());
            move |progress: &Progress| Ok(clean(&read.cloud, &scan.steps, progress)?)
        });
        let Some(cleaned) = cleaned else { return };
        let laid = self.laid.sync(keys.laid, Activity::LayingScan, executor, || {
            let (job, cleaned, part, surfaces) = (job.clone(), cleaned.clone(), part.clone(), surfaces.clone());
            move |progress: &Progress| Ok(lay(&part, &surfaces, &cleaned.cloud, &job, progress)?)
        });
        let Some(laid) = laid else { return };
        let compared = self.compared.sync(keys.compared, Activity::ComparingScan, executor, || {
            let (scan, laid) = (scan(), laid.clone());
            move |progress: &Progress| Ok(compare(&laid, &scan, progress)?)
        });
        let Some(compared) = compared else { return };
        self.worn.sync(keys.worn, Activity::CuttingPatches, executor, || {
            let (job, laid, compared) = (job.clone(), laid.clone(), compared.clone());
            move |progress: &Progress| Ok(worn((&laid, &compared), &job, progress)?)
        });
    }

    /// What there is for these keys; `None` while nothing was read.
    pub(super) fn of(&self, keys: &ScanKeys) -> Option<Scanned> {
        Some(Scanned {
            read: self.read.of(keys.read)?.clone(),
            cleaned: self.cleaned.of(keys.cleaned).cloned(),
            laid: self.laid.of(keys.laid).cloned(),
            compared: self.compared.of(keys.compared).cloned(),
            worn: self.worn.of(keys.worn).cloned(),
        })
    }

    /// Why the scan says nothing.
    pub(super) fn failure(&self, keys: &ScanKeys) -> Option<&Failure<ScanError>> {
        let before = self.read.failure(keys.read).or_else(|| self.cleaned.failure(keys.cleaned));
        let then = before.or_else(|| self.laid.failure(keys.laid)).or_else(|| self.compared.failure(keys.compared));
        then.or_else(|| self.worn.failure(keys.worn))
    }

    /// Whether work is going on.
    pub(super) fn is_running(&self) -> bool {
        self.progress().is_some()
    }

    /// How far it is.
    pub(super) fn progress(&self) -> Option<&Progress> {
        let before = self.read.progress().or(self.cleaned.progress()).or(self.laid.progress());
        before.or(self.compared.progress()).or(self.worn.progress())
    }

    /// Ends the work.
    pub(super) fn cancel(&mut self) {
        self.read.cancel();
        self.cleaned.cancel();
        self.laid.cancel();
        self.compared.cancel();
        self.worn.cancel();
    }

    /// Ends the work for a scan that was taken away: it comes back as if nothing had been begun.
    pub(super) fn stop(&mut self) {
        self.read.stop();
        self.cleaned.stop();
        self.laid.stop();
        self.compared.stop();
        self.worn.stop();
    }

    /// Tries again what failed.
    pub(super) fn try_again(&mut self) {
        self.read.try_again();
        self.cleaned.try_again();
        self.laid.try_again();
        self.compared.try_again();
        self.worn.try_again();
    }
}
