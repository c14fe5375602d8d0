//! What people are to know of a plan, in one list: what is unsafe first, then what is not done, then what is not as it
//! was wanted, then what was found in the file.
//!
//! A new finding is a variant here, with its severity and where it is found, and its sentence in `text::notice`.

use super::problem::{NotDone, Problem};
use super::{NothingReason, PlanFinding, Report, Unproven};
use crate::cell::motion::{RefusalCause, RefusalReason};
use crate::document::Job;
use crate::part::{PartFinding, SurfaceId};
use crate::path::{Direction, Strategy};
use crate::planning::TakenBy;
use crate::planning::remark::Remark;
use crate::pose::Correction;
use crate::program::OffSpeed;
use std::collections::BTreeMap;

/// How bad a finding is; the worst comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Something may be harmed if the program is run.
    Unsafe,
    /// Something that was chosen is not worked on.
    NotDone,
    /// It is done, but not as it was wanted.
    NotAsWanted,
    /// What was found in the part's file, or done to it.
    Found,
}

/// One finding of a plan.
#[derive(Clone, Debug, PartialEq)]
pub enum Notice {
    /// Moves with the laser on that are not proven to touch nothing.
    NotProven(Unproven),
    /// No move has the laser on, so there is no program.
    NothingPlanned(NothingReason),
    /// Targets of a surface that are left out for the same cause.
    LeftOut {
        /// The surface.
        surface: SurfaceId,
        /// Why.
        cause: RefusalCause,
        /// The surface in the way.
        by_surface: Option<SurfaceId>,
        /// How the beam may be tilted on it; `None`: what works there is no beam.
        correction: Option<Correction>,
        /// How far the part may lie off where it was scanned or seen, which tool and arm keep clear as well, mm.
        slack_mm: f64,
        /// How many.
        targets: usize,
        /// The first of them: pass and point.
        first: (usize, usize),
        /// Why a move or the robot cannot do that one, where one of them is the cause.
        why: Option<RefusalReason>,
    },
    /// A surface has no line at all.
    NoLines {
        /// The surface.
        surface: SurfaceId,
        /// What takes the last one.
        taken_by: TakenBy,
        /// Its area, mm².
        area_mm2: f64,
    },
    /// The spot does not have its speed everywhere on a surface.
    OffSpeed(OffSpeed),
    /// Area of a surface that no line reaches.
    Missed {
        /// The surface.
        surface: SurfaceId,
        /// The area that is missed, mm².
        missed_mm2: f64,
        /// Its whole area, mm².
        area_mm2: f64,
        /// Whether planes cut its lines, which another direction may suit better.
        by_planes: bool,
    },
    /// Lines or program of a surface are not as they were wanted.
    Remark {
        /// The surface.
        surface: SurfaceId,
        /// What is said.
        remark: Remark,
    },
    /// The part's file is another one than when the job was saved.
    PartChanged {
        /// Surfaces that have another number now: old, new.
        renumbered: Vec<[SurfaceId; 2]>,
        /// Surfaces that the job speaks of and that were not found again.
        lost: Vec<SurfaceId>,
    },
    /// What is to be known of the part's file.
    InFile(PartFinding),
}

impl Notice {
    /// How bad it is.
    pub fn severity(&self) -> Severity {
        match self {
            Notice::NotProven(_) => Severity::Unsafe,
            Notice::NothingPlanned(_) | Notice::NoLines { .. } | Notice::LeftOut { .. } | Notice::Missed { .. } => {
                Severity::NotDone
            }
            Notice::OffSpeed(_) | Notice::Remark { .. } => Severity::NotAsWanted,
            Notice::PartChanged { .. } | Notice::InFile(_) => Severity::Found,
        }
    }

    /// The surface that it is about, where it is about one.
    pub fn surface(&self) -> Option<SurfaceId> {
        match self {
            Notice::NotProven(u) => u.surface,
            Notice::OffSpeed(off) => Some(SurfaceId(off.surface)),
            Notice::NoLines { surface, .. }
            | Notice::LeftOut { surface, .. }
            | Notice::Missed { surface, .. }
            | Notice::Remark { surface, .. } => Some(*surface),
            Notice::NothingPlanned(_) | Notice::PartChanged { .. } | Notice::InFile(_) => None,
        }
    }

    /// The target to look at first: pass and point.
    pub fn target(&self) -> Option<(usize, usize)> {
        match self {
            Notice::LeftOut { first, .. } => Some(*first),
            Notice::OffSpeed(off) => Some((off.pass, off.point)),
            _ => None,
        }
    }
}

/// All findings of a job's plan, the worst first; of one severity in the order of work. `in_file`: what was found in
/// the part's file.
pub fn notices_worst_first(report: &Report, job: &Job, in_file: &[PartFinding]) -> Vec<Notice> {
    let mut out: Vec<Notice> = report.unproven.iter().cloned().map(Notice::NotProven).collect();
    out.extend(report.findings.iter().filter_map(of_finding));
    let mut groups = BTreeMap::new();
    for problem in &report.problems {
        match problem.cause {
            NotDone::Blocked(cause) => left_out(&mut out, &mut groups, problem, cause, (job, report.slack_mm())),
            NotDone::Missed => out.extend(missed(report, SurfaceId(problem.surface), job)),
        }
    }
    let rows = report.surfaces.iter();
    // Why a surface has no line is told with that.
    let rows = rows.filter(|row| row.taken_by().is_none());
    let remarks = rows.flat_map(|s| s.remarks.iter().map(|r| (SurfaceId(s.surface), r.clone())));
    out.extend(remarks.map(|(surface, remark)| Notice::Remark { surface, remark }));
    out.extend(in_file.iter().cloned().map(Notice::InFile));
    out.sort_by_key(Notice::severity);
    out
}

fn of_finding(finding: &PlanFinding) -> Option<Notice> {
    Some(match finding {
        PlanFinding::NothingPlanned { reason } => Notice::NothingPlanned(reason.clone()),
        PlanFinding::SlowMove(off) => Notice::OffSpeed(*off),
        PlanFinding::PartChanged { kept, lost, .. } => {
            let moved = kept.iter().filter(|[old, new]| old != new);
            Notice::PartChanged {
                renumbered: moved.map(|pair| pair.map(SurfaceId)).collect(),
                lost: lost.iter().copied().map(SurfaceId).collect(),
            }
        }
        // Moves that are not proven stand in the list already, and the panel of the cell and the program's head say
        // what of robot and dialect nobody has checked. Findings of the file are handed in by whoever wants them in the list:
        // the command line has told them by then.
        PlanFinding::NotProven(_)
        | PlanFinding::UnverifiedFrame { .. }
        | PlanFinding::UnverifiedWord { .. }
        | PlanFinding::InFile(_) => return None,
    })
}

/// Surface, cause and surface in the way of targets that are left out, and where in the list they are counted.
type Groups = BTreeMap<(SurfaceId, RefusalCause, Option<SurfaceId>), usize>;

/// Counts a target that is left out, with those of its surface that have the same cause.
fn left_out(
    out: &mut Vec<Notice>,
    groups: &mut Groups,
    problem: &Problem,
    cause: RefusalCause,
    (job, slack_mm): (&Job, f64),
) {
    let (surface, by_surface) = (SurfaceId(problem.surface), problem.by_surface.map(SurfaceId));
    let group = (surface, cause, by_surface);
    if let Some(Notice::LeftOut { targets, .. }) = groups.get(&group).and_then(|at| out.get_mut(*at)) {
        *targets += 1;
        return;
    }
    let (Some(pass), Some(point)) = (problem.pass, problem.point) else { return };
    groups.insert(group, out.len());
    let correction = (!job.weld.is_there()).then(|| job.of_surface(surface).path.correction);
    let why = problem.why.clone();
    out.push(Notice::LeftOut {
        surface,
        cause,
        by_surface,
        correction,
        slack_mm,
        targets: 1,
        first: (pass, point),
        why,
    });
}

fn missed(report: &Report, surface: SurfaceId, job: &Job) -> Option<Notice> {
    let row = report.surfaces.iter().find(|s| s.surface == surface.0)?;
    if let Some(taken_by) = row.taken_by() {
        return Some(Notice::NoLines { surface, taken_by, area_mm2: row.area_mm2 });
    }
    let layers = &job.of_surface(surface).layers;
    let is_cut = !matches!(layers.strategy, Strategy::Offset | Strategy::Spiral);
    let by_planes = is_cut && layers.direction != Direction::Auto;
    Some(Notice::Missed { surface, missed_mm2: row.missed_area_mm2, area_mm2: row.area_mm2, by_planes })
}
