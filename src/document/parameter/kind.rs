//! What a number measures or counts: from that follow its unit, and how finely it is shown and dragged.

/// What a number measures or counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberKind {
    /// A distance, mm.
    Length,
    /// The wavelength of light, nm.
    Wavelength,
    /// An area, mm².
    Area,
    /// An angle, degrees.
    Angle,
    /// A turn per way, degrees/mm.
    TurnPerLength,
    /// A turn over time, degrees/s.
    TurnRate,
    /// A speed, mm/s.
    Speed,
    /// A power, W.
    Power,
    /// A frequency, kHz.
    Frequency,
    /// Energy on an area, J/cm².
    Fluence,
    /// A force, N.
    Force,
    /// How fast a speed changes, mm/s².
    Acceleration,
    /// A width in an image, pixels.
    Pixels,
    /// A part of a whole, per cent.
    Share,
    /// A ratio, without a unit.
    Factor,
    /// How many: a whole number.
    Count,
}

impl NumberKind {
    /// The unit as printed; empty where there is none.
    pub const fn unit(self) -> &'static str {
        match self {
            NumberKind::Length => "mm",
            NumberKind::Wavelength => "nm",
            NumberKind::Area => "mm²",
            NumberKind::Angle => "°",
            NumberKind::TurnPerLength => "°/mm",
            NumberKind::TurnRate => "°/s",
            NumberKind::Speed => "mm/s",
            NumberKind::Power => "W",
            NumberKind::Frequency => "kHz",
            NumberKind::Fluence => "J/cm²",
            NumberKind::Force => "N",
            NumberKind::Acceleration => "mm/s²",
            NumberKind::Pixels => "px",
            NumberKind::Share => "%",
            NumberKind::Factor | NumberKind::Count => "",
        }
    }

    /// Whether it is a whole number.
    pub const fn is_whole(self) -> bool {
        matches!(self, NumberKind::Count)
    }

    /// How many decimals are shown, at most.
    pub fn decimals(self) -> usize {
        if self.is_whole() { 0 } else { 4 }
    }

    /// By how much a drag over one pixel changes a value.
    pub fn drag_step(self, value: f64) -> f64 {
        // Twenty pixels a step: a count is never passed over.
        if self.is_whole() { 0.05 } else { (value.abs() * 0.01).clamp(0.001, 1.0) }
    }
}
