//! What a panel wants done: collected while it is drawn, and carried out by the window afterwards.

use super::App;
use super::command::Command;
use super::context::Context;
use super::dialogs::Purpose;
use super::file_findings::FileCure;
use super::questions::Reply;
use super::recipe_library::LibraryChange;
use super::session::Session;
use crate::document::{Edit, Parameter};
use crate::part::Weld;
use crate::view::Bounds;
use nalgebra::{Point3, Vector3};
use std::path::PathBuf;

/// One thing that is wanted.
enum Action {
    Command(Command),
    Edit { edit: Edit, gesture: Option<String> },
    Number(&'static Parameter, f64),
    Weld(Weld),
    Cure(FileCure),
    Robot(String),
    Library(LibraryChange),
    Open(PathBuf),
    Sample(&'static str),
    Tour,
    Ask(Purpose),
    Focus(u32),
    Session(Box<dyn FnOnce(&mut Session)>),
    GoToTarget((usize, usize)),
    GoToTime(f64),
    LookAt { in_part: Point3<f64>, reach_mm: f64 },
    ApplyBetterSetup,
    DismissBetterSetup,
    Save,
    GoOn,
    Reply(Reply),
}

/// What is wanted, in the order in which it came.
#[derive(Default)]
pub(super) struct Actions(Vec<Action>);

impl Actions {
    /// Gives a command, as its menu and its keys do; one that is not enabled does nothing.
    pub fn command(&mut self, command: Command) {
        self.0.push(Action::Command(command));
    }

    /// Changes the document, as a step of its own.
    pub fn edit(&mut self, edit: Edit) {
        self.0.push(Action::Edit { edit, gesture: None });
    }

    /// Changes the document as part of a drag: edits of one gesture are one step of undo.
    pub fn drag(&mut self, edit: Edit, gesture: impl Into<String>) {
        self.0.push(Action::Edit { edit, gesture: Some(gesture.into()) });
    }

    /// Sets a number of the parameter table, as part of a drag.
    pub fn number(&mut self, parameter: &'static Parameter, value: f64) {
        self.0.push(Action::Number(parameter, value));
    }

    /// Welds the corners of the part otherwise.
    pub fn weld(&mut self, weld: Weld) {
        self.0.push(Action::Weld(weld));
    }

    /// Cures a finding of the part's file.
    pub fn cure(&mut self, cure: FileCure) {
        self.0.push(Action::Cure(cure));
    }

    /// Chooses a robot by its key or file, with the dialect of its controller; an empty name stands for no robot.
    pub fn robot(&mut self, name: String) {
        self.0.push(Action::Robot(name));
    }

    /// Changes the user's library of recipes.
    pub fn library(&mut self, change: LibraryChange) {
        self.0.push(Action::Library(change));
    }

    /// Opens a part or a job, once unsaved changes are dealt with.
    pub fn open(&mut self, file: PathBuf) {
        self.0.push(Action::Open(file));
    }

    /// Opens a shipped sample by its name, once unsaved changes are dealt with.
    pub fn sample(&mut self, name: &'static str) {
        self.0.push(Action::Sample(name));
    }

    /// Begins the guided tour.
    pub fn tour(&mut self) {
        self.0.push(Action::Tour);
    }

    /// Asks the user for a file.
    pub fn ask(&mut self, purpose: Purpose) {
        self.0.push(Action::Ask(purpose));
    }

    /// Fits the camera to a surface.
    pub fn focus(&mut self, surface: u32) {
        self.0.push(Action::Focus(surface));
    }

    /// Changes what is selected, shown or open.
    pub fn session(&mut self, change: impl FnOnce(&mut Session) + 'static) {
        self.0.push(Action::Session(Box::new(change)));
    }

    /// Selects a surface alone, and scrolls its row into sight.
    pub fn reveal(&mut self, surface: u32) {
        self.session(move |s| (s.selected, s.scroll_to) = ([surface].into(), Some(surface)));
    }

    /// Steps to a target: pass and point.
    pub fn go_to_target(&mut self, at: (usize, usize)) {
        self.0.push(Action::GoToTarget(at));
    }

    /// Goes to a time of the program, s.
    pub fn go_to_time(&mut self, time_s: f64) {
        self.0.push(Action::GoToTime(time_s));
    }

    /// Turns the camera to a point of the part frame, with `reach_mm` around it in sight. Where the part stands then is
    /// found out after the actions before this one.
    pub fn look_at(&mut self, in_part: Point3<f64>, reach_mm: f64) {
        self.0.push(Action::LookAt { in_part, reach_mm });
    }

    /// Takes the better set-up into the job.
    pub fn apply_better_setup(&mut self) {
        self.0.push(Action::ApplyBetterSetup);
    }

    /// Forgets the better set-up.
    pub fn dismiss_better_setup(&mut self) {
        self.0.push(Action::DismissBetterSetup);
    }

    /// Saves the job where it is kept, or asks where.
    pub fn save(&mut self) {
        self.0.push(Action::Save);
    }

    /// Does what had to wait until unsaved changes were dealt with.
    pub fn go_on(&mut self) {
        self.0.push(Action::GoOn);
    }

    /// Answers the question that waits.
    pub fn reply(&mut self, reply: Reply) {
        self.0.push(Action::Reply(reply));
    }
}

impl App {
    /// Draws a panel, and carries out what it wants.
    pub(super) fn panel(&mut self, draw: impl FnOnce(Context<'_>, &mut Actions)) {
        let mut actions = Actions::default();
        draw(self.context(), &mut actions);
        actions.0.into_iter().for_each(|action| self.act(action));
    }

    fn act(&mut self, action: Action) {
        match action {
            Action::Command(command) => self.run(command),
            Action::Edit { edit, gesture } => self.apply(&edit, gesture.as_deref()),
            Action::Number(parameter, value) => self.set_parameter(parameter, value),
            Action::Weld(weld) => self.set_weld(weld),
            Action::Cure(cure) => self.cure(cure),
            Action::Robot(name) => self.choose_robot(&name),
            Action::Library(change) => self.change_library(change),
            Action::Open(file) => self.open_guarded(file),
            Action::Sample(name) => self.open_sample(name),
            Action::Tour => self.begin_tour(),
            Action::Ask(purpose) => self.ask(purpose),
            Action::Focus(surface) => self.focus_surface(surface),
            Action::Session(change) => change(&mut self.session),
            Action::GoToTarget(at) => self.go_to_target(at),
            Action::GoToTime(time_s) => self.go_to_time(time_s),
            Action::LookAt { in_part, reach_mm } => {
                let (at, out) = (self.context().scene_from_part() * in_part, Vector3::repeat(reach_mm));
                self.glide_to_see(&in_part, Bounds { min: at - out, max: at + out });
            }
            Action::ApplyBetterSetup => self.apply_better_setup(),
            Action::DismissBetterSetup => {
                self.dismiss_better_setup();
            }
            Action::Save => self.save_job(),
            Action::GoOn => self.go_on(),
            Action::Reply(reply) => self.take_reply(reply),
        }
    }
}
