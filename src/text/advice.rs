//! What would help where the robot refuses targets.

use super::{Sentence, fixed, say};
use crate::cell::Mount;
use crate::cell::motion::advice::{FrameAxis, SetupChange, SuggestedChange};
use crate::planning::advice::Suggestion;

impl Sentence for Suggestion {
    fn sentence(&self) -> String {
        match self {
            Suggestion::SetupChange(suggested) => suggested.sentence(),
            Suggestion::Slower { speed_mm_s } => say!(advice_slower, speed = fixed(*speed_mm_s, 2)),
            Suggestion::Sampled { tried, of } => say!(advice_sampled, tried = *tried, of = *of),
        }
    }
}

impl Sentence for SuggestedChange {
    fn sentence(&self) -> String {
        say!(advice_change, change = self.change.sentence(), gains = self.gains())
    }
}

impl SuggestedChange {
    /// What the change brings, and what it takes.
    pub fn gains(&self) -> String {
        let SuggestedChange { gained, of, lost, .. } = *self;
        match lost {
            0 => say!(advice_gains, gained, of),
            _ => say!(advice_gains_and_loses, gained, of, lost),
        }
    }
}

impl Sentence for SetupChange {
    fn sentence(&self) -> String {
        match *self {
            SetupChange::FreeSpin => say!(advice_free_spin),
            SetupChange::TurnPart { mount: Mount::PartInHand, axis, deg } => {
                say!(advice_turn_on_flange, axis = letter(axis), deg = fixed(deg, 0))
            }
            SetupChange::TurnPart { mount: Mount::ToolInHand, axis, deg } => {
                say!(advice_turn_on_table, axis = letter(axis), deg = fixed(deg, 0))
            }
            SetupChange::Move { mount, axis, mm } => {
                let what = match mount {
                    Mount::PartInHand => "laser",
                    Mount::ToolInHand => "part",
                };
                let direction = match (axis, mm > 0.0) {
                    (FrameAxis::Z, true) => "up",
                    (FrameAxis::Z, false) => "down",
                    (FrameAxis::X, true) => "out",
                    (FrameAxis::X, false) => "in",
                    (FrameAxis::Y, true) => "left",
                    (FrameAxis::Y, false) => "right",
                };
                say!(advice_move, what, mm = fixed(mm.abs(), 0), direction)
            }
            SetupChange::HoldFurther { mm } => say!(advice_hold_further, mm = fixed(mm, 0)),
        }
    }
}

fn letter(axis: FrameAxis) -> &'static str {
    match axis {
        FrameAxis::X => "x",
        FrameAxis::Y => "y",
        FrameAxis::Z => "z",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_told_with_what_it_brings() {
        let change = SetupChange::Move { mount: Mount::PartInHand, axis: FrameAxis::Z, mm: -150.0 };
        let suggested = SuggestedChange { change, gained: 40, of: 60, lost: 0 };
        assert_eq!(suggested.sentence(), "put the laser 150 mm lower: 40 of 60 refused targets become possible");
        let change = SetupChange::TurnPart { mount: Mount::ToolInHand, axis: FrameAxis::X, deg: -10.0 };
        let suggested = SuggestedChange { change, gained: 2, of: 9, lost: 1 };
        let told = "turn the part on the table about its x by -10°: 2 of 9 refused targets become possible, \
                    1 other is lost";
        assert_eq!(suggested.sentence(), told);
    }
}
