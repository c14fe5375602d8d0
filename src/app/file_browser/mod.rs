//! File dialogs: those of the system, or where it has none one in the window itself.
//!
//! `wanted` is what is asked for, `system` asks the system for it, `folder` reads what a folder holds, `browser` is the
//! state of the dialog in the window and `window` draws it.

mod browser;
mod folder;
mod system;
mod wanted;
mod window;

use super::dialogs::{Answer, FileDialogs, Purpose};
use browser::Browser;
use eframe::egui;
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use system::Asked;
use wanted::Wanted;

/// The system's dialogs, and the window's own where the system shows none.
pub struct WindowDialogs {
    has_system: bool,
    sender: Sender<Unasked>,
    /// What the system was asked for and did not ask the user.
    unasked: Receiver<Unasked>,
    state: RefCell<State>,
}

/// What is still to be asked.
struct Unasked {
    wanted: Wanted,
    answer: Answer,
}

#[derive(Default)]
struct State {
    browser: Option<(Browser, Answer)>,
    /// Where the last file was picked.
    folder: Option<PathBuf>,
}

impl Default for WindowDialogs {
    fn default() -> WindowDialogs {
        WindowDialogs::new(system::is_there(&|name| std::env::var_os(name)))
    }
}

impl WindowDialogs {
    /// Dialogs in the window alone, from this folder on.
    pub fn in_window(folder: &Path) -> WindowDialogs {
        let dialogs = WindowDialogs::new(false);
        dialogs.state.borrow_mut().folder = Some(folder.to_path_buf());
        dialogs
    }

    fn new(has_system: bool) -> WindowDialogs {
        let (sender, unasked) = channel();
        WindowDialogs { has_system, sender, unasked, state: RefCell::default() }
    }
}

impl FileDialogs for WindowDialogs {
    fn ask(&self, purpose: Purpose, name: &str, ctx: &egui::Context, answer: Answer) {
        let wanted = Wanted::of(purpose, name);
        let (sender, ctx) = (self.sender.clone(), ctx.clone());
        let unasked = move |wanted, answer| {
            // The window may be gone by now.
            let _ = sender.send(Unasked { wanted, answer });
            ctx.request_repaint();
        };
        if !self.has_system {
            return unasked(wanted, answer);
        }
        std::thread::spawn(move || match system::ask(&wanted) {
            Asked::Answered(path) => answer(path),
            Asked::NotShown => unasked(wanted, answer),
        });
    }

    fn ui(&self, ctx: &egui::Context, recent: &[PathBuf]) {
        let mut state = self.state.borrow_mut();
        for Unasked { wanted, answer } in self.unasked.try_iter() {
            let of_recent = || recent.iter().find_map(|file| Some(file.parent()?.to_path_buf()));
            let folder = state.folder.clone().or_else(of_recent).or_else(folder::home);
            let browser = Browser::new(wanted, folder.unwrap_or_default(), recent, ctx);
            if let Some((_, given_up)) = state.browser.replace((browser, answer)) {
                given_up(None);
            }
        }
        let Some((browser, _)) = &mut state.browser else { return };
        let Some(ended) = window::ui(ctx, browser) else { return };
        let folder = browser.folder().to_path_buf();
        if let Some((_, answer)) = state.browser.take() {
            if ended.is_some() {
                state.folder = Some(folder);
            }
            answer(ended);
        }
    }
}
