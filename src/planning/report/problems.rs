//! What is blocked or missed, and why.

use crate::cell::motion::{Cause, Why};
use crate::part::Surfaces;
use crate::planning::plan::Plan;
use crate::planning::surface_plan::SurfacePlan;
use crate::pose::{Obstruction, State};
use serde::Serialize;
use std::collections::BTreeSet;
use std::sync::Arc;

/// One thing that is not done.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Problem {
    /// Pass; null for what is missed.
    pub pass: Option<usize>,
    /// Point of the pass.
    pub point: Option<usize>,
    /// Surface.
    pub surface: u32,
    /// `beam`, `missed`, or what the robot cannot do: `robot head obstacle reach limit speed singularity`.
    pub cause: &'static str,
    /// The facet in the way.
    pub by_facet: Option<u32>,
    /// Its surface.
    pub by_surface: Option<u32>,
    /// What stands against it, where a move or the robot does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<Why>,
}

/// Blocked targets in program order, then missed surfaces.
pub fn problems(plan: &Plan, surfaces: &Surfaces) -> Vec<Problem> {
    let mut out = Vec::new();
    let mut refusals = plan.refusals.iter().peekable();
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate().filter(|(_, t)| t.state == State::Blocked) {
            let refused = refusals.next_if(|r| (r.pass, r.point) == (number, point));
            let wall = if refused.is_some() { None } else { t.normal_hits };
            let by_facet = wall.and_then(|b| match b.obstruction {
                Obstruction::Facet(f) => Some(f),
                Obstruction::Clamp(_) => None,
            });
            let cause = refused.map(|r| r.cause).or(wall.map(|b| Cause::of_blocker(&b))).unwrap_or(Cause::Beam);
            out.push(Problem {
                pass: Some(number),
                point: Some(point),
                surface: pass.surface,
                cause: cause.word(),
                by_facet,
                by_surface: by_facet.map(|f| surfaces.of_facet[f as usize]),
                why: refused.map(|r| r.why.clone()),
            });
        }
    }
    let is_missed = |s: &&Arc<SurfacePlan>| s.laid.coverage.missed_area_mm2 > 0.0;
    let missed: BTreeSet<u32> = plan.surfaces.iter().filter(is_missed).map(|s| s.laid.surface).collect();
    let first = plan.surfaces.iter().filter(|s| s.laid.layer == 0).map(|s| s.laid.surface);
    for surface in first.filter(|n| missed.contains(n)) {
        out.push(Problem {
            pass: None,
            point: None,
            surface,
            cause: "missed",
            by_facet: None,
            by_surface: None,
            why: None,
        });
    }
    out
}
