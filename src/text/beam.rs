//! What is wrong with a head's file, and what beam or head hits.

use super::{Sentence, exact, id, say};
use crate::beam::{HeadError, StackError};
use crate::pose::{Blocker, Obstruction, ToolBody};

impl Sentence for HeadError {
    fn sentence(&self) -> String {
        match self {
            HeadError::File(e) => e.sentence(),
            HeadError::Stack { file, what } => say!(head_stack, file, what = what.sentence()),
            HeadError::Solid(e) => e.sentence(),
        }
    }
}

impl Sentence for StackError {
    fn sentence(&self) -> String {
        match self {
            StackError::Toml(e) => e.sentence(),
            StackError::Empty => say!(stack_empty),
            StackError::Span { line, part, from_mm, to_mm } => {
                say!(stack_span, line = id(line), part = id(part), from = exact(*from_mm), to = exact(*to_mm))
            }
            StackError::Radii { line, part, r0_mm, r1_mm } => {
                say!(stack_radii, line = id(line), part = id(part), r0 = exact(*r0_mm), r1 = exact(*r1_mm))
            }
        }
    }
}

impl Sentence for Blocker {
    fn sentence(&self) -> String {
        match (self.tool_body, self.obstruction) {
            (ToolBody::Beam, Obstruction::Facet(facet)) => say!(beam_hits_facet, facet = id(facet)),
            (ToolBody::Head, Obstruction::Facet(facet)) => say!(head_hits_facet, facet = id(facet)),
            (ToolBody::Beam, Obstruction::Clamp(clamp)) => say!(beam_hits_clamp, clamp = id(clamp + 1)),
            (ToolBody::Head, Obstruction::Clamp(clamp)) => say!(head_hits_clamp, clamp = id(clamp + 1)),
            (ToolBody::Beam, Obstruction::Unscanned) => say!(beam_in_unscanned),
            (ToolBody::Head, Obstruction::Unscanned) => say!(head_in_unscanned),
        }
    }
}
