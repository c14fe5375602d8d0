//! What is in the way of the tool: which of its bodies collides, and with what.

/// The part of the tool that collides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ToolBody {
    /// The beam.
    Beam,
    /// The head, or what is mounted behind a disc or belt.
    Head,
    /// The disc or belt of a contact tool, too close to a wall or a clamp.
    Abrasive,
    /// The disc or belt where it reaches into the skin: it touches beside its contact.
    Gouge,
}

impl ToolBody {
    /// Its word in `report.json`.
    pub fn word(self) -> &'static str {
        match self {
            ToolBody::Beam => "beam",
            ToolBody::Head => "head",
            ToolBody::Abrasive => "abrasive",
            ToolBody::Gouge => "gouge",
        }
    }
}

/// What the tool collides with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Obstruction {
    /// A facet of the part.
    Facet(u32),
    /// A clamp, by its place in the job's list.
    Clamp(u32),
    /// Space that was not scanned: nobody knows what is there.
    Unscanned,
}

impl Obstruction {
    /// What stands at a place of the list of clamps.
    pub fn of_clamp(index: usize, is_unscanned: bool) -> Obstruction {
        if is_unscanned { Obstruction::Unscanned } else { Obstruction::Clamp(index as u32) }
    }

    /// The facet of the part, if it is one.
    pub fn facet(self) -> Option<u32> {
        match self {
            Obstruction::Facet(facet) => Some(facet),
            Obstruction::Clamp(_) | Obstruction::Unscanned => None,
        }
    }
}

/// What stands in the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocker {
    /// Which of the tool's bodies.
    pub tool_body: ToolBody,
    /// What it hits.
    pub obstruction: Obstruction,
    /// Distance along the beam, mm.
    pub t_mm: f64,
}

impl std::fmt::Display for ToolBody {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            ToolBody::Beam => "the beam",
            ToolBody::Head => "the head",
            ToolBody::Abrasive => "the abrasive",
            ToolBody::Gouge => "the abrasive beside its contact",
        })
    }
}

impl std::fmt::Display for Blocker {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let body = self.tool_body;
        match self.obstruction {
            Obstruction::Facet(facet) => write!(f, "{body} hits facet {facet}"),
            Obstruction::Clamp(clamp) => write!(f, "{body} hits clamp {}", clamp + 1),
            Obstruction::Unscanned => write!(f, "{body} enters what was not scanned"),
        }
    }
}
