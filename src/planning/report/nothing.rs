//! Plans that never light, and why.

use super::problem::{NotDone, Problem, word};
use super::rows::SurfaceReport;
use crate::cell::motion::RefusalCause;
use crate::planning::TakenBy;
use crate::planning::plan::Plan;
use crate::program::Step;
use serde::Serialize;

/// Why there is nothing to do.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum NothingReason {
    /// No line lies on the chosen surfaces, or none that is long enough for a move.
    NoLines {
        /// What takes the last one on most of the area; `None`: there are lines, and none is long enough.
        #[serde(flatten)]
        taken_by: Option<TakenBy>,
        /// Area of the chosen surfaces, mm².
        area_mm2: f64,
        /// What takes the last one on each surface, in the order of work.
        by: Vec<BareSurface>,
    },
    /// The scan shows no patch to work.
    NoWear,
    /// What is to be ground waits for the operator's word.
    Held,
    /// No pass of the bead is left, or none of it is chosen, and no other area.
    NothingToGrind,
    /// Every line is blocked.
    AllBlocked {
        /// By what, in the order in which it was met.
        by: Vec<BlockedBy>,
    },
}

/// A surface without a line.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BareSurface {
    /// Its number.
    pub surface: u32,
    /// What takes the last one.
    #[serde(flatten)]
    pub taken_by: TakenBy,
    /// Its area, mm².
    pub area_mm2: f64,
}

/// Blocked targets with the same cause.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BlockedBy {
    /// The cause, named as in `problems`.
    #[serde(serialize_with = "word")]
    pub cause: RefusalCause,
    /// The surface in the way.
    pub by_surface: Option<u32>,
    /// How many.
    pub targets: usize,
}

/// Whether a plan has no move with the laser on.
pub fn is_dark(plan: &Plan) -> bool {
    !plan.steps.list.iter().any(|s| matches!(s, Step::Laser(true)))
}

/// Why a plan has nothing to do; `None`: it has.
pub(super) fn nothing_planned(plan: &Plan, problems: &[Problem], rows: &[SurfaceReport]) -> Option<NothingReason> {
    if !is_dark(plan) {
        return None;
    }
    // Surfaces are chosen, or a scan or images tell them.
    if rows.is_empty() {
        return Some(match &plan.weld_report {
            Some(weld) if weld.held.is_some() => NothingReason::Held,
            Some(_) => NothingReason::NothingToGrind,
            None => NothingReason::NoWear,
        });
    }
    let mut by: Vec<BlockedBy> = Vec::new();
    for p in problems {
        let NotDone::Blocked(cause) = p.cause else { continue };
        match by.iter_mut().find(|b| (b.cause, b.by_surface) == (cause, p.by_surface)) {
            Some(b) => b.targets += 1,
            None => by.push(BlockedBy { cause, by_surface: p.by_surface, targets: 1 }),
        }
    }
    Some(if by.is_empty() { no_lines(rows) } else { NothingReason::AllBlocked { by } })
}

fn no_lines(rows: &[SurfaceReport]) -> NothingReason {
    let bare = |row: &SurfaceReport| {
        Some(BareSurface { surface: row.surface, taken_by: row.taken_by()?, area_mm2: row.area_mm2 })
    };
    let by: Vec<BareSurface> = rows.iter().filter_map(bare).collect();
    let mut areas_mm2: Vec<(TakenBy, f64)> = Vec::new();
    for one in &by {
        match areas_mm2.iter_mut().find(|(taken_by, _)| *taken_by == one.taken_by) {
            Some((_, area_mm2)) => *area_mm2 += one.area_mm2,
            None => areas_mm2.push((one.taken_by, one.area_mm2)),
        }
    }
    let most = areas_mm2.into_iter().reduce(|most, next| if next.1 > most.1 { next } else { most });
    let area_mm2 = rows.iter().map(|row| row.area_mm2).fold(0.0, |a, b| a + b);
    NothingReason::NoLines { taken_by: most.map(|(taken_by, _)| taken_by), area_mm2, by }
}
