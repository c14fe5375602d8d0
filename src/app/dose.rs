//! The dose of the plan that is shown: computed on a thread once it is asked for, with progress and
//! cancel, and kept for one plan. And what of it stands at a clicked place.

use super::App;
use super::session::Coloring;
use crate::part::Surfaces;
use crate::picture::dose::{DoseLook, dose_item};
use crate::planning::PlannedJob;
use crate::planning::dose::{DoseReport, dose, not_cleanable};
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
    /// Its numbers.
    pub report: DoseReport,
    /// The surfaces that it was computed for.
    pub surfaces: Arc<Surfaces>,
    /// By dose, and by incidence.
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

impl App {
    /// The dose of the plan as it is; `None`: it is being computed, or was cancelled.
    pub(super) fn dose(&self) -> Option<&Arc<DoseView>> {
        self.derived.current_plan(&self.document)?;
        self.derived.dose.of(self.derived.pipeline.dose_key()?)
    }

    /// How far the computation is that is going on.
    pub(super) fn dose_progress(&self) -> Option<&Progress> {
        self.derived.dose.progress()
    }

    /// Shows the dose on the part, or the surfaces again.
    pub(super) fn toggle_dose(&mut self) {
        let show = !self.session.show.dose;
        self.session.show.dose = show;
        self.session.coloring = if show { Coloring::Dose } else { Coloring::Surface };
        // A computation that was cancelled is asked for again.
        if show {
            self.derived.dose.try_again();
        }
    }

    /// Computes what is asked for, one plan at a time.
    pub(super) fn sync_dose(&mut self) {
        self.derived.dose.poll();
        let planned = self.derived.current_plan(&self.document).cloned();
        let (Some(planned), Some(key)) = (planned, self.derived.pipeline.dose_key()) else {
            // Nobody waits for the dose of what is out of date.
            if self.derived.dose.is_running() {
                self.derived.dose.clear();
            }
            return;
        };
        if !self.session.show.dose || !self.derived.dose.lacks(key) {
            return;
        }
        // Thresholds are those of the job as it is; all else of it is the plan's.
        let job = self.document.job().clone();
        let executor = self.derived.pipeline.executor().clone();
        self.derived.dose.start(key, Activity::SummingDose, &*executor, move |progress| {
            let PlannedJob { part, surfaces, plan, setup, .. } = &*planned;
            let map = dose(part, surfaces, plan, &job, setup, progress)?;
            let patches = not_cleanable(part, surfaces, plan, &job, &map);
            let report = DoseReport::new(&map, &patches, surfaces);
            let items = [DoseLook::Dose, DoseLook::Incidence].map(|look| dose_item(&map, surfaces, look));
            Ok(DoseView { map, patches, report, surfaces: surfaces.clone(), items })
        });
    }

    /// The part coloured by what lands, if that is asked for and known.
    pub(super) fn dose_picture(&self) -> Option<MeshItem> {
        let which = match self.session.coloring {
            Coloring::Surface => return None,
            Coloring::Dose => 0,
            Coloring::Incidence => 1,
        };
        Some(self.dose()?.items[which].clone())
    }

    /// Keeps what lands at a clicked place.
    pub(super) fn click_dose(&mut self, facet: u32, p: Point3<f64>) {
        let (Some(view), Some(planned)) = (self.dose(), self.derived.current_plan(&self.document)) else { return };
        let Some(normal) = view.surfaces.normals.get(facet as usize) else { return };
        let hits = view.map.hits_at(&planned.part, &planned.setup.tool.clamps, facet, &p, normal);
        self.session.clicked = Some(Clicked { p, facet, hits });
    }
}
