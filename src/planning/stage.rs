//! A computed value and the key of all that it depends on.
//!
//! A result carries its key by construction: each piece of work has a slot of its own, and a stage that wants
//! another key lets go of the slot, so what arrives late arrives nowhere. A panic is a failure with its words.
//! Which key is wanted, the pipeline says.

use crate::part::Digest;
use crate::progress::{Activity, Cancelled, Progress};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex};
use thiserror::Error;

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
    /// What it computes.
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

/// Why a stage has no value.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Failure<E> {
    /// The user ended the work.
    #[error("cancelled")]
    Cancelled,
    /// A fault of the program: the words of the panic.
    #[error("a fault in the program: {0}")]
    Panicked(String),
    /// What was given cannot be worked on.
    #[error("{0}")]
    Refused(E),
}

impl<E> From<Cancelled> for Failure<E> {
    fn from(_: Cancelled) -> Failure<E> {
        Failure::Cancelled
    }
}

type Slot<V, E> = Arc<Mutex<Option<Result<V, Failure<E>>>>>;

/// How far a stage is.
enum State<V, E> {
    Idle,
    Running { key: Digest, progress: Arc<Progress>, slot: Slot<V, E> },
    Done,
    Failed { key: Digest, why: Failure<E> },
}

/// A computed value: idle, running, done or failed, each for one key.
///
/// The newest value stays when another is wanted, to be shown as out of date; [`Stage::of`] alone gives it as
/// current.
pub struct Stage<V, E> {
    state: State<V, E>,
    newest: Option<(Digest, Arc<V>)>,
}

impl<V, E> Default for Stage<V, E> {
    fn default() -> Self {
        Stage { state: State::Idle, newest: None }
    }
}

impl<V, E> Stage<V, E> {
    /// The value, if it is the one of this key.
    pub fn of(&self, key: Digest) -> Option<&Arc<V>> {
        let (of, value) = self.newest.as_ref()?;
        (*of == key && matches!(self.state, State::Done)).then_some(value)
    }

    /// The newest value that there was, with its key: it may be out of date.
    pub fn newest(&self) -> Option<(Digest, &Arc<V>)> {
        self.newest.as_ref().map(|(key, value)| (*key, value))
    }

    /// Takes the outcome out once it is there, for one who keeps it elsewhere; the stage is idle then.
    pub fn taken(&mut self) -> Option<Result<V, Failure<E>>> {
        // It may have been there since the start: a thread can be that quick.
        self.poll();
        match std::mem::take(self) {
            Stage { state: State::Done, newest: Some((_, value)) } => Arc::into_inner(value).map(Ok),
            Stage { state: State::Failed { why, .. }, .. } => Some(Err(why)),
            other => {
                *self = other;
                None
            }
        }
    }

    /// Why there is none for this key.
    pub fn failure(&self, key: Digest) -> Option<&Failure<E>> {
        match &self.state {
            State::Failed { key: of, why } if *of == key => Some(why),
            _ => None,
        }
    }

    /// Whether nothing is known of this key, and nothing is being done for it.
    pub fn lacks(&self, key: Digest) -> bool {
        match &self.state {
            State::Idle => true,
            State::Running { key: of, .. } | State::Failed { key: of, .. } => *of != key,
            State::Done => self.of(key).is_none(),
        }
    }

    /// Whether work is going on, for whichever key.
    pub fn is_running(&self) -> bool {
        matches!(self.state, State::Running { .. })
    }

    /// How far the work is.
    pub fn progress(&self) -> Option<&Progress> {
        match &self.state {
            State::Running { progress, .. } => Some(progress),
            _ => None,
        }
    }

    /// Asks the work to end; the stage has failed for its key then.
    pub fn cancel(&mut self) {
        if let State::Running { key, progress, .. } = &self.state {
            progress.cancel();
            self.state = State::Failed { key: *key, why: Failure::Cancelled };
        }
    }

    /// Ends the work, and has failed for this key.
    pub fn fail(&mut self, key: Digest, why: Failure<E>) {
        self.cancel();
        self.state = State::Failed { key, why };
    }

    /// Forgets failures, so that the same is tried again.
    pub fn try_again(&mut self) {
        if matches!(self.state, State::Failed { .. }) {
            self.state = State::Idle;
        }
    }

    /// Ends the work and forgets everything.
    pub fn clear(&mut self) {
        if let Some(progress) = self.progress() {
            progress.cancel();
        }
        *self = Stage::default();
    }

    /// Ends work for any other key than this, as nobody waits for it.
    pub fn only(&mut self, key: Digest) {
        if let State::Running { key: of, progress, .. } = &self.state
            && *of != key
        {
            progress.cancel();
            self.state = State::Idle;
        }
    }

    /// Computes the value of a key here and now.
    pub fn fill(&mut self, key: Digest, work: impl FnOnce() -> Result<V, Failure<E>>) {
        self.only(key);
        let result = guarded(work);
        self.settle(key, result);
    }

    /// Takes what has arrived; whether anything did.
    pub fn poll(&mut self) -> bool {
        let State::Running { key, slot, .. } = &self.state else { return false };
        let key = *key;
        let Some(result) = slot.lock().ok().and_then(|mut slot| slot.take()) else { return false };
        self.settle(key, result);
        true
    }

    fn settle(&mut self, key: Digest, result: Result<V, Failure<E>>) {
        match result {
            Ok(value) => {
                self.newest = Some((key, Arc::new(value)));
                self.state = State::Done;
            }
            Err(why) => self.state = State::Failed { key, why },
        }
    }
}

impl<V: Send + 'static, E: Send + 'static> Stage<V, E> {
    /// Starts the work for a key; work for another is ended.
    pub fn start(
        &mut self,
        key: Digest,
        stage: Activity,
        executor: &dyn Executor,
        work: impl FnOnce(&Progress) -> Result<V, Failure<E>> + Send + 'static,
    ) {
        if let Some(progress) = self.progress() {
            progress.cancel();
        }
        let (progress, slot): (Arc<Progress>, Slot<V, E>) = Default::default();
        progress.begin(stage, 1);
        self.state = State::Running { key, progress: progress.clone(), slot: slot.clone() };
        let run = move |first: &dyn Fn()| {
            let result = guarded(|| {
                first();
                progress.check()?;
                work(&progress)
            });
            if let Ok(mut slot) = slot.lock() {
                *slot = Some(result);
            }
        };
        executor.start(Task { stage, run: Box::new(run) });
        // An executor that works at once has the result by now.
        self.poll();
    }
}

fn guarded<V, E>(work: impl FnOnce() -> Result<V, Failure<E>>) -> Result<V, Failure<E>> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| Err(Failure::Panicked(words_of(panic.as_ref()))))
}

fn words_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "without words".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Hasher;
    use proptest::prelude::*;

    /// Keeps what it is given until it is told to run it.
    #[derive(Default)]
    struct Held(Mutex<Vec<Task>>);

    impl Executor for Held {
        fn start(&self, task: Task) {
            self.0.lock().expect("no panic").push(task);
        }
    }

    impl Held {
        fn run(&self, which: usize) {
            let mut tasks = self.0.lock().expect("no panic");
            if !tasks.is_empty() {
                let at = which % tasks.len();
                let task = tasks.remove(at);
                drop(tasks);
                task.run();
            }
        }
    }

    fn key(n: u32) -> Digest {
        Hasher::default().of(&n).finish()
    }

    proptest! {
        /// Whatever is wanted and in whichever order work ends, a value is current under its own key alone.
        #[test]
        fn a_value_belongs_to_its_key(steps in prop::collection::vec((0u32..4, 0usize..5, 0u8..3), 1..40)) {
            let held = Held::default();
            let mut stage: Stage<u32, String> = Stage::default();
            let mut wanted = 0;
            for (n, which, what) in steps {
                match what {
                    0 => {
                        wanted = n;
                        if stage.lacks(key(n)) {
                            stage.start(key(n), Activity::Planning, &held, move |_| Ok(n));
                        }
                    }
                    1 => held.run(which),
                    _ => drop(stage.poll()),
                }
                for m in 0..4 {
                    prop_assert!(stage.of(key(m)).is_none_or(|value| **value == m));
                }
            }
            while !held.0.lock().expect("no panic").is_empty() {
                held.run(0);
            }
            stage.poll();
            if !stage.lacks(key(wanted)) {
                prop_assert_eq!(stage.of(key(wanted)).map(|v| **v), Some(wanted));
            }
        }
    }

    #[test]
    fn a_panic_is_a_failure_with_its_words_and_can_be_tried_again() {
        let held = Held::default();
        let mut stage: Stage<u32, String> = Stage::default();
        stage.start(key(1), Activity::Planning, &held, |_| Ok(7));
        let task = held.0.lock().expect("no panic").pop().expect("a task");
        task.run_after(|| panic!("planted"));
        assert!(stage.poll());
        assert_eq!(stage.failure(key(1)), Some(&Failure::Panicked("planted".into())));
        assert!(!stage.lacks(key(1)) && stage.lacks(key(2)) && !stage.is_running());
        stage.try_again();
        stage.start(key(1), Activity::Planning, &held, |_| Ok(7));
        held.run(0);
        stage.poll();
        assert_eq!(stage.of(key(1)).map(|v| **v), Some(7));
    }

    #[test]
    fn what_is_out_of_date_stays_to_be_shown() {
        let held = Held::default();
        let mut stage: Stage<u32, String> = Stage::default();
        stage.fill(key(1), || Ok(1));
        stage.start(key(2), Activity::Planning, &held, |_| Ok(2));
        assert_eq!((stage.of(key(1)), stage.newest().map(|(of, v)| (of, **v))), (None, Some((key(1), 1))));
        stage.cancel();
        assert_eq!(stage.failure(key(2)), Some(&Failure::Cancelled));
        held.run(0);
        assert!(!stage.poll(), "nobody waits for it");
        assert_eq!(stage.newest().map(|(of, _)| of), Some(key(1)));
    }
}
