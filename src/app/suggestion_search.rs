//! What would help with the targets that the robot refuses: suggestions, and a better set-up
//! with its picture. Both are looked for on a thread, with progress and cancel, and belong to one plan:
//! with that they go.

use crate::cell::Setup;
use crate::cell::motion::advice::BetterSetup;
use crate::part::{Digest, Hasher};
use crate::picture::CellPicture;
use crate::picture::palette::state;
use crate::planning::advice::Suggestion;
use crate::planning::{Executor, Failure, PlanCache, PlannedJob, Stage, advice};
use crate::progress::{Activity, Cancelled, Progress};
use crate::view::{Depth, PointItem};
use nalgebra::{Isometry3, Point3};
use std::convert::Infallible;
use std::sync::Arc;

/// Colour of targets within reach, in a preview.
pub(super) const WITHIN: [u8; 3] = [64, 178, 255];
/// Colour of targets out of reach, in a preview.
pub(super) const OUT_OF_REACH: [u8; 3] = state::BLOCKED;

/// A set-up that was found, ready to be looked at.
pub struct BetterSetupPreview {
    /// Its frames and what they are worth.
    pub found: BetterSetup,
    /// Targets that are refused with it, and without.
    pub refused: [usize; 2],
    /// Cell and robot as they would stand.
    pub setup: Setup,
    /// Arm and head there.
    pub picture: Option<CellPicture>,
    /// Targets that would be within reach, and those that would not.
    points: [PointItem; 2],
}

impl BetterSetupPreview {
    fn new(of: &PlannedJob, cache: &PlanCache, progress: &Progress) -> Result<Option<BetterSetupPreview>, Cancelled> {
        let better = advice::better_setup(&of.part, &of.surfaces, &of.plan, &of.job, &of.setup, cache, progress)?;
        let Some((found, left)) = better else { return Ok(None) };
        let cell = advice::applied(&of.job.cell, of.setup.mount, &found);
        let mut setup = (*of.setup).clone();
        cell.put_frames(&mut setup.cell);
        let spots = advice::spots(&found, of.job.beam.defocus_mm);
        let points = [(true, WITHIN, 6.0), (false, OUT_OF_REACH, 9.0)]
            .map(|(kind, color, size_px)| points(spots.iter().filter(|s| s.1 == kind).map(|s| s.0), color, size_px));
        let refused = [left, of.plan.refusals.len()];
        Ok(Some(BetterSetupPreview { picture: CellPicture::new(&setup), found, refused, setup, points }))
    }

    /// The dots of the preview where the part stands, at a share of their size.
    pub fn points_at(&self, place: Isometry3<f64>, share: f32) -> impl Iterator<Item = PointItem> {
        let at = move |i: &PointItem| PointItem { scene_from_item: place, size_px: share * i.size_px, ..i.clone() };
        self.points.iter().map(at)
    }
}

fn points(spots: impl Iterator<Item = Point3<f64>>, [r, g, b]: [u8; 3], size_px: f32) -> PointItem {
    let points: Vec<_> = spots.map(|p| ([p.x as f32, p.y as f32, p.z as f32], [r, g, b, 255])).collect();
    let numbers: Vec<f64> = points.iter().flat_map(|(p, _)| p.map(f64::from)).collect();
    let key = Hasher::default().f64s(&numbers).u32s(&[u32::from(r)]).finish().0 as u64;
    // What is out of reach must be found, wherever it is.
    let depth = if size_px > 8.0 { Depth::OnTop } else { Depth::Tested };
    PointItem { key, points: Arc::new(points), size_px, depth, scene_from_item: Isometry3::identity() }
}

/// The two searches.
#[derive(Default)]
pub struct SuggestionSearch {
    /// What would help with what is refused.
    suggestions: Stage<Vec<Suggestion>, Infallible>,
    /// A better set-up, if there is any.
    better_setup: Stage<Option<BetterSetupPreview>, Infallible>,
}

impl SuggestionSearch {
    /// Takes what has arrived, looks for suggestions on a plan of which the robot refuses something, and ends searches
    /// for plans that are no more.
    pub fn sync(&mut self, refusing: Option<Arc<PlannedJob>>, executor: &dyn Executor) {
        self.suggestions.poll();
        self.better_setup.poll();
        let Some(planned) = refusing else {
            self.suggestions.clear();
            self.better_setup.clear();
            return;
        };
        self.better_setup.only(planned.key);
        if self.suggestions.lacks(planned.key) {
            self.suggestions.start(planned.key, Activity::LookingForSuggestions, executor, move |progress| {
                let PlannedJob { part, plan, job, setup, .. } = &*planned;
                Ok(advice::suggestions(part, plan, job, setup, progress)?)
            });
        }
    }

    /// Looks for a better set-up.
    pub fn find_better_setup(&mut self, planned: Arc<PlannedJob>, cache: Arc<PlanCache>, executor: &dyn Executor) {
        self.better_setup.clear();
        self.better_setup.start(planned.key, Activity::LookingForSetup, executor, move |progress| {
            Ok(BetterSetupPreview::new(&planned, &cache, progress)?)
        });
    }

    /// What would help with a plan; `None`: that is being looked for.
    pub fn suggestions(&self, plan: Digest) -> Option<Result<&[Suggestion], &Failure<Infallible>>> {
        let known = self.suggestions.of(plan).map(|told| Ok(told.as_slice()));
        known.or_else(|| self.suggestions.failure(plan).map(Err))
    }

    /// The better set-up that was found for a plan.
    pub fn better_setup(&self, plan: Digest) -> Option<&BetterSetupPreview> {
        Option::as_ref(self.better_setup.of(plan)?)
    }

    /// Whether a set-up for a plan was looked for in vain.
    pub fn found_no_better_setup(&self, plan: Digest) -> bool {
        self.better_setup.of(plan).is_some_and(|found| found.is_none())
    }

    /// Whether a better set-up is being looked for.
    pub fn is_better_setup_sought(&self) -> bool {
        self.better_setup.is_running()
    }

    /// Whether nothing is being looked for.
    pub fn is_at_rest(&self) -> bool {
        !self.suggestions.is_running() && !self.better_setup.is_running()
    }

    /// Progress of the search that is shown: of a better set-up, which the operator asked for, before that of advice.
    pub fn progress(&self) -> Option<&Progress> {
        self.better_setup.progress().or(self.suggestions.progress())
    }

    /// Cancels that search.
    pub fn cancel_shown(&mut self) {
        if self.better_setup.is_running() {
            self.better_setup.cancel();
        } else {
            self.suggestions.cancel();
        }
    }

    /// Cancels both searches.
    pub fn cancel(&mut self) {
        self.suggestions.cancel();
        self.better_setup.cancel();
    }

    /// Looks again for suggestions that was cancelled.
    pub fn try_again(&mut self) {
        self.suggestions.try_again();
    }

    /// Forgets the better set-up.
    pub fn forget_better_setup(&mut self) {
        self.better_setup.clear();
    }
}
