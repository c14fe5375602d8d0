//! What a dose is computed and judged by: the `[dose]` table of a job.

use crate::number_fields::number_fields;
use serde::{Deserialize, Serialize};

/// How the power is spread over the spot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Profile {
    /// Gaussian; the spot's diameter is where 1/e² of the peak is left.
    #[default]
    Gaussian,
    /// Even power everywhere in the spot.
    TopHat,
    /// A line across the travel direction, of even power along it and Gaussian across, as a scanner
    /// draws it.
    Line,
}

impl Profile {
    /// All profiles, as offered.
    pub const ALL: [Profile; 3] = [Profile::Gaussian, Profile::TopHat, Profile::Line];

    /// The word used in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Profile::Gaussian => "gaussian",
            Profile::TopHat => "top-hat",
            Profile::Line => "line",
        }
    }
}

/// The `[dose]` table of a job. A threshold of 0 stands for its share of `P/(v·d)`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct DoseParameters {
    /// How the power is spread over the spot.
    pub profile: Profile,
    /// Width of a scanned line, mm.
    pub line_mm: f64,
    /// Less leaves the surface unclean.
    pub low_j_cm2: f64,
    /// More damages it.
    pub high_j_cm2: f64,
    /// Greatest dose allowed on a surface that was not chosen.
    pub collateral_j_cm2: f64,
}

impl Default for DoseParameters {
    fn default() -> Self {
        DoseParameters::DEFAULT
    }
}

crate::part::keyed_words!(Profile: Gaussian, TopHat, Line);
crate::part::keyed!(DoseParameters { profile, line_mm, low_j_cm2, high_j_cm2, collateral_j_cm2 });
number_fields!(DoseParameters { profile: _, line_mm, low_j_cm2, high_j_cm2, collateral_j_cm2 });

/// Which doses are too little and too much, J/cm².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// Less leaves the surface unclean.
    pub low_j_cm2: f64,
    /// More damages it.
    pub high_j_cm2: f64,
    /// Greatest dose allowed on a surface that was not chosen.
    pub collateral_j_cm2: f64,
}

impl DoseParameters {
    /// Those of a new job.
    pub const DEFAULT: DoseParameters = DoseParameters {
        profile: Profile::Gaussian,
        line_mm: 10.0,
        low_j_cm2: 0.0,
        high_j_cm2: 0.0,
        collateral_j_cm2: 0.0,
    };

    /// Whether the job says itself what is too little or too much.
    pub fn has_threshold(&self) -> bool {
        [self.low_j_cm2, self.high_j_cm2, self.collateral_j_cm2].iter().any(|j_cm2| *j_cm2 != 0.0)
    }

    /// The thresholds of a job: those given, or 0.5, 2 and 0.1 times `P/(v·d)`, what lands on a plate
    /// on the average with planes d apart.
    pub fn thresholds(&self, power_w: f64, speed_mm_s: f64, spacing_mm: f64) -> Thresholds {
        let mean = 100.0 * power_w / (speed_mm_s * spacing_mm);
        let or = |given: f64, share: f64| if given > 0.0 { given } else { share * mean };
        Thresholds {
            low_j_cm2: or(self.low_j_cm2, 0.5),
            high_j_cm2: or(self.high_j_cm2, 2.0),
            collateral_j_cm2: or(self.collateral_j_cm2, 0.1),
        }
    }
}
