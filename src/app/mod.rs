//! The window.
//!
//! `Document` (saved, undone) · `Session` (selection, what is shown) · `Derived` (the stages of the one
//! pipeline, and what the window makes of them). Panels look at a `Context` of these and ask for `Actions`:
//! [`Command`]s and edits. Work over 100 ms runs on a pool of threads, and results that are no longer wanted are
//! dropped.

mod access;
mod access_place;
mod actions;
mod at_cursor;
mod better_setup;
mod border;
mod box_select;
mod clearance;
mod command;
mod context;
mod derived;
mod dialogs;
mod dose;
mod edits;
mod enabled;
mod export_review;
mod file_browser;
mod file_findings;
mod files;
mod gizmo;
mod going_on;
mod head_file;
mod journal;
mod measuring;
mod menu_place;
mod opening;
mod outside;
mod packing;
mod panels;
mod part_cut;
mod pick;
mod playback;
mod playback_data;
mod program_view;
mod quantity;
mod questions;
mod reading;
mod recipe_library;
mod run;
mod scan_files;
mod scan_section;
mod scan_tool;
mod scan_view;
mod scene;
mod selection;
mod session;
mod shortcuts;
mod shown;
mod sight;
mod simulation;
mod spacing;
mod suggestion_search;
mod sync;
mod tab;
mod theme;
mod thumbnails;
mod toggle;
mod tour;
mod weld;

pub use command::{Command, Jump, Menu, More, RowStep, TurnAxis};
pub use dialogs::{FileDialogs, Purpose};
pub use file_browser::WindowDialogs;
pub use toggle::Toggle;

use crate::document::files::JobError;
use crate::document::{Document, Library, users_folder};
use crate::planning::export::{ExportError, Exported};
use crate::planning::{Pool, Stage};
use crate::text;
use crate::text::say;
use crate::view::{Navigation, Scene, Viewport};
use derived::Derived;
use eframe::egui;
use session::Session;
use shown::Tab;
use std::path::PathBuf;
use std::sync::Arc;

/// The window's state.
pub struct App {
    document: Document,
    derived: Derived,
    session: Session,
    viewport: Viewport,
    scene: Arc<Scene>,
    ctx: egui::Context,
    dialogs: Box<dyn FileDialogs>,
    /// What files are being asked for.
    answers: dialogs::Answers,
    /// What is being read.
    reading: reading::Reading,
    /// The question that waits for the operator's answer.
    question: Option<questions::Question>,
    /// Keeps unsaved changes, in case the program is killed.
    journal: journal::JournalKeeper,
    /// The export that is being written.
    exporting: Stage<Exported, ExportError>,
    /// The look at a folder before an export into it.
    reviewing: Stage<questions::ExportReview, ExportError>,
    /// The package that is being written.
    packing: Stage<PathBuf, Arc<JobError>>,
    /// The access map and strip that were asked for last.
    access: access::AccessViews,
    /// Lines of the paths, kept while nothing about them changes.
    path_lines: Option<scene::PathLines>,
    recent: Vec<PathBuf>,
    /// Small pictures of those files.
    thumbnails: thumbnails::Thumbnails,
    /// The library: recipes of the user and shipped ones.
    recipes: Library,
    /// Dots of the achieved spacing, kept while the plan stays.
    spacing: spacing::SpacingView,
    /// Borders that offset lines may start from, kept while the surfaces stay.
    borders: border::Borders,
    /// The points of the scan, kept while it stays.
    scan: scan_view::ScanView,
    /// What is shown for a tool for the scan, while it is in the hand.
    tool: scan_tool::ToolView,
    /// The section through part and scan.
    section: scan_section::SectionView,
    /// Files that are on their way into the job's scan.
    adding: scan_files::ScanAdding,
    /// Images of a weld that are on their way into a job.
    asking: weld::WeldAsking,
    /// What is shown of the weld, kept while it stays.
    weld: weld::WeldView,
}

/// A window that leaves less beside both panels than they take, points.
const NARROW: f32 = 940.0;

/// The window's picture in task bars, 256 × 256.
const ICON: &[u8] = include_bytes!("../../assets/package/clearbeam.png");

const RECENT_KEY: &str = "recent";
const LANGUAGE_KEY: &str = "language";
const NAVIGATION_KEY: &str = "navigation";

impl App {
    /// Builds the window's contents; `open` is a part or a job.
    pub fn new(cc: &eframe::CreationContext<'_>, dialogs: Box<dyn FileDialogs>, open: Option<PathBuf>) -> App {
        theme::install(&cc.egui_ctx);
        let kept: Option<String> = cc.storage.and_then(|s| eframe::get_value(s, LANGUAGE_KEY));
        if let Some(language) = kept.and_then(|code| text::language_of(&code)).filter(|_| !text::is_chosen()) {
            text::choose(language);
        }
        // Buttons act while they are drawn: a frame drawn twice over, as egui does when a table is
        // measured first, would act twice and move a second surface.
        cc.egui_ctx.options_mut(|o| o.max_passes = std::num::NonZeroUsize::MIN);
        let mut viewport =
            cc.gl.clone().and_then(|gl| Viewport::new(gl).ok()).unwrap_or_else(Viewport::without_picture);
        text::name_view(&mut viewport);
        let navigation: Option<usize> = cc.storage.and_then(|s| eframe::get_value(s, NAVIGATION_KEY)).flatten();
        let navigation = navigation.and_then(|at| Navigation::ALL.get(at).copied()).unwrap_or_default();
        let recent = cc.storage.and_then(|s| eframe::get_value(s, RECENT_KEY)).unwrap_or_default();
        let mut app = App {
            document: Document::default(),
            derived: Derived::new(outside::own_threads(&cc.egui_ctx)),
            session: Session { navigation, ..Session::default() },
            viewport,
            scene: Arc::new(Scene::default()),
            ctx: cc.egui_ctx.clone(),
            dialogs,
            answers: dialogs::Answers::default(),
            reading: reading::Reading::default(),
            question: None,
            journal: journal::JournalKeeper::default(),
            exporting: Stage::default(),
            reviewing: Stage::default(),
            packing: Stage::default(),
            access: access::AccessViews::default(),
            path_lines: None,
            recent,
            thumbnails: thumbnails::Thumbnails::default(),
            recipes: Library::open(None),
            spacing: spacing::SpacingView::default(),
            borders: border::Borders::default(),
            scan: scan_view::ScanView::default(),
            tool: scan_tool::ToolView::default(),
            section: scan_section::SectionView::default(),
            adding: scan_files::ScanAdding::default(),
            asking: weld::WeldAsking::default(),
            weld: weld::WeldView::default(),
        };
        if let Some(path) = open {
            app.open(path);
        }
        app
    }

    /// The panels on both sides of the view; in a narrow window one, which has the lists as a tab.
    fn sides(&mut self, ui: &mut egui::Ui) {
        let width = ui.available_width();
        self.session.is_narrow = width < NARROW;
        let shows = |app: &App, what| app.session.show.is_on(what);
        let has_lists = shows(self, Toggle::Lists) && !self.session.is_narrow;
        if has_lists {
            let panel =
                egui::Panel::left("lists").default_size((0.25 * width).min(330.0)).size_range(220.0..=0.3 * width);
            panel.show(ui, |ui| self.panel(|context, actions| panels::lists::ui(ui, context, actions)));
        }
        if shows(self, Toggle::Settings) {
            let id = if self.session.is_narrow { "settings beside a narrow view" } else { "settings" };
            let panel = egui::Panel::right(id).default_size(310.0).size_range(310.0..=(0.4 * width).max(310.0));
            panel.show(ui, |ui| self.panel(|context, actions| panels::parameters::ui(ui, context, actions)));
        }
        if !has_lists && self.context().tab() != Tab::Lists {
            // Else the lists do this: what the pointer is on is told by the view alone.
            self.session.hovered = None;
        }
    }

    /// The window with the user's recipes from this folder; `None`: there are none.
    pub fn with_recipes(self, folder: Option<PathBuf>) -> App {
        App { recipes: Library::open(folder), ..self }
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.take_opened();
        self.take_review();
        self.take_exported();
        self.take_packed();
        self.take_answers();
        self.take_scans();
        self.take_weld_images();
        self.take_dropped_files(ctx);
        self.guard_close(ctx);
        // While something is asked the keys are the question's.
        if self.question.is_none() && self.answers.is_empty() && self.session.palette.is_none() {
            shortcuts::pressed(ctx).into_iter().for_each(|command| self.run(command));
        }
        self.advance_playback(ctx);
        self.watch_focus(ctx);
        self.follow_tour();
        self.sync();
        if !ctx.input(|i| i.pointer.any_down()) {
            self.document.end_gesture();
            self.session.recut_anchor = None;
        }
        let title = self.title();
        if title != self.session.title {
            // Every command asks for another frame: an idle window must not give any.
            ctx.send_viewport_cmd(egui::ViewportCommand::Title(title.clone()));
            self.session.title = title;
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        egui::Panel::top("menu").show(ui, |ui| self.panel(|context, actions| panels::menu::ui(ui, context, actions)));
        egui::Panel::bottom("status")
            .show(ui, |ui| self.panel(|context, actions| panels::status::ui(ui, context, actions)));
        if self.derived.part.is_some() {
            if self.session.show.is_on(Toggle::Plots) && self.context().timeline().is_some() {
                let panel = egui::Panel::bottom("plots").default_size(240.0).min_size(160.0);
                panel.show(ui, |ui| self.panel(|context, actions| panels::plots::ui(ui, context, actions)));
            }
            if self.session.show.is_on(Toggle::ScanSection) && self.context().scan_is_laid() {
                let panel = egui::Panel::bottom("scan section").default_size(300.0).min_size(180.0);
                panel.show(ui, |ui| self.panel(|context, actions| panels::scan::section::ui(ui, context, actions)));
            }
            if self.session.show.is_on(Toggle::AccessMap) && self.derived.plan().is_some() {
                self.sync_access();
                let panel = egui::Panel::bottom("access").default_size(230.0).min_size(150.0);
                panel.show(ui, |ui| self.panel(|context, actions| panels::access::ui(ui, context, actions)));
            }
            self.sides(ui);
            let panel = egui::Panel::bottom("timeline");
            panel.show(ui, |ui| self.panel(|context, actions| panels::timeline::ui(ui, context, actions)));
            if self.session.show.is_on(Toggle::ProgramText) && self.derived.playback_data().is_some() {
                let panel = egui::Panel::right("text").default_size(330.0).min_size(180.0);
                panel.show(ui, |ui| self.panel(|context, actions| panels::program_text::ui(ui, context, actions)));
            }
            let frame = egui::Frame::NONE.fill(ui.visuals().panel_fill);
            egui::CentralPanel::default().frame(frame).show(ui, |ui| self.view(ui));
        } else {
            self.thumbnails.sync(&self.recent, ui.ctx());
            egui::CentralPanel::default()
                .show(ui, |ui| self.panel(|context, actions| panels::start::ui(ui, context, actions)));
        }
        self.dialogs.ui(ui.ctx(), &self.recent);
        self.panel(|context, actions| panels::tour::ui(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::palette::ui(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::dialogs::help(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::dialogs::guard(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::questions::ui(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::dialogs::message(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::compare::ui(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::head_editor::ui(ui.ctx(), context, actions));
        self.panel(|context, actions| panels::weld::images::ui(ui.ctx(), context, actions));
        panels::library::at_cursor(ui.ctx());
        // Edits of this frame are kept with it: there may be no other for a while.
        self.keep_journal();
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        eframe::set_value(storage, RECENT_KEY, &self.recent);
        eframe::set_value(storage, LANGUAGE_KEY, &text::language().code());
        let at = Navigation::ALL.iter().position(|n| *n == self.session.navigation);
        eframe::set_value(storage, NAVIGATION_KEY, &at);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.keep_thumbnail();
        self.derived.cancel_all();
        if self.session.may_close {
            self.clear_journal();
        }
        self.viewport.release();
    }
}

/// Opens the window, and returns when it is closed.
///
/// # Errors
/// There is no screen, or no OpenGL on it.
pub fn run(open: Option<PathBuf>) -> anyhow::Result<()> {
    let options = eframe::NativeOptions {
        renderer: eframe::Renderer::Glow,
        viewport: egui::ViewportBuilder::default()
            .with_inner_size([1440.0, 900.0])
            .with_min_inner_size([640.0, 420.0])
            .with_app_id("clearbeam")
            .with_icon(eframe::icon_data::from_png_bytes(ICON).unwrap_or_default())
            .with_drag_and_drop(true),
        ..Default::default()
    };
    let app = |cc: &eframe::CreationContext<'_>| {
        App::new(cc, Box::new(WindowDialogs::default()), open)
            .with_recipes(users_folder::recipes())
            .with_journal(users_folder::journal())
            .with_thumbnails(users_folder::thumbnails())
    };
    eframe::run_native("clearbeam", options, Box::new(|cc| Ok(Box::new(app(cc)))))
        .map_err(|e| anyhow::Error::msg(say!(window_not_opened, reason = e.to_string())))
}
