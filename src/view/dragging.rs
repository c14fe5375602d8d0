//! A drag in the view: what it does is settled where it begins.

use super::navigation::{DragKind, Navigation};
use eframe::egui::{self, PointerButton, Pos2, Rect, Response};

/// The drag that is going on.
#[derive(Debug, Default)]
pub(super) struct Dragging {
    /// Its button, and what it does.
    now: Option<(PointerButton, DragKind)>,
    /// Where it began.
    from: Pos2,
}

impl Dragging {
    /// Takes a drag that begins in this frame. With a brush the left button paints, unless Ctrl is held.
    pub fn begin(&mut self, ui: &egui::Ui, response: &Response, navigation: Navigation, brush: bool) {
        let (keys, from) = ui.input(|input| (input.modifiers, input.pointer.press_origin()));
        for button in [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary] {
            if response.drag_started_by(button) {
                let kind = match button == PointerButton::Primary && brush {
                    true if keys.command => Some(DragKind::Orbit),
                    true => None,
                    false => navigation.drag(button, keys),
                };
                self.now = kind.map(|kind| (button, kind));
                self.from = from.unwrap_or_default();
            }
        }
    }

    /// What the drag does in this frame; `None`: there is none.
    pub fn kind(&self, response: &Response) -> Option<DragKind> {
        self.now.filter(|(button, _)| response.dragged_by(*button)).map(|(_, kind)| kind)
    }

    /// The box that is being drawn, points of the window; whether it is finished.
    pub fn drawn_box(&self, ui: &egui::Ui, response: &Response) -> Option<(Rect, bool)> {
        let (button, _) = self.now.filter(|(_, kind)| *kind == DragKind::Box)?;
        let is_over = response.drag_stopped_by(button);
        let to = ui.input(|input| input.pointer.latest_pos())?;
        (is_over || response.dragged_by(button)).then_some((Rect::from_two_pos(self.from, to), is_over))
    }
}
