//! A piece of a stage's work, and who does it. What a piece computes and where its result goes, `stage` says.

use crate::progress::Activity;

/// Runs the work of stages: on threads, at once, or when a test says so.
pub trait Executor: Send + Sync {
    /// Takes a piece of work. It must be run once, or dropped when nobody waits for anything any more.
    fn start(&self, task: Task);
}

/// What a task does, behind something that may panic as the work itself may.
type Run = Box<dyn FnOnce(&dyn Fn()) + Send>;

/// A piece of work for an [`Executor`].
pub struct Task {
    stage: Activity,
    run: Run,
}

impl Task {
    /// A piece of the work of a stage.
    pub(super) fn new(stage: Activity, run: impl FnOnce(&dyn Fn()) + Send + 'static) -> Task {
        Task { stage, run: Box::new(run) }
    }

    /// Name of the stage whose value it computes.
    pub fn stage(&self) -> Activity {
        self.stage
    }

    /// Does the work and puts the result where its stage looks for it.
    pub fn run(self) {
        self.run_after(|| ());
    }

    /// Does the work behind something that may panic as the work itself may: so tests plant a panic.
    pub fn run_after(self, first: impl Fn()) {
        (self.run)(&first);
    }
}
