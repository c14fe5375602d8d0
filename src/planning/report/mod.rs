//! `report.json`: what was planned, in numbers that scripts rely on; and what people are to know of it first
//! (`notices_worst_first`). Sentences of it stand in `text`.

mod corrections;
mod in_file;
mod lengths;
mod nothing;
mod notice;
mod plan_finding;
mod plan_status;
mod problem;
mod rows;
mod unproven;
mod unverified;
mod written_files;

pub use corrections::CorrectionOutcome;
pub use in_file::in_file;
pub use nothing::{BareSurface, BlockedBy, NothingReason, is_dark};
pub use notice::{Notice, Severity, notices_worst_first};
pub use plan_finding::{PlanFinding, UnverifiedOf};
pub use plan_status::{Grade, PlanStatus};
pub use problem::{NotDone, Problem, problems};
pub use rows::{OrderReport, SplitReport, SurfaceReport};
pub use unproven::Unproven;
pub use unverified::unverified;
pub use written_files::{DryRunReport, FileDigest, StandingProgram, WrittenFiles};

use super::cell_report::CellReport;
use super::dose::DoseReport;
use super::plan::Plan;
use super::scanned::{ScanReport, WornPatch};
use super::welded::WeldReport;
use crate::cell::Setup;
use crate::document::Job;
use crate::document::files::InputDigest;
use crate::part::{PartFinding, Surfaces};
use crate::pose::{Pass, Target, TargetState};
use crate::program::Timeline;
use crate::program::sweep::Proof;
use corrections::corrections;
use lengths::{is_blocked, is_corrected, length};
use nothing::nothing_planned;
use rows::{splits, surface_rows};
use serde::{Serialize, Serializer};
use unproven::unproven;

/// The report. Lengths mm, areas mm², angles degrees, times s.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Layers of the thickest build-up; 1 where nothing is built up.
    pub layers: usize,
    /// Lines.
    pub passes: usize,
    /// Rows of `path.csv`.
    pub points: usize,
    /// Points of the lines as the strategy made them, before any were inserted or dropped.
    pub line_points: usize,
    /// Points of the dense lines, of which the rows were chosen.
    pub dense_points: usize,
    /// Length of the moves with the laser on.
    pub work_mm: f64,
    /// The part of that length that begins or ends at a corrected target.
    pub corrected_mm: f64,
    /// Length of passes with the laser off, gaps of lines not counted.
    pub blocked_mm: f64,
    /// Length of connecting moves.
    pub air_mm: f64,
    /// Work and connecting moves.
    pub time_s: f64,
    /// The way between lines, straight from end to start, before and after they were put in order.
    pub order: OrderReport,
    /// Rows whose beam along the normal hits the part.
    pub interfering: usize,
    /// Rows that were corrected.
    pub corrected: usize,
    /// Rows that are blocked.
    pub blocked: usize,
    /// Largest angle between beam and normal with the laser on.
    pub max_tilt_deg: f64,
    /// Fastest turn of the beam against the normal on lit moves that touch a corrected target, degrees/mm.
    pub max_tilt_rate_deg_per_mm: f64,
    /// Largest distance of a dropped point from its chord.
    pub max_chord_error_mm: f64,
    /// Largest distance of neighbouring lines on any surface.
    pub max_surface_spacing_mm: f64,
    /// Area that no line reaches.
    pub missed_area_mm2: f64,
    /// By surface, in the order of work.
    pub surfaces: Vec<SurfaceReport>,
    /// What is blocked or missed, and why.
    pub problems: Vec<Problem>,
    /// What was dropped, passed over or assumed on the way, and whether anything is planned at all.
    pub findings: Vec<PlanFinding>,
    /// Where the laser is off while the beam turns.
    pub splits: Vec<SplitReport>,
    /// Both corrections within the same limits, before any robot; none unless the beam was searched.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub corrections: Vec<CorrectionOutcome>,
    /// What is proven of the moves with the laser on; null before the program is made.
    pub proof: Option<Proof>,
    /// Moves with the laser on that are not proven, grouped by what they would touch.
    #[serde(skip)]
    pub unproven: Vec<Unproven>,
    /// Whether there are moves with the laser on, and all of them are proven.
    pub proven: bool,
    /// The least that beam and head keep from everything at a target with the laser on; null without a head.
    pub min_clearance_mm: Option<f64>,
    /// What lands; it is computed apart from the plan, when it is asked for.
    #[serde(serialize_with = "dose_if_looked_at")]
    pub dose: Option<DoseReport>,
    /// The frames that were used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<CellReport>,
    /// How the scan lies on the part; `None` where the job has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scan: Option<ScanReport>,
    /// What is worn or built up by the scan, the farthest off first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub patches: Option<Vec<WornPatch>>,
    /// The weld that is ground; `None` where the job has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weld: Option<WeldReport>,
    /// The files that it was planned from, as they were when it was exported; only what is exported has them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<InputDigest>,
    /// Whose export this is, and its files; only what is exported has it.
    #[serde(flatten)]
    pub written: Option<WrittenFiles>,
}

/// A script must not take a dose that nobody computed for one of nothing.
fn dose_if_looked_at<S: Serializer>(dose: &Option<DoseReport>, s: S) -> Result<S::Ok, S::Error> {
    match dose {
        Some(dose) => dose.serialize(s),
        None => s.serialize_str("not looked at"),
    }
}

impl Report {
    /// The report of a plan.
    pub fn new(plan: &Plan, surfaces: &Surfaces) -> Report {
        let count = |passes: &[Pass], which: &dyn Fn(&Target) -> bool| {
            passes.iter().flat_map(|p| &p.targets).filter(|t| which(t)).count()
        };
        let all = &plan.passes;
        let rows = surface_rows(plan, surfaces);
        let clearance = all
            .iter()
            .flat_map(|p| &p.targets)
            .filter(|t| t.state != TargetState::Blocked)
            .filter_map(|t| t.clearance_mm);
        let lit = all.iter().flat_map(|p| &p.targets).filter(|t| t.state != TargetState::Blocked);
        let problems = problems(plan, surfaces);
        let nothing = nothing_planned(plan, &problems, &rows);
        let unproven = plan.proof.as_ref().map_or_else(Vec::new, |p| unproven(p, surfaces));
        Report {
            layers: plan.grown.len().max(1),
            passes: all.iter().filter(|p| !p.targets.is_empty()).count(),
            points: count(all, &|_| true),
            line_points: all.iter().map(|p| p.line_points).sum(),
            dense_points: all.iter().map(|p| p.dense_points).sum(),
            work_mm: length(all, |_, to| to.laser),
            corrected_mm: length(all, is_corrected),
            blocked_mm: length(all, is_blocked),
            air_mm: plan.steps.air_mm,
            time_s: plan.timeline.as_ref().map_or(plan.steps.time_s, Timeline::total_s),
            order: OrderReport::new(plan),
            interfering: count(all, &|t| t.normal_hits.is_some()),
            corrected: count(all, &|t| t.state == TargetState::Corrected),
            blocked: count(all, &|t| t.state == TargetState::Blocked),
            max_tilt_deg: lit.map(Target::tilt_deg).fold(0.0, f64::max),
            max_tilt_rate_deg_per_mm: all.iter().map(Pass::max_tilt_rate_deg_mm).fold(0.0, f64::max),
            max_chord_error_mm: all.iter().map(|p| p.chord_error_mm).fold(0.0, f64::max),
            max_surface_spacing_mm: rows.iter().filter_map(|r| r.spacing_max_mm).fold(0.0, f64::max),
            missed_area_mm2: rows.iter().map(|r| r.missed_area_mm2).fold(0.0, |a, b| a + b),
            findings: nothing
                .map(|reason| PlanFinding::NothingPlanned { reason })
                .into_iter()
                .chain(unproven.iter().cloned().map(PlanFinding::NotProven))
                .chain(plan.steps.off_speed.iter().copied().map(PlanFinding::SlowMove))
                .collect(),
            problems,
            splits: splits(all, surfaces),
            corrections: corrections(plan),
            surfaces: rows,
            proven: plan.proof.as_ref().is_some_and(|p| p.lit_moves > 0 && p.refuted.is_empty()),
            unproven,
            proof: plan.proof.clone(),
            min_clearance_mm: clearance.reduce(f64::min),
            dose: None,
            cell: plan.cell.clone(),
            scan: plan.scan.clone(),
            patches: plan.scan.as_ref().map(|s| s.patches.clone()),
            weld: plan.weld_report.as_deref().cloned(),
            inputs: Vec::new(),
            written: None,
        }
    }

    /// Adds what was found in the part's file, and what of cell, robot and dialect nobody has measured or checked.
    pub fn with_inputs(mut self, in_file: &[PartFinding], job: &Job, setup: &Setup) -> Report {
        self.findings.extend(in_file.iter().cloned().map(PlanFinding::InFile));
        self.findings.extend(unverified(job, setup));
        self
    }

    /// How far the part may lie off where it was scanned or seen, mm.
    pub fn slack_mm(&self) -> f64 {
        let scanned_mm = self.scan.as_ref().map_or(0.0, |scan| scan.slack_mm);
        self.weld.as_ref().map_or(scanned_mm, |weld| scanned_mm.max(weld.slack_mm))
    }

    /// Whether everything chosen is done.
    pub fn is_complete(&self) -> bool {
        self.problems.is_empty() && !self.findings.iter().any(PlanFinding::leaves_undone)
    }
}
