//! Handles in the view by which a clamp, the laser or the part is moved and turned: arrows along the axes of what is
//! moved, and rings around them.
//!
//! `moved` says what is moved and which edit that is, `handles` finds and draws the handles, `drag` is the motion of a
//! hand as a motion in space.

mod drag;
mod handles;
mod moved;
pub(super) mod state;

pub(super) use handles::Handle;
pub(super) use moved::put_clamp;

use super::actions::Actions;
use super::context::Context;
use crate::view::{Camera, ViewportResponse};
use drag::Drag;
use eframe::egui;

impl Context<'_> {
    /// Whether a press at this place of the view takes a handle, so that it moves no camera.
    pub fn handle_at(self, at: egui::Pos2, rect: egui::Rect, camera: &Camera, per_point: f64) -> Option<Handle> {
        let gizmo = self.session.gizmo.as_ref()?;
        let pose = self.pose_of(gizmo.of)?;
        handles::at(at, &handles::placed(&pose, rect, camera, per_point))
    }
}

/// Draws the handles and does what a hand does with them. `view`: the view as it was drawn in this frame.
pub(super) fn ui(ui: &egui::Ui, view: &ViewportResponse, camera: &Camera, context: Context<'_>, actions: &mut Actions) {
    let Some(gizmo) = &context.session.gizmo else { return };
    let Some(pose) = context.pose_of(gizmo.of) else { return };
    let (rect, per_point) = (view.response.rect, f64::from(ui.pixels_per_point()));
    let placed = handles::placed(&pose, rect, camera, per_point);
    let pointer = ui.input(|i| i.pointer.latest_pos());
    let hovered = pointer.filter(|at| rect.contains(*at)).and_then(|at| handles::at(at, &placed));
    handles::draw(&ui.painter_at(rect), &placed, gizmo.drag.as_ref().map(|d| d.handle).or(hovered));
    let ray = pointer.map(|at| {
        let px = (at - rect.min) * per_point as f32;
        camera.ray_through(nalgebra::Point2::new(f64::from(px.x), f64::from(px.y)), view.size)
    });
    let (is_pressed, is_down) = ui.input(|i| (i.pointer.primary_pressed(), i.pointer.primary_down()));
    match (&gizmo.drag, ray) {
        (None, Some(ray)) if is_pressed && view.response.contains_pointer() => {
            let drag = hovered.and_then(|handle| Drag::begin(handle, &pose, &ray));
            if drag.is_some() {
                actions.session(move |s| s.gizmo.iter_mut().for_each(|g| g.drag.clone_from(&drag)));
            }
        }
        (Some(_), _) if !is_down => actions.session(|s| s.gizmo.iter_mut().for_each(|g| g.drag = None)),
        (Some(drag), Some(ray)) => {
            if let Some(moved) = drag.pose_at(&ray).filter(|moved| *moved != pose) {
                context.move_to(gizmo.of, &moved, actions);
            }
        }
        _ => {}
    }
}
