//! What a job asks for, checked before anything is computed: numbers, surfaces, and how large the plan would be.

use super::build_up::SurfaceJobs;
use super::surface_plan::max_gap_mm;
use crate::document::model::{BeadParameters, GrindingStrategy, Job};
use crate::part::ground::Ground;
use crate::part::{Part, SurfaceId, Surfaces};
use crate::path::{Order, Strategy};
use crate::planning::error::PlanError;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The surfaces to clean and the job of each, checked.
pub(in super::super) fn prepare<'a>(
    part: &Part,
    surfaces: &Surfaces,
    job: &'a Job,
) -> Result<(Vec<u32>, SurfaceJobs<'a>), PlanError> {
    job.check()?;
    let list = chosen(surfaces, job)?;
    let size_mm = part.mesh.diagonal();
    let mut own: SurfaceJobs<'_> = list.iter().map(|&n| (n, job.of_surface(SurfaceId(n)))).collect();
    for (n, own) in &mut own {
        // How often a patch is filled follows from its depth.
        if let Some(fill) = surfaces.fill(*n) {
            let own = own.to_mut();
            (own.bead.height_mm, own.bead.layers) = (fill.bead_mm, fill.layers);
        }
        if let Some(ground) = surfaces.ground(*n) {
            grind(own.to_mut(), ground);
        }
    }
    if let Some(spacing_mm) = own.values().map(|j| j.layers.spacing_mm).find(|mm| *mm > size_mm) {
        return Err(PlanError::SpacingTooLarge { spacing_mm, size_mm });
    }
    bound_size(surfaces, &own, size_mm)?;
    Ok((list, own))
}

/// Lays the lines of a surface that is ground as the job's weld says; those along a centre line need no more.
fn grind(own: &mut Job, ground: &Ground) {
    let strategy = own.weld.strategy_of(ground.is_bead());
    let layers = &mut own.layers;
    (layers.strategy, layers.order) = match strategy {
        GrindingStrategy::OneWay => (Strategy::Planes, Order::OneWay),
        GrindingStrategy::Spiral => (Strategy::Spiral, Order::Zigzag),
        GrindingStrategy::Zigzag | GrindingStrategy::Along => (Strategy::Planes, Order::Zigzag),
    };
    own.bead = BeadParameters::default();
}

/// Numbers of the surfaces to clean, checked.
fn chosen(surfaces: &Surfaces, job: &Job) -> Result<Vec<u32>, PlanError> {
    let list = job.chosen(surfaces);
    // Where a scan shows no wear there is nothing to do, and that is no mistake.
    if list.is_empty() && surfaces.worked.is_none() {
        return Err(PlanError::Nothing);
    }
    if let Some(&surface) = list.iter().find(|n| surfaces.get(**n).is_none()) {
        let last = surfaces.list.last().map_or(0, |s| s.number);
        return Err(PlanError::NoSurface { surface, last });
    }
    Ok(list)
}

/// Refuses what no machine's memory would hold, before anything is allocated.
fn bound_size(surfaces: &Surfaces, own: &BTreeMap<u32, Cow<'_, Job>>, size_mm: f64) -> Result<(), PlanError> {
    // A hundred metres: no robot reaches that, and one flipped bit of a coordinate gives more.
    if size_mm > 1e5 || size_mm.is_nan() {
        return Err(PlanError::PartTooLarge { size_mm });
    }
    // Every plane is cut through every surface at least once.
    let points_of = |(&n, job): (&u32, &Cow<'_, Job>)| {
        let (spacing_mm, gap_mm) = (job.layers.spacing_mm, max_gap_mm(job));
        (surfaces.get(n).map_or(0.0, |s| s.area_mm2) / (spacing_mm * gap_mm) + size_mm / spacing_mm)
            * f64::from(job.layer_count())
    };
    let points: f64 = own.iter().map(points_of).sum();
    let spacing_mm = own.values().map(|j| j.layers.spacing_mm).fold(f64::INFINITY, f64::min);
    if points > MOST_POINTS {
        return Err(PlanError::SpacingTooSmall { spacing_mm, points });
    }
    Ok(())
}

/// Points of dense lines: a square metre at P1's spacing has 8 million, and takes a minute or two.
const MOST_POINTS: f64 = 5e8;
