//! The window without threads and without a screen: its work is done when a test says so, in any order.
#![allow(dead_code, reason = "each test file uses its own share")]

use super::window::Answers;
use clearbeam::app::App;
use clearbeam::planning::{Executor, Task};
use clearbeam::progress::Activity;
use eframe::egui;
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// Keeps work until it is told to do it.
#[derive(Clone, Default)]
pub struct Held(Arc<Mutex<Vec<Task>>>);

impl Executor for Held {
    fn start(&self, task: Task) {
        self.0.lock().expect("no panic").push(task);
    }
}

impl Held {
    /// Does one piece of work that waits; which one, `pick` says. Whether there was any.
    pub fn run(&self, pick: usize) -> bool {
        self.take(pick).map(Task::run).is_some()
    }

    /// Takes one piece of work without doing it.
    pub fn take(&self, pick: usize) -> Option<Task> {
        let mut tasks = self.0.lock().expect("no panic");
        let at = pick.checked_rem(tasks.len())?;
        Some(tasks.remove(at))
    }

    pub fn is_empty(&self) -> bool {
        self.0.lock().expect("no panic").is_empty()
    }

    /// Takes the first piece of work of a stage.
    pub fn take_stage(&self, stage: Activity) -> Option<Task> {
        let mut tasks = self.0.lock().expect("no panic");
        let at = tasks.iter().position(|t| t.stage() == stage)?;
        Some(tasks.remove(at))
    }
}

/// The real window's state, driven frame by frame; nothing is drawn.
pub struct Bare {
    pub app: App,
    pub held: Held,
    ctx: egui::Context,
    frame: eframe::Frame,
}

impl Bare {
    pub fn new(ctx: &egui::Context, open: PathBuf) -> Bare {
        Bare::with_answers(ctx, open, &Answers::default())
    }

    pub fn with_answers(ctx: &egui::Context, open: PathBuf, answers: &Answers) -> Bare {
        let held = Held::default();
        let cc = eframe::CreationContext::_new_kittest(ctx.clone());
        let app = App::new(&cc, Box::new(answers.clone()), None);
        let app = app.with_executor(Arc::new(held.clone())).opening(open);
        let mut bare = Bare { app, held, ctx: ctx.clone(), frame: eframe::Frame::_new_kittest() };
        bare.settle();
        bare
    }

    /// One frame of the window.
    pub fn step(&mut self) {
        use eframe::App as _;
        self.ctx.begin_pass(egui::RawInput::default());
        self.app.logic(&self.ctx, &mut self.frame);
        // Nobody draws.
        self.ctx.end_pass().textures_delta.clear();
    }

    /// Frames and work until nothing is left to do.
    pub fn settle(&mut self) {
        self.step();
        for _ in 0..200 {
            while self.held.run(0) {}
            self.step();
            if self.held.is_empty() && self.app.is_settled() {
                return;
            }
        }
        panic!("the window never came to rest");
    }
}
