//! What is blocked or missed, and why.

use crate::cell::motion::{RefusalCause, RefusalReason};
use crate::part::Surfaces;
use crate::planning::plan::Plan;
use crate::planning::surface_plan::SurfacePlan;
use crate::pose::TargetState;
use serde::{Serialize, Serializer};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A target that is left out, or a surface that is missed in part.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Problem {
    /// Pass; null for what is missed.
    pub pass: Option<usize>,
    /// Point of the pass.
    pub point: Option<usize>,
    /// Surface.
    pub surface: u32,
    /// Why.
    #[serde(serialize_with = "not_done_word")]
    pub cause: NotDone,
    /// The facet in the way.
    pub by_facet: Option<u32>,
    /// Its surface.
    pub by_surface: Option<u32>,
    /// Why a move or the robot cannot do it, where one of them is the cause.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<RefusalReason>,
}

/// Why something is not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NotDone {
    /// A target: something is in the beam's way, or the robot cannot do it.
    Blocked(RefusalCause),
    /// Area of a surface that no line reaches.
    Missed,
}

impl NotDone {
    /// The word in `report.json`.
    pub fn word(self) -> &'static str {
        match self {
            NotDone::Blocked(cause) => cause.word(),
            NotDone::Missed => "missed",
        }
    }
}

fn not_done_word<S: Serializer>(cause: &NotDone, s: S) -> Result<S::Ok, S::Error> {
    s.serialize_str(cause.word())
}

/// A cause by its word.
pub(super) fn word<S: Serializer>(cause: &RefusalCause, s: S) -> Result<S::Ok, S::Error> {
    s.serialize_str(cause.word())
}

/// Blocked targets in program order, then missed surfaces.
pub fn problems(plan: &Plan, surfaces: &Surfaces) -> Vec<Problem> {
    let mut out = Vec::new();
    let mut refusals = plan.refusals.iter().peekable();
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate().filter(|(_, t)| t.state == TargetState::Blocked) {
            let refused = refusals.next_if(|r| (r.pass, r.point) == (number, point));
            let wall = if refused.is_some() { None } else { t.normal_hits };
            let by_facet = wall.and_then(|b| b.obstruction.facet());
            let cause =
                refused.map(|r| r.cause).or(wall.map(|b| RefusalCause::of_blocker(&b))).unwrap_or(RefusalCause::Beam);
            out.push(Problem {
                pass: Some(number),
                point: Some(point),
                surface: pass.surface,
                cause: NotDone::Blocked(cause),
                by_facet,
                by_surface: by_facet.map(|f| surfaces.of_facet[f as usize]),
                why: refused.map(|r| r.why.clone()),
            });
        }
    }
    let is_missed = |s: &&Arc<SurfacePlan>| s.toolpath.coverage.missed_area_mm2 > 0.0;
    let missed: BTreeSet<u32> = plan.surfaces.iter().filter(is_missed).map(|s| s.toolpath.surface).collect();
    let first = plan.surfaces.iter().filter(|s| s.toolpath.layer == 0).map(|s| s.toolpath.surface);
    for surface in first.filter(|n| missed.contains(n)) {
        out.push(Problem {
            pass: None,
            point: None,
            surface,
            cause: NotDone::Missed,
            by_facet: None,
            by_surface: None,
            why: None,
        });
    }
    out
}
