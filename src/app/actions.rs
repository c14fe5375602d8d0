//! What commands do, and the way every edit takes.

use super::App;
use super::command::{COMMANDS, Command};
use super::dialogs::Purpose;
use super::session::{AfterGuard, Tool};
use crate::document::{Edit, Lost, Parameter, RecutAnchor};
use crate::part::{Placement, Shape, SurfaceId, angle};
use crate::text::Sentence;
use crate::view::{Bounds, Projection, StandardView};
use eframe::egui;
use nalgebra::Vector3;

impl App {
    /// Applies an edit as a step of its own.
    pub(super) fn edit(&mut self, edit: Edit) {
        self.apply(&edit, None);
    }

    /// Applies an edit as a piece of the drag that is going on.
    pub(super) fn edit_dragging(&mut self, edit: &Edit, gesture: &str) {
        self.apply(edit, Some(gesture));
    }

    /// Applies an edit, and says what surfaces lost by it; a drag that brings it back takes the word back.
    fn apply(&mut self, edit: &Edit, gesture: Option<&str>) {
        let all: Vec<SurfaceId> = self.derived.surfaces.ids().collect();
        let told = |lost: &[Lost]| lost.iter().map(Lost::sentence).collect::<Vec<_>>().join("; ");
        let before = told(self.document.lost());
        self.document.apply(edit, &all, gesture);
        let now = told(self.document.lost());
        if !now.is_empty() || !before.is_empty() && self.session.said == before {
            self.session.said = now;
        }
    }

    /// Surfaces to clean, in the order of work.
    pub(super) fn clean_list(&self) -> Vec<u32> {
        self.document.job().chosen(&self.derived.surfaces)
    }

    /// Whether a command can do anything now.
    pub(super) fn is_enabled(&self, command: Command) -> bool {
        use Command as C;
        let selected = &self.session.selected;
        let clean = || self.clean_list();
        match command {
            C::Open | C::Help | C::Escape | C::Theme => true,
            C::Undo => self.document.undo_step().is_some(),
            C::Redo => self.document.redo_step().is_some(),
            C::Cancel => self.progress().is_some(),
            C::Export => self.plan().is_some(),
            C::Play
            | C::NextPoint
            | C::LastPoint
            | C::NextPass
            | C::LastPass
            | C::First
            | C::Last
            | C::Section
            | C::Access
            | C::Dose
            | C::Spacing => self.derived.plan().is_some(),
            C::Cell => self.derived.cell.is_some(),
            C::BetterSetup => self.has_refusals() && !self.is_proposing(),
            C::Plots => self.timeline().is_some(),
            C::Text => self.derived.motion().is_some(),
            C::Clean => selected.iter().any(|n| !clean().contains(n)),
            C::Unclean | C::Earlier | C::Later => selected.iter().any(|n| clean().contains(n)),
            // Facets are cut and joined on the part as it is.
            C::Merge => selected.len() > 1 && self.derived.has_current_surfaces(&self.document),
            C::Split => selected.len() == 1 && self.derived.has_current_surfaces(&self.document),
            C::Rename | C::FlipSurface | C::FlipShell => selected.len() == 1,
            C::SelectSameShape | C::SelectSameNormal | C::SelectNeighbours | C::Hide | C::Isolate => {
                !selected.is_empty()
            }
            _ => self.derived.part.is_some(),
        }
    }

    pub(super) fn run(&mut self, command: Command, ctx: &egui::Context) {
        use Command as C;
        if !self.is_enabled(command) {
            return;
        }
        match command {
            C::Open if self.document.is_dirty() => self.session.after_guard = Some(AfterGuard::AskOpen),
            C::Open => self.ask(Purpose::Open),
            C::Save => self.save_job(),
            C::SaveAs => self.ask(Purpose::SaveJob),
            C::Export => self.ask(Purpose::Export),
            C::Undo => self.document.undo(),
            C::Redo => self.document.redo(),
            C::Clean => self.move_selected(true),
            C::Unclean => self.move_selected(false),
            C::Earlier => self.edit(Edit::Shift(self.selected(), -1)),
            C::Later => self.edit(Edit::Shift(self.selected(), 1)),
            C::SelectAll | C::SelectSameShape | C::SelectSameNormal | C::SelectNeighbours => self.select_more(command),
            C::Merge => {
                let list = self.selected();
                self.edit(Edit::Merge(list));
            }
            C::Split => {
                let (part, angle_deg) = (self.derived.part.clone(), self.session.split_angle_deg);
                if let (Some(part), Some(&n)) = (part, self.selected().first()) {
                    self.edit(Edit::split(&part, &self.derived.surfaces, self.document.job(), n, angle_deg));
                }
            }
            C::Rename => {
                let first = self.session.selected.first().copied();
                let settings = &self.document.job().settings;
                self.session.renaming = first.map(|n| (n, settings.of(SurfaceId(n)).name.clone()));
            }
            C::FlipSurface => self.selected().into_iter().for_each(|n| self.edit(Edit::FlipSurface(n))),
            C::FlipShell => {
                let shell = self.selected().first().and_then(|n| {
                    let first = *self.derived.surfaces.get(n.0)?.facets.first()?;
                    self.derived.part.as_ref()?.orientation.shell_of.get(first as usize).copied()
                });
                if let Some(shell) = shell {
                    self.edit(Edit::FlipShell(shell));
                }
            }
            C::PickOrigin => self.session.tool = Tool::PickOrigin,
            C::LayFlat => self.session.tool = Tool::LayFlat,
            C::TurnX => self.place(|p| p.quarter_turn(0)),
            C::TurnY => self.place(|p| p.quarter_turn(1)),
            C::TurnZ => self.place(|p| p.quarter_turn(2)),
            C::Plan => self.plan_again(),
            C::Cancel => self.cancel(),
            C::BetterSetup => self.propose(),
            C::Theme => {
                let dark = ctx.theme() == egui::Theme::Dark;
                ctx.set_theme(if dark { egui::Theme::Light } else { egui::Theme::Dark });
            }
            C::Help => self.session.help_open = !self.session.help_open,
            C::Escape => self.step_out(),
            C::Play | C::NextPoint | C::LastPoint | C::NextPass | C::LastPass | C::First | C::Last => {
                self.step(command)
            }
            _ => self.run_view(command),
        }
    }

    fn run_view(&mut self, command: Command) {
        use Command as C;
        let show = &mut self.session.show;
        match command {
            C::Look(i) => self.viewport.look(StandardView::ALL[usize::from(i) % StandardView::ALL.len()]),
            C::Fit => self.fit_selection(),
            C::Projection => {
                let now = self.viewport.camera.projection;
                let parallel = matches!(now, Projection::Parallel);
                self.viewport.set_projection(if parallel { Projection::Perspective } else { Projection::Parallel });
            }
            C::Hide => self.session.hidden.extend(&self.session.selected),
            C::Isolate => {
                let all = self.derived.numbers();
                self.session.hidden = all.into_iter().filter(|n| !self.session.selected.contains(n)).collect();
            }
            C::ShowAll => self.session.hidden.clear(),
            C::Lines => show.lines = !show.lines,
            C::Frames => show.frames = !show.frames,
            C::Beams => show.beams = !show.beams,
            C::Air => show.air = !show.air,
            C::Before => show.before = !show.before,
            C::Plain => show.plain = !show.plain,
            C::HideChosen => show.hide_chosen = !show.hide_chosen,
            C::Section => {
                show.section = !show.section;
                if show.section {
                    self.leave_cell();
                    self.look_along_section();
                }
            }
            C::Cell => self.toggle_cell(),
            C::Plots => show.plots = !show.plots,
            C::Text => show.text = !show.text,
            C::ToolBodies => show.tool = !show.tool,
            C::Access => show.access = !show.access,
            C::Dose => self.toggle_dose(),
            C::Spacing => show.spacing = !show.spacing,
            _ => {}
        }
    }

    fn selected(&self) -> Vec<SurfaceId> {
        self.session.selected.iter().copied().map(SurfaceId).collect()
    }

    /// Moves the selection to the list to clean or back; focus stays on the neighbour.
    fn move_selected(&mut self, to_clean: bool) {
        let clean = self.clean_list();
        let list: Vec<u32> = self.session.selected.iter().copied().filter(|n| clean.contains(n) != to_clean).collect();
        let from: Vec<u32> = if to_clean { self.rows_left() } else { clean };
        let neighbour = from
            .iter()
            .position(|n| list.contains(n))
            .and_then(|at| from[at..].iter().chain(from[..at].iter().rev()).find(|n| !list.contains(n)).copied());
        let list = list.into_iter().map(SurfaceId).collect();
        self.edit(if to_clean { Edit::Clean(list) } else { Edit::Unclean(list) });
        self.session.selected = neighbour.into_iter().collect();
        self.session.anchor = neighbour;
    }

    fn select_more(&mut self, command: Command) {
        let d = &self.derived;
        let selected = self.session.selected.clone();
        let normal = |n: u32| match d.shape(n) {
            Some(Shape::Plane { normal }) => Some(*normal),
            _ => None,
        };
        let same_shape = |a: u32, b: u32| match (d.shape(a), d.shape(b)) {
            (Some(x), Some(y)) => x.is_like(y),
            _ => false,
        };
        let near = |a: Vector3<f64>, b: u32| normal(b).is_some_and(|v| angle::between_deg(&a, &v) < 1.0);
        let more: Vec<u32> = match command {
            Command::SelectAll => self.rows_left(),
            Command::SelectSameShape => {
                d.numbers().into_iter().filter(|&n| selected.iter().any(|&s| same_shape(s, n))).collect()
            }
            Command::SelectSameNormal => {
                let normals: Vec<Vector3<f64>> = selected.iter().filter_map(|&s| normal(s)).collect();
                d.numbers().into_iter().filter(|&n| normals.iter().any(|&a| near(a, n))).collect()
            }
            _ => match &d.part {
                Some(part) => selected.iter().flat_map(|&s| d.surfaces.neighbours(&part.mesh, s)).collect(),
                None => Vec::new(),
            },
        };
        self.session.selected.extend(more);
    }

    /// Changes where the part stands.
    pub(super) fn place(&mut self, change: impl FnOnce(&Placement) -> Placement) {
        let placement = change(&self.document.job().part.placement);
        self.edit(Edit::Place(placement));
    }

    /// Drag → tool → selection; never loses data.
    fn step_out(&mut self) {
        if self.session.help_open {
            self.session.help_open = false;
        } else if self.session.renaming.is_some() {
            self.session.renaming = None;
        } else if self.session.tool != Tool::Select {
            self.session.tool = Tool::Select;
        } else if self.dismiss_proposal() {
            // Its preview is gone: one step.
        } else if self.session.show.section {
            self.session.show.section = false;
        } else {
            self.session.selected.clear();
        }
    }

    fn fit_selection(&mut self) {
        let Some(part) = &self.derived.part else { return };
        let facets = self.session.selected.iter().filter_map(|n| self.derived.surfaces.get(*n)).flat_map(|s| &s.facets);
        let place = self.scene_from_part();
        let points = facets.flat_map(|&f| part.mesh.corners(f as usize)).map(|p| place * p);
        let bounds = Bounds::around(points).or_else(|| self.whole_bounds());
        bounds.into_iter().for_each(|b| self.viewport.fit(b));
    }

    /// Sets a number of the parameter table. One that cuts the surfaces anew carries over what is said of them.
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
                self.session.said = "the part is being built anew; cut its surfaces once it is there".into();
                return;
            }
        };
        self.edit_dragging(&Edit::recut(&part, &anchor, p, value), p.key);
        self.session.recut_anchor = Some((anchor, self.document.job().clone()));
    }

    /// Runs the commands whose keys were pressed, unless a text is being typed.
    pub(super) fn take_shortcuts(&mut self, ctx: &egui::Context) {
        use Command as C;
        if self.question.is_some() {
            return;
        }
        let typing = ctx.text_edit_focused();
        // More modifiers first: Shift+H is not H.
        let mut rows: Vec<_> = COMMANDS.iter().filter_map(|r| r.keys.map(|k| (k, r.command))).collect();
        rows.sort_by_key(|(k, _)| {
            std::cmp::Reverse(u8::from(k.modifiers.alt) + u8::from(k.modifiers.shift) + u8::from(k.modifiers.command))
        });
        for (keys, command) in rows {
            // In a text, Ctrl+A and Ctrl+Z belong to the text.
            if typing && !matches!(command, C::Open | C::Save | C::SaveAs | C::Export | C::Plan) {
                continue;
            }
            if ctx.input_mut(|i| i.consume_shortcut(&keys)) {
                self.run(command, ctx);
            }
        }
    }
}
