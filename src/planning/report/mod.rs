//! `report.json`: what was planned, in numbers that scripts rely on.

mod finding;
mod problems;
mod standing;
mod text;
mod written_files;

use super::dose::DoseReport;
use super::plan::Plan;
use super::surface_plan::SurfacePlan;
use crate::cell::{Frame, Mount, Setup};
use crate::part::Surfaces;
use crate::pose::{Correction, Obstruction, Pass, Split, State, Target};
use crate::program::Timeline;
use crate::program::sweep::Proof;
use finding::nothing_planned;
pub use finding::{BlockedBy, NothingReason, PlanFinding, is_dark};
pub use problems::{Problem, problems};
use serde::Serialize;
pub use standing::{Grade, Standing, grouped};
pub use text::hours;
pub use written_files::{FileDigest, WrittenFiles};

/// The report. Lengths mm, areas mm², angles degrees, times s.
///
/// `work_mm` is the length of all moves with the laser on, `corrected_mm` the share of it that
/// begins or ends at a corrected target, `blocked_mm` the length of passes with the laser off.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Layers of the thickest build-up; 1 where nothing is built up.
    pub layers: usize,
    /// Lines.
    pub passes: usize,
    /// Rows of `path.csv`.
    pub points: usize,
    /// Points of the lines as they were laid, before anything was put between or dropped.
    pub line_points: usize,
    /// Points of the dense lines, of which the rows were chosen.
    pub dense_points: usize,
    /// See above.
    pub work_mm: f64,
    /// See above.
    pub corrected_mm: f64,
    /// See above.
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
    pub corrections: Vec<Outcome>,
    /// What is proven of the moves with the laser on; null before the program is made.
    pub proof: Option<Proof>,
    /// Whether all of them are, and there are any.
    pub proven: bool,
    /// The least that beam and head keep from everything at a target with the laser on; null without a head.
    pub min_clearance_mm: Option<f64>,
    /// What lands; it is computed apart from the plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dose: Option<DoseReport>,
    /// The frames that were used.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cell: Option<CellReport>,
    /// Whose export this is, and its files; only what is exported has it.
    #[serde(flatten)]
    pub written: Option<WrittenFiles>,
}

/// What the order of the lines comes to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OrderReport {
    /// In a plain zigzag, mm.
    pub zigzag_way_mm: f64,
    /// As they are run, mm.
    pub way_mm: f64,
}

impl OrderReport {
    fn new(plan: &Plan) -> OrderReport {
        let sum = |way: fn(&SurfacePlan) -> f64| plan.surfaces.iter().map(|s| way(s)).fold(0.0, |a, b| a + b);
        OrderReport { zigzag_way_mm: sum(|s| s.zigzag_way_mm), way_mm: sum(|s| s.way_mm) }
    }
}

/// The frames of a plan, row by row, mm; those of its mount.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellReport {
    /// Key or file of the robot; null: poses only.
    pub robot: Option<String>,
    /// `part-in-hand` or `tool-in-hand`.
    pub mount: &'static str,
    /// Part in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_laser: Option<[[f64; 4]; 4]>,
    /// Part in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flange_from_part: Option<[[f64; 4]; 4]>,
    /// Tool in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_part: Option<[[f64; 4]; 4]>,
    /// Tool in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flange_from_tool: Option<[[f64; 4]; 4]>,
}

impl CellReport {
    /// The frames of a setup; `robot` as the job names it.
    pub fn new(setup: &Setup, robot: &str) -> CellReport {
        let rows = |frame: &Frame| {
            let m = frame.isometry().to_homogeneous();
            std::array::from_fn(|r| std::array::from_fn(|c| m[(r, c)] + 0.0))
        };
        let cell = &setup.cell;
        let in_hand = setup.mount == Mount::PartInHand;
        let of = |mine: bool, frame: &Frame| mine.then(|| rows(frame));
        CellReport {
            robot: (!robot.is_empty()).then(|| robot.to_owned()),
            mount: setup.mount.word(),
            base_from_laser: of(in_hand, &cell.base_from_laser),
            flange_from_part: of(in_hand, &cell.flange_from_part),
            base_from_part: of(!in_hand, &cell.base_from_part),
            flange_from_tool: of(!in_hand, &cell.flange_from_tool),
        }
    }
}

/// One surface.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceReport {
    /// Its number.
    pub surface: u32,
    /// Its area.
    pub area_mm2: f64,
    /// As above.
    pub passes: usize,
    /// As above.
    pub points: usize,
    /// As above.
    pub work_mm: f64,
    /// As above.
    pub corrected_mm: f64,
    /// As above.
    pub blocked_mm: f64,
    /// As above.
    pub missed_area_mm2: f64,
    /// Least distance of its lines on the surface; null where no line runs.
    pub spacing_min_mm: Option<f64>,
    /// Greatest.
    pub spacing_max_mm: Option<f64>,
    /// What of its lines is not as it was wanted.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
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

/// What a correction makes of the same lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Its word.
    pub correction: &'static str,
    /// Rows that it corrects.
    pub corrected: usize,
    /// Rows that it leaves blocked.
    pub blocked: usize,
    /// Length that it leaves blocked.
    pub blocked_mm: f64,
    /// Largest angle between beam and normal.
    pub max_tilt_deg: f64,
    /// Fastest turn against the normal.
    pub max_tilt_rate_deg_per_mm: f64,
}

impl Outcome {
    fn of<'a>(correction: Correction, passes: impl Iterator<Item = &'a Pass> + Clone) -> Outcome {
        let targets = || passes.clone().flat_map(|p| &p.targets);
        let count = |state: State| targets().filter(|t| t.state == state).count();
        Outcome {
            correction: correction.word(),
            corrected: count(State::Corrected),
            blocked: count(State::Blocked),
            blocked_mm: passes.clone().map(|p| p.length_mm(is_blocked)).fold(0.0, |a, b| a + b),
            max_tilt_deg: targets().filter(|t| t.state != State::Blocked).map(Target::tilt_deg).fold(0.0, f64::max),
            max_tilt_rate_deg_per_mm: passes.map(Pass::max_tilt_rate_deg_mm).fold(0.0, f64::max),
        }
    }
}

/// Both corrections on the surfaces that were searched.
fn corrections(plan: &Plan) -> Vec<Outcome> {
    if plan.surfaces.iter().all(|s| s.by_section_plane.is_none()) {
        return Vec::new();
    }
    let searched = plan.surfaces.iter().flat_map(|s| &s.passes);
    let other = plan.surfaces.iter().flat_map(|s| {
        let by_plane = s.by_section_plane.iter().flatten();
        s.passes.iter().zip(by_plane).map(|(own, other)| other.as_ref().unwrap_or(own))
    });
    vec![Outcome::of(Correction::Clearance, searched), Outcome::of(Correction::SectionPlane, other)]
}

fn splits(passes: &[Pass], surfaces: &Surfaces) -> Vec<SplitReport> {
    let of_pass = |(pass, p): (usize, &Pass)| -> Vec<SplitReport> {
        let one = |s: &Split| {
            let by_facet = s.wall.and_then(|b| match b.obstruction {
                Obstruction::Facet(f) => Some(f),
                Obstruction::Clamp(_) => None,
            });
            let by_surface = by_facet.map(|f| surfaces.of_facet[f as usize]);
            SplitReport { pass, point: s.point, surface: p.surface, by_facet, by_surface }
        };
        p.splits.iter().map(one).collect()
    };
    passes.iter().enumerate().flat_map(of_pass).collect()
}

impl Report {
    /// The report of a plan.
    pub fn new(plan: &Plan, surfaces: &Surfaces) -> Report {
        let count = |passes: &[Pass], which: &dyn Fn(&Target) -> bool| {
            passes.iter().flat_map(|p| &p.targets).filter(|t| which(t)).count()
        };
        let all = &plan.passes;
        // The first layer has every surface; those above it add to its row.
        let first = plan.surfaces.iter().filter(|s| s.laid.layer == 0);
        let rows: Vec<SurfaceReport> = first
            .map(|s| {
                let surface = s.laid.surface;
                let passes: Vec<&Pass> = all.iter().filter(|p| p.surface == surface).collect();
                let layers = || plan.surfaces.iter().map(|s| &s.laid).filter(|l| l.surface == surface);
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
                    remarks: plan.remarks().filter(|r| r.0 == surface).map(|r| r.1.to_owned()).collect(),
                }
            })
            .collect();
        let clearance =
            all.iter().flat_map(|p| &p.targets).filter(|t| t.state != State::Blocked).filter_map(|t| t.clearance_mm);
        let lit = all.iter().flat_map(|p| &p.targets).filter(|t| t.state != State::Blocked);
        let problems = problems(plan, surfaces);
        Report {
            layers: plan.grown.len().max(1),
            passes: all.len(),
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
            corrected: count(all, &|t| t.state == State::Corrected),
            blocked: count(all, &|t| t.state == State::Blocked),
            max_tilt_deg: lit.map(Target::tilt_deg).fold(0.0, f64::max),
            max_tilt_rate_deg_per_mm: all.iter().map(Pass::max_tilt_rate_deg_mm).fold(0.0, f64::max),
            max_chord_error_mm: all.iter().map(|p| p.chord_error_mm).fold(0.0, f64::max),
            max_surface_spacing_mm: rows.iter().filter_map(|r| r.spacing_max_mm).fold(0.0, f64::max),
            missed_area_mm2: rows.iter().map(|r| r.missed_area_mm2).fold(0.0, |a, b| a + b),
            findings: nothing_planned(plan, &problems).into_iter().collect(),
            problems,
            splits: splits(all, surfaces),
            corrections: corrections(plan),
            surfaces: rows,
            proven: plan.proof.as_ref().is_some_and(|p| p.intervals > 0 && p.refuted.is_empty()),
            proof: plan.proof.clone(),
            min_clearance_mm: clearance.reduce(f64::min),
            dose: None,
            cell: plan.cell.clone(),
            written: None,
        }
    }

    /// Whether everything chosen is done.
    pub fn is_complete(&self) -> bool {
        self.problems.is_empty() && self.findings.is_empty()
    }
}

fn length<'a>(passes: impl IntoIterator<Item = &'a Pass>, which: impl Fn(&Target, &Target) -> bool + Copy) -> f64 {
    passes.into_iter().map(|p| p.length_mm(which)).fold(0.0, |a, b| a + b)
}

/// The laser is off because something is in the way: over a gap of the line it is off on purpose.
fn is_blocked(from: &Target, to: &Target) -> bool {
    !to.laser && !Pass::is_gap(from, to)
}

fn is_corrected(from: &Target, to: &Target) -> bool {
    to.laser && (from.state == State::Corrected || to.state == State::Corrected)
}
