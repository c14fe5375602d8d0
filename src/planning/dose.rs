//! The dose of a plan, and how it is written: `dose.ply`, and its key of the report.
//!
//! It is computed apart from the plan, so that planning stays quick.

use super::error::PlanError;
use super::plan::Plan;
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::{Part, SurfaceId, Surfaces};
use crate::path::Strategy;
use crate::pose::Pass;
use crate::process::{DoseInput, DoseMap, Light, Patch, PatchCause, Spot, Thresholds, WayTime, dose as computed};
use crate::program::{MoveTiming, Step};
use crate::progress::{Cancelled, Progress};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// Key `dose` of the report. Shares of the chosen area, areas mm² and cm², J/cm².
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DoseReport {
    /// Share within the window.
    pub within: f64,
    /// Share below it.
    pub under: f64,
    /// Share above it.
    pub over: f64,
    /// Share that would get enough, but for what shades it.
    pub shaded: f64,
    /// Area of other surfaces that gets more than it may.
    pub collateral_mm2: f64,
    /// The least that counts as enough.
    pub low_j_cm2: f64,
    /// The most that does no harm.
    pub high_j_cm2: f64,
    /// What may land on other surfaces.
    pub collateral_j_cm2: f64,
    /// The other surfaces.
    pub collateral: Vec<CollateralReport>,
    /// What stays unclean, the largest patch first.
    pub not_cleanable: Vec<PatchReport>,
}

/// A patch that stays unclean.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PatchReport {
    /// Its surface.
    pub surface: u32,
    /// Its area.
    pub area_cm2: f64,
    /// `blocked`, `shaded`, `missed` or `thin`.
    #[serde(serialize_with = "word")]
    pub cause: PatchCause,
    /// What it is blocked or shaded by.
    pub by_surface: Option<u32>,
    /// A spacing below this would bring enough to a gap between lines, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub closer_than_mm: Option<f64>,
    /// Its middle, part frame.
    pub centre_mm: [f64; 3],
}

/// A surface that was not chosen and gets more than it may.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CollateralReport {
    /// Its number.
    pub surface: u32,
    /// Area above the threshold.
    pub area_mm2: f64,
    /// The greatest dose on it.
    pub greatest_j_cm2: f64,
}

/// The passes of a plan that run on the bare part: the first layer's.
fn on_the_part(plan: &Plan) -> &[Pass] {
    let first = plan.passes.iter().take_while(|p| p.settings.layer == 0).count();
    plan.passes.get(..first).unwrap_or_default()
}

/// Computes the dose of a plan; of a build-up that of its first layer, on the bare part.
///
/// # Errors
/// [`PlanError::Cancelled`] when `progress` says so.
pub fn dose(
    part: &Part,
    surfaces: &Surfaces,
    plan: &Plan,
    job: &Job,
    setup: &Setup,
    progress: &Progress,
) -> Result<DoseMap, PlanError> {
    let chosen = job.chosen(surfaces);
    let with_recipe = chosen.iter().filter(|n| job.recipe_of(SurfaceId(**n)).is_some());
    let own = with_recipe.map(|n| (*n, thresholds(&job.of_surface(SurfaceId(*n))))).collect();
    let spot = spot(job);
    let times = way_times(plan);
    let light = Light::new(on_the_part(plan), &spot, |pass, point| times.get(&(pass, point)).copied());
    let task = DoseInput { part, surfaces, clamps: &setup.tool.clamps, chosen, thresholds: thresholds(job), own };
    Ok(computed(&task, light, progress)?)
}

/// What is little and what is much where a job says nothing: against what all its passes together land on a
/// plate; a cross goes over it twice.
fn thresholds(job: &Job) -> Thresholds {
    job.dose.thresholds(power_w(job), job.beam.speed_mm_s, job.layers.spacing_mm)
}

/// The power of all passes over one place together.
fn power_w(job: &Job) -> f64 {
    job.beam.power_w * f64::from(job.layers.passes) * if job.layers.strategy == Strategy::Cross { 2.0 } else { 1.0 }
}

fn spot(job: &Job) -> Spot {
    let (b, d) = (&job.beam, &job.dose);
    Spot { profile: d.profile, line_mm: d.line_mm, spot_mm: b.spot_mm, defocus_mm: b.defocus_mm, optics: job.optics }
}

/// When the spot goes to the targets, s from the program's start. Without a robot nothing is known of moves by joints,
/// and they take no time.
fn way_times(plan: &Plan) -> BTreeMap<(usize, usize), WayTime> {
    let moves: Vec<(Option<(usize, usize)>, WayTime)> = match &plan.timeline {
        Some(timeline) => {
            timeline.stops().iter().map(|s| (s.target, WayTime { seconds: s.seconds, ends_s: s.at_s })).collect()
        }
        None => timed_moves(plan),
    };
    let mut out = BTreeMap::new();
    // Stations between two targets belong to the way to the second.
    let mut seconds = 0.0;
    for (target, time) in moves {
        seconds += time.seconds;
        if let Some(target) = target {
            out.insert(target, WayTime { seconds, ..time });
            seconds = 0.0;
        }
    }
    out
}

/// The moves that are given their seconds, one after another.
fn timed_moves(plan: &Plan) -> Vec<(Option<(usize, usize)>, WayTime)> {
    let mut ends_s = 0.0;
    let timed = |step: &Step| {
        let Step::Go(go) = step else { return None };
        let seconds = if let MoveTiming::Seconds(s) = go.timing { s } else { 0.0 };
        ends_s += seconds;
        Some((go.target, WayTime { seconds, ends_s }))
    };
    plan.steps.list.iter().filter_map(timed).collect()
}

impl DoseReport {
    /// What a dose comes to.
    pub fn new(map: &DoseMap, patches: &[Patch], surfaces: &Surfaces) -> DoseReport {
        let shares = map.shares(surfaces);
        let collateral: Vec<CollateralReport> = map
            .collateral(surfaces)
            .into_iter()
            .map(|c| CollateralReport { surface: c.surface, area_mm2: c.area_mm2, greatest_j_cm2: c.greatest_j_cm2 })
            .collect();
        DoseReport {
            within: shares.within,
            under: shares.under,
            over: shares.over,
            shaded: shares.shaded,
            collateral_mm2: collateral.iter().map(|c| c.area_mm2).fold(0.0, |a, b| a + b),
            low_j_cm2: map.thresholds.low_j_cm2,
            high_j_cm2: map.thresholds.high_j_cm2,
            collateral_j_cm2: map.thresholds.collateral_j_cm2,
            collateral,
            not_cleanable: patches.iter().map(|p| PatchReport::new(p, surfaces)).collect(),
        }
    }
}

fn word<S: Serializer>(cause: &PatchCause, s: S) -> Result<S::Ok, S::Error> {
    s.serialize_str(cause.word())
}

impl PatchReport {
    fn new(p: &Patch, surfaces: &Surfaces) -> PatchReport {
        let wall = p.shaded_by.or(p.blocker.map(|b| b.obstruction));
        PatchReport {
            surface: p.surface,
            area_cm2: 0.01 * p.area_mm2,
            cause: p.cause,
            by_surface: wall.and_then(|w| surfaces.of_facet.get(w.facet()? as usize).copied()),
            closer_than_mm: p.closer_than_mm,
            centre_mm: p.centre.coords.map(|x| x + 0.0).into(),
        }
    }

    /// Whether other values of the job would clean it.
    pub fn is_thin(&self) -> bool {
        self.cause == PatchCause::Thin
    }
}

/// What a plan leaves unclean, by its dose.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn not_cleanable(
    (part, surfaces): (&Part, &Surfaces),
    plan: &Plan,
    job: &Job,
    map: &DoseMap,
    progress: &Progress,
) -> Result<Vec<Patch>, Cancelled> {
    let mut patches = map.not_cleanable(&part.mesh, surfaces, on_the_part(plan), job.layers.spacing_mm, progress)?;
    for patch in patches.iter_mut().filter(|p| p.cause == PatchCause::Thin) {
        progress.check()?;
        patch.closer_than_mm = closer_than_mm(&job.of_surface(SurfaceId(patch.surface)), patch.gap_mm);
    }
    Ok(patches)
}

/// The spacing below which enough would land in a gap between lines. Where that is wider on the surface than between
/// the planes, by the same share.
fn closer_than_mm(job: &Job, gap_mm: f64) -> Option<f64> {
    let planned_mm = job.layers.spacing_mm;
    let apart_mm = gap_mm.max(planned_mm);
    let (power_w, speed_mm_s) = (power_w(job), job.beam.speed_mm_s);
    let enough = |spacing_mm: f64, least: f64| {
        // Without a window of its own a job asks for half of what lands on the average at its planes' spacing.
        let asked_mm = spacing_mm * planned_mm / apart_mm;
        100.0 * power_w / speed_mm_s * least >= job.dose.thresholds(power_w, speed_mm_s, asked_mm).low_j_cm2
    };
    spot(job).sufficient_spacing_mm(apart_mm, &enough).map(|mm| mm * planned_mm / apart_mm)
}

/// `dose.ply`: a point for each sample, binary little endian.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn ply(map: &DoseMap, surfaces: &Surfaces, progress: &Progress) -> Result<Vec<u8>, Cancelled> {
    let mut out = format!(
        "ply\nformat binary_little_endian 1.0\ncomment samples of the surface; mm, mm2, J/cm2; -1 degrees where nothing \
         lands\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nproperty float fluence_j_cm2\n\
         property float incidence_deg\nproperty int surface\nproperty float area_mm2\nend_header\n",
        map.samples.len()
    )
    .into_bytes();
    out.reserve(28 * map.samples.len());
    for (number, s) in map.samples.iter().enumerate() {
        progress.check_at(number)?;
        for x in s.centre.iter().chain([&s.fluence_j_cm2, &s.incidence_deg]) {
            out.extend((x + 0.0).to_le_bytes());
        }
        let surface = surfaces.of_facet.get(s.facet as usize).map_or(0, |n| *n as i32);
        out.extend(surface.to_le_bytes());
        out.extend(s.area_mm2.to_le_bytes());
    }
    Ok(out)
}
