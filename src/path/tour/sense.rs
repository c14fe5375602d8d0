//! The sense in which the lines of a tour may be run.

/// In which sense open lines may be run. Closed ones keep theirs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// From either end.
    Either,
    /// As they are: cladding in one direction, or spirals that are to end outside.
    Kept,
}
