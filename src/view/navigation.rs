//! Which buttons of the mouse turn, move and zoom the view: by the habits of the programs that people come from.

use eframe::egui::{Modifiers, PointerButton};

/// Whose habits the view follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Navigation {
    /// Slicers: the left button orbits, the others pan.
    #[default]
    Slicer,
    /// CAD programs: the middle button orbits, and pans with Ctrl or Shift.
    Cad,
    /// Blender: the middle button orbits, pans with Shift and zooms with Ctrl.
    Blender,
}

/// What a drag does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DragKind {
    /// Turns the camera about its target.
    Orbit,
    /// Moves it across.
    Pan,
    /// Moves it nearer and further.
    Zoom,
    /// Draws a box around what is selected.
    Box,
}

impl Navigation {
    /// All, as they are offered.
    pub const ALL: [Navigation; 3] = [Navigation::Slicer, Navigation::Cad, Navigation::Blender];

    /// What a drag with a button does that begins with these keys held.
    pub(super) fn drag(self, button: PointerButton, keys: Modifiers) -> Option<DragKind> {
        use {DragKind as D, Navigation as N, PointerButton as B};
        match (self, button) {
            (N::Slicer, B::Primary) if keys.shift => Some(D::Box),
            (N::Slicer, B::Primary) => Some(D::Orbit),
            (N::Slicer, B::Middle) | (_, B::Secondary) => Some(D::Pan),
            (N::Cad | N::Blender, B::Primary) => Some(D::Box),
            (N::Blender, B::Middle) if keys.command => Some(D::Zoom),
            (_, B::Middle) if keys.shift || keys.command => Some(D::Pan),
            (_, B::Middle) => Some(D::Orbit),
            (_, B::Extra1 | B::Extra2) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_habit_can_orbit_pan_and_draw_a_box() {
        let keys = [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND];
        let buttons = [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary];
        for navigation in Navigation::ALL {
            let all: Vec<_> =
                buttons.iter().flat_map(|b| keys.iter().filter_map(|k| navigation.drag(*b, *k))).collect();
            for kind in [DragKind::Orbit, DragKind::Pan, DragKind::Box] {
                assert!(all.contains(&kind), "{navigation:?} never does {kind:?}");
            }
        }
    }
}
