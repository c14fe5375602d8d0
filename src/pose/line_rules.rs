//! The rules that a line is planned by. Values alone.

use super::correction::Correction;
use super::tilt::{Pin, TiltRule};
use crate::path::chord::ChordLimits;

/// What a line is planned by.
#[derive(Clone, Debug, PartialEq)]
pub struct LineRules {
    /// Largest gap of the dense line, mm.
    pub max_gap_mm: f64,
    /// Largest turn of the normal on it, degrees.
    pub max_dense_turn_deg: f64,
    /// What a chord may span.
    pub chord: ChordLimits,
    /// What is done about interference.
    pub correction: Correction,
    /// Greatest angle between beam and normal, degrees.
    pub max_tilt_deg: f64,
    /// How fast the search may turn the beam against the normal along the line, degrees/mm.
    pub tilt_rate_deg_mm: f64,
    /// What the surface asks of the tilt.
    pub tilt: TiltRule,
    /// What the operator has set on lines of the surface.
    pub pins: Vec<Pin>,
}

crate::part::keyed!(LineRules {
    max_gap_mm,
    max_dense_turn_deg,
    chord,
    correction,
    max_tilt_deg,
    tilt_rate_deg_mm,
    tilt,
    pins
});
