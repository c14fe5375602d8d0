//! The unit that a part's file was written in. STL, OBJ and PLY do not say, so the operator does; 3MF does. An
//! implausible size is remarked on, never scaled in silence.

use serde::{Deserialize, Serialize};

/// Unit of the coordinates in the file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// Millimetres.
    #[default]
    Mm,
    /// Metres.
    M,
    /// Inches.
    Inch,
}

impl Units {
    /// All units, in the order in which they are offered.
    pub const ALL: [Units; 3] = [Units::Mm, Units::M, Units::Inch];

    /// Millimetres in one unit.
    pub fn mm(self) -> f64 {
        match self {
            Units::Mm => 1.0,
            Units::M => 1000.0,
            Units::Inch => 25.4,
        }
    }

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Units::Mm => "mm",
            Units::M => "m",
            Units::Inch => "inch",
        }
    }

    /// The unit of that word.
    pub fn from_word(word: &str) -> Option<Units> {
        Units::ALL.into_iter().find(|u| u.word() == word)
    }

    /// A unit in which the part would have a plausible size, where this one gives none.
    ///
    /// `largest` is the longest side of the box around the part, in file units. Bracketing cases: an IMU housing of
    /// 0.047 (metres), a connecting rod of 5.6 (inches), a hip cup of 46 (mm, nothing offered).
    pub fn better_guess(self, largest: f64) -> Option<Units> {
        let plausible = |u: Units| is_plausible(largest * u.mm());
        if plausible(self) {
            return None;
        }
        // Below one unit metres are the likelier slip (CAD in SI), above it inches.
        let order = if largest < 1.0 { [Units::M, Units::Inch, Units::Mm] } else { [Units::Inch, Units::Mm, Units::M] };
        order.into_iter().find(|&u| u != self && plausible(u))
    }
}

/// Whether a part can be that large: its longest side, mm. Parts that a robot works on measure 10 mm to 3 m.
pub fn is_plausible(longest_mm: f64) -> bool {
    (10.0..=3000.0).contains(&longest_mm)
}

/// A unit that a file states itself, as 3MF files do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum StatedUnit {
    /// A thousandth of a millimetre.
    Micron,
    /// Millimetres.
    Millimeter,
    /// Centimetres.
    Centimeter,
    /// Inches.
    Inch,
    /// Feet.
    Foot,
    /// Metres.
    Meter,
}

impl StatedUnit {
    /// All of them.
    pub const ALL: [StatedUnit; 6] = [
        StatedUnit::Micron,
        StatedUnit::Millimeter,
        StatedUnit::Centimeter,
        StatedUnit::Inch,
        StatedUnit::Foot,
        StatedUnit::Meter,
    ];

    /// Its word in 3MF files.
    pub fn word(self) -> &'static str {
        match self {
            StatedUnit::Micron => "micron",
            StatedUnit::Millimeter => "millimeter",
            StatedUnit::Centimeter => "centimeter",
            StatedUnit::Inch => "inch",
            StatedUnit::Foot => "foot",
            StatedUnit::Meter => "meter",
        }
    }

    /// The unit of that word.
    pub fn from_word(word: &str) -> Option<StatedUnit> {
        StatedUnit::ALL.into_iter().find(|u| u.word() == word)
    }

    /// The unit that a part of such a file has: the same where a part can have it, else millimetres.
    pub fn taken(self) -> Units {
        match self {
            StatedUnit::Inch => Units::Inch,
            StatedUnit::Meter => Units::M,
            StatedUnit::Micron | StatedUnit::Millimeter | StatedUnit::Centimeter | StatedUnit::Foot => Units::Mm,
        }
    }

    /// One of it in the unit that is taken.
    pub fn in_taken(self) -> f64 {
        match self {
            StatedUnit::Micron => 0.001,
            StatedUnit::Centimeter => 10.0,
            StatedUnit::Foot => 304.8,
            StatedUnit::Millimeter | StatedUnit::Inch | StatedUnit::Meter => 1.0,
        }
    }
}

super::keyed_words!(Units: Mm, M, Inch);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_better_unit_is_offered_only_where_the_size_is_implausible() {
        assert_eq!(Units::Mm.better_guess(46.0), None);
        assert_eq!(Units::Mm.better_guess(0.047), Some(Units::M));
        assert_eq!(Units::Mm.better_guess(5.6), Some(Units::Inch));
        assert_eq!(Units::M.better_guess(46.0), Some(Units::Inch));
        assert_eq!(Units::Mm.better_guess(1e9), None);
    }
}
