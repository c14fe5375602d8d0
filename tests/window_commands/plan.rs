//! Effects on planning, and on the place in the plan.

use crate::common::held::Bare;
use crate::common::window::job_on;
use crate::window::Window;
use crate::{JOB, REFUSED};
use clearbeam::app::{Command, Jump};
use clearbeam::document::Edit;
use clearbeam::progress::Activity;
use eframe::egui;

fn bare(name: &str, text: &str) -> (Bare, tempfile::TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let job = job_on(&folder, name, text);
    (Bare::new(&egui::Context::default(), job), folder)
}

pub fn cancelled_and_planned_again() {
    let (mut bare, _folder) = bare("workpiece", JOB);
    bare.app.send(Edit::Set("layers.spacing_mm", 15.0));
    bare.step();
    bare.app.give(Command::Cancel, &[]);
    bare.settle();
    assert!(bare.app.plan().is_none() && bare.app.why_no_plan().is_some_and(|why| why.contains("cancelled")));
    bare.app.give(Command::Plan, &[]);
    bare.settle();
    assert!(bare.app.plan().is_some());
}

pub fn better_setup() {
    let (mut bare, _folder) = bare("acetabular_cup", REFUSED);
    bare.app.give(Command::BetterSetup, &[]);
    assert!(bare.held.take_stage(Activity::LookingForSetup).is_some(), "it is being looked for");
    assert!(!bare.app.can(Command::BetterSetup), "once is enough");
}

pub fn play(w: &mut Window) {
    let at = |w: &Window| w.app().target_at();
    w.give(Command::Go(Jump::FirstPoint), &[]);
    w.give(Command::Play, &[]);
    w.h.run_steps(60);
    let reached = at(w);
    assert!(reached > (0, 0) && w.says("Pause"));
    w.give(Command::Play, &[]);
    let stopped = at(w);
    w.h.run_steps(30);
    assert_eq!(at(w), stopped);
}

pub fn go(w: &mut Window, jump: Jump) {
    let planned = w.app().plan().expect("a plan").clone();
    let points = |pass: usize| planned.plan.passes[pass].targets.len();
    let last = planned.plan.passes.len() - 1;
    assert!(last >= 3 && points(1) >= 2 && points(2) >= 2, "something to step through");
    // From the second point of the third pass, and over the ends of passes.
    w.give(Command::Go(Jump::FirstPoint), &[]);
    for to in [Jump::NextPass, Jump::NextPass, Jump::NextPoint] {
        w.give(Command::Go(to), &[]);
    }
    assert_eq!(w.app().target_at(), (2, 1));
    w.give(Command::Go(jump), &[]);
    let once = match jump {
        Jump::NextPoint if points(2) > 2 => (2, 2),
        Jump::NextPoint => (3, 0),
        Jump::PreviousPoint => (2, 0),
        Jump::NextPass => (3, 0),
        Jump::PreviousPass => (1, 0),
        Jump::FirstPoint => (0, 0),
        Jump::LastPoint => (last, points(last) - 1),
    };
    assert_eq!(w.app().target_at(), once, "{jump:?}");
    w.give(Command::Go(jump), &[]);
    if jump == Jump::PreviousPoint {
        assert_eq!(w.app().target_at(), (1, points(1) - 1), "over the end of a pass");
    }
}
