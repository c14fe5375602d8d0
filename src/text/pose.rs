//! What is in the way of beam or head.

use super::{Sentence, id, say};
use crate::pose::{Blocker, Obstruction, ToolBody};

impl Sentence for Blocker {
    fn sentence(&self) -> String {
        match (self.tool_body, self.obstruction) {
            (ToolBody::Beam, Obstruction::Facet(facet)) => say!(beam_hits_facet, facet = id(facet)),
            (ToolBody::Head, Obstruction::Facet(facet)) => say!(head_hits_facet, facet = id(facet)),
            (ToolBody::Beam, Obstruction::Clamp(clamp)) => say!(beam_hits_clamp, clamp = id(clamp + 1)),
            (ToolBody::Head, Obstruction::Clamp(clamp)) => say!(head_hits_clamp, clamp = id(clamp + 1)),
        }
    }
}
