//! What would help with the targets that the robot refuses: sentences of advice, and a better set-up
//! with its picture. Both are looked for on a thread, with progress and cancel, and belong to one plan:
//! with that they go.

use super::App;
use super::worker::Outcome;
use crate::cell::Setup;
use crate::cell::motion::Arm;
use crate::cell::motion::advice::BetterSetup;
use crate::document::Edit;
use crate::document::Job;
use crate::part::{Hasher, Part, Surfaces};
use crate::picture::{CellPicture, palette::state};
use crate::planning::Cache;
use crate::planning::Plan;
use crate::planning::advice;
use crate::progress::{Cancelled, Progress};
use crate::view::{Depth, PointItem};
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// Colour of a target that is within reach, in a preview.
pub(super) const WITHIN: [u8; 3] = [64, 178, 255];
/// And of one that is not.
pub(super) const OUT_OF_REACH: [u8; 3] = state::BLOCKED;

/// What is known of help, and the number of the plan that it is for.
#[derive(Default)]
pub struct Remedy {
    /// Of a search that was cancelled nothing is known.
    advice: Option<(u64, Result<Vec<String>, Cancelled>)>,
    advising: Option<Search>,
    /// `None` in it: there is no better one.
    proposal: Option<(u64, Option<Arc<Proposal>>)>,
    proposing: Option<Search>,
}

/// A search on its thread.
pub struct Search {
    /// The plan that it is for.
    pub of: u64,
    /// How far it is, and its end.
    pub progress: Arc<Progress>,
}

impl Search {
    /// A search for the plan of that number.
    pub fn new(of: u64) -> (Search, Arc<Progress>) {
        let progress = Arc::new(Progress::default());
        (Search { of, progress: progress.clone() }, progress)
    }
}

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

/// What a search takes with it.
struct Ingredients {
    part: Arc<Part>,
    plan: Arc<Plan>,
    job: Job,
    setup: Setup,
}

impl Proposal {
    fn new(
        i: &Ingredients,
        surfaces: &Surfaces,
        cache: &Cache,
        progress: &Progress,
    ) -> Result<Option<Proposal>, Cancelled> {
        let Ingredients { part, plan, job, setup } = i;
        let better = advice::better_setup(part, surfaces, plan, job, setup, cache, progress)?;
        let Some((found, left)) = better else { return Ok(None) };
        let cell = advice::applied(&job.cell, setup.mount, &found);
        let mut setup = setup.clone();
        cell.put_frames(&mut setup.cell);
        let spots = advice::spots(&found, job.beam.defocus_mm);
        let points = [(true, WITHIN, 6.0), (false, OUT_OF_REACH, 9.0)]
            .map(|(kind, color, size_px)| points(spots.iter().filter(|s| s.1 == kind).map(|s| s.0), color, size_px));
        let refused = [left, plan.refusals.len()];
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
    /// Whether the plan is of the job as it is.
    pub(super) fn has_current_plan(&self) -> bool {
        self.derived.plan.is_some() && self.derived.plan_of.as_ref() == Some(self.document.job())
    }

    /// Whether the robot refuses anything of the plan.
    pub(super) fn has_refusals(&self) -> bool {
        self.has_current_plan() && self.derived.plan.as_ref().is_some_and(|(plan, _)| !plan.refusals.is_empty())
    }

    /// What would help with the plan as it is; `None`: that is being looked for.
    pub(super) fn advice(&self) -> Option<Result<&[String], Cancelled>> {
        let known = self.derived.remedy.advice.as_ref().filter(|(of, _)| *of == self.derived.plan_count);
        known.map(|(_, told)| told.as_deref().map_err(|e| *e))
    }

    /// The set-up that is proposed for the plan as it is.
    pub(super) fn proposal(&self) -> Option<&Arc<Proposal>> {
        let (of, proposal) = self.derived.remedy.proposal.as_ref()?;
        proposal.as_ref().filter(|_| *of == self.derived.plan_count && self.has_current_plan())
    }

    /// Whether one was looked for in vain.
    pub(super) fn has_no_proposal(&self) -> bool {
        matches!(&self.derived.remedy.proposal, Some((of, None)) if *of == self.derived.plan_count)
            && self.has_current_plan()
    }

    /// Whether a set-up for the plan as it is is being looked for.
    pub(super) fn is_proposing(&self) -> bool {
        self.derived.remedy.proposing.as_ref().is_some_and(|s| s.of == self.derived.plan_count)
            && self.has_current_plan()
    }

    /// The search that is shown: one that was asked for before one that nobody asked for.
    pub(super) fn search(&self) -> Option<&Progress> {
        let r = &self.derived.remedy;
        r.proposing.as_ref().or(r.advising.as_ref()).map(|s| &*s.progress)
    }

    /// Ends all of them.
    pub(super) fn end_searches(&self) {
        let r = &self.derived.remedy;
        r.advising.iter().chain(&r.proposing).for_each(|s| s.progress.cancel());
        self.end_dose();
    }

    /// Looks for what would help, one plan at a time, and ends searches for plans that are no more.
    pub(super) fn sync_advice(&mut self) {
        let stale = |s: &&Search| s.of != self.derived.plan_count || !self.has_current_plan();
        let r = &self.derived.remedy;
        r.advising.iter().chain(&r.proposing).filter(stale).for_each(|s| s.progress.cancel());
        if r.advising.is_some() || !self.has_refusals() || self.advice().is_some() {
            return;
        }
        if let Some(Ingredients { part, plan, job, setup }) = self.ingredients() {
            let of = self.derived.plan_count;
            let (search, progress) = Search::new(of);
            self.derived.remedy.advising = Some(search);
            self.worker.spawn(move || Outcome::Advised(of, advice::advice(&part, &plan, &job, &setup, &progress)));
        }
    }

    pub(super) fn advised(&mut self, of: u64, told: Result<Vec<String>, Cancelled>) {
        self.derived.remedy.advising = None;
        if of == self.derived.plan_count && self.has_current_plan() {
            self.derived.remedy.advice = Some((of, told));
        }
    }

    /// Looks for a better set-up.
    pub(super) fn propose(&mut self) {
        if let Some(ingredients) = self.ingredients() {
            let (surfaces, cache) = (self.derived.surfaces.clone(), self.derived.cache.clone());
            let of = self.derived.plan_count;
            self.derived.remedy.proposal = None;
            let (search, progress) = Search::new(of);
            if let Some(before) = self.derived.remedy.proposing.replace(search) {
                before.progress.cancel();
            }
            self.worker.spawn(move || {
                let proposal = Proposal::new(&ingredients, &surfaces, &cache, &progress);
                Outcome::Proposed(of, proposal.map(|found| found.map(Arc::new)))
            });
        }
    }

    pub(super) fn proposed(&mut self, of: u64, proposal: Result<Option<Arc<Proposal>>, Cancelled>) {
        if self.derived.remedy.proposing.take_if(|s| s.of == of).is_some() {
            self.derived.remedy.proposal = proposal.ok().map(|found| (of, found));
        }
    }

    /// Takes the proposed set-up into the job.
    pub(super) fn apply_proposal(&mut self) {
        let Some(proposal) = self.proposal().cloned() else { return };
        let cell = advice::applied(&self.document.job().cell, proposal.setup.mount, &proposal.found);
        self.derived.remedy.proposal = None;
        self.edit(Edit::Frames(Box::new(cell)));
    }

    /// Forgets the proposed set-up; whether there was one.
    pub(super) fn dismiss_proposal(&mut self) -> bool {
        let there = self.proposal().is_some() || self.has_no_proposal();
        self.derived.remedy.proposal = None;
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

    fn ingredients(&self) -> Option<Ingredients> {
        let d = &self.derived;
        let (Some((plan, _)), Some(job), Some((_, Ok(setup)))) = (&d.plan, &d.plan_of, &d.setup) else { return None };
        Some(Ingredients { part: d.part.clone()?, plan: plan.clone(), job: job.clone(), setup: setup.clone() })
    }
}
