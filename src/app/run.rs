//! When a command can be given, and what it does.

use super::App;
use super::command::{Command, More, Toggle};
use super::context::Context;
use super::dialogs::Purpose;
use super::session::{AfterGuard, Coloring, PointerTool};
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::text::{self, say};
use crate::view::{Bounds, Projection};
use eframe::egui;

impl Context<'_> {
    /// Whether a command can do anything now.
    pub fn is_enabled(self, command: Command) -> bool {
        use Command as C;
        let selected = &self.session.selected;
        let clean = || self.clean_list();
        match command {
            C::Open | C::OpenWeld | C::Help | C::Escape | C::Theme | C::Language => true,
            C::OpenScan | C::Save | C::SaveAs | C::Plan => self.derived.part.is_some(),
            C::Select(More::Listed) | C::PickOrigin | C::LayFlat | C::QuarterTurn(_) => self.derived.part.is_some(),
            C::Look(_) | C::Fit | C::Projection | C::ShowAll => self.derived.part.is_some(),
            C::Undo => self.document.undo_step().is_some(),
            C::Redo => self.document.redo_step().is_some(),
            C::Cancel => self.progress().is_some(),
            C::Export | C::ExportDryRun => self.plan().is_some(),
            C::ExportFromPass => self.plan().is_some() && self.target().is_some(),
            C::Play | C::Go(_) => self.derived.plan().is_some(),
            C::Toggle(what) => self.is_there(what),
            C::BetterSetup => self.refusing_plan().is_some() && !self.derived.suggestions.is_better_setup_sought(),
            C::Clean | C::Unclean | C::CleanEarlier | C::CleanLater if self.is_told_what_to_work() => false,
            C::FlipSurface | C::FlipShell if self.has_scan() || self.has_weld() => false,
            C::Clean => selected.iter().any(|n| !clean().contains(n)),
            C::Unclean | C::CleanEarlier | C::CleanLater => selected.iter().any(|n| clean().contains(n)),
            // Facets are cut and joined on the part as it is.
            C::Merge => selected.len() > 1 && self.derived.has_current_surfaces(self.document),
            C::Split => selected.len() == 1 && self.derived.has_current_surfaces(self.document),
            C::Rename | C::FlipSurface | C::FlipShell => selected.len() == 1,
            C::Select(More::SameShape | More::SameNormal | More::Neighbours) | C::Hide | C::Isolate => {
                !selected.is_empty()
            }
        }
    }

    /// Why a command cannot be given while there is a scan, or a weld is ground.
    pub fn why_not(self, command: Command) -> Option<String> {
        use Command as C;
        match command {
            C::Toggle(what) => (self.has_weld() && is_of_light(what)).then(|| say!(weld_panel_no_light)),
            C::Clean | C::Unclean | C::CleanEarlier | C::CleanLater => self.why_told_what_to_work(),
            C::Merge | C::Split | C::FlipSurface | C::FlipShell if self.has_weld() => {
                Some(say!(weld_panel_keeps_surfaces))
            }
            _ if !self.has_scan() => None,
            C::Merge | C::Split | C::FlipSurface | C::FlipShell => Some(say!(scan_panel_keeps_surfaces)),
            _ => None,
        }
    }

    /// Whether there is something to be shown.
    fn is_there(self, what: Toggle) -> bool {
        use Toggle as T;
        match what {
            _ if self.has_weld() && is_of_light(what) => false,
            T::WeldImages => self.has_weld(),
            T::WeldPoints => self.weld.measured().is_some(),
            T::PathLines | T::PoseFrames | T::Beams | T::ConnectingMoves => self.derived.part.is_some(),
            T::BeforeCorrection | T::PlainPart | T::HideChosen | T::ToolBodies => self.derived.part.is_some(),
            T::SectionPlane | T::AccessMap | T::Dose | T::Spacing => self.derived.plan().is_some(),
            T::Scan | T::DroppedPoints | T::DeviationOnModel | T::ScanSection => self.scan_is_laid(),
            T::Cell => self.derived.cell.is_some(),
            T::Plots => self.timeline().is_some(),
            T::ProgramText => self.derived.playback_data().is_some(),
        }
    }
}

/// What only light has: a grinding tool lays no dose on the part, and nobody corrects its beam.
fn is_of_light(what: Toggle) -> bool {
    matches!(what, Toggle::Dose | Toggle::BeforeCorrection)
}

impl App {
    /// Does what a command asks for, if it is enabled.
    pub(super) fn run(&mut self, command: Command) {
        use Command as C;
        if !self.context().is_enabled(command) {
            return;
        }
        match command {
            C::Open if self.document.is_dirty() => self.session.after_guard = Some(AfterGuard::AskOpen),
            C::Open => self.ask(Purpose::Open),
            C::OpenScan => self.ask(Purpose::Scan),
            C::OpenWeld => self.ask_weld(),
            C::Save => self.save_job(),
            C::SaveAs => self.ask(Purpose::SaveJob),
            C::Export => self.ask(Purpose::Export),
            C::ExportDryRun => self.ask(Purpose::ExportDryRun),
            C::ExportFromPass => self.go_on_from_pass(),
            C::Undo => self.document.undo(),
            C::Redo => self.document.redo(),
            C::Clean => self.move_selected(true),
            C::Unclean => self.move_selected(false),
            C::CleanEarlier => self.edit(Edit::Shift(self.session.selected_ids(), -1)),
            C::CleanLater => self.edit(Edit::Shift(self.session.selected_ids(), 1)),
            C::Select(more) => self.select_more(more),
            C::Merge => self.edit(Edit::Merge(self.session.selected_ids())),
            C::Split => self.split_selected(),
            C::Rename => self.begin_renaming(),
            C::FlipSurface => self.flip_surface(),
            C::FlipShell => self.flip_shell(),
            C::PickOrigin => self.take_tool(PointerTool::PickOrigin),
            C::LayFlat => self.take_tool(PointerTool::LayFlat),
            C::QuarterTurn(axis) => self.place(|p| p.quarter_turn(axis as usize)),
            C::Look(view) => self.viewport.look(view),
            C::Fit => self.fit_selection(),
            C::Projection => self.change_projection(),
            C::Hide => self.session.hidden.extend(&self.session.selected),
            C::Isolate => self.isolate(),
            C::ShowAll => self.session.hidden.clear(),
            C::Toggle(what) => self.toggle(what),
            C::Theme => self.change_theme(),
            C::Language => self.change_language(),
            C::Plan => self.plan_again(),
            C::Cancel => self.cancel(),
            C::BetterSetup => self.find_better_setup(),
            C::Play => self.play_or_pause(),
            C::Go(jump) => self.jump(jump),
            C::Help => self.session.help_open = !self.session.help_open,
            C::Escape => self.step_out(),
        }
    }

    fn toggle(&mut self, what: Toggle) {
        use Toggle as T;
        match what {
            T::Cell => self.toggle_cell(),
            T::SectionPlane => {
                if self.session.show.flip(what) {
                    self.leave_cell();
                    self.look_along_section();
                }
            }
            T::Dose => {
                let on = self.session.show.flip(what);
                self.session.coloring = if on { Coloring::Dose } else { Coloring::Surface };
                // A computation that was cancelled is asked for again.
                if on {
                    self.derived.dose.try_again();
                }
            }
            T::PathLines
            | T::PoseFrames
            | T::Beams
            | T::ConnectingMoves
            | T::BeforeCorrection
            | T::PlainPart
            | T::HideChosen
            | T::Plots
            | T::ProgramText
            | T::ToolBodies
            | T::AccessMap
            | T::Spacing
            | T::Scan
            | T::DroppedPoints
            | T::DeviationOnModel
            | T::ScanSection
            | T::WeldImages
            | T::WeldPoints => {
                self.session.show.flip(what);
            }
        }
    }

    /// One tool at a time is in the hand.
    fn take_tool(&mut self, tool: PointerTool) {
        (self.session.tool, self.session.scan_tool) = (tool, None);
    }

    fn change_projection(&mut self) {
        let parallel = matches!(self.viewport.camera.projection, Projection::Parallel);
        self.viewport.set_projection(if parallel { Projection::Perspective } else { Projection::Parallel });
    }

    fn change_theme(&self) {
        let dark = self.ctx.theme() == egui::Theme::Dark;
        self.ctx.set_theme(if dark { egui::Theme::Light } else { egui::Theme::Dark });
    }

    fn change_language(&mut self) {
        text::choose(text::language().next());
        text::name_view(&mut self.viewport);
    }

    fn begin_renaming(&mut self) {
        let settings = &self.document.job().settings;
        let first = self.session.selected.first().copied();
        self.session.renaming = first.map(|n| (n, settings.of(SurfaceId(n)).name.clone()));
    }

    fn split_selected(&mut self) {
        let (part, angle_deg) = (self.derived.part.clone(), self.session.split_angle_deg);
        if let (Some(part), Some(&n)) = (part, self.session.selected_ids().first()) {
            self.edit(Edit::split(&part, &self.derived.surfaces, self.document.job(), n, angle_deg));
        }
    }

    fn flip_surface(&mut self) {
        if let Some(&n) = self.session.selected_ids().first() {
            self.edit(Edit::FlipSurface(n));
        }
    }

    fn flip_shell(&mut self) {
        let shell = self.session.selected.first().and_then(|n| {
            let first = *self.derived.surfaces.get(*n)?.facets.first()?;
            self.derived.part.as_ref()?.orientation.shell_of.get(first as usize).copied()
        });
        if let Some(shell) = shell {
            self.edit(Edit::FlipShell(shell));
        }
    }

    /// Ends what is being computed: what the status line shows first.
    fn cancel(&mut self) {
        if self.reading.progress().is_some() {
            self.reading.cancel();
        } else if self.adding.progress().is_some() {
            self.adding.cancel();
        } else if self.asking.progress().is_some() {
            self.asking.cancel();
        } else if self.derived.pipeline.progress().is_some() {
            self.derived.pipeline.cancel();
        } else if self.exporting.is_running() {
            self.exporting.cancel();
        } else if self.packing.is_running() {
            self.packing.cancel();
        } else if self.derived.suggestions.progress().is_some() {
            self.derived.suggestions.cancel_shown();
        } else {
            self.derived.dose.cancel();
        }
    }

    /// Ends the innermost thing that is going on; never loses data.
    fn step_out(&mut self) {
        if self.session.help_open {
            self.session.help_open = false;
        } else if self.session.renaming.is_some() {
            self.session.renaming = None;
        } else if self.session.tool != PointerTool::Select {
            self.session.tool = PointerTool::Select;
        } else if self.session.scan_tool.take().is_some() {
            // Laid down, with what was not taken over.
        } else if self.dismiss_better_setup() {
            // Its preview is gone: one step.
        } else if self.session.show.is_on(Toggle::SectionPlane) {
            self.session.show.set(Toggle::SectionPlane, false);
        } else {
            self.session.selected.clear();
        }
    }

    fn fit_selection(&mut self) {
        let Some(part) = &self.derived.part else { return };
        let facets = self.session.selected.iter().filter_map(|n| self.derived.surfaces.get(*n)).flat_map(|s| &s.facets);
        let place = self.context().scene_from_part();
        let points = facets.flat_map(|&f| part.mesh.corners(f as usize)).map(|p| place * p);
        let bounds = Bounds::around(points).or_else(|| self.context().whole_bounds());
        bounds.into_iter().for_each(|b| self.viewport.fit(b));
    }
}
