//! Lead-in and lead-out: straight on along the line at the speed of the work, the laser off, so that the spot
//! has its speed when the laser goes on and keeps it until it is off.
//!
//! The beam keeps its direction. A lead on which beam or head would touch something is left out, and counted.

use super::transfer_space::TransferSpace;
use crate::pose::Pass;
use crate::program::neutral::steps::Station;

/// A lead, seen from the end of the lit piece that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lead {
    /// The far end of the lead: where a lead-in begins, or a lead-out ends.
    pub at: Station,
    /// How long it takes, s.
    pub seconds: f64,
}

/// The two leads of a lit piece, where they are wanted and free.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leads {
    /// Before the laser goes on.
    pub before: Option<Lead>,
    /// After it went off.
    pub behind: Option<Lead>,
    /// How many of the two are wanted but not free.
    pub left_out: usize,
}

/// The leads of the lit piece of a pass from target `first` to `last`, which the beam stands at as given.
pub fn leads(
    space: &TransferSpace<'_>,
    pass: &Pass,
    (first, last): (usize, usize),
    [start, end]: [&Station; 2],
) -> Leads {
    let before = lead(space, pass, (first, first + 1), start, pass.settings.lead_in_mm);
    let behind = lead(space, pass, (last, last.saturating_sub(1)), end, pass.settings.lead_out_mm);
    let left_out = [&before, &behind].iter().filter(|l| matches!(l, Some(Err(())))).count();
    Leads { before: before.and_then(Result::ok), behind: behind.and_then(Result::ok), left_out }
}

/// The lead that goes straight on beyond target `at`, away from target `inner`.
/// `None`: none is wanted; an error: it is not free.
fn lead(
    space: &TransferSpace<'_>,
    pass: &Pass,
    (at, inner): (usize, usize),
    station: &Station,
    length_mm: f64,
) -> Option<Result<Lead, ()>> {
    let way = pass.targets.get(at)?.p - pass.targets.get(inner)?.p;
    let direction = way.try_normalize(1e-9).filter(|_| length_mm > 0.0)?;
    let there = Station { x: station.x + direction * length_mm, ..*station };
    let is_free = space.is_lead_free(station, &there, pass.settings.defocus_mm);
    Some(if is_free { Ok(Lead { at: there, seconds: length_mm / pass.settings.speed_mm_s }) } else { Err(()) })
}
