//! What a command does. When it can be given stands in `enabled`.

use super::App;
use super::command::Command;
use super::dialogs::Purpose;
use super::panels::palette::state::Palette;
use super::session::{AfterGuard, Coloring, PointerTool};
use super::shown::Tab;
use super::toggle::Toggle;
use crate::document::Edit;
use crate::part::SurfaceId;
use crate::text::{self, say};
use crate::view::{Bounds, Projection};
use eframe::egui;

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
            C::SelectByPainting => self.take_tool(PointerTool::Paint),
            C::SelectRow(step) => self.select_row(step),
            C::Merge => self.edit(Edit::Merge(self.session.selected_ids())),
            C::Split => self.split_selected(),
            C::Rename => self.begin_renaming(),
            C::FlipSurface => self.flip_surface(),
            C::FlipShell => self.flip_shell(),
            C::PickOrigin => self.take_tool(PointerTool::PickOrigin),
            C::LayFlat => self.take_tool(PointerTool::LayFlat),
            C::Measure => {
                self.session.measured.clear();
                self.take_tool(PointerTool::Measure);
            }
            C::QuarterTurn(axis) => self.place(|p| p.quarter_turn(axis as usize)),
            C::Look(view) => self.viewport.look(view),
            C::Fit => self.fit_selection(),
            C::Projection => self.change_projection(),
            C::Hide => self.session.hidden.extend(&self.session.selected),
            C::Isolate => self.isolate(),
            C::ShowAll => self.session.hidden.clear(),
            C::Toggle(what) => self.toggle(what),
            C::Navigate(navigation) => self.session.navigation = navigation,
            C::Theme => self.change_theme(),
            C::Language => self.change_language(),
            C::Plan => self.plan_again(),
            C::Cancel => self.cancel(),
            C::BetterSetup => self.find_better_setup(),
            C::Play => self.play_or_pause(),
            C::Go(jump) => self.jump(jump),
            C::Palette => self.session.palette = Some(Palette::default()),
            C::Help => self.session.help_open = !self.session.help_open,
            C::Escape => self.step_out(),
        }
    }

    fn toggle(&mut self, what: Toggle) {
        use Toggle as T;
        match what {
            T::Cell => self.toggle_cell(),
            T::SectionPlane if self.session.show.is_on(what) => self.leave_section(),
            T::SectionPlane => {
                self.session.show.set(what, true);
                self.leave_cell();
                self.session.camera_before_section = Some(self.viewport.camera);
                self.look_along_section();
            }
            // In a narrow window the lists are a tab of the settings.
            T::Lists if self.session.is_narrow => {
                let on = self.context().is_shown(Command::Toggle(what));
                self.session.show.set(T::Settings, !on);
                self.session.tab = Some(Tab::Lists);
            }
            T::Dose => {
                let on = self.session.show.flip(what);
                self.session.coloring = if on { Coloring::Dose } else { Coloring::Surface };
                // A computation that was cancelled is asked for again.
                if on {
                    self.derived.dose.try_again();
                    self.session.show.set(T::Settings, true);
                    self.session.tab = Some(Tab::Dose);
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
            | T::WeldPoints
            | T::Cut
            | T::Lists
            | T::Settings => {
                self.session.show.flip(what);
            }
        }
    }

    fn take_tool(&mut self, tool: PointerTool) {
        self.session.empty_hand();
        self.session.tool = tool;
    }

    fn change_projection(&mut self) {
        let parallel = matches!(self.viewport.camera.projection, Projection::Parallel);
        self.viewport.set_projection(if parallel { Projection::Perspective } else { Projection::Parallel });
    }

    fn change_theme(&mut self) {
        use egui::ThemePreference as P;
        let next = match self.ctx.options(|o| o.theme_preference) {
            P::Dark => P::Light,
            P::Light => P::System,
            P::System => P::Dark,
        };
        self.ctx.set_theme(next);
        self.session.said = match next {
            P::Dark => say!(theme_dark),
            P::Light => say!(theme_light),
            P::System => say!(theme_system),
        };
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
            self.session.measured.clear();
        } else if self.session.gizmo.take().is_some() {
            // What was moved stays where it is.
        } else if self.session.scan_tool.take().is_some() {
            // Laid down, with what was not taken over.
        } else if self.dismiss_better_setup() {
            // Its preview is gone: one step.
        } else if self.session.show.is_on(Toggle::SectionPlane) {
            self.leave_section();
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
