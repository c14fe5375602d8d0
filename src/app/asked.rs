//! Questions of panels that still draw on the whole window; the answers are those of its
//! [`Context`](super::context::Context).

use super::command::Command;
use super::{App, panels};
use eframe::egui;
use nalgebra::Isometry3;

impl App {
    /// Whether a command can do anything now.
    pub(super) fn is_enabled(&self, command: Command) -> bool {
        self.context().is_enabled(command)
    }

    /// Whether the robot refuses anything of the plan.
    pub(super) fn has_refusals(&self) -> bool {
        self.context().refusing_plan().is_some()
    }

    /// Whether a better set-up is being looked for.
    pub(super) fn is_proposing(&self) -> bool {
        self.derived.remedy.is_proposing()
    }

    /// Where the part stands in the view: in its own frame, or in the base.
    pub(super) fn scene_from_part(&self) -> Isometry3<f64> {
        self.context().scene_from_part()
    }

    /// What is wrong with the plan.
    pub(super) fn problems(&mut self, ui: &mut egui::Ui) {
        self.panel(|context, actions| panels::problems::ui(ui, context, actions));
    }
}
