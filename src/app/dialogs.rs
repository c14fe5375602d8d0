//! File dialogs, off the UI thread and behind a trait, so that tests can give the answer.

use crate::part::file::ENDINGS;
use crate::scan;
use crate::text::say;
use eframe::egui;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};

/// What a file is wanted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A part or job to open.
    Open,
    /// Where to save the job.
    SaveJob,
    /// A folder for the program.
    Export,
    /// A folder for its dry run.
    ExportDryRun,
    /// A part in the place of one that has changed or is gone.
    Part,
    /// A cell file.
    Cell,
    /// A robot file.
    Robot,
    /// A laser head to open.
    Head,
    /// The facets of a clamp on the part.
    Clamp,
    /// A scan of the part as it is.
    Scan,
    /// The grey image of a weld.
    WeldGray,
    /// Its depth image.
    WeldDepth,
    /// The camera that took both.
    WeldCamera,
    /// The grey image after a pass was ground.
    NextGray,
    /// The depth image after a pass was ground.
    NextDepth,
    /// Where the camera stood.
    HandEye,
    /// A grinding tool.
    GrindingTool,
}

/// Called with the user's answer; `None`: the dialog was cancelled.
pub type Answer = Box<dyn FnOnce(Option<PathBuf>) + Send>;

/// Asks the user for files.
pub trait FileDialogs {
    /// Asks, without waiting; `name` is suggested.
    fn ask(&self, purpose: Purpose, name: &str, answer: Answer);
}

/// Answers that are waited for.
pub(super) struct Answers {
    sender: Sender<(Purpose, Option<PathBuf>)>,
    receiver: Receiver<(Purpose, Option<PathBuf>)>,
    waiting: usize,
}

impl Default for Answers {
    fn default() -> Self {
        let (sender, receiver) = channel();
        Answers { sender, receiver, waiting: 0 }
    }
}

impl Answers {
    /// Waits for one more, and wakes the window with it.
    pub(super) fn expect(&mut self, purpose: Purpose, ctx: &egui::Context) -> Answer {
        self.waiting += 1;
        let (sender, ctx) = (self.sender.clone(), ctx.clone());
        Box::new(move |path| {
            // The window may be gone by now.
            let _ = sender.send((purpose, path));
            ctx.request_repaint();
        })
    }

    /// The next answer.
    pub(super) fn take(&mut self) -> Option<(Purpose, Option<PathBuf>)> {
        let answer = self.receiver.try_recv().ok()?;
        self.waiting -= 1;
        Some(answer)
    }

    /// Whether none is waited for.
    pub(super) fn is_empty(&self) -> bool {
        self.waiting == 0
    }
}

/// Endings of parts in small and large letters, which some systems tell apart, and others.
fn parts_and(others: &[&str]) -> Vec<String> {
    cased(&ENDINGS, others)
}

fn cased(endings: &[&str], others: &[&str]) -> Vec<String> {
    let both = endings.iter().flat_map(|e| [(*e).to_owned(), e.to_uppercase()]);
    both.chain(others.iter().map(|e| (*e).to_owned())).collect()
}

/// Endings that grey images have and depth images have not, and the other way round.
const JPEG: [&str; 2] = ["jpg", "jpeg"];
const PGM: [&str; 1] = ["pgm"];

fn images(besides: &[&str]) -> Vec<String> {
    cased(&[&["png", "tif", "tiff"], besides].concat(), &[])
}

/// The system's dialogs.
pub struct NativeDialogs;

impl FileDialogs for NativeDialogs {
    fn ask(&self, purpose: Purpose, name: &str, answer: Answer) {
        let name = name.to_owned();
        std::thread::spawn(move || {
            let dialog = rfd::FileDialog::new();
            answer(match purpose {
                Purpose::Open => {
                    dialog.add_filter(say!(dialog_part_or_job), &parts_and(&["toml", "clearbeam"])).pick_file()
                }
                Purpose::Part => dialog.add_filter(say!(dialog_part), &parts_and(&[])).pick_file(),
                Purpose::SaveJob => {
                    dialog.add_filter(say!(dialog_job), &["toml", "clearbeam"]).set_file_name(name).save_file()
                }
                Purpose::Export => dialog.set_title(say!(dialog_program_folder)).pick_folder(),
                Purpose::ExportDryRun => dialog.set_title(say!(dialog_dry_run_folder)).pick_folder(),
                Purpose::Cell => dialog.add_filter(say!(dialog_cell), &["toml"]).pick_file(),
                Purpose::Head => dialog.add_filter(say!(dialog_head), &parts_and(&["toml"])).pick_file(),
                Purpose::Clamp => dialog.add_filter(say!(dialog_clamp), &parts_and(&[])).pick_file(),
                Purpose::Scan => dialog.add_filter(say!(dialog_scan), &cased(&scan::file::ENDINGS, &[])).pick_file(),
                Purpose::WeldGray | Purpose::NextGray => {
                    dialog.set_title(say!(dialog_weld_gray)).add_filter(say!(dialog_image), &images(&JPEG)).pick_file()
                }
                Purpose::WeldDepth | Purpose::NextDepth => {
                    dialog.set_title(say!(dialog_weld_depth)).add_filter(say!(dialog_image), &images(&PGM)).pick_file()
                }
                Purpose::WeldCamera => {
                    let dialog = dialog.set_title(say!(dialog_weld_camera));
                    dialog.add_filter(say!(dialog_camera), &["toml", "json"]).pick_file()
                }
                Purpose::HandEye => dialog.add_filter(say!(dialog_hand_eye), &["toml"]).pick_file(),
                Purpose::GrindingTool => dialog.add_filter(say!(dialog_grinding_tool), &["toml"]).pick_file(),
                Purpose::Robot => dialog.add_filter(say!(dialog_robot), &["toml"]).pick_file(),
            });
        });
    }
}
