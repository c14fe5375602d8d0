//! What the robot carries, and whether it may turn it about the beam.

use serde::{Deserialize, Serialize};

/// What the robot carries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mount {
    /// The part, under a fixed laser (P1, P2).
    #[default]
    PartInHand,
    /// The head, over a fixed part (P3, P4).
    ToolInHand,
}

impl Mount {
    /// The word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Mount::PartInHand => "part-in-hand",
            Mount::ToolInHand => "tool-in-hand",
        }
    }

    /// The mount of that word.
    pub fn from_word(word: &str) -> Option<Mount> {
        [Mount::PartInHand, Mount::ToolInHand].into_iter().find(|m| m.word() == word)
    }
}

/// Rotation of the part, or the tool, about the beam axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spin {
    /// Chosen for the arm's sake: the spot is round.
    #[default]
    Free,
    /// Fixed to the travel direction: a line scanner needs that.
    Travel,
}

impl Spin {
    /// The word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Spin::Free => "free",
            Spin::Travel => "travel",
        }
    }

    /// The spin of that word.
    pub fn from_word(word: &str) -> Option<Spin> {
        [Spin::Free, Spin::Travel].into_iter().find(|s| s.word() == word)
    }
}

crate::part::keyed_words!(Mount: PartInHand, ToolInHand);
crate::part::keyed_words!(Spin: Free, Travel);
