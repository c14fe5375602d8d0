//! The state of the dialog in the window: where it is, what it lists, what is typed and chosen. Folders are read on a
//! thread, since one of the network may take its time.

use super::folder::{self, Entry};
use super::wanted::{Wanted, WantedKind};
use crate::text::say;
use eframe::egui;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};

/// Folders of files that were opened last, at most.
const PLACES: usize = 5;

/// What a folder held, or why it could not be read.
type Listing = Result<Vec<Entry>, String>;

/// The dialog.
pub(super) struct Browser {
    /// What is asked for.
    pub wanted: Wanted,
    /// The path as it stands in its field.
    pub typed: String,
    /// The file's name, as it is typed or was chosen.
    pub name: String,
    /// Whether files of other kinds are shown as well.
    pub shows_all: bool,
    /// Why the last thing that was done could not be.
    pub why: Option<String>,
    /// A file that would be replaced, until that is confirmed.
    pub replaces: Option<PathBuf>,
    /// The name of a folder that is being made.
    pub new_folder: Option<String>,
    /// Folders to go to at once.
    pub places: Vec<PathBuf>,
    folder: PathBuf,
    listing: Option<Listing>,
    reading: Option<Receiver<Listing>>,
    ctx: egui::Context,
}

impl Browser {
    /// The dialog in a folder.
    pub fn new(wanted: Wanted, folder: PathBuf, recent: &[PathBuf], ctx: &egui::Context) -> Browser {
        let name = if let WantedKind::NewFile(name) = &wanted.kind { name.clone() } else { String::new() };
        let mut places: Vec<PathBuf> = folder::home().into_iter().collect();
        for place in recent.iter().filter_map(|file| file.parent()) {
            if places.len() <= PLACES && places.iter().all(|known| known != place) {
                places.push(place.to_path_buf());
            }
        }
        let mut browser = Browser {
            wanted,
            typed: String::new(),
            name,
            shows_all: false,
            why: None,
            replaces: None,
            new_folder: None,
            places,
            folder: PathBuf::new(),
            listing: None,
            reading: None,
            ctx: ctx.clone(),
        };
        browser.enter(&std::path::absolute(&folder).unwrap_or(folder));
        browser
    }

    /// The folder that is shown.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Shows a folder.
    pub fn enter(&mut self, folder: &Path) {
        self.folder = folder.to_path_buf();
        self.typed = folder.display().to_string();
        (self.listing, self.why, self.replaces) = (None, None, None);
        if self.wanted.kind == WantedKind::File {
            self.name.clear();
        }
        let (sender, receiver) = channel();
        let (folder, ctx) = (self.folder.clone(), self.ctx.clone());
        std::thread::spawn(move || {
            // Another folder may have been entered by now.
            let _ = sender.send(folder::entries(&folder));
            ctx.request_repaint();
        });
        self.reading = Some(receiver);
    }

    /// Goes to the folder that this one is in.
    pub fn go_up(&mut self) {
        if let Some(above) = self.folder.parent().map(Path::to_path_buf) {
            self.enter(&above);
        }
    }

    /// The rows that are shown; `None`: the folder is being read.
    pub fn rows(&mut self) -> Option<Result<Vec<Entry>, String>> {
        if let Some(listing) = self.reading.as_ref().and_then(|reading| reading.try_recv().ok()) {
            (self.listing, self.reading) = (Some(listing), None);
        }
        let shown = |e: &&Entry| e.is_folder || self.shows_all || self.wanted.takes(&e.name);
        let listing = self.listing.as_ref()?.as_ref();
        Some(listing.map(|all| all.iter().filter(shown).cloned().collect()).map_err(Clone::clone))
    }

    /// Goes where the typed path says: into a folder, or to a file, which is picked.
    pub fn take_typed(&mut self) -> Option<PathBuf> {
        let path = self.folder.join(self.typed.trim());
        if path.is_dir() {
            self.enter(&path);
            return None;
        }
        match (path.parent(), path.file_name()) {
            (Some(folder), Some(name)) if folder.is_dir() && self.wanted.kind != WantedKind::Folder => {
                let name = name.to_string_lossy().into_owned();
                self.enter(folder);
                self.name = name;
                self.pick()
            }
            _ => {
                self.why = Some(say!(browser_not_there, path = path.display().to_string()));
                None
            }
        }
    }

    /// What is picked, if it can be: an existing file is replaced only once that is confirmed.
    pub fn pick(&mut self) -> Option<PathBuf> {
        self.why = None;
        if self.wanted.kind == WantedKind::Folder {
            return Some(self.folder.clone());
        }
        let name = self.name.trim();
        if name.is_empty() {
            return None;
        }
        let path = self.folder.join(name);
        if path.is_dir() {
            self.enter(&path);
            return None;
        }
        match self.wanted.kind {
            WantedKind::File if !path.is_file() => {
                self.why = Some(say!(browser_not_there, path = path.display().to_string()));
                None
            }
            WantedKind::NewFile(_) if path.exists() && self.replaces.as_ref() != Some(&path) => {
                self.replaces = Some(path);
                None
            }
            _ => Some(path),
        }
    }

    /// Makes a folder and enters it.
    pub fn make_folder(&mut self, name: &str) {
        let path = self.folder.join(name.trim());
        match std::fs::create_dir(&path) {
            Ok(()) => {
                self.new_folder = None;
                self.enter(&path);
            }
            Err(e) => {
                let folder = path.display().to_string();
                self.why = Some(say!(start_no_folder, folder, reason = e.to_string()));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::dialogs::Purpose;
    use super::*;

    fn browser(purpose: Purpose, folder: &Path) -> Browser {
        Browser::new(Wanted::of(purpose, "job.toml"), folder.to_path_buf(), &[], &egui::Context::default())
    }

    fn listed(browser: &mut Browser) -> Vec<String> {
        loop {
            if let Some(rows) = browser.rows() {
                return rows.expect("readable").into_iter().map(|e| e.name).collect();
            }
            std::thread::yield_now();
        }
    }

    #[test]
    fn a_file_is_picked_by_name_and_by_path() {
        let dir = tempfile::tempdir().expect("a folder");
        std::fs::create_dir(dir.path().join("in")).expect("made");
        std::fs::write(dir.path().join("in/part.stl"), "").expect("writes");
        std::fs::write(dir.path().join("notes.txt"), "").expect("writes");
        let mut b = browser(Purpose::Open, dir.path());
        assert_eq!(listed(&mut b), ["in"], "a text is no part");
        b.shows_all = true;
        assert_eq!(listed(&mut b), ["in", "notes.txt"]);
        b.name = "in".into();
        assert_eq!(b.pick(), None, "a folder is entered");
        assert_eq!(listed(&mut b), ["part.stl"]);
        b.name = "gone.stl".into();
        assert_eq!(b.pick(), None);
        assert!(b.why.is_some());
        b.typed = dir.path().join("in/part.stl").display().to_string();
        assert_eq!(b.take_typed(), Some(dir.path().join("in/part.stl")));
        b.go_up();
        assert_eq!(b.folder(), dir.path());
    }

    #[test]
    fn a_file_that_is_there_is_replaced_only_when_that_is_confirmed() {
        let dir = tempfile::tempdir().expect("a folder");
        let mut b = browser(Purpose::SaveJob, dir.path());
        assert_eq!(b.pick(), Some(dir.path().join("job.toml")));
        std::fs::write(dir.path().join("job.toml"), "").expect("writes");
        assert_eq!(b.pick(), None, "asked first");
        assert_eq!(b.replaces, Some(dir.path().join("job.toml")));
        assert_eq!(b.pick(), Some(dir.path().join("job.toml")));
    }

    #[test]
    fn a_folder_is_made_and_picked() {
        let dir = tempfile::tempdir().expect("a folder");
        let mut b = browser(Purpose::Export, dir.path());
        b.make_folder("out");
        assert_eq!(b.pick(), Some(dir.path().join("out")));
        b.go_up();
        b.make_folder("out");
        assert!(b.why.is_some(), "it is there already");
    }
}
