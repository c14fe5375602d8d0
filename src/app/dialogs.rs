//! File dialogs, off the UI thread and behind a trait, so that tests inject the answer.

use std::path::PathBuf;

/// What a file is wanted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A part or job to open.
    Open,
    /// Where to save the job.
    SaveJob,
    /// A folder for the program.
    Export,
    /// A cell file.
    Cell,
    /// A robot file.
    Robot,
    /// A laser head to open.
    Head,
    /// An STL that stands on the part.
    Clamp,
}

/// Gets its answer when the user has given it; `None` if he would not.
pub type Answer = Box<dyn FnOnce(Option<PathBuf>) + Send>;

/// Asks the user for files.
pub trait FileDialogs {
    /// Asks, without waiting; `name` is suggested.
    fn ask(&self, purpose: Purpose, name: &str, answer: Answer);
}

/// The system's dialogs.
pub struct NativeDialogs;

impl FileDialogs for NativeDialogs {
    fn ask(&self, purpose: Purpose, name: &str, answer: Answer) {
        let name = name.to_owned();
        std::thread::spawn(move || {
            let dialog = rfd::FileDialog::new();
            answer(match purpose {
                Purpose::Open => dialog.add_filter("Part or job", &["stl", "STL", "toml", "clearbeam"]).pick_file(),
                Purpose::SaveJob => dialog.add_filter("Job", &["toml", "clearbeam"]).set_file_name(name).save_file(),
                Purpose::Export => dialog.set_title("Folder for the program").pick_folder(),
                Purpose::Cell => dialog.add_filter("Cell", &["toml"]).pick_file(),
                Purpose::Head => dialog.add_filter("Head", &["toml", "stl", "STL"]).pick_file(),
                Purpose::Clamp => dialog.add_filter("Clamp", &["stl", "STL"]).pick_file(),
                Purpose::Robot => dialog.add_filter("Robot", &["toml"]).pick_file(),
            });
        });
    }
}
