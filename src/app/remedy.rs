//! What would help with the targets that the robot refuses: advice, and a better set-up
//! with its picture. Both are searched on a thread, with progress and cancel, and belong to one plan: they are dropped
//! with it.

use crate::cell::Setup;
use crate::cell::motion::advice::BetterSetup;
use crate::part::{Digest, Hasher};
use crate::picture::CellPicture;
use crate::picture::palette::state;
use crate::planning::advice::Help;
use crate::planning::{Cache, Executor, Failure, PlannedJob, Stage, advice};
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
pub struct Proposal {
    /// Its frames, and how many targets they make possible.
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

impl Proposal {
    fn new(of: &PlannedJob, cache: &Cache, progress: &Progress) -> Result<Option<Proposal>, Cancelled> {
        let better = advice::better_setup(&of.part, &of.surfaces, &of.plan, &of.job, &of.setup, cache, progress)?;
        let Some((found, left)) = better else { return Ok(None) };
        let cell = advice::applied(&of.job.cell, of.setup.mount, &found);
        let mut setup = (*of.setup).clone();
        cell.put_frames(&mut setup.cell);
        let spots = advice::spots(&found, of.job.beam.defocus_mm);
        let points = [(true, WITHIN, 6.0), (false, OUT_OF_REACH, 9.0)]
            .map(|(kind, color, size_px)| points(spots.iter().filter(|s| s.1 == kind).map(|s| s.0), color, size_px));
        let refused = [left, of.plan.refusals.len()];
        Ok(Some(Proposal { picture: CellPicture::new(&setup), found, refused, setup, points }))
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
pub struct Remedy {
    /// What would help with what is refused.
    advice: Stage<Vec<Help>, Infallible>,
    /// A better set-up, if there is any.
    proposal: Stage<Option<Proposal>, Infallible>,
}

impl Remedy {
    /// Takes what has arrived, starts to look for advice where the robot refuses targets of the plan, and cancels
    /// searches for earlier plans.
    pub fn sync(&mut self, refusing: Option<Arc<PlannedJob>>, executor: &dyn Executor) {
        self.advice.poll();
        self.proposal.poll();
        let Some(planned) = refusing else {
            self.advice.clear();
            self.proposal.clear();
            return;
        };
        self.proposal.only(planned.key);
        if self.advice.lacks(planned.key) {
            self.advice.start(planned.key, Activity::LookingForHelp, executor, move |progress| {
                let PlannedJob { part, plan, job, setup, .. } = &*planned;
                Ok(advice::advice(part, plan, job, setup, progress)?)
            });
        }
    }

    /// Looks for a better set-up.
    pub fn propose(&mut self, planned: Arc<PlannedJob>, cache: Arc<Cache>, executor: &dyn Executor) {
        self.proposal.clear();
        self.proposal.start(planned.key, Activity::LookingForSetup, executor, move |progress| {
            Ok(Proposal::new(&planned, &cache, progress)?)
        });
    }

    /// What would help with a plan; `None`: that is being looked for.
    pub fn advice(&self, plan: Digest) -> Option<Result<&[Help], &Failure<Infallible>>> {
        let known = self.advice.of(plan).map(|told| Ok(told.as_slice()));
        known.or_else(|| self.advice.failure(plan).map(Err))
    }

    /// The set-up that is proposed for a plan.
    pub fn proposal(&self, plan: Digest) -> Option<&Proposal> {
        Option::as_ref(self.proposal.of(plan)?)
    }

    /// Whether a set-up for a plan was looked for in vain.
    pub fn found_no_proposal(&self, plan: Digest) -> bool {
        self.proposal.of(plan).is_some_and(|found| found.is_none())
    }

    /// Whether a better set-up is being looked for.
    pub fn is_proposing(&self) -> bool {
        self.proposal.is_running()
    }

    /// Whether nothing is being looked for.
    pub fn is_at_rest(&self) -> bool {
        !self.advice.is_running() && !self.proposal.is_running()
    }

    /// Progress of the search that is shown: of a better set-up, which the operator asked for, before that of advice.
    pub fn progress(&self) -> Option<&Progress> {
        self.proposal.progress().or(self.advice.progress())
    }

    /// Cancels that search.
    pub fn cancel_shown(&mut self) {
        if self.proposal.is_running() {
            self.proposal.cancel();
        } else {
            self.advice.cancel();
        }
    }

    /// Cancels both searches.
    pub fn cancel(&mut self) {
        self.advice.cancel();
        self.proposal.cancel();
    }

    /// Looks again for advice that was cancelled.
    pub fn try_again(&mut self) {
        self.advice.try_again();
    }

    /// Forgets the proposed set-up.
    pub fn forget_proposal(&mut self) {
        self.proposal.clear();
    }
}
