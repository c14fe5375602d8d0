//! One surface's share of a plan: its lines become passes. What has not changed is taken from the cache.

use super::toolpath::{Ordered, Toolpath, ToolpathRules, plan_toolpath};
use crate::beam::{Abrasive, Optics, ProcessSettings, Tool, ToolConfiguration, ToolGeometry, WorkingMedium};
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::surfaces::Surface;
use crate::part::{Digest, Hasher, Part, SurfaceId, Surfaces, keyed};
use crate::path::chord::ChordLimits;
use crate::path::planes::PlaneRaster;
use crate::path::{SurfacePlanes, dense};
use crate::planning::error::PlanError;
use crate::pose::{Correction, LineOnSurface, LineRules, Pass, TargetState, plan_line, plan_line_by_section_plane};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

/// A surface's share of a plan.
#[derive(Clone, Debug)]
pub struct SurfacePlan {
    /// Its lines.
    pub toolpath: Arc<Toolpath>,
    /// Length of the way between its lines, mm, and from the surface before.
    pub way_mm: f64,
    /// Length of the way in a plain zigzag, mm.
    pub zigzag_way_mm: f64,
    /// Its passes in working order, once each.
    pub passes: Vec<Pass>,
    /// Where the clearance search was used: for each pass that interferes, what the correction in the section plane makes
    /// of it within the same limits.
    pub by_section_plane: Option<Vec<Option<Pass>>>,
}

/// Surface plans and toolpaths by the digest of all that they depend on.
#[derive(Debug, Default)]
pub struct PlanCache(Mutex<PlanCacheContents>);

/// What one plan was made of.
#[derive(Debug, Default)]
pub(in super::super) struct PlanCacheContents {
    pub(in super::super) plans: BTreeMap<Digest, Arc<SurfacePlan>>,
    pub(in super::super) toolpaths: BTreeMap<Digest, Arc<Toolpath>>,
}

impl PlanCache {
    pub(in super::super) fn get(&self, key: &Digest) -> Option<Arc<SurfacePlan>> {
        self.0.lock().ok()?.plans.get(key).cloned()
    }

    /// The lines of the surface of a family in a layer, by the job of that surface; `None`: there is no such surface.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub(in super::super) fn toolpath<'a>(
        &self,
        (part, surfaces): (&Part, &Surfaces),
        family: SurfacePlanes,
        job_of: impl Fn(u32) -> &'a Job,
        layer: u32,
        progress: &Progress,
    ) -> Result<Option<(Digest, Arc<Toolpath>)>, Cancelled> {
        let Some(surface) = surfaces.get(family.surface) else { return Ok(None) };
        let by = ToolpathRules::new(surfaces, surface.number, job_of(surface.number), layer);
        let key = toolpath_key(part, surfaces, surface, &family, &by);
        let known = self.0.lock().ok().and_then(|kept| kept.toolpaths.get(&key).cloned());
        let toolpath = match known {
            Some(known) => known,
            None => Arc::new(plan_toolpath(part, surfaces, surface, family, &by, progress)?),
        };
        Ok(Some((key, toolpath)))
    }

    /// Keeps toolpaths for the plan to come.
    pub(in super::super) fn add_toolpaths(&self, toolpaths: &[(Digest, Arc<Toolpath>)]) {
        if let Ok(mut kept) = self.0.lock() {
            kept.toolpaths.extend(toolpaths.iter().cloned());
        }
    }

    /// Keeps what the newest plan uses, and nothing else.
    pub(in super::super) fn keep(&self, used: PlanCacheContents) {
        if let Ok(mut kept) = self.0.lock() {
            *kept = used;
        }
    }
}

/// The key of a surface's toolpath: a digest of all that its lines depend on.
fn toolpath_key(
    part: &Part,
    surfaces: &Surfaces,
    surface: &Surface,
    planes: &SurfacePlanes,
    by: &ToolpathRules<'_>,
) -> Digest {
    let measured = surfaces.measured.as_ref().map(|m| m.digest);
    let key = Hasher::default().of(&part.digest).u32s(&surface.facets).of(planes).of(by).of(&measured).finish();
    if by.layers.inset_mm >= 0.0 {
        return key;
    }
    // Lines that run on over the rim see the surfaces around, and which side of them is worked on.
    let turned = (0u32..).zip(&surfaces.normals).filter(|(f, n)| part.mesh.normals.get(*f as usize) != Some(*n));
    let turned: Vec<u32> = turned.map(|(f, _)| f).collect();
    Hasher::default().of(&key).of(&surfaces.of_facet).of(&turned).finish()
}

/// The planes that a surface's job wants.
pub(in super::super) fn raster(surface: u32, job: &Job) -> PlaneRaster {
    let l = &job.layers;
    PlaneRaster { surface, direction: l.direction, spacing_mm: l.spacing_mm, offset_mm: l.offset_mm.mm() }
}

/// What the lines of a surface are planned by.
pub(in super::super) fn rules_of(surface: u32, job: &Job) -> LineRules {
    let own = job.settings.of(SurfaceId(surface));
    LineRules {
        max_gap_mm: max_gap_mm(job),
        max_dense_turn_deg: dense::MAX_TURN_DEG.min(job.path.max_turn_deg),
        chord: ChordLimits {
            chord_error_mm: job.path.chord_error_mm,
            max_step_mm: job.path.max_step_mm,
            max_turn_deg: job.path.max_turn_deg,
        },
        correction: job.path.correction,
        max_tilt_deg: job.path.max_tilt_deg,
        tilt_rate_deg_mm: job.path.tilt_rate_deg_mm.min(job.path.tilt_rate_deg_s / job.beam.speed_mm_s),
        tilt: own.tilt.clone(),
        pins: own.pins.clone(),
    }
}

/// Largest gap of a job's dense lines, mm.
pub(in super::super) fn max_gap_mm(job: &Job) -> f64 {
    dense::max_gap_mm(job.layers.spacing_mm).min(job.path.max_step_mm)
}

/// A surface's plan with the process settings of its job. They are not in the key of its poses: power changes no pose,
/// speed only through the tilt rate of [`rules_of`], which is in the key, and without a head neither does the defocus.
pub(in super::super) fn with_process_settings(mut made: Arc<SurfacePlan>, job: &Job, tool: &Tool) -> Arc<SurfacePlan> {
    let wanted = process_settings(job, tool);
    let own = |w: &ProcessSettings| match tool.head.as_ref().filter(|_| tool.contact.is_none()) {
        None => ProcessSettings { layer: w.layer, ..wanted },
        Some(_) => ProcessSettings { defocus_mm: w.defocus_mm, spot_mm: w.spot_mm, layer: w.layer, ..wanted },
    };
    if made.passes.iter().any(|p| p.settings != own(&p.settings)) {
        Arc::make_mut(&mut made).passes.iter_mut().for_each(|p| p.settings = own(&p.settings));
    }
    made
}

/// A surface's plan with the length of the way to and between its lines, and that of a plain zigzag. They depend on where
/// the surface before ends, which poses do not.
pub(in super::super) fn with_ways(mut made: Arc<SurfacePlan>, ways_mm: (f64, f64)) -> Arc<SurfacePlan> {
    if (made.way_mm, made.zigzag_way_mm) != ways_mm {
        let plan = Arc::make_mut(&mut made);
        (plan.way_mm, plan.zigzag_way_mm) = ways_mm;
    }
    made
}

/// The tool geometry of a job; `None`: the beam is a ray.
pub fn tool_geometry<'a>(job: &Job, setup: &'a Setup) -> Option<ToolGeometry<'a>> {
    configurations(job, &setup.tool).swap_remove(0).geometry
}

/// The tool configurations that may be tried over lines, the wanted one first, then drawn back and pushed forward by half
/// of the standoff window and by all of it.
pub(in super::super) fn configurations<'a>(job: &Job, tool: &'a Tool) -> Vec<ToolConfiguration<'a>> {
    let wanted = process_settings(job, tool);
    // What touches has no standoff.
    let lifts: &[f64] =
        if job.path.standoff_mm > 0.0 && tool.contact.is_none() { &[0.0, 0.5, 1.0, -0.5, -1.0] } else { &[0.0] };
    let lifted = |share: &f64| wanted.lifted(&job.optics, share * job.path.standoff_mm);
    lifts.iter().map(|s| ToolConfiguration::new(tool, &job.optics, lifted(s), job.beam.margin_mm)).collect()
}

/// The process settings of a job, as its tool asks for them.
pub(in super::super) fn process_settings(job: &Job, tool: &Tool) -> ProcessSettings {
    let b = &job.beam;
    let light = ProcessSettings {
        defocus_mm: b.defocus_mm,
        spot_mm: b.spot_mm,
        speed_mm_s: b.speed_mm_s,
        power_w: b.power_w,
        frequency_khz: b.frequency_khz,
        lead_in_mm: job.path.lead_in_mm,
        lead_out_mm: job.path.lead_out_mm,
        ..ProcessSettings::default()
    };
    let Some(grinding) = &tool.contact else { return light };
    ProcessSettings {
        defocus_mm: grinding.place().defocus_mm,
        power_w: 0.0,
        frequency_khz: 0.0,
        lead_in_mm: 0.0,
        lead_out_mm: 0.0,
        arc_mm: grinding.arc_mm,
        force_n: grinding.force_n,
        medium: match grinding.tool.abrasive {
            Abrasive::Disc { .. } => WorkingMedium::Disc,
            Abrasive::Belt { .. } => WorkingMedium::Belt,
        },
        ..light
    }
}

/// Makes the passes of a surface.
pub(in super::super) fn plan_surface(
    part: &Part,
    toolpath: Arc<Toolpath>,
    ordered: Ordered,
    job: &Job,
    tool: &Tool,
    rules: &LineRules,
    progress: &Progress,
) -> Result<SurfacePlan, PlanError> {
    let is_searched = rules.correction == Correction::Clearance;
    let configurations = configurations(job, tool);
    let both = ordered
        .lines
        .par_iter()
        .enumerate()
        .map(|(number, line)| {
            progress.step()?;
            let line =
                LineOnSurface { line, surface: toolpath.surface, number: number as u32, m: toolpath.plane_of(line) };
            let mut pass = plan_line(part, &configurations, &line, rules, progress)?;
            pass.settings.layer = toolpath.layer;
            let interferes = pass.targets.iter().any(|t| t.normal_hits.is_some() || t.state != TargetState::Free);
            let other = (is_searched && interferes)
                .then(|| plan_line_by_section_plane(part, &configurations[0], &line, rules, progress))
                .transpose()?;
            Ok((pass, other))
        })
        .collect::<Result<Vec<(Pass, Option<Pass>)>, Cancelled>>()?;
    let (passes, others): (Vec<_>, Vec<_>) = both.into_iter().unzip();
    Ok(SurfacePlan {
        toolpath,
        way_mm: ordered.way_mm,
        zigzag_way_mm: ordered.zigzag_way_mm,
        passes,
        by_section_plane: is_searched.then_some(others),
    })
}

/// All that the poses of a surface depend on, beside its lines.
struct PosingRules<'a> {
    /// Where the first line begins may depend on where the surface before ends.
    spot: Option<Point3<f64>>,
    spacing_mm: f64,
    rules: &'a LineRules,
    standoff_mm: f64,
    tool: &'a Tool,
    width: Option<BeamWidth<'a>>,
}

keyed!(PosingRules<'_> { spot, spacing_mm, rules, standoff_mm, tool, width });

/// How wide the beam is, where it has a width: a ray has no focus. Power changes no pose, and speed only through the
/// tilt rate of the rules.
struct BeamWidth<'a> {
    defocus_mm: f64,
    spot_mm: f64,
    margin_mm: f64,
    optics: &'a Optics,
}

keyed!(BeamWidth<'_> { defocus_mm, spot_mm, margin_mm, optics });

/// The key of a surface's plan: a digest of its toolpath and all else that its poses depend on.
pub(in super::super) fn poses_key(
    toolpath: Digest,
    spot: Option<Point3<f64>>,
    job: &Job,
    rules: &LineRules,
    tool: &Tool,
) -> Digest {
    let b = &job.beam;
    let width = BeamWidth { defocus_mm: b.defocus_mm, spot_mm: b.spot_mm, margin_mm: b.margin_mm, optics: &job.optics };
    let by = PosingRules {
        spot,
        spacing_mm: job.layers.spacing_mm,
        rules,
        standoff_mm: job.path.standoff_mm,
        tool,
        width: (tool.head.is_some() || tool.contact.is_some()).then_some(width),
    };
    Hasher::default().of(&toolpath).of(&by).finish()
}
