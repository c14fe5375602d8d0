//! Changes that give lines to surfaces which have none. Each was tried on the whole job: only what gives lines, takes
//! them from no other surface and misses no more area is offered.

use super::PlanError;
use super::plan::Plan;
use super::plan::build_up::{LayerInput, families};
use super::plan::prepared::prepare;
use super::plan::preview::preview;
use super::surface_plan::PlanCache;
use super::taken_by::TakenBy;
use super::toolpath::{Toolpath, ToolpathRules, plan_toolpath};
use crate::document::{Edit, Job, LineChange};
use crate::part::{Part, SurfaceId, Surfaces};
use crate::path::ends::rim;
use crate::path::{Direction, Strategy, SurfacePlanes};
use crate::progress::{Cancelled, Progress};
use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Surfaces that a cure of their own is sought for, at most.
const MOST_SOUGHT: usize = 8;
/// Shares of a spacing that are tried, the greatest first.
const CLOSER: [f64; 5] = [0.5, 0.25, 0.1, 0.05, 0.02];
/// The share of the length of its lines that a surface is to keep when short pieces are left out.
const KEPT_SHARE: f64 = 0.9;

/// A change that was tried, and gives lines to surfaces that have none.
#[derive(Clone, Debug, PartialEq)]
pub struct Cure {
    /// The surfaces, in the order of work; the first is the one that it was sought for.
    pub surfaces: Vec<SurfaceId>,
    /// What is changed.
    pub change: LineChange,
    /// The edit that does it.
    pub edit: Edit,
}

/// What gives lines to the surfaces of a plan that have none; nothing where nothing that was tried does.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn cures(
    part: &Part,
    surfaces: &Surfaces,
    job: &Job,
    plan: &Plan,
    cache: &PlanCache,
    progress: &Progress,
) -> Result<Vec<Cure>, Cancelled> {
    let bare: Vec<(SurfaceId, TakenBy)> = plan.bare().collect();
    if bare.is_empty() {
        return Ok(Vec::new());
    }
    // The plan would not be there if this were refused.
    let Ok((list, jobs)) = prepare(part, surfaces, job) else { return Ok(Vec::new()) };
    let lowest = || plan.surfaces.iter().map(|s| &s.toolpath).filter(|t| t.layer == 0);
    let trial = Trial {
        part,
        surfaces,
        job,
        families: families(&LayerInput { part, surfaces, list: &list, jobs: &jobs, layer: 0 }),
        bare: bare.iter().map(|(surface, _)| *surface).collect(),
        lined: lowest().filter(|t| !t.lines.is_empty()).map(|t| t.surface).collect(),
        missed_mm2: lowest().map(|t| t.coverage.missed_area_mm2).fold(0.0, |a, b| a + b),
        cache,
        progress,
    };
    let mut found: Vec<Cure> = Vec::new();
    let mut sought = 0;
    for (surface, taken_by) in bare {
        if sought < MOST_SOUGHT && !found.iter().any(|cure| cure.surfaces.contains(&surface)) {
            found.extend(trial.cures_of(surface, taken_by)?);
            sought += 1;
        }
    }
    Ok(found)
}

/// The job that changes are tried on.
struct Trial<'a> {
    part: &'a Part,
    surfaces: &'a Surfaces,
    job: &'a Job,
    /// The planes of its surfaces.
    families: Vec<SurfacePlanes>,
    /// Surfaces without lines.
    bare: Vec<SurfaceId>,
    /// Surfaces with lines.
    lined: Vec<u32>,
    missed_mm2: f64,
    cache: &'a PlanCache,
    progress: &'a Progress,
}

/// A change that helps, and what comes of it.
struct Tried {
    cure: Cure,
    toolpaths: Vec<Arc<Toolpath>>,
    missed_mm2: f64,
}

impl Trial<'_> {
    fn cures_of(&self, surface: SurfaceId, taken_by: TakenBy) -> Result<Vec<Cure>, Cancelled> {
        let inset = |inset_mm: f64| self.first_that_helps(surface, self.inset(surface, inset_mm)?);
        let by_strategy = || vec![LineChange::Strategy(Strategy::Planes)];
        let found = match taken_by {
            TakenBy::Direction => vec![self.direction(surface)?],
            TakenBy::Inset { inset_mm } => vec![inset(inset_mm)?],
            TakenBy::Holes { inset_mm } => {
                let holes = self.ignored_holes(surface)?.map(LineChange::IgnoredHoles);
                vec![self.first_that_helps(surface, holes)?, inset(inset_mm)?]
            }
            TakenBy::Shortest { .. } => {
                let shortest = self.shortest_mm(surface)?.map(LineChange::Shortest);
                vec![self.first_that_helps(surface, shortest)?]
            }
            TakenBy::Spacing { spacing_mm } | TakenBy::Turn { spacing_mm } => {
                let closer = CLOSER.map(|share| LineChange::Spacing(rounded_down(share * spacing_mm)));
                vec![self.first_that_helps(surface, closer.into_iter().chain(by_strategy()))?]
            }
            TakenBy::Border { .. } => {
                let changes = [LineChange::WholeOutline].into_iter().chain(by_strategy());
                vec![self.first_that_helps(surface, changes)?]
            }
            TakenBy::Facets => Vec::new(),
        };
        Ok(found.into_iter().flatten().collect())
    }

    /// `auto`; or the axis that it comes to on the surface, where that does as well for all the job.
    fn direction(&self, surface: SurfaceId) -> Result<Option<Cure>, Cancelled> {
        let Some(auto) = self.tried(surface, LineChange::Direction(Direction::Auto))? else { return Ok(None) };
        let normal = auto.toolpaths.iter().find(|t| t.surface == surface.0).map(|t| t.normal);
        let is_same = |axis: &Direction| matches!(axis, Direction::Along(v) if Some(Vector3::from(*v)) == normal);
        let axis = Direction::AXES.map(|(_, axis)| axis).into_iter().find(is_same);
        let by_axis = axis.map(|axis| self.tried(surface, LineChange::Direction(axis))).transpose()?.flatten();
        let as_good = by_axis.filter(|axis| axis.missed_mm2 <= auto.missed_mm2);
        Ok(Some(as_good.unwrap_or(auto).cure))
    }

    /// The greatest smaller inset that leaves a surface lines.
    fn inset(&self, surface: SurfaceId, inset_mm: f64) -> Result<Option<LineChange>, Cancelled> {
        let places = places(inset_mm.abs());
        let steps = (inset_mm * power_of_ten(places)).ceil() - 1.0;
        if !(0.0..1000.0).contains(&steps) {
            return Ok(None);
        }
        let value = |step: u32| f64::from(step) / power_of_ten(places);
        let has_lines = |step| Ok(!self.lengths_mm(surface, LineChange::Inset(value(step)))?.is_empty());
        Ok(greatest(steps as u32, has_lines)?.map(|step| LineChange::Inset(value(step))))
    }

    /// The least width of holes to pass over with which a surface has lines, mm.
    fn ignored_holes(&self, surface: SurfaceId) -> Result<Option<f64>, Cancelled> {
        let Some(of) = self.surfaces.get(surface.0) else { return Ok(None) };
        let loops = rim(&self.part.mesh, of).loops;
        let mut widths: Vec<f64> = loops
            .iter()
            .filter(|l| l.is_hole())
            .map(|l| rounded_down(l.length_mm / std::f64::consts::PI * 1.1))
            .collect();
        // From the greatest: fewer and fewer holes are passed over.
        widths.sort_by(|a, b| b.total_cmp(a));
        widths.dedup();
        let Some(last) = widths.len().checked_sub(1) else { return Ok(None) };
        let has_lines =
            |at: u32| Ok(!self.lengths_mm(surface, LineChange::IgnoredHoles(widths[at as usize]))?.is_empty());
        Ok(greatest(last as u32, has_lines)?.map(|at| widths[at as usize]))
    }

    /// The greatest length from which pieces are to be kept so that nearly all lines of a surface are left, mm.
    fn shortest_mm(&self, surface: SurfaceId) -> Result<Option<f64>, Cancelled> {
        let mut lengths = self.lengths_mm(surface, LineChange::Shortest(0.0))?;
        lengths.sort_by(|a, b| b.total_cmp(a));
        let whole: f64 = lengths.iter().sum();
        let mut kept = 0.0;
        let is_enough = |mm: &f64| {
            kept += mm;
            kept >= KEPT_SHARE * whole
        };
        // A sum of exactly 40 mm may come out a little less, and counts as 40.
        Ok(lengths.iter().copied().find(is_enough).map(|mm| rounded_down(mm + 1e-10)))
    }

    /// Lengths of the lines that a surface has with a change of their ends, on the planes that it has.
    fn lengths_mm(&self, surface: SurfaceId, change: LineChange) -> Result<Vec<f64>, Cancelled> {
        if !self.progress.goes_on() {
            return Err(Cancelled);
        }
        let family = self.families.iter().find(|f| f.surface == surface.0);
        let (Some(family), Some(of)) = (family, self.surfaces.get(surface.0)) else { return Ok(Vec::new()) };
        let mut changed = self.job.clone();
        change.edit(self.job, surface).apply(&mut changed, &[]);
        let own = changed.of_surface(surface);
        let rules = ToolpathRules::new(self.surfaces, surface.0, &own, 0);
        let made = plan_toolpath(self.part, self.surfaces, of, family.clone(), &rules, self.progress)?;
        Ok(made.lines.iter().map(|line| line.length_mm()).collect())
    }

    fn first_that_helps(
        &self,
        surface: SurfaceId,
        changes: impl IntoIterator<Item = LineChange>,
    ) -> Result<Option<Cure>, Cancelled> {
        for change in changes {
            if let Some(helps) = self.tried(surface, change)? {
                return Ok(Some(helps.cure));
            }
        }
        Ok(None)
    }

    /// Lays the lines of the whole job with a change; `None`: it does not help.
    fn tried(&self, surface: SurfaceId, change: LineChange) -> Result<Option<Tried>, Cancelled> {
        let edit = change.edit(self.job, surface);
        let mut changed = self.job.clone();
        edit.apply(&mut changed, &[]);
        let toolpaths = match preview(self.part, self.surfaces, &changed, self.cache, self.progress) {
            Ok(toolpaths) => toolpaths,
            Err(PlanError::Cancelled) => return Err(Cancelled),
            Err(_) => return Ok(None),
        };
        let with_lines: BTreeMap<u32, bool> = toolpaths.iter().map(|t| (t.surface, !t.lines.is_empty())).collect();
        let has_lines = |n: &u32| with_lines.get(n).is_some_and(|has| *has);
        let missed_mm2 = toolpaths.iter().map(|t| t.coverage.missed_area_mm2).fold(0.0, |a, b| a + b);
        let helps = has_lines(&surface.0) && self.lined.iter().all(has_lines) && missed_mm2 <= self.missed_mm2;
        let others = self.bare.iter().copied().filter(|other| *other != surface && has_lines(&other.0));
        let surfaces = std::iter::once(surface).chain(others).collect();
        Ok(helps.then_some(Tried { cure: Cure { surfaces, change, edit }, toolpaths, missed_mm2 }))
    }
}

/// The greatest number up to `last` that holds, where all below one that holds do as well; `None`: 0 does not.
fn greatest(last: u32, mut holds: impl FnMut(u32) -> Result<bool, Cancelled>) -> Result<Option<u32>, Cancelled> {
    if !holds(0)? {
        return Ok(None);
    }
    let (mut low, mut beyond) = (0, last + 1);
    while beyond - low > 1 {
        let middle = low + (beyond - low) / 2;
        if holds(middle)? { low = middle } else { beyond = middle }
    }
    Ok(Some(low))
}

/// Decimal places that leave a number two digits.
fn places(value: f64) -> i32 {
    1 - libm::log10(value.max(1e-9)).floor() as i32
}

/// 10 to a power, or what divides by it as well: exact up to 22.
fn power_of_ten(places: i32) -> f64 {
    let power = (0..places.unsigned_abs()).fold(1.0, |power, _| power * 10.0);
    if places < 0 { 1.0 / power } else { power }
}

/// A number to two digits, down.
fn rounded_down(value: f64) -> f64 {
    let power = power_of_ten(places(value));
    (value * power).floor() / power
}

#[cfg(test)]
#[path = "cures_tests.rs"]
mod tests;
