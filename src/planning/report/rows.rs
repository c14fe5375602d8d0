//! Rows of the report: order of the lines, surfaces, splits.

use super::lengths::{is_blocked, is_corrected, length};
use crate::part::Surfaces;
use crate::planning::TakenBy;
use crate::planning::plan::Plan;
use crate::planning::remark::{Remark, ToolpathRemark};
use crate::planning::surface_plan::SurfacePlan;
use crate::pose::{Pass, Split};
use serde::Serialize;

/// What the order of the lines comes to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OrderReport {
    /// Length of the way between lines in a plain zigzag, mm.
    pub zigzag_way_mm: f64,
    /// Length of the way between lines in the order in which they are run, mm.
    pub way_mm: f64,
}

impl OrderReport {
    pub(super) fn new(plan: &Plan) -> OrderReport {
        let sum = |way: fn(&SurfacePlan) -> f64| plan.surfaces.iter().map(|s| way(s)).fold(0.0, |a, b| a + b);
        OrderReport { zigzag_way_mm: sum(|s| s.zigzag_way_mm), way_mm: sum(|s| s.way_mm) }
    }
}

/// One surface.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceReport {
    /// Its number.
    pub surface: u32,
    /// Its area.
    pub area_mm2: f64,
    /// Its lines, repeated ones counted again.
    pub passes: usize,
    /// Rows of `path.csv`.
    pub points: usize,
    /// Length of its moves with the laser on.
    pub work_mm: f64,
    /// The part of that length that begins or ends at a corrected target.
    pub corrected_mm: f64,
    /// Length of its passes with the laser off.
    pub blocked_mm: f64,
    /// Area that no line reaches.
    pub missed_area_mm2: f64,
    /// Least distance of its lines on the surface; null where no line runs.
    pub spacing_min_mm: Option<f64>,
    /// Greatest distance of its lines on the surface.
    pub spacing_max_mm: Option<f64>,
    /// What of its lines is not as it was wanted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<Remark>,
}

/// A row for each surface, in the order of work.
pub(super) fn surface_rows(plan: &Plan, surfaces: &Surfaces) -> Vec<SurfaceReport> {
    // Layers of one surface share its row; a bead that is ground has none in the first.
    let all = plan.surfaces.iter().map(|s| s.toolpath.surface);
    let mut rows: Vec<SurfaceReport> = Vec::new();
    for surface in all {
        if rows.iter().all(|row| row.surface != surface) {
            rows.push(SurfaceReport::new(plan, surfaces, surface));
        }
    }
    rows
}

impl SurfaceReport {
    /// What takes the last of its lines, where it has none in any layer.
    pub fn taken_by(&self) -> Option<TakenBy> {
        let taken_by = |remark: &Remark| match remark {
            Remark::Toolpath(ToolpathRemark::NoLines { taken_by, .. }) => Some(*taken_by),
            _ => None,
        };
        self.remarks.iter().find_map(taken_by).filter(|_| self.passes == 0)
    }

    fn new(plan: &Plan, surfaces: &Surfaces, surface: u32) -> SurfaceReport {
        let is_run = |p: &&Pass| p.surface == surface && !p.targets.is_empty();
        let passes: Vec<&Pass> = plan.passes.iter().filter(is_run).collect();
        let layers = || plan.surfaces.iter().map(|s| &s.toolpath).filter(|l| l.surface == surface);
        SurfaceReport {
            surface,
            area_mm2: surfaces.get(surface).map_or(0.0, |x| x.area_mm2),
            passes: passes.len(),
            points: passes.iter().map(|p| p.targets.len()).sum(),
            work_mm: length(passes.iter().copied(), |_, to| to.laser),
            corrected_mm: length(passes.iter().copied(), is_corrected),
            blocked_mm: length(passes.iter().copied(), is_blocked),
            missed_area_mm2: layers().map(|l| l.coverage.missed_area_mm2).fold(0.0, f64::max),
            spacing_min_mm: layers().filter_map(|l| l.coverage.spacing_min_mm).reduce(f64::min),
            spacing_max_mm: layers().filter_map(|l| l.coverage.spacing_max_mm).reduce(f64::max),
            remarks: plan.remarks().filter(|r| r.0.0 == surface).map(|r| r.1).collect(),
        }
    }
}
/// A pass that is split at a point, with two targets there.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SplitReport {
    /// Pass.
    pub pass: usize,
    /// The second of the two.
    pub point: usize,
    /// Surface.
    pub surface: u32,
    /// The facet that stands between.
    pub by_facet: Option<u32>,
    /// Its surface.
    pub by_surface: Option<u32>,
}

/// Where passes are split, in program order.
pub(super) fn splits(passes: &[Pass], surfaces: &Surfaces) -> Vec<SplitReport> {
    let of_pass = |(pass, p): (usize, &Pass)| -> Vec<SplitReport> {
        let report = |s: &Split| {
            let by_facet = s.wall.and_then(|b| b.obstruction.facet());
            let by_surface = by_facet.map(|f| surfaces.of_facet[f as usize]);
            SplitReport { pass, point: s.point, surface: p.surface, by_facet, by_surface }
        };
        p.splits.iter().map(report).collect()
    };
    passes.iter().enumerate().flat_map(of_pass).collect()
}
