//! Progress of long work, and the wish to end it: shared between the thread that works and the one
//! that shows.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// Named stage, done and whole, cancelled.
#[derive(Debug, Default)]
pub struct Progress {
    stage: Mutex<&'static str>,
    done: AtomicUsize,
    whole: AtomicUsize,
    cancelled: Arc<AtomicBool>,
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

    /// Of work within this one: it ends with this, and its stages are not shown.
    pub fn within(&self) -> Progress {
        Progress { cancelled: self.cancelled.clone(), ..Progress::default() }
    }

    /// One piece is done.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn step(&self) -> Result<(), Cancelled> {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.check()
    }

    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.goes_on() { Ok(()) } else { Err(Cancelled) }
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
