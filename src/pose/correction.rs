//! Which correction is applied to beams that interfere.

use serde::{Deserialize, Serialize};

/// How interfering targets are treated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Correction {
    /// They count as blocked: the state before correction (P1 Figs 7–9, left).
    None,
    /// P1 3.2: turned within the section plane.
    #[default]
    SectionPlane,
    /// Turned in two degrees of freedom, along the whole line at once.
    Clearance,
}

crate::part::keyed_words!(Correction: None, SectionPlane, Clearance);

impl Correction {
    /// All corrections, as offered.
    pub const ALL: [Correction; 3] = [Correction::SectionPlane, Correction::Clearance, Correction::None];

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Correction::None => "none",
            Correction::SectionPlane => "section-plane",
            Correction::Clearance => "clearance",
        }
    }

    /// The correction with this word.
    pub fn from_word(word: &str) -> Option<Correction> {
        Correction::ALL.into_iter().find(|c| c.word() == word)
    }
}
