//! What was found on the way to a plan and is no problem of a target: key `findings` of the report. Sentences of
//! it stand with the report's text.

use super::Problem;
use crate::planning::plan::Plan;
use crate::program::Step;
use serde::Serialize;

/// One thing that was found, by its code.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum PlanFinding {
    /// The plan has no move with the laser on, so there is no program.
    NothingPlanned {
        /// Why.
        #[serde(flatten)]
        reason: NothingReason,
    },
    /// The part's file is another one than when the job was saved.
    PartChanged {
        /// SHA-256 of the file that the job was made for, hexadecimal.
        was: String,
        /// SHA-256 of the file that was planned on.
        is: String,
        /// Surfaces that the job speaks of and that were found again: old number, new number.
        kept: Vec<[u32; 2]>,
        /// Those that were not; none of them was to be cleaned.
        lost: Vec<u32>,
    },
}

/// Why there is nothing to do.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum NothingReason {
    /// No line lies on the chosen surfaces, or none that is long enough for a move.
    NoLines,
    /// Every line is blocked.
    AllBlocked {
        /// By what, in the order in which it was met.
        by: Vec<BlockedBy>,
    },
}

/// Blocked targets with the same cause.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BlockedBy {
    /// As in `problems`.
    pub cause: &'static str,
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
pub(super) fn nothing_planned(plan: &Plan, problems: &[Problem]) -> Option<PlanFinding> {
    if !is_dark(plan) {
        return None;
    }
    let mut by: Vec<BlockedBy> = Vec::new();
    for p in problems.iter().filter(|p| p.pass.is_some()) {
        match by.iter_mut().find(|b| (b.cause, b.by_surface) == (p.cause, p.by_surface)) {
            Some(b) => b.targets += 1,
            None => by.push(BlockedBy { cause: p.cause, by_surface: p.by_surface, targets: 1 }),
        }
    }
    let reason = if by.is_empty() { NothingReason::NoLines } else { NothingReason::AllBlocked { by } };
    Some(PlanFinding::NothingPlanned { reason })
}

impl PlanFinding {
    /// A line for people.
    pub fn text(&self) -> String {
        match self {
            PlanFinding::NothingPlanned { reason } => {
                format!("nothing to do, so there is no program: {}", reason.text())
            }
            PlanFinding::PartChanged { kept, lost, .. } => {
                let list = |numbers: &mut dyn Iterator<Item = String>| numbers.collect::<Vec<_>>().join(", ");
                let moved = kept.iter().filter(|[old, new]| old != new).map(|[old, new]| format!("{old} is {new} now"));
                let moved: Vec<String> = moved.collect();
                let told = |what: &str, list: String| if list.is_empty() { list } else { format!("; {what} {list}") };
                format!(
                    "the part's file has changed since the job was saved; all that is to be cleaned was found again{}{}",
                    told("surface", moved.join(", ")),
                    told("not found: surface", list(&mut lost.iter().map(u32::to_string)))
                )
            }
        }
    }
}

impl NothingReason {
    fn text(&self) -> String {
        match self {
            NothingReason::NoLines => "no line lies on the chosen surfaces".into(),
            NothingReason::AllBlocked { by } => {
                let one = |b: &BlockedBy| {
                    let surface = b.by_surface.map_or(String::new(), |n| format!(" by surface {n}"));
                    format!("{} ({}{surface})", b.targets, b.cause)
                };
                format!("all targets are blocked: {}", by.iter().map(one).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_carry_their_code_and_their_fields_side_by_side() {
        let json = |f: &PlanFinding| serde_json::to_string(f).expect("JSON");
        let no_lines = PlanFinding::NothingPlanned { reason: NothingReason::NoLines };
        assert_eq!(json(&no_lines), r#"{"code":"nothing_planned","reason":"no_lines"}"#);
        let by = vec![BlockedBy { cause: "beam", by_surface: Some(3), targets: 7 }];
        let blocked = PlanFinding::NothingPlanned { reason: NothingReason::AllBlocked { by } };
        assert_eq!(
            json(&blocked),
            r#"{"code":"nothing_planned","reason":"all_blocked","by":[{"cause":"beam","by_surface":3,"targets":7}]}"#
        );
        let changed =
            PlanFinding::PartChanged { was: "a".into(), is: "b".into(), kept: vec![[1, 1], [2, 5]], lost: vec![3] };
        assert_eq!(json(&changed), r#"{"code":"part_changed","was":"a","is":"b","kept":[[1,1],[2,5]],"lost":[3]}"#);
        assert!(
            changed.text().ends_with("found again; surface 2 is 5 now; not found: surface 3"),
            "{}",
            changed.text()
        );
    }
}
