//! The one way that every edit of the window takes, and edits that need more than a value.

use super::App;
use crate::cell::Robot;
use crate::document::{Edit, LostSettings, Parameter, RecutAnchor};
use crate::part::{Placement, SurfaceId, Weld};
use crate::progress::Progress;
use crate::text::{Sentence as _, listed_clauses, say};
use std::path::Path;

impl App {
    /// Applies an edit as a step of its own.
    pub(super) fn edit(&mut self, edit: Edit) {
        self.apply(&edit, None);
    }

    /// Applies an edit as part of a drag: edits of one gesture are one step of undo.
    pub(super) fn edit_dragging(&mut self, edit: &Edit, gesture: &str) {
        self.apply(edit, Some(gesture));
    }

    /// Applies an edit, and says in the status line what surfaces lost by it; a drag that brings that back clears the
    /// line.
    pub(super) fn apply(&mut self, edit: &Edit, gesture: Option<&str>) {
        let all: Vec<SurfaceId> = self.derived.surfaces.ids().collect();
        let told = |lost: &[LostSettings]| listed_clauses(lost.iter().map(LostSettings::sentence));
        let before = told(self.document.lost());
        self.document.apply(edit, &all, gesture);
        let now = told(self.document.lost());
        if !now.is_empty() || !before.is_empty() && self.session.said == before {
            self.session.said = now;
        }
    }

    /// Changes the placement of the part.
    pub(super) fn place(&mut self, change: impl FnOnce(&Placement) -> Placement) {
        let placement = change(&self.document.job().part.placement);
        self.edit(Edit::Place(placement));
    }

    /// Chooses a robot by its key or file, with the dialect of its controller; an empty name stands for no robot.
    pub(super) fn choose_robot(&mut self, name: &str) {
        let dialect = self.document.job().cell.dialect.clone();
        if name.is_empty() {
            self.edit(Edit::Robot(String::new(), dialect));
            return;
        }
        match Robot::load(name, self.document.file().and_then(Path::parent)) {
            Ok(robot) => self.edit(Edit::Robot(name.into(), robot.dialect)),
            Err(e) => self.session.error = Some(e.sentence()),
        }
    }

    /// Sets a number of the parameter table. One that cuts the surfaces anew carries their settings over.
    pub(super) fn set_parameter(&mut self, p: &'static Parameter, value: f64) {
        if !p.recuts() {
            self.edit_dragging(&Edit::Set(p.key, value), p.key);
            return;
        }
        let Some(part) = self.derived.part.clone() else { return };
        // A drag goes on from where it began, unless something else was done meanwhile.
        let begun = self.session.recut_anchor.take().filter(|(_, reached)| reached == self.document.job());
        let anchor = match begun {
            Some((anchor, _)) => anchor,
            None if self.derived.has_current_surfaces(&self.document) => {
                RecutAnchor { job: self.document.job().clone(), surfaces: self.derived.surfaces.clone() }
            }
            None => {
                self.session.said = self.why_surfaces_stay();
                return;
            }
        };
        self.edit_dragging(&Edit::recut(&part, &anchor, p, value), p.key);
        self.session.recut_anchor = Some((anchor, self.document.job().clone()));
    }

    /// Welds the corners of the part otherwise; what is said of surfaces is carried over to those that come of it.
    pub(super) fn set_weld(&mut self, weld: Weld) {
        let job = self.document.job();
        let (Some(part), Some(source)) = (self.derived.part.clone(), self.derived.pipeline.source().cloned()) else {
            return;
        };
        if job.part.weld == weld {
            return;
        }
        if !self.derived.has_current_surfaces(&self.document) {
            self.session.said = self.why_surfaces_stay();
            return;
        }
        let anchor = RecutAnchor { job: job.clone(), surfaces: self.derived.surfaces.clone() };
        match Edit::weld(&source, &part, &anchor, weld, &Progress::default()) {
            Ok(edit) => edit.into_iter().for_each(|edit| self.edit(edit)),
            Err(e) => self.session.error = Some(e.sentence()),
        }
    }

    fn why_surfaces_stay(&self) -> String {
        match self.context() {
            context if context.has_weld() => say!(weld_panel_keeps_surfaces),
            context if context.has_scan() => say!(scan_panel_keeps_surfaces),
            _ => say!(window_part_being_built),
        }
    }
}
