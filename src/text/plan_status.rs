//! The state of a plan in one line: first what is not proven, then what is left out, then what is done.

use super::{Sentence, say};
use crate::planning::report::{NothingReason, PlanStatus};

impl Sentence for PlanStatus {
    fn sentence(&self) -> String {
        if self.lit_moves == 0 {
            return nothing(self);
        }
        let mut parts = Vec::new();
        if self.unproven > 0 {
            parts.push(say!(standing_unproven, moves = self.unproven));
        }
        if self.left_out > 0 {
            parts.push(say!(standing_left_out, targets = self.left_out));
        }
        if self.proven() > 0 {
            parts.push(say!(standing_proven, moves = self.proven()));
        }
        parts.join(" \u{b7} ")
    }
}

/// Why no move has the laser on.
fn nothing(status: &PlanStatus) -> String {
    match (status.targets, status.left_out) {
        (0, _) => match &status.nothing {
            Some(NothingReason::NoWear) => say!(standing_no_wear),
            Some(NothingReason::Held) => say!(standing_held),
            Some(NothingReason::NothingToGrind) => say!(standing_nothing_to_grind),
            Some(NothingReason::NoLines { taken_by: Some(why), .. }) => {
                say!(standing_no_lines_for, why = why.sentence())
            }
            Some(NothingReason::NoLines { .. } | NothingReason::AllBlocked { .. }) | None => say!(standing_no_lines),
        },
        (_, 0) => say!(standing_no_light),
        (targets, left_out) if targets == left_out => say!(standing_all_left_out, targets = left_out),
        (_, left_out) => say!(standing_nothing_left, targets = left_out),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planning::TakenBy;
    use crate::planning::report::Grade;

    fn status_of(targets: usize, left_out: usize, lit_moves: usize, unproven: usize) -> PlanStatus {
        PlanStatus { targets, left_out, lit_moves, unproven, nothing: None }
    }

    #[test]
    fn what_is_not_done_comes_first() {
        let cases = [
            (status_of(1700, 0, 1426, 0), Grade::Free, "proven free: 1 426 lit moves"),
            (status_of(2, 0, 1, 0), Grade::Free, "proven free: 1 lit move"),
            (status_of(1700, 232, 1426, 0), Grade::LeftOut, "232 targets left out · proven free: 1 426 lit moves"),
            (status_of(9, 1, 1, 0), Grade::LeftOut, "1 target left out · proven free: 1 lit move"),
            (status_of(1700, 0, 1426, 3), Grade::Unproven, "3 lit moves not proven · proven free: 1 423 lit moves"),
            (
                status_of(1_000_700, 232, 1_000_426, 1),
                Grade::Unproven,
                "1 lit move not proven · 232 targets left out · proven free: 1 000 425 lit moves",
            ),
            (status_of(9, 0, 4, 4), Grade::Unproven, "4 lit moves not proven"),
        ];
        for (status, grade, text) in cases {
            assert_eq!((status.grade(), status.sentence().as_str()), (grade, text));
        }
    }

    #[test]
    fn without_a_move_nothing_is_proven() {
        let cases = [
            (0, 0, "nothing to do: no line lies on the chosen surfaces"),
            (4, 0, "nothing to do: no move has the laser on"),
            (1, 1, "nothing to do: its only target is left out"),
            (1232, 1232, "nothing to do: all 1 232 targets left out"),
            (1232, 1230, "nothing to do: 1 230 targets left out"),
        ];
        for (targets, left_out, text) in cases {
            let status = status_of(targets, left_out, 0, 0);
            assert_eq!((status.grade(), status.sentence().as_str()), (Grade::Nothing, text));
        }
        let inset =
            NothingReason::NoLines { taken_by: Some(TakenBy::Inset { inset_mm: 9.99 }), area_mm2: 0.0, by: Vec::new() };
        let reasons = [
            (inset, "nothing to do: no line lies on the chosen surfaces: the inset of 9.99 mm leaves none"),
            (NothingReason::NoWear, "nothing to do: the scan shows no patch to work"),
            (NothingReason::Held, "the passes wait for your word"),
        ];
        for (reason, text) in reasons {
            let status = PlanStatus { nothing: Some(reason), ..status_of(0, 0, 0, 0) };
            assert_eq!(status.sentence(), text);
        }
    }
}
