//! Questions of panels that still draw on the whole window; the answers are those of its [`Context`].

use super::App;
use super::command::Command;
use super::dose::DoseView;
use super::remedy::Proposal;
use crate::beam::ProcessSettings;
use crate::planning::Failure;
use crate::planning::advice::Help;
use crate::pose::Target;
use crate::program::{Moment, Timeline};
use crate::progress::Progress;
use eframe::egui;
use nalgebra::Isometry3;
use std::convert::Infallible;
use std::sync::Arc;

impl App {
    /// Whether a command can do anything now.
    pub(super) fn is_enabled(&self, command: Command) -> bool {
        self.context().is_enabled(command)
    }

    /// Surfaces to clean, in the order of work.
    pub(super) fn clean_list(&self) -> Vec<u32> {
        self.context().clean_list()
    }

    /// The program over time, with a robot.
    pub(super) fn timeline(&self) -> Option<&Timeline> {
        self.context().timeline()
    }

    /// The arm now.
    pub(super) fn moment(&self) -> Option<Moment> {
        self.context().moment()
    }

    /// The current target.
    pub(super) fn target(&self) -> Option<&Target> {
        self.context().target()
    }

    /// What the current pass is worked with.
    pub(super) fn work(&self) -> ProcessSettings {
        self.context().work()
    }

    /// Whether the robot cell is shown.
    pub(super) fn is_in_cell(&self) -> bool {
        self.context().is_in_cell()
    }

    /// Why there is no plan for the document as it is, for people.
    pub(super) fn planning_error(&self) -> Option<String> {
        self.context().planning_error()
    }

    /// Whether the robot refuses anything of the plan.
    pub(super) fn has_refusals(&self) -> bool {
        self.context().refusing_plan().is_some()
    }

    /// What would help with that; `None`: it is being looked for.
    pub(super) fn advice(&self) -> Option<Result<&[Help], &Failure<Infallible>>> {
        self.derived.remedy.advice(self.context().refusing_plan()?.key)
    }

    /// The set-up that is proposed for the plan as it is.
    pub(super) fn proposal(&self) -> Option<&Proposal> {
        self.context().proposal()
    }

    /// Whether one was looked for in vain.
    pub(super) fn has_no_proposal(&self) -> bool {
        self.context().plan().is_some_and(|planned| self.derived.remedy.found_no_proposal(planned.key))
    }

    /// Whether one is being looked for.
    pub(super) fn is_proposing(&self) -> bool {
        self.derived.remedy.is_proposing()
    }

    /// How far the dose is that is being computed.
    pub(super) fn dose_progress(&self) -> Option<&Progress> {
        self.derived.dose.progress()
    }

    /// The dose of the plan as it is; `None`: it is being computed, or was cancelled.
    pub(super) fn dose(&self) -> Option<&Arc<DoseView>> {
        self.context().dose()
    }

    /// Where the part stands in the view: in its own frame, or in the base.
    pub(super) fn scene_from_part(&self) -> Isometry3<f64> {
        self.context().scene_from_part()
    }

    /// Selects as lists do.
    pub(super) fn select(&mut self, surface: Option<u32>, modifiers: egui::Modifiers) {
        self.session.select(surface, modifiers);
    }
}
