//! Lengths of moves, by what becomes of them.

use crate::pose::{Pass, Target, TargetState};

/// Total length of the moves that a condition holds of, mm.
pub(super) fn length<'a>(
    passes: impl IntoIterator<Item = &'a Pass>,
    which: impl Fn(&Target, &Target) -> bool + Copy,
) -> f64 {
    passes.into_iter().map(|p| p.length_mm(which)).fold(0.0, |a, b| a + b)
}

/// The laser is off because something is in the way: over a gap of the line it is off on purpose.
pub(super) fn is_blocked(from: &Target, to: &Target) -> bool {
    !to.laser && !Pass::is_gap(from, to)
}

/// The laser is on, and an end of the move was corrected.
pub(super) fn is_corrected(from: &Target, to: &Target) -> bool {
    to.laser && (from.state == TargetState::Corrected || to.state == TargetState::Corrected)
}
