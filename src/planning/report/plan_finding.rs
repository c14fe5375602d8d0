//! What was found on the way to a plan and is no problem of a target: key `findings` of the report.

use super::Unproven;
use super::nothing::NothingReason;
use crate::part::PartFinding;
use crate::program::OffSpeed;
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
    /// Moves with the laser on are not proven to touch nothing.
    NotProven(Unproven),
    /// The spot does not have its speed everywhere on a surface.
    SlowMove(OffSpeed),
    /// The part's file is another one than when the job was saved.
    PartChanged {
        /// SHA-256 of the file that the job was made for, hexadecimal.
        was: String,
        /// SHA-256 of the file that was planned on.
        is: String,
        /// Surfaces that the job speaks of and that were found again: old number, new number.
        kept: Vec<[u32; 2]>,
        /// Surfaces that the job speaks of and that were not found again; none of them was to be cleaned.
        lost: Vec<u32>,
    },
    /// Frames of the shipped cell are examples: nobody has measured them.
    UnverifiedFrame {
        /// Name of the cell.
        cell: String,
        /// Keys of the frames in its file.
        frames: Vec<&'static str>,
    },
    /// Words that nobody has checked.
    UnverifiedWord {
        /// Whose words they are.
        #[serde(flatten)]
        of: UnverifiedOf,
        /// Keys of the robot's file; words of the controller, and keys of the cell file.
        words: Vec<String>,
    },
    /// Something that was found in the part's file, or done to it.
    #[serde(untagged)]
    InFile(PartFinding),
}

/// Whose words nobody has checked.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum UnverifiedOf {
    /// The robot's, by its name.
    Robot(String),
    /// The dialect's, by its name.
    Dialect(&'static str),
}

impl PlanFinding {
    /// Whether something is not done as the job was saved. What was found in the file is to be known, no more: the
    /// plan is made on the part as it was read, for the cell as it is told.
    pub fn leaves_undone(&self) -> bool {
        match self {
            PlanFinding::NothingPlanned { .. }
            | PlanFinding::NotProven(_)
            | PlanFinding::SlowMove(_)
            | PlanFinding::PartChanged { .. } => true,
            PlanFinding::UnverifiedFrame { .. } | PlanFinding::UnverifiedWord { .. } | PlanFinding::InFile(_) => false,
        }
    }

    /// What was found in the part's file, if it is that.
    pub fn in_file(&self) -> Option<&PartFinding> {
        match self {
            PlanFinding::InFile(finding) => Some(finding),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::nothing::{BareSurface, BlockedBy};
    use super::*;
    use crate::cell::motion::RefusalCause;
    use crate::part::SurfaceId;
    use crate::planning::TakenBy;
    use crate::pose::ToolBody;

    #[test]
    fn findings_carry_their_code_and_their_fields_side_by_side() {
        let json = |f: &PlanFinding| serde_json::to_string(f).expect("JSON");
        let taken_by = TakenBy::Inset { inset_mm: 9.5 };
        let by = vec![BareSurface { surface: 3, taken_by, area_mm2: 800.0 }];
        let reason = NothingReason::NoLines { taken_by: Some(taken_by), area_mm2: 800.0, by };
        assert_eq!(
            json(&PlanFinding::NothingPlanned { reason }),
            r#"{"code":"nothing_planned","reason":"no_lines","cause":"inset","inset_mm":9.5,"area_mm2":800.0,"by":[{"surface":3,"cause":"inset","inset_mm":9.5,"area_mm2":800.0}]}"#
        );
        let reason = NothingReason::NoLines { taken_by: None, area_mm2: 2.0, by: Vec::new() };
        assert_eq!(
            json(&PlanFinding::NothingPlanned { reason }),
            r#"{"code":"nothing_planned","reason":"no_lines","area_mm2":2.0,"by":[]}"#
        );
        let off = OffSpeed { surface: 2, moves: 3, wanted_mm_s: 3.0, possible_mm_s: 2.25, pass: 4, point: 17 };
        assert_eq!(
            json(&PlanFinding::SlowMove(off)),
            r#"{"code":"slow_move","surface":2,"moves":3,"wanted_mm_s":3.0,"possible_mm_s":2.25,"pass":4,"point":17}"#
        );
        let by = vec![BlockedBy { cause: RefusalCause::Beam, by_surface: Some(3), targets: 7 }];
        let blocked = PlanFinding::NothingPlanned { reason: NothingReason::AllBlocked { by } };
        assert_eq!(
            json(&blocked),
            r#"{"code":"nothing_planned","reason":"all_blocked","by":[{"cause":"beam","by_surface":3,"targets":7}]}"#
        );
        let changed =
            PlanFinding::PartChanged { was: "a".into(), is: "b".into(), kept: vec![[1, 1], [2, 5]], lost: vec![3] };
        let tool_body = ToolBody::Head;
        let unproven = Unproven { tool_body, surface: Some(SurfaceId(3)), moves: 12 };
        assert_eq!(
            json(&PlanFinding::NotProven(unproven)),
            r#"{"code":"not_proven","tool":"head","surface":3,"moves":12}"#
        );
        let in_file = PlanFinding::InFile(PartFinding::BytesPassedOver { count: 5, at: 684 });
        assert_eq!(json(&in_file), r#"{"code":"bytes_passed_over","count":5,"at":684}"#);
        assert_eq!(json(&changed), r#"{"code":"part_changed","was":"a","is":"b","kept":[[1,1],[2,5]],"lost":[3]}"#);
    }
}
