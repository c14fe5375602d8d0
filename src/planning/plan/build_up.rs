//! Layers of a build-up: each is planned on the part as those before have made it.
//!
//! The beads of a layer itself are not part of that shape: whether the beam of a later line hits a bead of the same
//! layer is not checked.

use super::surface_plan::{
    PlanCache, PlanCacheContents, SurfacePlan, plan_surface, poses_key, raster, rules_of, with_process_settings,
    with_ways,
};
use super::toolpath::{self, Toolpath};
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::growth::{Folds, laid_on};
use crate::part::patched::after_layers;
use crate::part::{Digest, GrownPart, GrowthError, Part, Surfaces};
use crate::path::planes::{self, Raster};
use crate::path::{Order, SurfacePlanes};
use crate::planning::error::PlanError;
use crate::progress::{Activity, Cancelled, Progress};
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The jobs of surfaces, by their numbers.
pub(in super::super) type SurfaceJobs<'a> = BTreeMap<u32, Cow<'a, Job>>;

/// How many layers the thickest build-up has.
pub(in super::super) fn layer_count(own: &SurfaceJobs<'_>) -> u32 {
    own.values().map(|j| j.layer_count()).max().unwrap_or(1)
}

/// The part and its surfaces after each layer, on which the next one is planned: each surface has grown by its layers so
/// far. Empty without a bead.
///
/// # Errors
/// A surface that is too hollow for its build-up; [`PlanError::Cancelled`] when `progress` says so.
pub(in super::super) fn grown_parts(
    part: &Part,
    surfaces: &Surfaces,
    own: &SurfaceJobs<'_>,
    progress: &Progress,
) -> Result<Vec<Arc<GrownPart>>, PlanError> {
    let last = if own.values().any(|j| j.section_of_bead().is_some()) { layer_count(own) } else { 0 };
    let made: Vec<_> = (1..=last)
        .into_par_iter()
        .map(|layer| {
            progress.check()?;
            let height_mm = |facet: u32, vertex: u32| {
                let surface = surfaces.of_facet[facet as usize];
                let own = own.get(&surface)?;
                let layers = layer.min(own.layer_count());
                let whole_mm = own.bead.height_mm * f64::from(layers);
                // A patch is filled, and no more.
                surfaces.fill(surface).map_or(Some(whole_mm), |fill| fill.filled_mm(vertex, layers))
            };
            // What is filled becomes its model again, which is no fold; slivers along contours would pass for some.
            let folds = if surfaces.fills.is_empty() { Folds::AreRefused } else { Folds::AreTaken };
            let made = laid_on(part, surfaces, &height_mm, folds, progress).map_err(|e| match e {
                GrowthError::Folds(surface) => PlanError::Folds { surface, layers: layer },
                GrowthError::Cancelled => PlanError::Cancelled,
            })?;
            let surfaces = after_layers(&made.part.mesh, made.surfaces, layer);
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
    let rasters: Vec<Raster> =
        jobs.filter(|(_, job)| of.layer < job.layer_count()).map(|(n, job)| raster(n, job)).collect();
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
        let ordered = toolpath::ordered(toolpath, &job_of(toolpath.surface).layers, spot.as_ref());
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
