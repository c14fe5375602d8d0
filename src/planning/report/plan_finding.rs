//! What was found on the way to a plan and is no problem of a target: key `findings` of the report.

use super::nothing::NothingReason;
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
}

#[cfg(test)]
mod tests {
    use super::super::nothing::BlockedBy;
    use super::*;
    use crate::cell::motion::RefusalCause;

    #[test]
    fn findings_carry_their_code_and_their_fields_side_by_side() {
        let json = |f: &PlanFinding| serde_json::to_string(f).expect("JSON");
        let no_lines = PlanFinding::NothingPlanned { reason: NothingReason::NoLines };
        assert_eq!(json(&no_lines), r#"{"code":"nothing_planned","reason":"no_lines"}"#);
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
        assert_eq!(json(&changed), r#"{"code":"part_changed","was":"a","is":"b","kept":[[1,1],[2,5]],"lost":[3]}"#);
    }
}
