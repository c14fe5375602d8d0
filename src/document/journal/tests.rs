//! Two windows beside each other, and what one leaves behind that ended early.

use super::*;
use crate::document::{Document, Edit, IfChanged, Job, JobError, UndoStep, files, save};
use std::path::PathBuf;

/// A folder with a job `a.toml` that names its part `a.stl`, and the journal's folder in it.
struct Desk(tempfile::TempDir);

impl Desk {
    fn new() -> Desk {
        let desk = Desk(tempfile::tempdir().expect("a folder"));
        let mut job = Job::default();
        (job.part.file, job.part.sha256) = ("parts/a.stl".into(), "ab".into());
        std::fs::write(desk.path("a.toml"), files::to_toml(&job).expect("text")).expect("writes");
        desk
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn journal(&self) -> Journal {
        Journal::open(Some(&self.path("journal"))).expect("opens")
    }

    fn document(&self) -> Document {
        let (job, file) = save::open(&self.path("a.toml")).expect("opens");
        Document::new(job, Some(file))
    }

    /// A document whose spacing was changed.
    fn edited(&self, spacing_mm: f64) -> Document {
        let mut document = self.document();
        document.apply(&Edit::Set("layers.spacing_mm", spacing_mm), &[], None);
        document
    }

    fn left(&self) -> LeftBehind {
        left_behind(&self.path("journal"))
    }

    /// The spacings of what was left behind.
    fn spacings(&self) -> Vec<f64> {
        let left = self.left();
        assert!(left.unreadable.is_empty(), "{:?}", left.unreadable);
        left.leftovers.iter().map(|l| l.job().layers.spacing_mm).collect()
    }
}

#[test]
fn live_windows_do_not_see_each_other() {
    let desk = Desk::new();
    let (mut one, mut other) = (desk.journal(), desk.journal());
    one.record(&desk.edited(2.0)).expect("records");
    other.record(&desk.edited(3.0)).expect("records");
    assert!(desk.spacings().is_empty());
    drop(other); // as the kernel does for a killed process: the lock goes, the state stays
    assert_eq!(desk.spacings(), [3.0]);
    drop(one);
    let mut both = desk.spacings();
    both.sort_by(f64::total_cmp);
    assert_eq!(both, [2.0, 3.0]);
    assert_eq!(desk.spacings().len(), 2, "looking takes nothing away");
}

#[test]
fn a_new_window_keeps_off_what_was_left_behind() {
    let desk = Desk::new();
    let mut first = desk.journal();
    first.record(&desk.edited(2.0)).expect("records");
    drop(first);
    let mut next = desk.journal();
    next.record(&desk.edited(3.0)).expect("records");
    assert_eq!(desk.spacings(), [2.0]);
}

#[test]
fn a_clean_document_leaves_nothing() {
    let desk = Desk::new();
    let mut document = desk.edited(2.0);
    let mut journal = desk.journal();
    journal.record(&document).expect("records");
    document.save(&desk.path("a.toml"), IfChanged::Refuse).expect("saves");
    journal.record(&document).expect("records");
    drop(journal);
    assert!(desk.spacings().is_empty());
    let mut journal = desk.journal();
    document.undo();
    journal.record(&document).expect("records");
    document.redo();
    journal.record(&document).expect("records");
    drop(journal);
    assert!(desk.spacings().is_empty());
    assert_eq!(Journal::open(None).expect("opens").record(&desk.edited(3.0)).ok(), Some(()), "no folder, no journal");
}

#[test]
fn a_program_that_ended_between_saving_and_clearing_leaves_nothing_to_restore() {
    let desk = Desk::new();
    let mut document = desk.edited(2.0);
    let mut journal = desk.journal();
    journal.record(&document).expect("records");
    document.save(&desk.path("a.toml"), IfChanged::Refuse).expect("saves");
    drop(journal);
    assert!(desk.spacings().is_empty());
    assert!(!desk.path("journal/1.toml").exists());
}

#[test]
fn a_leftover_is_taken_over_once() {
    let desk = Desk::new();
    let mut killed = desk.journal();
    killed.record(&desk.edited(2.0)).expect("records");
    drop(killed);
    let mut journal = desk.journal();
    journal.record(&desk.edited(5.0)).expect("records");
    let mut left = desk.left().leftovers;
    assert!(desk.spacings().is_empty(), "another window that starts now does not find it");
    let leftover = left.pop().expect("one");
    assert_eq!((leftover.job_file(), leftover.part_name().as_str()), (Some(desk.path("a.toml").as_path()), "a"));
    assert_eq!(leftover.part_file(), desk.path("parts/a.stl"));
    let mut document = leftover.restored();
    assert_eq!((document.undo_step(), document.job()), (Some(&UndoStep::Restored), desk.edited(2.0).job()));
    leftover.take_over(&mut journal).expect("takes over");
    assert!(desk.spacings().is_empty(), "it is that of a live window now, and what that had is given up");
    document.apply(&Edit::Set("layers.spacing_mm", 4.0), &[], None);
    journal.record(&document).expect("records");
    drop(journal);
    assert_eq!(desk.spacings(), [4.0]);
}

#[test]
fn of_windows_that_start_at_once_one_takes_it_over() {
    let desk = Desk::new();
    let mut killed = desk.journal();
    killed.record(&desk.edited(2.0)).expect("records");
    drop(killed);
    let taken: Vec<Journal> = std::thread::scope(|scope| {
        let window = || {
            let mut journal = desk.journal();
            let leftover = desk.left().leftovers.pop()?;
            leftover.take_over(&mut journal).expect("takes over");
            Some(journal)
        };
        let windows: Vec<_> = (0..8).map(|_| scope.spawn(window)).collect();
        windows.into_iter().filter_map(|w| w.join().expect("no panic")).collect()
    });
    assert_eq!(taken.len(), 1);
    drop(taken);
    assert_eq!(desk.spacings(), [2.0]);
}

#[test]
fn what_is_discarded_is_gone_and_what_is_put_off_is_not() {
    let desk = Desk::new();
    let mut killed = desk.journal();
    killed.record(&desk.edited(2.0)).expect("records");
    drop(killed);
    drop(desk.left()); // not now
    desk.left().leftovers.pop().expect("still there").discard().expect("discards");
    assert!(desk.spacings().is_empty());
}

#[test]
fn a_job_without_a_file_names_its_part_from_anywhere() {
    let desk = Desk::new();
    let mut job = Job::default();
    (job.part.file, job.cell.robot) = ("src/../parts/b.stl".into(), "mz04".into());
    let mut document = Document::new(job, None);
    document.apply(&Edit::Set("layers.spacing_mm", 2.0), &[], None);
    document.apply(&Edit::Head("head.toml".into()), &[], None);
    let mut journal = desk.journal();
    journal.record(&document).expect("records");
    drop(journal);
    let leftover = desk.left().leftovers.pop().expect("one");
    let here = |name: &str| std::env::current_dir().expect("a folder").join(name).display().to_string();
    let job = leftover.job();
    assert_eq!((&job.part.file, &job.beam.head), (&here("parts/b.stl"), &here("head.toml")));
    assert_eq!((leftover.job_file(), job.cell.robot.as_str()), (None, "mz04"));
    let mut restored = leftover.restored();
    assert!(restored.is_dirty());
    restored.undo();
    assert_eq!((&restored.job().part.file, restored.is_dirty()), (&here("parts/b.stl"), false));
}

#[test]
fn changes_of_a_file_that_another_has_saved_or_removed_are_not_lost_and_not_forced() {
    let desk = Desk::new();
    let mut killed = desk.journal();
    killed.record(&desk.edited(2.0)).expect("records");
    drop(killed);
    desk.edited(3.0).save(&desk.path("a.toml"), IfChanged::Refuse).expect("saves");
    let leftover = desk.left().leftovers.pop().expect("one");
    let mut document = leftover.restored();
    let refused = document.save(&desk.path("a.toml"), IfChanged::Refuse);
    assert!(matches!(refused, Err(JobError::ChangedOnDisk { .. })), "{refused:?}");
    document.undo();
    assert_eq!(document.job().layers.spacing_mm, 3.0);
    std::fs::remove_file(desk.path("a.toml")).expect("removes");
    let mut document = leftover.restored();
    assert_eq!((document.job().layers.spacing_mm, document.is_dirty()), (2.0, true));
    document.save(&desk.path("a.toml"), IfChanged::Refuse).expect("saves");
    assert_eq!(files::read(&desk.path("a.toml")).expect("reads"), *desk.edited(2.0).job());
}

#[test]
fn damaged_states_are_told_and_stay() {
    let desk = Desk::new();
    let mut killed = desk.journal();
    killed.record(&desk.edited(2.0)).expect("records");
    drop(killed);
    let file = desk.path("journal/1.toml");
    let whole = std::fs::read(&file).expect("reads");
    for length in 0..whole.len() {
        std::fs::write(&file, &whole[..length]).expect("writes");
        let left = desk.left();
        assert!(left.leftovers.is_empty(), "cut to {length} bytes, it passes for a job");
        let told = left.unreadable.first().expect("told");
        assert!(matches!(told, JournalError::Unreadable { file: of, .. } if *of == file), "{told:?}");
        assert_eq!(std::fs::read(&file).expect("stays"), &whole[..length]);
    }
    let mut next = desk.journal();
    next.record(&desk.edited(3.0)).expect("records");
    assert!(file.exists() && desk.path("journal/2.toml").exists(), "a new window keeps off it");
    std::fs::write(&file, whole).expect("writes");
    assert_eq!(desk.spacings(), [2.0]);
}
