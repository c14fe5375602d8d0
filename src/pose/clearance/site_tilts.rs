//! The tilts of the beam at one site of a line: as it arrives there, and as it leaves.

use super::track::TiltVector;

/// The tilts at a site. They differ where the line is split.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SiteTilts {
    /// Arriving; `None`: the laser is off before.
    pub arrive: Option<TiltVector>,
    /// Leaving; `None`: the laser is off behind.
    pub leave: Option<TiltVector>,
}
