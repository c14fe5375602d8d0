//! Stages whose work ends in any order, panics, and comes too late.

use super::executor::{Executor, Task};
use super::failure::Failure;
use super::stage::Stage;
use crate::part::{Digest, Hasher};
use crate::progress::Activity;
use proptest::prelude::*;
use std::sync::Mutex;

/// Keeps what it is given until it is told to run it.
#[derive(Default)]
pub(super) struct Held(Mutex<Vec<Task>>);

impl Executor for Held {
    fn start(&self, task: Task) {
        self.0.lock().expect("no panic").push(task);
    }
}

impl Held {
    pub(super) fn run(&self, which: usize) {
        let mut tasks = self.0.lock().expect("no panic");
        if !tasks.is_empty() {
            let at = which % tasks.len();
            let task = tasks.remove(at);
            drop(tasks);
            task.run();
        }
    }
}

pub(super) fn key(n: u32) -> Digest {
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
