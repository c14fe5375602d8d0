//! The `[timing]` table of a cell file: how long laser and controller take to answer, for the
//! estimate of time. It slows nothing down: waits that the program makes are in `[outputs]`.

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
    /// # Errors
    /// Which figure makes no sense, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let figures = [("laser_on_s", self.laser_on_s), ("laser_off_s", self.laser_off_s), ("move_s", self.move_s)];
        match figures.into_iter().find(|(_, s)| !(0.0..=60.0).contains(s)) {
            Some((name, s)) => Err(format!("timing.{name} = {s}: give 0 to 60 seconds")),
            None => Ok(()),
        }
    }
}
