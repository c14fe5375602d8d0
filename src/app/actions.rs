//! What a panel wants done: it collects that while it is drawn, and the window carries it out afterwards.

use super::App;
use super::command::Command;
use super::context::Context;
use super::session::Session;
use crate::document::Edit;
use std::path::PathBuf;

/// One thing that is wanted.
enum Action {
    Command(Command),
    Edit { edit: Edit, gesture: Option<String> },
    Open(PathBuf),
    Focus(u32),
    Session(Box<dyn FnOnce(&mut Session)>),
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

    /// Changes the document as a piece of the drag that is going on: edits of one gesture are one step of undo.
    #[expect(dead_code, reason = "panels with fields ask the window itself so far")]
    pub fn drag(&mut self, edit: Edit, gesture: impl Into<String>) {
        self.0.push(Action::Edit { edit, gesture: Some(gesture.into()) });
    }

    /// Opens a part or a job, once unsaved changes are dealt with.
    pub fn open(&mut self, file: PathBuf) {
        self.0.push(Action::Open(file));
    }

    /// Fits the camera to a surface.
    pub fn focus(&mut self, surface: u32) {
        self.0.push(Action::Focus(surface));
    }

    /// Changes what is selected, shown or open.
    pub fn session(&mut self, change: impl FnOnce(&mut Session) + 'static) {
        self.0.push(Action::Session(Box::new(change)));
    }
}

impl App {
    /// Draws a panel, and carries out what it wants.
    pub(super) fn panel(&mut self, draw: impl FnOnce(Context<'_>, &mut Actions)) {
        let mut actions = Actions::default();
        draw(self.context(), &mut actions);
        for action in actions.0 {
            match action {
                Action::Command(command) => self.run(command),
                Action::Edit { edit, gesture } => self.apply(&edit, gesture.as_deref()),
                Action::Open(file) => self.open_guarded(file),
                Action::Focus(surface) => self.focus_surface(surface),
                Action::Session(change) => change(&mut self.session),
            }
        }
    }
}
