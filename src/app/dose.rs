//! The dose of the plan that is shown: computed on a thread once it is asked for, with progress and
//! cancel, and kept for one plan. And what of it stands at a clicked place.

use super::App;
use super::remedy::Search;
use super::session::Coloring;
use super::worker::Outcome;
use crate::part::Surfaces;
use crate::picture::dose::{DoseLook, dose_item};
use crate::planning::PlanError;
use crate::planning::dose::DoseReport;
use crate::planning::dose::dose;
use crate::planning::dose::not_cleanable;
use crate::process::{DoseMap, Patch, SpotHit};
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

/// What is known of the dose, and the number of the plan that it is for.
#[derive(Default)]
pub struct Doses {
    /// `None` in it: it was cancelled.
    known: Option<(u64, Option<Arc<DoseView>>)>,
    computing: Option<Search>,
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
        let known = self.derived.doses.known.as_ref().filter(|(of, _)| *of == self.derived.plan_count);
        known.and_then(|(_, view)| view.as_ref())
    }

    /// Stage and share of the computation that runs.
    pub(super) fn dose_progress(&self) -> Option<(&'static str, f32)> {
        self.derived.doses.computing.as_ref().map(|s| s.progress.now()).filter(|p| !p.0.is_empty())
    }

    /// Ends the computation that runs.
    pub(super) fn end_dose(&self) {
        self.derived.doses.computing.iter().for_each(|s| s.progress.cancel());
    }

    /// Shows the dose on the part, or the surfaces again.
    pub(super) fn toggle_dose(&mut self) {
        let show = !self.session.show.dose;
        self.session.show.dose = show;
        self.session.coloring = if show { Coloring::Dose } else { Coloring::Surface };
        // A computation that was cancelled is asked for again.
        if show && self.derived.doses.known.as_ref().is_some_and(|(_, view)| view.is_none()) {
            self.derived.doses.known = None;
        }
    }

    /// Computes what is asked for, one plan at a time.
    pub(super) fn sync_dose(&mut self) {
        let of = self.derived.plan_count;
        if let Some(s) = self.derived.doses.computing.as_ref().filter(|s| s.of != of || !self.has_current_plan()) {
            s.progress.cancel();
        }
        let known = self.derived.doses.known.as_ref().is_some_and(|(known, _)| *known == of);
        if !self.session.show.dose || known || self.derived.doses.computing.is_some() || !self.has_current_plan() {
            return;
        }
        let d = &self.derived;
        let (Some((plan, _)), Some(part), Some((_, Ok(setup)))) = (d.plan.clone(), d.part.clone(), &d.setup) else {
            return;
        };
        let (setup, surfaces, job) = (setup.clone(), d.surfaces.clone(), self.document.job().clone());
        let (search, progress) = Search::new(of);
        self.derived.doses.computing = Some(search);
        self.worker.spawn(move || {
            let view = dose(&part, &surfaces, &plan, &job, &setup, &progress).map(|map| {
                let patches = not_cleanable(&part, &surfaces, &plan, &job, &map);
                let report = DoseReport::new(&map, &patches, &surfaces);
                let items = [DoseLook::Dose, DoseLook::Incidence].map(|look| dose_item(&map, &surfaces, look));
                Arc::new(DoseView { map, patches, report, surfaces, items })
            });
            Outcome::Dosed(of, view)
        });
    }

    pub(super) fn dosed(&mut self, of: u64, view: Result<Arc<DoseView>, PlanError>) {
        self.derived.doses.computing = None;
        if of == self.derived.plan_count {
            self.derived.doses.known = Some((of, view.ok()));
        }
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
        let (Some(view), Some(part)) = (self.dose().cloned(), self.derived.part.clone()) else { return };
        let Some((_, Ok(setup))) = &self.derived.setup else { return };
        let Some(normal) = view.surfaces.normals.get(facet as usize) else { return };
        let hits = view.map.hits_at(&part, &setup.tool.clamps, facet, &p, normal);
        self.session.clicked = Some(Clicked { p, facet, hits });
    }
}
