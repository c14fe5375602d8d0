//! Long work on its own threads: one thing at a time, with progress and cancel. Results come back
//! over a channel and wake the window.

use super::clearance::ClearanceCurve;
use super::dialogs::Purpose;
use super::dose::DoseView;
use super::motion::Motion;
use super::remedy::Proposal;
use crate::document::{Job, JobFile};
use crate::part::{Part, Shape, Surfaces, stl::RawPart};
use crate::planning::Plan;
use crate::planning::PlanError;
use crate::planning::report::Report;
use crate::progress::Cancelled;
use crate::progress::Progress;
use crate::view::LineItem;
use eframe::egui;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// What a thread brings back.
pub enum Outcome {
    /// A part was read: its job, where that is kept, the facets, and the part.
    Opened(Result<Box<Opened>, String>),
    /// The part was built anew for another unit or place.
    Rebuilt(Result<Arc<Part>, String>),
    /// Shapes of surfaces.
    Shaped(Arc<Surfaces>, BTreeMap<u32, Shape>),
    /// The lines of this job, while its plan is being made.
    Laid(Box<Job>, LineItem),
    /// A plan for this job.
    Planned(Box<Job>, Result<(Arc<Plan>, Arc<Report>), PlanError>),
    /// The motion of the plan of that number.
    Moving(u64, Arc<Motion>),
    /// The clearance over the motion of the plan of that number.
    Cleared(u64, Arc<ClearanceCurve>),
    /// What would help with the plan of that number.
    Advised(u64, Result<Vec<String>, Cancelled>),
    /// A better set-up for it, if there is any.
    Proposed(u64, Result<Option<Arc<Proposal>>, Cancelled>),
    /// The dose of the plan of that number.
    Dosed(u64, Result<Arc<DoseView>, PlanError>),
    /// Files were written, or not.
    Exported(Result<Vec<PathBuf>, String>),
    /// A file was picked, or not.
    Picked(Purpose, Option<PathBuf>),
}

/// A part with its job.
pub struct Opened {
    /// The job.
    pub job: Job,
    /// Its file.
    pub file: Option<JobFile>,
    /// Facets as read.
    pub raw: Arc<RawPart>,
    /// The part.
    pub part: Arc<Part>,
}

/// Threads and their results.
pub struct Worker {
    ctx: egui::Context,
    sender: Sender<Outcome>,
    receiver: Receiver<Outcome>,
    running: usize,
    progress: Arc<Progress>,
}

impl Worker {
    /// A worker that wakes this window.
    pub fn new(ctx: egui::Context) -> Worker {
        let (sender, receiver) = channel();
        Worker { ctx, sender, receiver, running: 0, progress: Arc::default() }
    }

    /// Whether nothing runs.
    pub fn is_idle(&self) -> bool {
        self.running == 0
    }

    /// Stage and share of the planning that runs.
    pub fn progress(&self) -> Option<(&'static str, f32)> {
        (self.running > 0).then(|| self.progress.now()).filter(|p| !p.0.is_empty())
    }

    /// Asks the planning that runs to end.
    pub fn cancel(&self) {
        self.progress.cancel();
    }

    /// Starts planning; one that runs is cancelled. What is told meanwhile does not end the work.
    pub fn plan(&mut self, work: impl FnOnce(&Progress, &dyn Fn(Outcome)) -> Outcome + Send + 'static) {
        self.progress.cancel();
        self.progress = Arc::default();
        let (progress, sender, ctx) = (self.progress.clone(), self.sender.clone(), self.ctx.clone());
        let meanwhile = move |outcome| {
            let _ = sender.send(outcome);
            ctx.request_repaint();
        };
        self.spawn(move || work(&progress, &meanwhile));
    }

    /// Starts other work.
    pub fn spawn(&mut self, work: impl FnOnce() -> Outcome + Send + 'static) {
        let reply = self.reply();
        std::thread::spawn(move || reply(work()));
    }

    /// Expects one result from elsewhere (a file dialog).
    pub fn reply(&mut self) -> impl FnOnce(Outcome) + Send + 'static {
        self.running += 1;
        let (sender, ctx) = (self.sender.clone(), self.ctx.clone());
        move |outcome| {
            // The window may be gone by now.
            let _ = sender.send(outcome);
            ctx.request_repaint();
        }
    }

    /// The next result.
    pub fn take(&mut self) -> Option<Outcome> {
        let outcome = self.receiver.try_recv().ok()?;
        self.running -= usize::from(!matches!(outcome, Outcome::Laid(..)));
        Some(outcome)
    }
}
