//! What there is of the job that the pipeline was synced to last. What is named *newest* may be out of date, the rest
//! is current.

use super::super::error::PlanningError;
use super::super::failure::Failure;
use super::super::key::Keys;
use super::super::planned::PlannedJob;
use super::super::scanned::{Scanned, WornPart};
use super::super::stage::Stage;
use super::super::toolpath::Toolpath;
use super::super::welded::{WeldOnPart, Welded};
use super::Pipeline;
use crate::cell::{Cell, Setup};
use crate::document::files::JobError;
use crate::part::{Digest, Part, Source, Surfaces};
use crate::progress::Progress;
use std::sync::Arc;

impl Pipeline {
    fn keys(&self) -> Option<&Keys> {
        self.wanted.as_ref().map(|w| &w.keys)
    }

    /// The part's file as it was read.
    pub fn source(&self) -> Option<&Arc<Source>> {
        self.source.as_ref()
    }

    /// The newest plan.
    pub fn newest_plan(&self) -> Option<&Arc<PlannedJob>> {
        self.plan.newest().map(|(_, planned)| planned)
    }

    /// Part and surfaces of the job that was synced last; `None` while they are being made. With a scan those with its
    /// patches, as soon as they are there: see [`Pipeline::waits_for_scan`].
    pub fn surfaces(&self) -> Option<(&Arc<Part>, &Arc<Surfaces>)> {
        let keys = self.keys()?;
        let bare = (self.part.of(keys.part)?, self.surfaces.of(keys.surfaces)?);
        // While other patches are looked for nobody is shown a part without any.
        let is_other = |is_running: bool, was_there: bool| is_running && was_there;
        let is_between = self.waits_for_scan() && is_other(self.scan.is_running(), self.scan.worn.newest().is_some())
            || self.waits_for_weld() && is_other(self.weld.is_running(), self.weld.ground.newest().is_some());
        if is_between {
            return None;
        }
        if let Some(on_part) = self.weld_on_part(keys) {
            return Some((&on_part.ground.part, &on_part.ground.surfaces));
        }
        Some(self.worn(keys).map_or(bare, |worn| (&worn.part, &worn.surfaces)))
    }

    /// Key of those.
    pub fn surfaces_key(&self) -> Option<Digest> {
        let keys = self.keys()?;
        if let Some(weld) = keys.weld.filter(|_| self.weld_on_part(keys).is_some()) {
            return Some(weld.ground);
        }
        Some(keys.scan.filter(|_| self.worn(keys).is_some()).map_or(keys.surfaces, |scan| scan.worn))
    }

    /// The part as its file has it: without the patches of a scan. `None` while it is being made.
    pub fn part_of_file(&self) -> Option<&Arc<Part>> {
        self.part.of(self.keys()?.part)
    }

    fn worn(&self, keys: &Keys) -> Option<&Arc<WornPart>> {
        keys.scan.and_then(|scan| self.scan.worn.of(scan.worn))
    }

    fn weld_on_part(&self, keys: &Keys) -> Option<&Arc<WeldOnPart>> {
        keys.weld.and_then(|weld| self.weld.ground.of(weld.ground))
    }

    /// Whether the job grinds a weld whose areas are not there yet.
    pub fn waits_for_weld(&self) -> bool {
        self.keys().is_some_and(|keys| keys.weld.is_some() && self.weld_on_part(keys).is_none())
    }

    /// What is known of its weld; `None` where it has none, or its images are not read yet.
    pub fn welded(&self) -> Option<Welded> {
        let keys = self.keys()?;
        self.weld.of((&keys.weld?, keys.weld_report?))
    }

    /// Whether the job has a scan whose patches are not there yet: what is planned then would be another job.
    pub fn waits_for_scan(&self) -> bool {
        self.keys().is_some_and(|keys| keys.scan.is_some() && self.worn(keys).is_none())
    }

    /// What is known of its scan; `None` where it has none, or it is not read yet.
    pub fn scanned(&self) -> Option<Scanned> {
        self.scan.of(&self.keys()?.scan?)
    }

    /// The cell of the job that was synced last, with its file's frames, or why there is none.
    pub fn cell(&self) -> Option<Result<&Arc<Cell>, &Failure<Arc<JobError>>>> {
        outcome(&self.cell, self.keys()?.cell)
    }

    /// Robot, cell and head of the job that was synced last, or why there are none.
    pub fn setup(&self) -> Option<Result<&Arc<Setup>, &Failure<Arc<JobError>>>> {
        outcome(&self.setup, self.keys()?.setup)
    }

    /// Key of the set-up.
    pub fn setup_key(&self) -> Option<Digest> {
        self.keys().map(|keys| keys.setup)
    }

    /// Lines of the job that was synced last, while its plan is not there; until they are there, those of a job before it
    /// on the same surfaces.
    pub fn lines(&self) -> Option<(Digest, &Arc<Vec<Arc<Toolpath>>>)> {
        let key = self.keys()?.plan;
        let is_current = |of: Digest| of == key || self.lines.is_running();
        self.lines.arrived().filter(|(of, _)| is_current(*of) && self.plan.of(key).is_none())
    }

    /// The plan of the job that was synced last: what may be called proven, and exported.
    pub fn plan(&self) -> Option<&Arc<PlannedJob>> {
        self.plan.of(self.keys()?.plan)
    }

    /// Key of the dose of that plan.
    pub fn dose_key(&self) -> Option<Digest> {
        self.keys().map(|keys| keys.dose)
    }

    /// Why the job that was synced last has no plan.
    pub fn error(&self) -> Option<PlanningError> {
        let keys = self.keys()?;
        if let Some(why) = self.part.failure(keys.part) {
            return Some(why.clone().into());
        }
        if let Some(why) = keys.scan.and_then(|scan| self.scan.failure(&scan)) {
            return Some(why.clone().into());
        }
        let of_weld = keys.weld.zip(keys.weld_report);
        if let Some(why) = of_weld.and_then(|(weld, report)| self.weld.failure((&weld, report))) {
            return Some(why.clone().into());
        }
        if let Some(Err(why)) = self.setup() {
            return Some(why.clone().into());
        }
        self.plan.failure(keys.plan).map(|why| why.clone().into())
    }

    /// Whether nothing is being computed.
    pub fn is_at_rest(&self) -> bool {
        let is_measuring = self.scan.is_running() || self.weld.is_running();
        !self.part.is_running() && !is_measuring && !self.lines.is_running() && !self.plan.is_running()
    }

    /// How far the work is that is going on.
    pub fn progress(&self) -> Option<&Progress> {
        let measuring = self.scan.progress().or(self.weld.progress());
        self.part.progress().or(measuring).or(self.lines.progress()).or(self.plan.progress())
    }
}

fn outcome<V, E>(stage: &Stage<V, E>, key: Digest) -> Option<Result<&Arc<V>, &Failure<E>>> {
    stage.of(key).map(Ok).or_else(|| stage.failure(key).map(Err))
}
