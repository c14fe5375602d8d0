//! Who does the work of stages: a few threads, or the caller himself.

use super::executor::{Executor, Task};
use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex};
use thread_priority::{ThreadPriority, set_current_thread_priority};

/// Threads that take tasks in the order in which they come, and wake whoever waits for results.
///
/// Three, whatever the machine: a plan, what follows from the last one, and something small. Each of them
/// uses all cores where its work can be shared.
const THREADS: usize = 3;

/// Priority of all work, of 100, where a thread begins with about 50: where the window wants all cores, it gets a
/// thirtieth of them. On two cores, too, a part is turned while it is planned.
const PRIORITY: u8 = 10;

/// A bounded pool. Its threads end with it. What they share out among all cores they share out among threads of their own:
/// else whoever waits for a result could do nothing on all cores until it is there, and a window would stand still.
pub struct Pool {
    queue: Arc<Queue>,
}

struct Queue {
    tasks: Mutex<Waiting>,
    more: Condvar,
    /// `None`: there are no threads to be had, and those of everybody must do.
    cores: Option<rayon::ThreadPool>,
    wake: Box<dyn Fn() + Send + Sync>,
}

#[derive(Default)]
struct Waiting {
    tasks: VecDeque<Task>,
    is_closed: bool,
}

impl Pool {
    /// Starts the threads; `wake` is called after each task.
    pub fn new(wake: impl Fn() + Send + Sync + 'static) -> Pool {
        let cores = rayon::ThreadPoolBuilder::new().start_handler(|_| step_back()).build().ok();
        let queue = Arc::new(Queue { tasks: Mutex::default(), more: Condvar::new(), cores, wake: Box::new(wake) });
        for _ in 0..THREADS {
            let queue = queue.clone();
            std::thread::spawn(move || {
                step_back();
                queue.work();
            });
        }
        Pool { queue }
    }
}

/// Lowers the priority of this thread. Where the system does not let it the work is done all the same.
fn step_back() {
    if let Ok(priority) = PRIORITY.try_into() {
        let _ = set_current_thread_priority(ThreadPriority::Crossplatform(priority));
    }
}

impl Executor for Pool {
    fn start(&self, task: Task) {
        if let Ok(mut waiting) = self.queue.tasks.lock() {
            waiting.tasks.push_back(task);
        }
        self.queue.more.notify_one();
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        if let Ok(mut waiting) = self.queue.tasks.lock() {
            waiting.is_closed = true;
            waiting.tasks.clear();
        }
        self.queue.more.notify_all();
    }
}

impl Queue {
    fn work(&self) {
        while let Some(task) = self.next() {
            match &self.cores {
                Some(cores) => cores.install(|| task.run()),
                None => task.run(),
            }
            (self.wake)();
        }
    }

    fn next(&self) -> Option<Task> {
        let mut waiting = self.tasks.lock().ok()?;
        loop {
            if waiting.is_closed {
                return None;
            }
            if let Some(task) = waiting.tasks.pop_front() {
                return Some(task);
            }
            waiting = self.more.wait(waiting).ok()?;
        }
    }
}

/// Does the work at once, where it is asked for: for those who wait for the result anyway.
#[derive(Clone, Copy, Debug, Default)]
pub struct AtOnce;

impl Executor for AtOnce {
    fn start(&self, task: Task) {
        task.run();
    }
}

#[cfg(test)]
mod tests {
    use super::super::failure::Failure;
    use super::super::stage::Stage;
    use super::*;
    use crate::part::Hasher;
    use std::sync::mpsc::channel;

    #[test]
    fn a_pool_outlives_panics_and_wakes_after_each_task() {
        let (sender, woken) = channel();
        let sender = Mutex::new(sender);
        let pool = Pool::new(move || drop(sender.lock().map(|s| s.send(()))));
        let mut stages: Vec<Stage<u32, ()>> = (0..20).map(|_| Stage::default()).collect();
        let key = Hasher::default().finish();
        for (n, stage) in (0u32..).zip(&mut stages) {
            stage.start(key, crate::progress::Activity::Planning, &pool, move |_| {
                if n % 2 == 0 { panic!("even") } else { Ok(n) }
            });
        }
        for _ in 0..20 {
            woken.recv().expect("woken");
        }
        for (n, stage) in (0u32..).zip(&mut stages) {
            stage.poll();
            match stage.failure(key) {
                Some(why) => assert_eq!(*why, Failure::Panicked("even".into())),
                None => assert_eq!(stage.of(key).map(|v| **v), Some(n)),
            }
        }
    }
}
