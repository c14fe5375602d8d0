//! A plan: passes, steps, what was refused, and what is proven. How it is made, `making` says.

pub(super) mod build_up;
pub mod cell_report;
pub(super) mod prepared;
pub mod preview;
pub mod remark;
pub mod surface_plan;
pub mod taken_by;
pub mod toolpath;

use super::scanned::ScanReport;
use super::welded::{WeldOnPart, WeldReport};
use crate::cell::motion::{Choice, Refusal};
use crate::part::{GrownPart, SurfaceId};
use crate::pose::{Pass, TargetState};
use crate::program::sweep::Proof;
use crate::program::{Cuts, Steps, Timeline};
use cell_report::CellReport;
use remark::Remark;
use std::sync::Arc;
use surface_plan::SurfacePlan;
use taken_by::TakenBy;

/// A plan.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    /// By surface, in the order of work, layer after layer.
    pub surfaces: Vec<Arc<SurfacePlan>>,
    /// All passes in program order.
    pub passes: Vec<Pass>,
    /// The part as it has grown behind each layer; none where nothing is laid.
    pub grown: Vec<Arc<GrownPart>>,
    /// The program, step by step.
    pub steps: Steps,
    /// Where its lit pieces are cut because the controller takes no longer ones.
    pub cuts: Cuts,
    /// Joints and spin of every target that the robot does, and what it does not; without a robot
    /// nothing is known.
    pub choice: Option<Choice>,
    /// What was refused after the beam had been found free, and why, in program order.
    pub refusals: Vec<Refusal>,
    /// The program over time; without a robot nothing is known of moves by joints.
    pub timeline: Option<Timeline>,
    /// What is proven of its moves with the laser on.
    pub proof: Option<Proof>,
    /// The frames it was made for.
    pub cell: Option<CellReport>,
    /// The scan whose patches it works; `None`: it works surfaces of the model.
    pub scan: Option<ScanReport>,
    /// The weld that it grinds; `None`: it grinds none.
    pub weld: Option<Arc<WeldOnPart>>,
    /// What is reported of that weld.
    pub weld_report: Option<Arc<WeldReport>>,
}

impl Plan {
    /// What of lines and program is not as it was wanted, by surface: a layer's after those below it.
    pub fn remarks(&self) -> impl Iterator<Item = (SurfaceId, Remark)> {
        let of_lines = self.surfaces.iter().flat_map(|s| s.toolpath.remarks.iter().map(|r| (s.toolpath.surface, r)));
        let of_lines = of_lines.map(|(surface, r)| (SurfaceId(surface), Remark::Toolpath(r.clone())));
        of_lines.chain(self.steps.shortfalls.iter().map(|(surface, s)| (SurfaceId(*surface), Remark::Program(*s))))
    }

    /// Surfaces without a line in any layer, in the order of work, and what takes the last one.
    pub fn bare(&self) -> impl Iterator<Item = (SurfaceId, TakenBy)> {
        let toolpaths = || self.surfaces.iter().map(|s| &s.toolpath);
        let has_lines = move |n: u32| toolpaths().any(|t| t.surface == n && !t.lines.is_empty());
        let lowest = toolpaths().filter(|t| t.layer == 0);
        lowest.filter_map(move |t| Some((SurfaceId(t.surface), t.taken_by().filter(|_| !has_lines(t.surface))?)))
    }

    /// Blocks what was refused.
    pub(super) fn refuse(&mut self, refused: &[Refusal]) {
        for r in refused {
            block(&mut self.passes[r.pass], r.point);
            if let Some(choice) = &mut self.choice {
                choice.rows[r.pass][r.point] = None;
            }
        }
        self.refusals.extend_from_slice(refused);
    }
}

/// The laser is off at a target, and on the way to the next.
fn block(pass: &mut Pass, point: usize) {
    if let Some(t) = pass.targets.get_mut(point) {
        t.state = TargetState::Blocked;
        t.laser = false;
    }
    if let Some(next) = pass.targets.get_mut(point + 1) {
        next.laser = false;
    }
}
