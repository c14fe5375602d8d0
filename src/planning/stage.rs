//! A computed value and the key of all that it depends on.
//!
//! A result carries its key by construction: each piece of work has a slot of its own, and a stage that wants
//! another key lets go of the slot, so what arrives late arrives nowhere. Which key is wanted, the pipeline says.

use super::executor::{Executor, Task};
use super::failure::{Failure, guarded};
use crate::part::Digest;
use crate::progress::{Activity, Progress};
use std::sync::{Arc, Mutex};

type ResultSlot<V, E> = Arc<Mutex<Option<Result<V, Failure<E>>>>>;

/// The state of a stage.
enum StageState<V, E> {
    Idle,
    Running { key: Digest, progress: Arc<Progress>, slot: ResultSlot<V, E> },
    Done,
    Failed { key: Digest, why: Failure<E> },
}

/// A computed value: idle, running, done or failed, each for one key.
///
/// The newest value stays when another is wanted, to be shown as out of date; [`Stage::of`] alone gives it as
/// current.
pub struct Stage<V, E> {
    state: StageState<V, E>,
    newest: Option<(Digest, Arc<V>)>,
}

impl<V, E> Default for Stage<V, E> {
    fn default() -> Self {
        Stage { state: StageState::Idle, newest: None }
    }
}

impl<V, E> Stage<V, E> {
    /// The value, if it is the one of this key.
    pub fn of(&self, key: Digest) -> Option<&Arc<V>> {
        let (of, value) = self.newest.as_ref()?;
        (*of == key && matches!(self.state, StageState::Done)).then_some(value)
    }

    /// The newest value that there was, with its key: it may be out of date.
    pub fn newest(&self) -> Option<(Digest, &Arc<V>)> {
        self.newest.as_ref().map(|(key, value)| (*key, value))
    }

    /// Takes the outcome out once it is there, for one who keeps it elsewhere; the stage is idle then.
    pub fn take_result(&mut self) -> Option<Result<V, Failure<E>>> {
        // It may have been there since the start: a thread can be that quick.
        self.poll();
        match std::mem::take(self) {
            Stage { state: StageState::Done, newest: Some((_, value)) } => Arc::into_inner(value).map(Ok),
            Stage { state: StageState::Failed { why, .. }, .. } => Some(Err(why)),
            other => {
                *self = other;
                None
            }
        }
    }

    /// Why there is no value for this key.
    pub fn failure(&self, key: Digest) -> Option<&Failure<E>> {
        match &self.state {
            StageState::Failed { key: of, why } if *of == key => Some(why),
            _ => None,
        }
    }

    /// Whether nothing is known of this key, and nothing is being done for it.
    pub fn lacks(&self, key: Digest) -> bool {
        match &self.state {
            StageState::Idle => true,
            StageState::Running { key: of, .. } | StageState::Failed { key: of, .. } => *of != key,
            StageState::Done => self.of(key).is_none(),
        }
    }

    /// Whether work is going on, for whichever key.
    pub fn is_running(&self) -> bool {
        matches!(self.state, StageState::Running { .. })
    }

    /// How far the work is.
    pub fn progress(&self) -> Option<&Progress> {
        match &self.state {
            StageState::Running { progress, .. } => Some(progress),
            _ => None,
        }
    }

    /// Asks the work to end; the stage has failed for its key then.
    pub fn cancel(&mut self) {
        if let StageState::Running { key, progress, .. } = &self.state {
            progress.cancel();
            self.state = StageState::Failed { key: *key, why: Failure::Cancelled };
        }
    }

    /// Ends the work, which nobody waits for; it begins anew once it is wanted again.
    pub fn stop(&mut self) {
        if let StageState::Running { progress, .. } = &self.state {
            progress.cancel();
            self.state = StageState::Idle;
        }
    }

    /// Ends the work, and has failed for this key.
    pub fn fail(&mut self, key: Digest, why: Failure<E>) {
        self.cancel();
        self.state = StageState::Failed { key, why };
    }

    /// Forgets failures, so that the same is tried again.
    pub fn try_again(&mut self) {
        if matches!(self.state, StageState::Failed { .. }) {
            self.state = StageState::Idle;
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
        if let StageState::Running { key: of, progress, .. } = &self.state
            && *of != key
        {
            progress.cancel();
            self.state = StageState::Idle;
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
        let StageState::Running { key, slot, .. } = &self.state else { return false };
        let key = *key;
        let Some(result) = slot.lock().ok().and_then(|mut slot| slot.take()) else { return false };
        self.settle(key, result);
        true
    }

    fn settle(&mut self, key: Digest, result: Result<V, Failure<E>>) {
        match result {
            Ok(value) => {
                self.newest = Some((key, Arc::new(value)));
                self.state = StageState::Done;
            }
            Err(why) => self.state = StageState::Failed { key, why },
        }
    }
}

impl<V: Send + 'static, E: Send + 'static> Stage<V, E> {
    /// Takes what has arrived, and starts the work for a key of which nothing is known: `work` is asked for only then. The
    /// value, if it is there by now.
    pub fn sync<W>(
        &mut self,
        key: Digest,
        stage: Activity,
        executor: &dyn Executor,
        work: impl FnOnce() -> W,
    ) -> Option<&Arc<V>>
    where
        W: FnOnce(&Progress) -> Result<V, Failure<E>> + Send + 'static,
    {
        self.poll();
        if self.lacks(key) {
            self.start(key, stage, executor, work());
        }
        self.of(key)
    }

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
        let (progress, slot): (Arc<Progress>, ResultSlot<V, E>) = Default::default();
        progress.begin(stage, 1);
        self.state = StageState::Running { key, progress: progress.clone(), slot: slot.clone() };
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
        executor.start(Task::new(stage, run));
        // An executor that works at once has the result by now.
        self.poll();
    }
}
