//! Layers of a build-up: each is planned on the part as those before have made it. Passes that grind something off go the
//! same way downwards: each is planned on the part as it leaves it, and before the first one everything still stands.
//!
//! The beads of a layer itself are not part of that shape: whether the beam of a later line hits a bead of the same
//! layer is not checked.

use super::surface_plan::{
    PlanCache, PlanCacheContents, SurfacePlan, plan_surface, poses_key, raster, rules_of, with_process_settings,
    with_ways,
};
use super::toolpath::{self, Toolpath};
use crate::cell::Setup;
use crate::document::model::{GrindingStrategy, Job};
use crate::part::ground::Ground;
use crate::part::growth::{Folds, laid_on};
use crate::part::patched::{after_layers, before_pass};
use crate::part::{Digest, GrownPart, GrowthError, Part, Surfaces};
use crate::path::along_rim::along_rim;
use crate::path::back_and_forth::{REACH_IN_SPACINGS, back_and_forth};
use crate::path::normals::VertexNormals;
use crate::path::planes::{self, PlaneRaster};
use crate::path::{Order, SurfacePlanes, TransversalLine};
use crate::planning::error::PlanError;
use crate::progress::{Activity, Cancelled, Progress};
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The jobs of surfaces, by their numbers.
pub(in super::super) type SurfaceJobs<'a> = BTreeMap<u32, Cow<'a, Job>>;

/// How many layers the thickest build-up has, or grinding passes the highest bead, with the part before the first one.
pub(in super::super) fn layer_count(surfaces: &Surfaces, own: &SurfaceJobs<'_>) -> u32 {
    own.iter().map(|(&n, job)| layers_of(surfaces, n, job).end).max().unwrap_or(1)
}

/// The layers in which a surface is worked. A bead that is ground off is not touched in layer 0, where it stands.
fn layers_of(surfaces: &Surfaces, number: u32, job: &Job) -> Range<u32> {
    match surfaces.ground(number).filter(|ground| ground.is_bead()) {
        Some(ground) => 1..ground.passes() + 1,
        None => 0..job.layer_count(),
    }
}

/// The part and its surfaces after each layer, on which the next one is planned: each surface has grown by its layers so
/// far. What is ground off has shrunk by its passes so far, and has the facets that the last of them grinds. Empty where
/// nothing is laid on or ground off.
///
/// # Errors
/// A surface that is too hollow for its build-up; [`PlanError::Cancelled`] when `progress` says so.
pub(in super::super) fn grown_parts(
    part: &Part,
    surfaces: &Surfaces,
    own: &SurfaceJobs<'_>,
    progress: &Progress,
) -> Result<Vec<Arc<GrownPart>>, PlanError> {
    let is_ground = own.keys().any(|&n| surfaces.ground(n).is_some_and(Ground::is_bead));
    let last = match own.values().any(|j| j.section_of_bead().is_some()) {
        true => layer_count(surfaces, own),
        false if is_ground => layer_count(surfaces, own) - 1,
        false => 0,
    };
    let made: Vec<_> = (1..=last)
        .into_par_iter()
        .map(|layer| {
            progress.check()?;
            let height_mm = |facet: u32, vertex: u32| {
                let surface = surfaces.of_facet[facet as usize];
                let own = own.get(&surface)?;
                if let Some(ground) = surfaces.ground(surface) {
                    return Some(ground.standing_mm(vertex, layer)? - ground.standing_mm(vertex, 0)?);
                }
                let layers = layer.min(own.layer_count());
                let whole_mm = own.bead.height_mm * f64::from(layers);
                // A patch is filled, and no more.
                surfaces.fill(surface).map_or(Some(whole_mm), |fill| fill.filled_mm(vertex, layers))
            };
            // What is filled becomes its model again, which is no fold; slivers along contours would pass for some.
            let is_plain = surfaces.fills.is_empty() && surfaces.grounds.is_empty();
            let folds = if is_plain { Folds::AreRefused } else { Folds::AreTaken };
            let made = laid_on(part, surfaces, &height_mm, folds, progress).map_err(|e| match e {
                GrowthError::Folds(surface) => PlanError::Folds { surface, layers: layer },
                GrowthError::Cancelled => PlanError::Cancelled,
            })?;
            let surfaces = after_layers(&made.part.mesh, made.surfaces, layer);
            let surfaces = if is_ground { before_pass(&made.part.mesh, surfaces, layer) } else { surfaces };
            Ok(Arc::new(GrownPart { part: made.part, surfaces }))
        })
        .collect();
    // The lowest layer that folds is the one to tell, whichever thread was first.
    made.into_iter().collect()
}

/// What one layer is planned from.
#[derive(Clone, Copy)]
pub(in super::super) struct LayerInput<'a> {
    /// The part as it has grown when the layer begins.
    pub(in super::super) part: &'a Part,
    /// Its surfaces, grown with it.
    pub(in super::super) surfaces: &'a Surfaces,
    /// Numbers of the surfaces to work on, in the order of work.
    pub(in super::super) list: &'a [u32],
    /// Their jobs.
    pub(in super::super) jobs: &'a SurfaceJobs<'a>,
    /// Layer of the build-up, from 0.
    pub(in super::super) layer: u32,
}

/// The planes of the surfaces of one layer.
pub(in super::super) fn families(of: &LayerInput<'_>) -> Vec<SurfacePlanes> {
    let jobs = of.list.iter().filter_map(|n| Some((*n, of.jobs.get(n)?)));
    let rasters: Vec<PlaneRaster> = jobs
        .filter(|(n, job)| layers_of(of.surfaces, *n, job).contains(&of.layer))
        .map(|(n, job)| raster(n, job))
        .collect();
    // All stand on the one part.
    let placement = of.jobs.values().next().map(|job| job.part.placement).unwrap_or_default();
    planes::planes(&of.part.mesh, of.surfaces, &rasters, &placement.isometry().rotation.to_rotation_matrix())
}

/// The toolpaths of one layer, each with the digest of all that it depends on.
pub(in super::super) fn layer_toolpaths(
    of: &LayerInput<'_>,
    cache: &PlanCache,
    progress: &Progress,
) -> Result<Vec<(Digest, Arc<Toolpath>)>, Cancelled> {
    let LayerInput { part, surfaces, jobs, layer, .. } = *of;
    let default = Job::default();
    let job_of = |n: u32| jobs.get(&n).map_or(&default, |j| j);
    let families = families(of);
    progress.begin(Activity::LayingLines, families.len());
    let toolpaths = families.into_par_iter().map(|family| {
        let toolpath = cache.toolpath((part, surfaces), family, job_of, layer, progress)?;
        progress.step()?;
        Ok(toolpath)
    });
    Ok(toolpaths.collect::<Result<Vec<Option<_>>, Cancelled>>()?.into_iter().flatten().collect())
}

/// The lines of a surface that is ground as the tool runs them: it stays on the surface from line to line of a zigzag, and
/// along the rim where that cuts a spiral.
fn without_lifting(
    of: &LayerInput<'_>,
    number: u32,
    job: &Job,
    lines: Vec<TransversalLine>,
    progress: &Progress,
) -> Result<Vec<TransversalLine>, Cancelled> {
    let (mesh, surfaces) = (&of.part.mesh, of.surfaces);
    let (Some(ground), Some(surface)) = (surfaces.ground(number), surfaces.get(number)) else { return Ok(lines) };
    match job.weld.strategy_of(ground.is_bead()) {
        GrindingStrategy::Zigzag => Ok(back_and_forth(lines, REACH_IN_SPACINGS * job.layers.spacing_mm)),
        GrindingStrategy::Spiral => {
            let normals = VertexNormals::new_under(progress, mesh, surfaces, surface)?;
            Ok(along_rim(mesh, surface, &normals, lines))
        }
        GrindingStrategy::OneWay | GrindingStrategy::Along => Ok(lines),
    }
}

/// Plans one layer, its surfaces in the order of work. The pieces that it is made of go into `used`.
pub(in super::super) fn plan_layer(
    of: &LayerInput<'_>,
    setup: &Setup,
    cache: &PlanCache,
    used: &mut PlanCacheContents,
    progress: &Progress,
) -> Result<Vec<Arc<SurfacePlan>>, PlanError> {
    let (part, jobs, tool) = (of.part, of.jobs, &setup.tool);
    let default = Job::default();
    let job_of = |n: u32| jobs.get(&n).map_or(&default, |j| j);
    let toolpaths = layer_toolpaths(of, cache, progress)?;
    // Where a surface begins may depend on where the one before ends.
    let (mut spot, mut lines) = (None, Vec::with_capacity(toolpaths.len()));
    for (key, toolpath) in &toolpaths {
        let job = job_of(toolpath.surface);
        let mut ordered = toolpath::ordered(toolpath, &job.layers, spot.as_ref());
        ordered.lines = without_lifting(of, toolpath.surface, job, ordered.lines, progress)?;
        let from = spot;
        spot = toolpath::end_of(&ordered.lines).or(spot);
        lines.push((*key, from, toolpath.clone(), ordered));
    }
    progress.begin(Activity::Planning, lines.iter().map(|l| l.3.lines.len()).sum());
    let planned: Vec<(Digest, Arc<SurfacePlan>)> = lines
        .into_par_iter()
        .map(|(key, from, toolpath, ordered)| {
            let job = job_of(toolpath.surface);
            let rules = rules_of(toolpath.surface, job);
            let from = from.filter(|_| job.layers.order == Order::Shortest);
            let key = poses_key(key, from, job, &rules, tool);
            let ways_mm = (ordered.way_mm, ordered.zigzag_way_mm);
            let made = match cache.get(&key) {
                Some(known) => known,
                None => Arc::new(plan_surface(part, toolpath, ordered, job, tool, &rules, progress)?),
            };
            Ok((key, with_ways(with_process_settings(made, job, tool), ways_mm)))
        })
        .collect::<Result<_, PlanError>>()?;
    let surface_plans = planned.iter().map(|(_, p)| p.clone()).collect();
    used.plans.extend(planned);
    used.toolpaths.extend(toolpaths);
    Ok(surface_plans)
}
