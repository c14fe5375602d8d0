//! The views that have a name, a key and a face on the cube. z is up, front looks along +y.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

/// The views on the keys 0-6 and on the faces of the view cube.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StandardView {
    /// From front, right and above.
    Iso,
    /// Looking along +y.
    Front,
    /// Looking along -y.
    Back,
    /// Looking along +x.
    Left,
    /// Looking along -x.
    Right,
    /// Looking down, +y up on the screen.
    Top,
    /// Looking up, +y down on the screen.
    Bottom,
}

impl StandardView {
    /// All, in the order of the keys 0-6.
    pub const ALL: [Self; 7] = [Self::Iso, Self::Front, Self::Back, Self::Left, Self::Right, Self::Top, Self::Bottom];

    /// The word used on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Iso => "iso",
            Self::Front => "front",
            Self::Back => "back",
            Self::Left => "left",
            Self::Right => "right",
            Self::Top => "top",
            Self::Bottom => "bottom",
        }
    }

    /// Yaw and pitch of the view.
    pub fn angles_rad(self) -> (f64, f64) {
        match self {
            // Pitch of a true isometric view.
            Self::Iso => (FRAC_PI_2 / 2.0, libm::atan(FRAC_1_SQRT_2)),
            Self::Front => (0.0, 0.0),
            Self::Back => (2.0 * FRAC_PI_2, 0.0),
            Self::Left => (-FRAC_PI_2, 0.0),
            Self::Right => (FRAC_PI_2, 0.0),
            Self::Top => (0.0, FRAC_PI_2),
            Self::Bottom => (0.0, -FRAC_PI_2),
        }
    }
}
