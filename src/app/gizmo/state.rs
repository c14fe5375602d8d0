//! What the session keeps of the handles: what they move, and which one is held.

use super::drag::Drag;

/// Something that is moved by hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Moved {
    /// A clamp on the part, by its place in the list.
    Clamp(usize),
    /// The laser in the base, under a part that the robot carries.
    Laser,
    /// The part in the base, under a head that the robot carries.
    Part,
}

/// The handles that are shown, and what a hand does with them.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Gizmo {
    /// What they move.
    pub of: Moved,
    /// The handle that is held.
    pub drag: Option<Drag>,
}

impl Gizmo {
    /// Handles on something, with no hand on them.
    pub fn on(of: Moved) -> Gizmo {
        Gizmo { of, drag: None }
    }

    /// Whether a hand holds one of them.
    pub fn is_held(&self) -> bool {
        self.drag.is_some()
    }
}
