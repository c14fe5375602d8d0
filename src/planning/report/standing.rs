//! How a plan stands, in one sentence: what is not proven comes first, then what is left out, then the rest.

use super::Report;

/// What matters most of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grade {
    /// Moves with the laser on that are not proven to touch nothing.
    Unproven,
    /// Nothing is worked at all.
    Nothing,
    /// Targets are left out.
    LeftOut,
    /// All is worked, and proven.
    Free,
}

/// How a plan stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// What matters most.
    pub grade: Grade,
    /// In words.
    pub text: String,
}

impl Report {
    /// How the plan stands; `None` before its moves are looked at.
    pub fn standing(&self) -> Option<Standing> {
        let proof = self.proof.as_ref()?;
        Some(standing(self.points, self.blocked, proof.intervals, proof.refuted.len()))
    }
}

/// Of so many targets and moves with the laser on.
fn standing(targets: usize, left_out: usize, moves: usize, unproven: usize) -> Standing {
    let targets_left = format!("{} left out", counted(left_out, "target"));
    if moves == 0 {
        let why = match (targets, left_out) {
            (0, _) => "no line comes to what was chosen".into(),
            (_, 0) => "no move has the laser on".into(),
            (1, _) => "its only target is left out".into(),
            _ if left_out == targets => format!("all {targets_left}"),
            _ => targets_left,
        };
        return Standing { grade: Grade::Nothing, text: format!("nothing to do: {why}") };
    }
    let free = moves.saturating_sub(unproven);
    let mut said = Vec::new();
    if unproven > 0 {
        said.push(format!("{} not proven", counted(unproven, "move")));
    }
    if left_out > 0 {
        said.push(targets_left);
    }
    if free > 0 {
        let rest = if said.is_empty() { "" } else { "the other " };
        said.push(format!("{rest}{} proven free", counted(free, "move")));
    }
    let grade = match (unproven, left_out) {
        (1.., _) => Grade::Unproven,
        (0, 1..) => Grade::LeftOut,
        (0, 0) => Grade::Free,
    };
    Standing { grade, text: said.join(" · ") }
}

/// `1 426 moves`, and `1 move`.
fn counted(count: usize, what: &str) -> String {
    format!("{} {what}{}", grouped(count), if count == 1 { "" } else { "s" })
}

/// A number with a blank before every three digits.
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut out = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(' ');
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn said(targets: usize, left_out: usize, moves: usize, unproven: usize) -> (Grade, String) {
        let standing = standing(targets, left_out, moves, unproven);
        (standing.grade, standing.text)
    }

    #[test]
    fn what_is_not_done_comes_first() {
        let cases = [
            (1700, 0, 1426, 0, Grade::Free, "1 426 moves proven free"),
            (2, 0, 1, 0, Grade::Free, "1 move proven free"),
            (1700, 232, 1426, 0, Grade::LeftOut, "232 targets left out · the other 1 426 moves proven free"),
            (9, 1, 1, 0, Grade::LeftOut, "1 target left out · the other 1 move proven free"),
            (1700, 0, 1426, 3, Grade::Unproven, "3 moves not proven · the other 1 423 moves proven free"),
            (
                1_000_700,
                232,
                1_000_426,
                1,
                Grade::Unproven,
                "1 move not proven · 232 targets left out · the other 1 000 425 moves proven free",
            ),
            (9, 0, 4, 4, Grade::Unproven, "4 moves not proven"),
        ];
        for (targets, left_out, moves, unproven, grade, text) in cases {
            assert_eq!(said(targets, left_out, moves, unproven), (grade, text.into()));
        }
    }

    #[test]
    fn without_a_move_nothing_is_proven() {
        let cases = [
            (0, 0, "nothing to do: no line comes to what was chosen"),
            (4, 0, "nothing to do: no move has the laser on"),
            (1, 1, "nothing to do: its only target is left out"),
            (1232, 1232, "nothing to do: all 1 232 targets left out"),
            (1232, 1230, "nothing to do: 1 230 targets left out"),
        ];
        for (targets, left_out, text) in cases {
            assert_eq!(said(targets, left_out, 0, 0), (Grade::Nothing, text.into()));
        }
    }

    proptest! {
        #[test]
        fn grouped_digits_are_the_number(count in any::<usize>()) {
            let text = grouped(count);
            prop_assert_eq!(text.replace(' ', ""), count.to_string());
            let groups: Vec<&str> = text.split(' ').collect();
            prop_assert!(groups.iter().skip(1).all(|g| g.len() == 3) && (1..=3).contains(&groups[0].len()));
        }
    }
}
