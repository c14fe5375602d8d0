//! When the spot goes from target to target: as the program has it, or at the speed that is set.

use super::light_piece::BeamFrame;

/// When the spot goes to a target, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayTime {
    /// How long it takes from the target before.
    pub seconds: f64,
    /// When it is there, from the program's start.
    pub ends_s: f64,
}

/// When the spot goes from each frame of a lit piece to the next. `known`: by the frame that it goes to; where that is
/// not known it goes at the speed that is set, from 0 s on.
pub(super) fn lit_way_times(
    frames: &[BeamFrame],
    speed_mm_s: f64,
    known: impl Fn(usize) -> Option<WayTime>,
) -> Vec<WayTime> {
    let mut ends_s = 0.0;
    let time = |(i, w): (usize, &[BeamFrame])| {
        let seconds = (w[1].p - w[0].p).norm() / speed_mm_s;
        ends_s += seconds;
        known(i + 1).unwrap_or(WayTime { seconds, ends_s })
    };
    frames.windows(2).enumerate().map(time).collect()
}
