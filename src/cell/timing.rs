//! The `[timing]` table of a cell file: how long laser and controller take to answer, for the
//! estimate of time. It slows nothing down: waits that the program makes are in `[outputs]`.

use super::check::{FigureError, ranges};
use serde::{Deserialize, Serialize};

/// Latencies, s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Timing {
    /// From the output to light.
    pub laser_on_s: f64,
    /// From the output to darkness.
    pub laser_off_s: f64,
    /// Between two moves, for moves that the controller does not blend.
    pub move_s: f64,
}

impl Timing {
    /// Whether each latency is one.
    ///
    /// # Errors
    /// The first that is out of its range.
    pub fn check(&self) -> Result<(), FigureError> {
        ranges(&[
            ("timing.laser_on_s", self.laser_on_s, 0.0, 60.0),
            ("timing.laser_off_s", self.laser_off_s, 0.0, 60.0),
            ("timing.move_s", self.move_s, 0.0, 60.0),
        ])
    }
}
