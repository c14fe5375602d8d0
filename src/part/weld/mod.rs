//! Welds the corners of facets to vertices: those with equal coordinates, and where edges stay open those of open
//! edges that are a rounding apart.

mod exact;
mod joining;
mod seams;
#[cfg(test)]
mod tests;

use super::edges::Edges;
use super::raw_part::RawFacet;
use crate::progress::{Cancelled, Progress};
use serde::{Deserialize, Serialize};

/// Which corners become one vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Weld {
    /// Those with equal coordinates; then those of open edges a rounding apart, where that closes edges.
    #[default]
    Auto,
    /// Those with equal coordinates alone.
    Exact,
}

impl Weld {
    /// Both, in the order in which they are offered.
    pub const ALL: [Weld; 2] = [Weld::Auto, Weld::Exact];

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Weld::Auto => "auto",
            Weld::Exact => "exact",
        }
    }

    /// The one of that word.
    pub fn from_word(word: &str) -> Option<Weld> {
        Weld::ALL.into_iter().find(|w| w.word() == word)
    }
}

super::keyed_words!(Weld: Auto, Exact);

/// What was joined that is not equal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joined {
    /// Vertices that vanished.
    pub corners: usize,
    /// The farthest way that one of them went, file units.
    pub within: f64,
}

/// Facets over vertices, file units.
#[derive(Clone, Debug, Default)]
pub struct Welded {
    /// Vertices in the order of first appearance; of joined ones the first.
    pub points: Vec<[f32; 3]>,
    /// Vertices of each facet.
    pub facets: Vec<[u32; 3]>,
    /// What was joined that is not equal.
    pub joined: Joined,
    pub(super) edges: Edges,
}

impl Welded {
    /// Welds facets as stored (−0 = 0).
    pub fn new(raw: &[RawFacet], weld: Weld) -> Welded {
        // Nobody else holds this progress, so it is not cancelled.
        Welded::built(raw, weld, &Progress::default()).unwrap_or_default()
    }

    /// Welds facets as stored (−0 = 0), as long as nobody wants that to end.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(raw: &[RawFacet], weld: Weld, progress: &Progress) -> Result<Welded, Cancelled> {
        let (points, facets) = exact::weld_corners(raw, progress)?;
        let edges = Edges::built(points.len(), &facets, progress)?;
        let exact = Welded { points, facets, joined: Joined::default(), edges };
        if weld == Weld::Exact {
            return Ok(exact);
        }
        let seams = seams::matched(&exact.points, &exact.facets, &exact.edges, progress)?;
        Ok(joining::joined(&exact.points, &exact.facets, seams, progress)?.unwrap_or(exact))
    }
}
