//! What the window calls proven, and lets out as a program, belongs to the job as it is: each way in which it
//! did not is a test.

mod common;

use clearbeam::app::{Command, Purpose};
use clearbeam::document::save::save;
use clearbeam::document::{Edit, IfChanged, files};
use clearbeam::part::Units;
use clearbeam::planning::Pipeline;
use clearbeam::progress::Activity;
use common::held::Bare;
use common::window::{Answers, job_on, sample};
use eframe::egui;
use std::path::Path;
use std::sync::Arc;

const JOB: &str = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 20.0\ndirection = \"x\"\n";

fn opened(folder: &tempfile::TempDir, answers: &Answers) -> Bare {
    let job = job_on(folder, "workpiece", JOB);
    Bare::with_answers(&egui::Context::default(), job, answers)
}

/// Length of the work that the command line finds in the job as the window would save it, mm.
fn work_mm_by_command_line(bare: &Bare, folder: &Path) -> f64 {
    let file = folder.join("saved.toml");
    let document = bare.app.document();
    let (job, _) = save(document.job(), document.job_file(), &file, IfChanged::Overwrite).expect("saves");
    let source = files::read_part(&job, Some(&file)).expect("the part");
    let (_, planned) = Pipeline::planned(Arc::new(source), &job, Some(&file)).expect("a plan");
    planned.report.work_mm
}

#[test]
fn one_click_on_a_unit_never_leaves_the_plan_of_the_other_part() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut bare = opened(&folder, &Answers::default());
    let before = bare.app.plan().expect("a plan").report.work_mm;
    bare.app.send(Edit::Set("part.placement.scale", 2.0));
    assert!(bare.app.plan().is_none(), "at once");
    // Whatever is being done: until all of it is, no plan is called current.
    while !bare.held.is_empty() || !bare.app.is_settled() {
        bare.step();
        let current = bare.app.plan().map(|p| p.report.work_mm);
        assert!(current.is_none_or(|mm| mm > 1.5 * before), "{current:?} beside {before}");
        bare.held.run(0);
    }
    let work_mm = bare.app.plan().expect("a plan").report.work_mm;
    assert_eq!(work_mm, work_mm_by_command_line(&bare, folder.path()));
}

#[test]
fn of_four_quick_changes_the_last_is_shown_whichever_ends_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut bare = opened(&folder, &Answers::default());
    let changes = [Edit::Set("part.placement.scale", 2.0), Edit::Units(Units::Inch), Edit::Units(Units::Mm)];
    for change in changes.into_iter().chain([Edit::Set("part.placement.scale", 0.5)]) {
        bare.app.send(change);
        bare.step();
    }
    // The newest ends first, the others after it.
    while bare.held.run(usize::MAX) {
        bare.step();
    }
    bare.settle();
    let planned = bare.app.plan().expect("a plan");
    assert_eq!(
        planned.part.mesh.diagonal(),
        {
            let file = folder.path().join("workpiece.stl");
            clearbeam::part::load(&file, Units::Mm, &bare.app.document().job().part.placement, &[]).expect("loads")
        }
        .mesh
        .diagonal()
    );
    assert_eq!(planned.report.work_mm, work_mm_by_command_line(&bare, folder.path()));
}

#[test]
fn nothing_is_exported_while_the_plan_is_not_that_of_the_job() {
    let (folder, out) = (tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder"));
    let answers = Answers::default();
    answers.0.lock().expect("no panic").push((Purpose::Export, out.path().to_path_buf()));
    let mut bare = opened(&folder, &answers);
    // The edit comes while the folder is looked at.
    bare.app.give(Command::Export, &[]);
    bare.app.send(Edit::Set("part.placement.scale", 0.5));
    bare.settle();
    assert_eq!(std::fs::read_dir(out.path()).expect("there").count(), 0, "nothing may be written");
}

#[test]
fn a_head_that_was_changed_on_disk_makes_the_plan_stale() {
    let folder = tempfile::tempdir().expect("a folder");
    let head = |r1_mm: f64| {
        let stack = format!("[[part]]\nfrom_mm = 30.0\nto_mm = 60.0\nr0_mm = 2.0\nr1_mm = {r1_mm:?}\n");
        std::fs::write(folder.path().join("head.toml"), stack).expect("writes");
    };
    head(8.0);
    let out = tempfile::tempdir().expect("a folder");
    let answers = Answers::default();
    answers.0.lock().expect("no panic").push((Purpose::Export, out.path().to_path_buf()));
    let mut bare = opened(&folder, &answers);
    bare.app.send(Edit::Head("head.toml".into()));
    bare.settle();
    let before = bare.app.plan().expect("a plan").key;
    head(12.25);
    bare.app.give(Command::Export, &[]);
    bare.settle();
    assert_eq!(std::fs::read_dir(out.path()).expect("there").count(), 0, "that plan is of another head");
    assert_ne!(bare.app.plan().expect("made anew").key, before);
}

#[test]
fn a_panic_on_a_thread_is_told_and_the_window_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    for stage in [Activity::BuildingPart, Activity::LayingLines, Activity::Planning] {
        let mut bare = opened(&folder, &Answers::default());
        bare.app.send(Edit::Set("part.placement.scale", 2.0));
        bare.step();
        let planted = loop {
            if let Some(task) = bare.held.take_stage(stage) {
                break task;
            }
            assert!(bare.held.run(0), "{stage:?} never came");
            bare.step();
        };
        planted.run_after(|| panic!("planted in {stage:?}"));
        if stage != Activity::LayingLines {
            bare.settle();
            let why = bare.app.why_no_plan().expect("told");
            assert!(why.contains("planted in") && why.contains("Ctrl+R"), "{why}");
            assert!(bare.app.plan().is_none());
            bare.app.give(Command::Plan, &[]);
        }
        bare.settle();
        let work_mm = bare.app.plan().expect("a plan").report.work_mm;
        assert_eq!(work_mm, work_mm_by_command_line(&bare, folder.path()), "{stage:?}");
    }
}

#[test]
fn a_cancelled_plan_is_no_plan_and_is_made_on_demand() {
    let mut bare = Bare::new(&egui::Context::default(), sample("workpiece.toml"));
    assert!(bare.app.plan().is_some());
    bare.app.send(Edit::Set("layers.spacing_mm", 15.0));
    bare.step();
    bare.app.give(Command::Cancel, &[]);
    bare.settle();
    assert!(bare.app.plan().is_none() && bare.app.why_no_plan().is_some_and(|why| why.contains("cancelled")));
    bare.app.give(Command::Plan, &[]);
    bare.settle();
    assert!(bare.app.plan().is_some());
}
