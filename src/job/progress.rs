//! Progress of long work, and the wish to end it: shared between the thread that works and the one
//! that shows.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Named stage, done and whole, cancelled.
#[derive(Debug, Default)]
pub struct Progress {
    stage: Mutex<&'static str>,
    done: AtomicUsize,
    whole: AtomicUsize,
    cancelled: AtomicBool,
}

/// The work was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl Progress {
    /// Begins a stage of so many pieces.
    pub fn begin(&self, stage: &'static str, whole: usize) {
        if let Ok(mut s) = self.stage.lock() {
            *s = stage;
        }
        self.done.store(0, Ordering::Relaxed);
        self.whole.store(whole, Ordering::Relaxed);
    }

    /// One piece is done.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn step(&self) -> Result<(), Cancelled> {
        self.done.fetch_add(1, Ordering::Relaxed);
        if self.cancelled.load(Ordering::Relaxed) { Err(Cancelled) } else { Ok(()) }
    }

    /// Whether nobody asked the work to end.
    pub fn goes_on(&self) -> bool {
        !self.cancelled.load(Ordering::Relaxed)
    }

    /// Asks the work to end.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Stage and share done, 0 to 1.
    pub fn now(&self) -> (&'static str, f32) {
        let whole = self.whole.load(Ordering::Relaxed).max(1);
        let share = self.done.load(Ordering::Relaxed) as f32 / whole as f32;
        (self.stage.lock().map_or("", |s| *s), share.min(1.0))
    }
}
