//! The window as seen from outside: what tests look at, and the same edits and commands that panels send.

use super::derived::Derived;
use super::{App, Command, Pool};
use crate::document::{Document, Edit, Parameter};
use crate::planning::{Executor, PlannedJob};
use crate::view::Camera;
use nalgebra::Isometry3;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

impl App {
    /// The window with its work done by this executor.
    pub fn with_executor(self, executor: Arc<dyn Executor>) -> App {
        App { derived: Derived::new(executor), ..self }
    }

    /// The window with a part or job that is being opened.
    pub fn opening(mut self, path: PathBuf) -> App {
        self.open(path);
        self
    }

    /// The job that is worked on, with its file.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The plan of the job as it is; `None`: there is none, or what is shown is out of date.
    pub fn plan(&self) -> Option<&Arc<PlannedJob>> {
        self.context().plan()
    }

    /// Why the job as it is has no plan, for people.
    pub fn why_no_plan(&self) -> Option<String> {
        self.context().planning_error()
    }

    /// Numbers of the surfaces that are shown.
    pub fn surfaces(&self) -> Vec<u32> {
        self.derived.numbers()
    }

    /// The surfaces that are selected.
    pub fn selected(&self) -> &BTreeSet<u32> {
        &self.session.selected
    }

    /// The surfaces that are not shown.
    pub fn hidden(&self) -> &BTreeSet<u32> {
        &self.session.hidden
    }

    /// The current target: pass and point.
    pub fn target_at(&self) -> (usize, usize) {
        self.session.playback.at
    }

    /// From where the 3D view looks.
    pub fn camera(&self) -> &Camera {
        &self.viewport.camera
    }

    /// Where the scan stands in the view while a tool shows it beside the part, or alone.
    pub fn scene_from_scan(&self) -> Option<Isometry3<f64>> {
        self.context().scene_from_scan()
    }

    /// Whether a command can do anything now.
    pub fn can(&self, command: Command) -> bool {
        self.context().is_enabled(command)
    }

    /// Whether nothing is being computed or waited for: what is shown is current.
    pub fn is_settled(&self) -> bool {
        let is_read = self.reading.is_at_rest() && self.adding.is_at_rest() && self.asking.is_at_rest();
        let is_idle = is_read
            && self.tool.is_at_rest()
            && !self.exporting.is_running()
            && !self.reviewing.is_running()
            && !self.packing.is_running()
            && self.answers.is_empty();
        is_idle && self.derived.is_at_rest() && !self.viewport.is_gliding() && self.derived.is_current(&self.document)
    }

    /// Sends an edit as a step of its own.
    pub fn send(&mut self, edit: Edit) {
        self.edit(edit);
    }

    /// Sets a number of the parameter table, as its field does.
    pub fn set(&mut self, key: &str, value: f64) {
        if let Some(p) = Parameter::by_key(key) {
            self.set_parameter(p, value);
        }
    }

    /// Selects these surfaces, if there are any, and gives a command.
    pub fn give(&mut self, command: Command, selected: &[u32]) {
        if !selected.is_empty() {
            self.session.selected = selected.iter().copied().collect();
        }
        self.run(command);
    }
}

/// The window's own threads, which wake it with every result.
pub(super) fn own_threads(ctx: &eframe::egui::Context) -> Arc<dyn Executor> {
    let ctx = ctx.clone();
    Arc::new(Pool::new(move || ctx.request_repaint()))
}
