//! The dose of the plan that is shown: computed on a thread once it is asked for, with progress and
//! cancel, and kept for one plan. Also what lands at a clicked place.

use crate::document::Job;
use crate::part::{Digest, Surfaces};
use crate::picture::dose::{DoseLook, dose_item};
use crate::planning::dose::{DoseReport, dose, not_cleanable};
use crate::planning::{Executor, Failure, PlanError, PlannedJob, Stage};
use crate::process::{DoseMap, Patch, SpotHit};
use crate::progress::{Activity, Progress};
use crate::view::MeshItem;
use nalgebra::Point3;
use std::sync::Arc;

/// A dose, ready to be shown.
pub struct DoseView {
    /// The samples.
    pub map: DoseMap,
    /// What stays unclean.
    pub patches: Vec<Patch>,
    /// Its figures, as in the report.
    pub report: DoseReport,
    /// The surfaces that it was computed for.
    pub surfaces: Arc<Surfaces>,
    /// The coloured part: by dose, and by incidence.
    items: [MeshItem; 2],
}

/// What lands at a place that was clicked.
#[derive(Clone, Debug)]
pub struct Clicked {
    /// Where, mm, part frame.
    pub p: Point3<f64>,
    /// The facet.
    pub facet: u32,
    /// Which passes come there.
    pub hits: Vec<SpotHit>,
}

/// The computation of the dose, for one plan at a time.
#[derive(Default)]
pub struct Dose(Stage<DoseView, PlanError>);

impl Dose {
    /// Takes what has arrived, and starts to compute the dose of a plan if it is wanted; that of a plan that is out of
    /// date is dropped. Thresholds are those of the job as it is; all else is the plan's.
    pub fn sync(
        &mut self,
        current: Option<(Digest, Arc<PlannedJob>)>,
        job: &Job,
        is_wanted: bool,
        executor: &dyn Executor,
    ) {
        self.0.poll();
        let Some((key, planned)) = current else {
            if self.0.is_running() {
                self.0.clear();
            }
            return;
        };
        if is_wanted && self.0.lacks(key) {
            let job = job.clone();
            self.0.start(key, Activity::SummingDose, executor, move |progress| DoseView::new(&planned, &job, progress));
        }
    }

    /// The dose for a key of the pipeline.
    pub fn of(&self, key: Digest) -> Option<&Arc<DoseView>> {
        self.0.of(key)
    }

    /// The progress of the computation, while there is one.
    pub fn progress(&self) -> Option<&Progress> {
        self.0.progress()
    }

    /// Whether nothing is being computed.
    pub fn is_at_rest(&self) -> bool {
        !self.0.is_running()
    }

    /// Cancels the computation.
    pub fn cancel(&mut self) {
        self.0.cancel();
    }

    /// Computes again what was cancelled or failed.
    pub fn try_again(&mut self) {
        self.0.try_again();
    }
}

impl DoseView {
    fn new(of: &PlannedJob, job: &Job, progress: &Progress) -> Result<DoseView, Failure<PlanError>> {
        let PlannedJob { part, surfaces, plan, setup, .. } = of;
        let map = dose(part, surfaces, plan, job, setup, progress)?;
        progress.check()?;
        let patches = not_cleanable((part, surfaces), plan, job, &map, progress)?;
        let report = DoseReport::new(&map, &patches, surfaces);
        progress.check()?;
        let items = [DoseLook::Dose, DoseLook::Incidence].map(|look| dose_item(&map, surfaces, look));
        Ok(DoseView { map, patches, report, surfaces: surfaces.clone(), items })
    }

    /// The part coloured by it.
    pub fn picture(&self, look: DoseLook) -> &MeshItem {
        let [by_dose, by_incidence] = &self.items;
        match look {
            DoseLook::Dose => by_dose,
            DoseLook::Incidence => by_incidence,
        }
    }

    /// What lands at a place of the part of a plan: facet, and point in the part frame, mm.
    pub fn at(&self, of: &PlannedJob, facet: u32, p: Point3<f64>) -> Option<Clicked> {
        let normal = self.surfaces.normals.get(facet as usize)?;
        let hits = self.map.hits_at(&of.part, &of.setup.tool.clamps, facet, &p, normal);
        Some(Clicked { p, facet, hits })
    }
}
