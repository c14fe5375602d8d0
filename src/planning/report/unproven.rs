//! Moves with the laser on that are not proven to touch nothing, by what they would touch.

use crate::part::{SurfaceId, Surfaces};
use crate::pose::ToolBody;
use crate::program::sweep::Proof;
use serde::{Serialize, Serializer};

/// Moves with the laser on whose same tool body would touch the same obstacle.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Unproven {
    /// The body of the tool that would touch it: `beam` or `head`.
    #[serde(rename = "tool", serialize_with = "word")]
    pub tool_body: ToolBody,
    /// The surface that would be touched; `None`: a clamp.
    pub surface: Option<SurfaceId>,
    /// How many moves.
    pub moves: usize,
}

fn word<S: Serializer>(tool_body: &ToolBody, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(tool_body.word())
}

/// What is not proven, in program order of the first of each.
pub(super) fn unproven(proof: &Proof, surfaces: &Surfaces) -> Vec<Unproven> {
    let mut out: Vec<Unproven> = Vec::new();
    for (_, blocker) in &proof.refuted {
        let facet = blocker.obstruction.facet();
        let surface = facet.and_then(|f| surfaces.of_facet.get(f as usize)).map(|n| SurfaceId(*n));
        match out.iter_mut().find(|u| (u.tool_body, u.surface) == (blocker.tool_body, surface)) {
            Some(known) => known.moves += 1,
            None => out.push(Unproven { tool_body: blocker.tool_body, surface, moves: 1 }),
        }
    }
    out
}
