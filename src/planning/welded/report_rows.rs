//! Rows of what is reported of a weld: areas, times, passes. Values alone; `weld_report` gathers them.

use crate::weld::bead::AreaKind;
use serde::Serialize;

/// An area that is to be ground.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AreaReport {
    /// What it is.
    pub area: AreaKind,
    /// The surfaces that it is ground as; none where it was not chosen.
    pub surfaces: Vec<u32>,
    /// Its area on the surface.
    pub area_mm2: f64,
    /// Length by width of the ellipse with the same spread.
    pub aspect: f64,
    /// Height where it is highest.
    pub max_height_mm: f64,
    /// Column and row of its middle in the image.
    pub centre_px: [f64; 2],
}

/// How long each strategy takes for an area at a speed, s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AreaTimes {
    /// The area.
    pub area: AreaKind,
    /// Speed on the surface, mm/s.
    pub speed_mm_s: f64,
    /// Lines all in one sense.
    pub one_way_s: f64,
    /// Lines back and forth.
    pub zigzag_s: f64,
    /// A spiral.
    pub spiral_s: f64,
    /// How often each of the three leaves the surface on the way, in that order.
    pub lifts: [u32; 3],
}

/// A pass that was ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GroundPassReport {
    /// Height before it.
    pub before_mm: f64,
    /// Height that it should have left.
    pub planned_mm: f64,
    /// Height that it left, as measured.
    pub left_mm: f64,
}

/// Why the next pass waits for the operator's word.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "cause", rename_all = "snake_case")]
pub enum HeldReason {
    /// The last pass took off more or less than it should.
    Removal {
        /// What it took off.
        removed_mm: f64,
        /// What it should have.
        planned_mm: f64,
    },
    /// Something was ground below the surface around the bead.
    Below {
        /// By how much.
        below_mm: f64,
    },
    /// Where the images lie on the part is open, and nobody knows where the camera stood: so no area is ground.
    Place {
        /// How far they may lie off; `None`: they slide, or lie as well elsewhere.
        slack_mm: Option<f64>,
    },
}

impl AreaTimes {
    /// The quickest: 0 one-way, 1 zigzag, 2 spiral; of equals the last.
    pub fn quickest(&self) -> usize {
        let all = [self.one_way_s, self.zigzag_s, self.spiral_s];
        (0..3).fold(2, |best, i| if all[i] < all[best] { i } else { best })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quickest_of_equals_is_the_spiral() {
        let times = |one_way_s, zigzag_s, spiral_s| AreaTimes {
            area: AreaKind::Flat,
            speed_mm_s: 50.0,
            one_way_s,
            zigzag_s,
            spiral_s,
            lifts: [0; 3],
        };
        assert_eq!(times(9.0, 5.0, 4.0).quickest(), 2);
        assert_eq!(times(9.0, 3.0, 4.0).quickest(), 1);
        assert_eq!(times(4.0, 4.0, 4.0).quickest(), 2);
    }
}
