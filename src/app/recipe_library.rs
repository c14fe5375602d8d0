//! The operator's changes of the recipe library, which outlives a job, and what the window says of them.

use super::App;
use crate::document::Recipe;
use crate::text::{Sentence as _, say};

/// A change of the user's library.
#[derive(Clone, Debug, PartialEq)]
pub enum LibraryChange {
    /// Keeps a recipe in the user's folder.
    Keep(Recipe),
    /// Takes the recipe of that name out; it can come back.
    Forget(String),
    /// Brings back the recipe that was taken out last.
    BringBack,
}

impl App {
    /// Changes the user's library, and tells what came of it.
    pub(super) fn change_library(&mut self, change: LibraryChange) {
        let done = match change {
            LibraryChange::Keep(recipe) => self.recipes.keep(&recipe).map(|file| {
                self.session.said = say!(library_saved, file = file.display().to_string());
            }),
            LibraryChange::Forget(name) => {
                self.recipes.forget(&name).map(|forgotten| self.session.forgotten = Some(forgotten))
            }
            LibraryChange::BringBack => match self.session.forgotten.take() {
                Some(forgotten) => self.recipes.bring_back(&forgotten),
                None => Ok(()),
            },
        };
        if let Err(why) = done {
            self.session.error = Some(why.sentence());
        }
    }
}
