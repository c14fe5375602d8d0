//! The job with its file, and undo and redo of every edit since it was opened.

use super::edit::Edit;
use super::files::save::{FileState, IfChanged, JobFile, save};
use super::files::{JobError, rebased};
use super::model::Job;
use super::remembered::Remembered;
use super::renumber::LostSettings;
use crate::part::SurfaceId;
use std::path::Path;

/// What a step of undo did.
#[derive(Clone, Debug, PartialEq)]
pub enum UndoStep {
    /// An edit; of a drag the last one.
    Edited(Edit),
    /// Changes that a killed program left behind came back.
    Restored,
}

/// A job that is being worked on.
#[derive(Clone, Debug, Default)]
pub struct Document {
    job: Job,
    /// Where the job is kept; `None` until it is saved first.
    file: Option<JobFile>,
    saved: Job,
    /// Steps with the job as it was before each.
    undo: Vec<(UndoStep, Job)>,
    /// Steps with the job as it was after each.
    redo: Vec<(UndoStep, Job)>,
    /// What the last edit is a piece of: a drag, a run of key presses.
    gesture: Option<String>,
    /// What surfaces lost by the last edit.
    lost: Vec<LostSettings>,
}

impl Document {
    /// A document over a job as it is in its file.
    pub fn new(job: Job, file: Option<JobFile>) -> Document {
        Document { saved: job.clone(), job, file, ..Default::default() }
    }

    /// A document over a job as it is in its file, with what was not saved as one step over it.
    pub fn restored(saved: Job, file: Option<JobFile>, unsaved: Job) -> Document {
        let mut document = Document::new(saved, file);
        if unsaved != document.job {
            let saved = std::mem::replace(&mut document.job, unsaved);
            document.undo.push((UndoStep::Restored, saved));
        }
        document
    }

    /// The job as it is now.
    pub fn job(&self) -> &Job {
        &self.job
    }

    /// Where the job is kept; `None` until it is saved first.
    pub fn file(&self) -> Option<&Path> {
        self.file.as_ref().map(|f| f.path.as_path())
    }

    /// Where the job is kept, and what the file held when it was last read or written.
    pub fn job_file(&self) -> Option<&JobFile> {
        self.file.as_ref()
    }

    /// Whether the file on disk is still the one that was last read or written here.
    pub fn file_state(&self) -> FileState {
        self.file.as_ref().map_or(FileState::New, JobFile::state)
    }

    /// Applies an edit and records undo. Edits that change one property of one subject within one `gesture` are one
    /// step. Returns whether anything changed; [`Document::lost`] tells what went with it.
    pub fn apply(&mut self, edit: &Edit, all_surfaces: &[SurfaceId], gesture: Option<&str>) -> bool {
        let before = self.job.clone();
        self.lost = edit.apply(&mut self.job, all_surfaces);
        if self.job == before {
            return false;
        }
        let is_same_gesture = gesture.is_some() && self.gesture.as_deref() == gesture;
        match self.undo.last_mut() {
            Some((UndoStep::Edited(last), _)) if is_same_gesture && edit.goes_on_from(last) => last.clone_from(edit),
            _ => self.undo.push((UndoStep::Edited(edit.clone()), before)),
        }
        self.gesture = gesture.map(str::to_owned);
        self.redo.clear();
        true
    }

    /// What surfaces lost by the last edit, because their facets are others since.
    pub fn lost(&self) -> &[LostSettings] {
        &self.lost
    }

    /// Ends a drag: the next edit is a step of its own.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// The step that undo would take back.
    pub fn undo_step(&self) -> Option<&UndoStep> {
        self.undo.last().map(|(step, _)| step)
    }

    /// The step that redo would bring again.
    pub fn redo_step(&self) -> Option<&UndoStep> {
        self.redo.last().map(|(step, _)| step)
    }

    /// Takes the last step back.
    pub fn undo(&mut self) {
        if let Some((step, job)) = self.undo.pop() {
            self.redo.push((step, std::mem::replace(&mut self.job, job)));
            self.gesture = None;
            self.lost.clear();
        }
    }

    /// Brings the last undone step again.
    pub fn redo(&mut self) {
        if let Some((step, job)) = self.redo.pop() {
            self.undo.push((step, std::mem::replace(&mut self.job, job)));
            self.gesture = None;
            self.lost.clear();
        }
    }

    /// Whether there is anything that the file does not hold.
    pub fn is_dirty(&self) -> bool {
        self.job != self.saved
    }

    /// Remembers what the part's surfaces look like, for the next save. That is no edit.
    pub fn remember(&mut self, landmarks: Remembered) {
        self.job.part.landmarks = landmarks;
    }

    /// Saves the job, from now on with its paths seen from the file. Steps of undo and redo are seen from there too.
    ///
    /// # Errors
    /// The file has changed since it was last read or written here, and may not be overwritten; what
    /// cannot be written, and why. The document stays as it was.
    pub fn save(&mut self, to: &Path, if_changed: IfChanged) -> Result<(), JobError> {
        let from = self.file();
        let moved = |steps: &[(UndoStep, Job)]| -> Result<Vec<(UndoStep, Job)>, JobError> {
            steps.iter().map(|(step, job)| Ok((step.clone(), rebased(job, from, to)?))).collect()
        };
        let (undo, redo) = (moved(&self.undo)?, moved(&self.redo)?);
        let (job, file) = save(&self.job, self.file.as_ref(), to, if_changed)?;
        *self = Document { saved: job.clone(), job, file: Some(file), undo, redo, ..Document::default() };
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Order;
    use crate::pose::{Pin, Tilt};
    use proptest::prelude::*;

    fn some() -> impl Strategy<Value = Vec<SurfaceId>> {
        prop::collection::vec((1u32..9).prop_map(SurfaceId), 1..4)
    }

    fn edits() -> impl Strategy<Value = Edit> {
        prop_oneof![
            (1.0..40.0f64).prop_map(|v| Edit::Set("layers.spacing_mm", v)),
            some().prop_map(Edit::Clean),
            some().prop_map(Edit::Unclean),
            (some(), prop_oneof![Just(-1), Just(1)]).prop_map(|(l, by)| Edit::Shift(l, by)),
            (1u32..9).prop_map(|n| Edit::FlipSurface(SurfaceId(n))),
            Just(Edit::Order(Order::OneWay)),
            (1u32..9, "[a-z]{0,3}").prop_map(|(n, s)| Edit::Rename(SurfaceId(n), s)),
        ]
    }

    proptest! {
        #[test]
        fn undo_brings_back_every_state_and_redo_too(list in prop::collection::vec(edits(), 1..25)) {
            let mut doc = Document::default();
            let all: Vec<SurfaceId> = (1..9).map(SurfaceId).collect();
            let mut states = vec![doc.job().clone()];
            for e in &list {
                if doc.apply(e, &all, None) {
                    states.push(doc.job().clone());
                }
            }
            for s in states.iter().rev() {
                prop_assert_eq!(doc.job(), s);
                doc.undo();
            }
            for s in states.iter().skip(1) {
                doc.redo();
                prop_assert_eq!(doc.job(), s);
            }
        }
    }

    #[test]
    fn a_drag_is_one_step() {
        let mut doc = Document::default();
        for v in [1.0, 2.0, 3.0] {
            doc.apply(&Edit::Set("layers.spacing_mm", v), &[], Some("drag"));
        }
        assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(Edit::Set("layers.spacing_mm", 3.0))));
        doc.end_gesture();
        doc.apply(&Edit::Set("layers.spacing_mm", 4.0), &[], Some("drag"));
        doc.undo();
        assert_eq!(doc.job().layers.spacing_mm, 3.0);
        doc.undo();
        assert_eq!((doc.job().layers.spacing_mm, doc.is_dirty()), (0.5, false));
    }

    #[test]
    fn another_subject_within_a_drag_is_another_step() {
        let mut doc = Document::default();
        let pin = |at_mm| Pin { line: 0, at_mm, tilt: Tilt::default() };
        let edits = [
            Edit::Set("layers.spacing_mm", 1.0),
            Edit::Set("beam.power_w", 1.0),
            Edit::Pins(SurfaceId(1), vec![pin(1.0)]),
            Edit::Pins(SurfaceId(2), vec![pin(1.0)]),
            Edit::SurfaceCentre(SurfaceId(2), Some([1.0; 3])),
        ];
        for edit in &edits {
            assert!(doc.apply(edit, &[], Some("drag")));
        }
        for edit in edits.iter().rev() {
            assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(edit.clone())));
            doc.undo();
        }
        assert_eq!(*doc.job(), Job::default());
    }

    #[test]
    fn what_was_not_saved_is_one_step_over_the_file() {
        let mut unsaved = Job::default();
        unsaved.layers.spacing_mm = 7.0;
        let mut doc = Document::restored(Job::default(), None, unsaved.clone());
        assert_eq!((doc.job(), doc.is_dirty(), doc.undo_step()), (&unsaved, true, Some(&UndoStep::Restored)));
        doc.undo();
        assert_eq!((doc.job(), doc.is_dirty(), doc.undo_step()), (&Job::default(), false, None));
        let nothing = Document::restored(unsaved.clone(), None, unsaved);
        assert_eq!((nothing.is_dirty(), nothing.undo_step()), (false, None));
    }

    #[test]
    fn steps_follow_the_job_to_another_folder() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        std::fs::create_dir(path("jobs")).expect("makes");
        let mut job = Job::default();
        (job.part.file, job.part.sha256) = ("a.stl".into(), "ab".into());
        std::fs::write(path("a.toml"), crate::document::files::to_toml(&job).expect("text")).expect("writes");
        let (job, file) = crate::document::save::open(&path("a.toml")).expect("opens");
        let mut doc = Document::new(job, Some(file));
        for v in [1.0, 2.0] {
            doc.apply(&Edit::Set("layers.spacing_mm", v), &[], None);
        }
        doc.undo();
        doc.save(&path("jobs/b.toml"), IfChanged::Refuse).expect("saves");
        assert_eq!((doc.file(), doc.file_state()), (Some(path("jobs/b.toml").as_path()), FileState::AsOpened));
        let seen = |doc: &Document| (doc.job().part.file.clone(), doc.job().part.sha256.clone(), doc.is_dirty());
        let there = |dirty| ("../a.stl".to_owned(), "ab".to_owned(), dirty);
        assert_eq!(seen(&doc), there(false));
        doc.undo();
        assert_eq!(seen(&doc), there(true));
        doc.redo();
        assert_eq!(seen(&doc), there(false));
        doc.redo();
        assert_eq!((seen(&doc), doc.job().layers.spacing_mm), (there(true), 2.0));
    }

    #[test]
    fn order_of_work_moves_as_a_block() {
        let mut doc = Document::default();
        let mut order = |edit: Edit| {
            doc.apply(&edit, &[1, 2, 3, 4, 7].map(SurfaceId), None);
            doc.job().settings.choice()
        };
        let ids = |numbers: &[u32]| numbers.iter().copied().map(SurfaceId).collect::<Vec<_>>();
        order(Edit::Clean(ids(&[1, 2, 3, 4])));
        assert_eq!(order(Edit::Shift(ids(&[3, 4]), -1)), [1, 3, 4, 2].into());
        assert_eq!(order(Edit::Shift(ids(&[1, 2]), 1)), [3, 1, 4, 2].into());
        assert_eq!(order(Edit::Merge(ids(&[1, 4, 7]))), [3, 1, 2].into());
    }
}
