//! What would help with the targets that the robot refuses: advice, and a better set-up
//! with its picture. Both are looked for on a thread, with progress and cancel, and belong to one plan:
//! with that they go.

use super::App;
use crate::cell::Setup;
use crate::cell::motion::Arm;
use crate::cell::motion::advice::BetterSetup;
use crate::document::Edit;
use crate::part::Hasher;
use crate::picture::CellPicture;
use crate::picture::palette::state;
use crate::planning::advice::Help;
use crate::planning::{Cache, Failure, PlannedJob, advice};
use crate::progress::{Activity, Cancelled, Progress};
use crate::view::{Depth, PointItem};
use nalgebra::{Isometry3, Point3};
use std::convert::Infallible;
use std::sync::Arc;

/// Colour of a target that is within reach, in a preview.
pub(super) const WITHIN: [u8; 3] = [64, 178, 255];
/// And of one that is not.
pub(super) const OUT_OF_REACH: [u8; 3] = state::BLOCKED;

/// A set-up that was found, ready to be looked at.
pub struct Proposal {
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
}

fn points(spots: impl Iterator<Item = Point3<f64>>, [r, g, b]: [u8; 3], size_px: f32) -> PointItem {
    let points: Vec<_> = spots.map(|p| ([p.x as f32, p.y as f32, p.z as f32], [r, g, b, 255])).collect();
    let numbers: Vec<f64> = points.iter().flat_map(|(p, _)| p.map(f64::from)).collect();
    let key = Hasher::default().f64s(&numbers).u32s(&[u32::from(r)]).finish().0 as u64;
    // What is out of reach must be found, wherever it is.
    let depth = if size_px > 8.0 { Depth::OnTop } else { Depth::Tested };
    PointItem { key, points: Arc::new(points), size_px, depth, scene_from_item: Isometry3::identity() }
}

impl App {
    /// The plan of the job as it is, if the robot refuses anything of it.
    fn refusing_plan(&self) -> Option<&Arc<PlannedJob>> {
        self.derived.current_plan(&self.document).filter(|planned| !planned.plan.refusals.is_empty())
    }

    /// Whether the robot refuses anything of the plan.
    pub(super) fn has_refusals(&self) -> bool {
        self.refusing_plan().is_some()
    }

    /// What would help with the plan as it is; `None`: that is being looked for.
    pub(super) fn advice(&self) -> Option<Result<&[Help], &Failure<Infallible>>> {
        let key = self.refusing_plan()?.key;
        let known = self.derived.advice.of(key).map(|told| Ok(told.as_slice()));
        known.or_else(|| self.derived.advice.failure(key).map(Err))
    }

    /// The set-up that is proposed for the plan as it is.
    pub(super) fn proposal(&self) -> Option<&Proposal> {
        let found = self.derived.proposal.of(self.derived.current_plan(&self.document)?.key)?;
        Option::as_ref(found)
    }

    /// Whether one was looked for in vain.
    pub(super) fn has_no_proposal(&self) -> bool {
        let found = self.derived.current_plan(&self.document).and_then(|p| self.derived.proposal.of(p.key));
        found.is_some_and(|found| found.is_none())
    }

    /// Whether a set-up for the plan as it is is being looked for.
    pub(super) fn is_proposing(&self) -> bool {
        self.derived.proposal.is_running()
    }

    /// The search that is shown: one that was asked for before one that nobody asked for.
    pub(super) fn search(&self) -> Option<&Progress> {
        self.derived.proposal.progress().or(self.derived.advice.progress())
    }

    /// Ends it.
    pub(super) fn end_search(&mut self) {
        if self.derived.proposal.is_running() {
            self.derived.proposal.cancel();
        } else {
            self.derived.advice.cancel();
        }
    }

    /// Looks for what would help, one plan at a time, and ends searches for plans that are no more.
    pub(super) fn sync_advice(&mut self) {
        self.derived.advice.poll();
        self.derived.proposal.poll();
        let Some(planned) = self.refusing_plan().cloned() else {
            self.derived.advice.clear();
            self.derived.proposal.clear();
            return;
        };
        let d = &mut self.derived;
        d.proposal.only(planned.key);
        if d.advice.lacks(planned.key) {
            let executor = d.pipeline.executor().clone();
            d.advice.start(planned.key, Activity::LookingForHelp, &*executor, move |progress| {
                let PlannedJob { part, plan, job, setup, .. } = &*planned;
                Ok(advice::advice(part, plan, job, setup, progress)?)
            });
        }
    }

    /// Looks for a better set-up.
    pub(super) fn propose(&mut self) {
        let Some(planned) = self.refusing_plan().cloned() else { return };
        let (cache, executor) = (self.derived.pipeline.cache.clone(), self.derived.pipeline.executor().clone());
        self.derived.proposal.clear();
        let key = planned.key;
        self.derived.proposal.start(key, Activity::LookingForSetup, &*executor, move |progress| {
            Ok(Proposal::new(&planned, &cache, progress)?)
        });
    }

    /// Takes the proposed set-up into the job.
    pub(super) fn apply_proposal(&mut self) {
        let Some(proposal) = self.proposal() else { return };
        let cell = advice::applied(&self.document.job().cell, proposal.setup.mount, &proposal.found);
        self.derived.proposal.clear();
        self.edit(Edit::Frames(Box::new(cell)));
    }

    /// Forgets the proposed set-up; whether there was one.
    pub(super) fn dismiss_proposal(&mut self) -> bool {
        let there = self.proposal().is_some() || self.has_no_proposal();
        self.derived.proposal.clear();
        there
    }

    /// The sample of a proposal, where the part is.
    pub(super) fn proposed_points(&self, place: Isometry3<f64>) -> Vec<PointItem> {
        let items = self.proposal().map_or(&[][..], |p| &p.points);
        // In the cell the part is small: dots must not hide it.
        let share = if self.is_in_cell() { 0.5 } else { 1.0 };
        let at = |i: &PointItem| PointItem { scene_from_item: place, size_px: share * i.size_px, ..i.clone() };
        items.iter().map(at).collect()
    }

    /// The arm in a proposed set-up: at the target that is stepped to, else at home.
    pub(super) fn proposed_joints_deg(&self, proposal: &Proposal) -> crate::cell::Joints {
        let job = self.document.job();
        let frame = self.target().map(|t| t.frame(self.work().defocus_mm));
        let states = frame.and_then(|f| Arm::new(&proposal.setup, job.cell.spin)?.states(&f).ok());
        // The one that is furthest from a singular pose.
        let best = states.and_then(|s| s.into_iter().max_by(|a, b| a.singularity.total_cmp(&b.singularity)));
        best.map_or(proposal.setup.home_joints_deg(), |s| s.joints_deg)
    }
}
