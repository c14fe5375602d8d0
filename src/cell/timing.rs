//! The `[timing]` table of a cell file: how long laser and controller take to answer, for the estimate of time, and
//! how short a lit move may be. It slows nothing down: waits that the program makes are in `[outputs]`.

use super::check::{FigureError, ranges};
use serde::{Deserialize, Serialize};

/// Latencies and the least move, s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Timing {
    /// From the output to light.
    pub laser_on_s: f64,
    /// From the output to darkness.
    pub laser_off_s: f64,
    /// Between two moves, for moves that the controller does not blend.
    pub move_s: f64,
    /// What a lit move should take at least: targets are kept so far apart where chord error, turn and deviation
    /// allow, and moves that are shorter are told. Controllers interpolate every 2 ms (UR e-Series) to 12 ms (KUKA
    /// KR C4): at 20 ms every move has a point of its own on any of them. No maker states a least time.
    pub least_move_s: f64,
}

impl Default for Timing {
    fn default() -> Self {
        Timing { laser_on_s: 0.0, laser_off_s: 0.0, move_s: 0.0, least_move_s: 0.02 }
    }
}

impl Timing {
    /// Whether each figure is one.
    ///
    /// # Errors
    /// The first that is out of its range.
    pub fn check(&self) -> Result<(), FigureError> {
        ranges(&[
            ("timing.laser_on_s", self.laser_on_s, 0.0, 60.0),
            ("timing.laser_off_s", self.laser_off_s, 0.0, 60.0),
            ("timing.move_s", self.move_s, 0.0, 60.0),
            ("timing.least_move_s", self.least_move_s, 0.0, 10.0),
        ])
    }
}
