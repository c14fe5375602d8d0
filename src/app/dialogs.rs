//! What files are asked for, behind a trait, so that tests can give the answer. The dialogs themselves stand in
//! `file_browser`.

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
    /// Where to save the laser head that is being put together.
    SaveHead,
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
    fn ask(&self, purpose: Purpose, name: &str, ctx: &egui::Context, answer: Answer);

    /// Draws the dialogs that stand in the window itself, where there are any. `recent`: files that were opened last.
    fn ui(&self, _ctx: &egui::Context, _recent: &[PathBuf]) {}
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
