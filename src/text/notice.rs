//! What people are to know of a plan, finding by finding, and what helps.

use super::{NamedSentence, Naming, Sentence, exact, fixed, id, listed, listed_clauses, say, short};
use crate::cell::motion::{RefusalCause, RefusalReason};
use crate::part::SurfaceId;
use crate::planning::report::{BlockedBy, NothingReason, Notice, Unproven};
use crate::pose::{Correction, ToolBody};
use crate::program::OffSpeed;

impl NamedSentence for Notice {
    fn sentence_with(&self, naming: &Naming<'_>) -> String {
        match self {
            Notice::NotProven(unproven) => not_proven(unproven, naming),
            Notice::NothingPlanned(reason) => reason.sentence_with(naming),
            Notice::LeftOut { surface, targets, why: Some(RefusalReason::OffLine { .. }), .. } => {
                let surface = naming.surface(*surface);
                say!(notice_refused, surface, targets = *targets, why = say!(why_far_from_flange))
            }
            Notice::LeftOut {
                surface,
                cause: RefusalCause::Head,
                by_surface: Some(by),
                correction: None,
                targets,
                ..
            } => {
                // What grinds has no head.
                let (surface, by) = (naming.surface(*surface), naming.surface(*by));
                say!(notice_blocked_for_tool, surface, targets = *targets, by)
            }
            Notice::LeftOut { surface, cause, by_surface, targets, .. } => {
                left_out(&naming.surface(*surface), *cause, by_surface.map(|s| naming.surface(s)), *targets)
            }
            Notice::NoLines { surface, taken_by, area_mm2 } => {
                let (surface, area) = (naming.surface(*surface), fixed(*area_mm2, 2));
                say!(notice_no_lines_on, surface, area, why = taken_by.sentence())
            }
            Notice::Missed { surface, missed_mm2, area_mm2, by_planes } => {
                let (surface, missed, area) = (naming.surface(*surface), fixed(*missed_mm2, 2), fixed(*area_mm2, 2));
                match by_planes {
                    true => say!(notice_missed_by_planes, surface, missed, area),
                    false => say!(notice_missed_by_lines, surface, missed, area),
                }
            }
            Notice::Remark { surface, remark } => {
                say!(notice_remark, surface = naming.surface(*surface), remark = remark.sentence())
            }
            Notice::OffSpeed(off) => off_speed(off, naming),
            Notice::PartChanged { renumbered, lost } => part_changed(renumbered, lost),
            Notice::InFile(finding) => finding.sentence(),
        }
    }
}

/// What helps against a finding, where that is known.
pub fn remedy(notice: &Notice) -> Option<String> {
    Some(match notice {
        Notice::NotProven(_) => say!(remedy_not_proven),
        Notice::NothingPlanned(NothingReason::NoLines { taken_by: None, .. }) => say!(remedy_no_lines),
        Notice::LeftOut { why: Some(RefusalReason::OffLine { .. }), .. } => say!(remedy_far_from_flange),
        Notice::LeftOut {
            cause: RefusalCause::Beam | RefusalCause::Head | RefusalCause::Obstacle, slack_mm, ..
        } if *slack_mm >= TOLD_SLACK_MM => {
            say!(remedy_slack, slack = fixed(*slack_mm, 1))
        }
        Notice::LeftOut { cause, correction, .. } => against(*cause, *correction),
        Notice::Missed { by_planes: true, .. } => say!(remedy_missed_by_planes),
        Notice::Missed { by_planes: false, .. } => say!(remedy_missed_by_lines),
        Notice::OffSpeed(off) if off.possible_mm_s < off.wanted_mm_s => say!(remedy_slow),
        Notice::OffSpeed(_) => say!(remedy_fast),
        Notice::PartChanged { .. } => say!(remedy_part_changed),
        // Remarks and findings of the file say it themselves, what is blocked is told by surface, and what gives lines is
        // sought for the plan.
        Notice::Remark { .. } | Notice::InFile(_) | Notice::NothingPlanned(_) | Notice::NoLines { .. } => return None,
    })
}

/// A slack from which on it is the likelier reason that nothing fits, mm: as much as the margin that is kept anyway.
const TOLD_SLACK_MM: f64 = 1.0;

/// The first target that a finding is about, and what the robot has against it.
pub fn example(notice: &Notice) -> Option<String> {
    let Notice::LeftOut { first: (pass, point), why: Some(why), .. } = notice else { return None };
    Some(say!(notice_example, pass = id(pass), point = id(point), why = why.sentence()))
}

/// A finding with its example and what helps, in one line.
pub fn notice_line(notice: &Notice, naming: &Naming<'_>) -> String {
    let sentence = notice.sentence_with(naming);
    let more = [example(notice), remedy(notice)].into_iter().flatten();
    listed_clauses(std::iter::once(sentence).chain(more))
}

impl NamedSentence for NothingReason {
    fn sentence_with(&self, naming: &Naming<'_>) -> String {
        match self {
            NothingReason::NoLines { taken_by: None, .. } => say!(notice_no_lines),
            NothingReason::NoLines { taken_by: Some(why), area_mm2, .. } => {
                say!(notice_no_lines_for, area = fixed(*area_mm2, 2), why = why.sentence())
            }
            NothingReason::NoWear => say!(notice_no_wear),
            NothingReason::Held => say!(notice_held),
            NothingReason::NothingToGrind => say!(notice_nothing_to_grind),
            NothingReason::AllBlocked { by } => {
                say!(notice_all_left_out, list = listed(by.iter().map(|b| blocked_by(b, naming))))
            }
        }
    }
}

fn blocked_by(b: &BlockedBy, naming: &Naming<'_>) -> String {
    match b.by_surface {
        Some(n) => say!(notice_by_surface, targets = b.targets, surface = naming.surface(SurfaceId(n))),
        None => say!(notice_by_cause, targets = b.targets, cause = why(b.cause)),
    }
}

fn not_proven(unproven: &Unproven, naming: &Naming<'_>) -> String {
    let moves = unproven.moves;
    match (unproven.tool_body, unproven.surface.map(|s| naming.surface(s))) {
        (ToolBody::Beam, Some(surface)) => say!(notice_unproven_beam, moves, surface),
        (ToolBody::Head, Some(surface)) => say!(notice_unproven_head, moves, surface),
        (ToolBody::Abrasive, Some(surface)) => say!(notice_unproven_abrasive, moves, surface),
        (ToolBody::Gouge, Some(surface)) => say!(notice_unproven_gouge, moves, surface),
        (ToolBody::Beam, None) => say!(notice_unproven_beam_clamp, moves),
        (ToolBody::Head, None) => say!(notice_unproven_head_clamp, moves),
        (ToolBody::Abrasive | ToolBody::Gouge, None) => say!(notice_unproven_abrasive_clamp, moves),
    }
}

fn off_speed(off: &OffSpeed, naming: &Naming<'_>) -> String {
    let (surface, moves, wanted) = (naming.surface(SurfaceId(off.surface)), off.moves, exact(off.wanted_mm_s));
    let (possible, pass, point) = (short(off.possible_mm_s), id(off.pass), id(off.point));
    match off.possible_mm_s < off.wanted_mm_s {
        true => say!(notice_slow, surface, moves, wanted, possible, pass, point),
        false => say!(notice_fast, surface, moves, wanted, possible, pass, point),
    }
}

/// Targets of a surface that are left out for a cause, and the surface that is in the way.
pub(crate) fn left_out(surface: &str, cause: RefusalCause, by: Option<String>, targets: usize) -> String {
    match (cause, by) {
        (RefusalCause::Head, Some(by)) => say!(notice_blocked_for_head, surface, targets, by),
        (_, Some(by)) => say!(notice_blocked_by, surface, targets, by),
        (RefusalCause::Beam, None) => say!(notice_blocked, surface, targets),
        (_, None) => say!(notice_refused, surface, targets, why = why(cause)),
    }
}

/// What would happen if such a target were worked.
fn why(cause: RefusalCause) -> String {
    match cause {
        RefusalCause::Beam => say!(why_beam),
        RefusalCause::Robot => say!(why_robot),
        RefusalCause::Head => say!(why_head),
        RefusalCause::Obstacle => say!(why_obstacle),
        RefusalCause::Reach => say!(why_reach),
        RefusalCause::Limit => say!(why_limit),
        RefusalCause::Speed => say!(why_speed),
        RefusalCause::Singularity => say!(why_singularity),
    }
}

fn against(cause: RefusalCause, correction: Option<Correction>) -> String {
    match (cause, correction) {
        (RefusalCause::Beam | RefusalCause::Head, None) => say!(remedy_grinding),
        (RefusalCause::Beam | RefusalCause::Head, Some(Correction::None)) => say!(remedy_correct),
        (RefusalCause::Beam | RefusalCause::Head, Some(Correction::SectionPlane)) => say!(remedy_clearance),
        (RefusalCause::Beam | RefusalCause::Head, Some(Correction::Clearance)) => say!(remedy_tilt),
        (RefusalCause::Obstacle, _) => say!(remedy_obstacle),
        (RefusalCause::Robot | RefusalCause::Singularity, _) => say!(remedy_turn_part),
        (RefusalCause::Reach, _) => say!(remedy_reach),
        (RefusalCause::Limit, _) => say!(remedy_limit),
        (RefusalCause::Speed, _) => say!(remedy_speed),
    }
}

fn part_changed(renumbered: &[[SurfaceId; 2]], lost: &[SurfaceId]) -> String {
    let mut parts = vec![say!(notice_part_changed)];
    let moved: Vec<String> =
        renumbered.iter().map(|[old, new]| say!(notice_renumbered, old = id(old), new = id(new))).collect();
    if !moved.is_empty() {
        parts.push(say!(notice_surfaces_renumbered, list = listed(moved)));
    }
    if !lost.is_empty() {
        parts.push(say!(notice_surfaces_lost, list = listed(lost.iter().map(ToString::to_string))));
    }
    listed_clauses(parts)
}
