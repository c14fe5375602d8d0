//! What is wrong with the file of a head or contact tool, and what they or the beam hit.

use super::{Sentence, exact, id, say};
use crate::beam::{ContactToolError, ContactToolFault, HeadError, StackError};
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

impl Sentence for ContactToolError {
    fn sentence(&self) -> String {
        match self {
            ContactToolError::File(e) => e.sentence(),
            ContactToolError::Tool { file, what } => say!(in_file, file, what = what.sentence()),
        }
    }
}

impl Sentence for ContactToolFault {
    fn sentence(&self) -> String {
        match self {
            ContactToolFault::Toml(e) => e.sentence(),
            ContactToolFault::Missing { key } => say!(contact_tool_missing, key = *key),
            ContactToolFault::Needless { line, key } => say!(contact_tool_needless, line = id(line), key = *key),
            ContactToolFault::Range { line, key, value, low, high } => say!(
                contact_tool_range,
                line = id(line),
                key = *key,
                value = exact(*value),
                low = exact(*low),
                high = exact(*high)
            ),
            ContactToolFault::Stack(e) => e.sentence(),
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
            (ToolBody::Abrasive, Obstruction::Facet(facet)) => say!(abrasive_hits_facet, facet = id(facet)),
            (ToolBody::Abrasive, Obstruction::Clamp(clamp)) => say!(abrasive_hits_clamp, clamp = id(clamp + 1)),
            (ToolBody::Abrasive, Obstruction::Unscanned) => say!(abrasive_in_unscanned),
            (ToolBody::Gouge, Obstruction::Facet(facet)) => say!(abrasive_gouges_facet, facet = id(facet)),
            // Clamps and what was not scanned are no skin.
            (ToolBody::Gouge, Obstruction::Clamp(clamp)) => say!(abrasive_hits_clamp, clamp = id(clamp + 1)),
            (ToolBody::Gouge, Obstruction::Unscanned) => say!(abrasive_in_unscanned),
            (ToolBody::Beam, Obstruction::Unscanned) => say!(beam_in_unscanned),
            (ToolBody::Head, Obstruction::Unscanned) => say!(head_in_unscanned),
        }
    }
}
