//! All that is computed from the document: the pipeline's stages, and what the window alone makes of them.
//!
//! What is shown may be out of date, and is marked so then. What is *current* is asked for by the job as it
//! is now: only that is called proven, and only that is exported.

use super::clearance::ClearanceSearch;
use super::dose::Dose;
use super::playback_data::PlaybackData;
use super::suggestion_search::SuggestionSearch;
use crate::document::model::JobPart;
use crate::document::{Document, Job};
use crate::part::{Digest, Part, PartFinding, Shape, SurfaceId, Surfaces};
use crate::picture::{CellPicture, PartPicture, ToolPicture};
use crate::planning::{Executor, Pipeline, PlannedJob, PlanningError, Stage};
use crate::text::{id, say, shape_label};
use crate::view::LineItem;
use std::collections::BTreeMap;
use std::convert::Infallible;
use std::sync::Arc;

/// Computed state.
pub struct Derived {
    /// From the part's file to the plan.
    pub pipeline: Pipeline,
    /// The part that is shown; with a scan the one on which its patches are surfaces.
    pub part: Option<Arc<Part>>,
    /// The part as its file has it: what a job remembers is told by its facets.
    pub file_part: Option<Arc<Part>>,
    /// How it was built from its file.
    pub part_of: JobPart,
    /// Its feature surfaces.
    pub surfaces: Arc<Surfaces>,
    /// Their shapes, as far as known.
    pub shapes: Stage<BTreeMap<u32, Shape>, Infallible>,
    /// Whether the part shatters.
    pub shattered: Stage<Option<PartFinding>, Infallible>,
    /// Buffers of the part.
    pub picture: Option<PartPicture>,
    /// Head, beam and clamps, and the key of the set-up that they were made for.
    pub tool_picture: Option<(Digest, ToolPicture)>,
    /// Arm, head and floor, where the set-up has a robot.
    pub cell: Option<CellPicture>,
    /// The lines of the job whose plan is being made.
    pub(super) laid: Option<(Digest, LineItem)>,
    /// What is played back of the plan.
    pub(super) playback_data: Stage<PlaybackData, Infallible>,
    /// How far everything keeps from everything over it.
    pub(super) clearance: ClearanceSearch,
    /// What would help with what the robot refuses.
    pub(super) suggestions: SuggestionSearch,
    /// What lands.
    pub(super) dose: Dose,
}

impl Derived {
    /// Nothing yet.
    pub fn new(executor: Arc<dyn Executor>) -> Derived {
        Derived {
            pipeline: Pipeline::new(executor, true),
            part: None,
            file_part: None,
            part_of: JobPart::default(),
            surfaces: Arc::default(),
            shapes: Stage::default(),
            shattered: Stage::default(),
            picture: None,
            tool_picture: None,
            cell: None,
            laid: None,
            playback_data: Stage::default(),
            clearance: ClearanceSearch::default(),
            suggestions: SuggestionSearch::default(),
            dose: Dose::default(),
        }
    }

    /// The newest plan; it may be out of date.
    pub fn plan(&self) -> Option<&Arc<PlannedJob>> {
        self.pipeline.newest_plan()
    }

    /// That plan, if it was made on the part that is shown: else its lines would not lie on it.
    pub fn plan_on_part(&self) -> Option<&Arc<PlannedJob>> {
        let part = self.part.as_ref()?;
        // The patches of a scan that is looked at again make the same part once more.
        self.plan().filter(|planned| Arc::ptr_eq(&planned.part, part) || planned.part.digest == part.digest)
    }

    /// The plan of the document as it is.
    pub fn current_plan(&self, document: &Document) -> Option<&Arc<PlannedJob>> {
        (self.is_synced(document) && !self.waits_for_images()).then(|| self.pipeline.plan()).flatten()
    }

    /// Why the document as it is has no plan.
    pub fn error(&self, document: &Document) -> Option<PlanningError> {
        if self.is_synced(document) { self.pipeline.error() } else { None }
    }

    /// Whether all that is shown belongs to the document as it is.
    pub fn is_current(&self, document: &Document) -> bool {
        if self.part.is_none() {
            return true;
        }
        // With a scan there is always a plan: it may be one of nothing.
        let is_empty = || self.surfaces.worked.is_none() && document.job().chosen(&self.surfaces).is_empty();
        let has_surfaces =
            || self.is_synced(document) && !self.waits_for_images() && self.pipeline.surfaces().is_some();
        self.error(document).is_some() || has_surfaces() && (self.current_plan(document).is_some() || is_empty())
    }

    /// Whether the plan that is shown is none of the document as it is: that one is being made, or was cancelled or
    /// refused.
    pub fn is_plan_out_of_date(&self, document: &Document) -> bool {
        self.plan().is_some() && self.current_plan(document).is_none()
    }

    /// Whether part and surfaces are those of the document as it is, and of the part's file: what is cut, merged and
    /// split is looked for on them. With a scan they are not, since patches have facets that the file has not.
    pub fn has_current_surfaces(&self, document: &Document) -> bool {
        let job = document.job();
        let is_of_file = !job.scan.is_there() && !job.weld.is_there() && self.surfaces.worked.is_none();
        is_of_file && self.is_synced(document) && self.pipeline.surfaces().is_some()
    }

    /// Whether the patches of a scan or the areas of a weld are not there yet.
    fn waits_for_images(&self) -> bool {
        self.pipeline.waits_for_scan() || self.pipeline.waits_for_weld()
    }

    fn is_synced(&self, document: &Document) -> bool {
        self.pipeline.is_synced(document.job(), document.file())
    }

    /// What is played back of the plan that is shown.
    pub fn playback_data(&self) -> Option<&Arc<PlaybackData>> {
        self.playback_data.of(self.plan()?.key)
    }

    /// Cancels all work.
    pub fn cancel_all(&mut self) {
        self.pipeline.cancel();
        self.suggestions.cancel();
        self.dose.cancel();
        self.clearance.cancel();
    }

    /// Whether no work is going on.
    pub fn is_at_rest(&self) -> bool {
        self.pipeline.is_at_rest()
            && !self.shapes.is_running()
            && !self.shattered.is_running()
            && !self.playback_data.is_running()
            && self.clearance.is_at_rest()
            && self.suggestions.is_at_rest()
            && self.dose.is_at_rest()
    }

    /// Numbers of all surfaces.
    pub fn numbers(&self) -> Vec<u32> {
        self.surfaces.list.iter().map(|s| s.number).collect()
    }

    /// The shape of a surface, once it is known.
    pub fn shape(&self, surface: u32) -> Option<&Shape> {
        let (_, shapes) = self.shapes.newest()?;
        shapes.get(&surface)
    }

    /// Name of a surface in lists and at the cursor.
    pub fn label(&self, job: &Job, surface: u32) -> String {
        match job.settings.of(SurfaceId(surface)).name.as_str() {
            "" if let Some(patch) = self.patch_of(surface) => say!(scan_panel_patch_name, patch = id(patch + 1)),
            "" => self.shape(surface).map_or_else(|| "…".into(), shape_label),
            name => name.into(),
        }
    }

    /// Which patch of the scan a surface is a piece of, from 0.
    pub fn patch_of(&self, surface: u32) -> Option<usize> {
        self.surfaces.worked.as_ref()?;
        let worn = self.pipeline.scanned()?.worn?;
        worn.patches.iter().position(|pieces| pieces.iter().any(|piece| piece.surface.0 == surface))
    }
}
