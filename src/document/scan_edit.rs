//! Changes of the scan of a job, each an [`Edit`](super::Edit) of its own.

use super::model::{
    ContinuedDamage, JobScan, PatchChoice, PickedPair, ScanFile, ScanLines, ScanRegion, ScanTogether, ScanWork,
};
use crate::cell::{Frame, Mount};
use crate::part::Units;
use crate::scan::cleaning::Step;

/// A change of the scan.
#[derive(Clone, Debug, PartialEq)]
pub enum ScanEdit {
    /// Other files, or another unit for them; without files the scan is gone. Where the frame of the scan is another then,
    /// what was found in it, transform and pairs, goes; cleaning steps, regions and choice stay for the next scan.
    Files(Vec<ScanFile>, Units),
    /// The part's own file as its scan, with `model_from_scan` row by row: there is no other model, so lines go through
    /// its points, and the job's surfaces are worked.
    OwnScan(ScanFile, [f64; 16]),
    /// A cleaning step behind the others.
    AddStep(Step),
    /// A cleaning step goes; from 0.
    RemoveStep(usize),
    /// Another cleaning step in the place of one; from 0.
    AlterStep(usize, Step),
    /// `model_from_scan` row by row; `None`: it is to be looked for.
    Transform(Option<[f64; 16]>),
    /// Picked pairs, in place of those there were; a position that was kept goes, so that they count.
    Pairs(Vec<PickedPair>),
    /// Damage across which sound regions are continued, in place of what there was.
    Continued(Vec<ContinuedDamage>),
    /// Regions left out, in place of those there were.
    LeftOut(Vec<ScanRegion>),
    /// The patches that are worked.
    Patches(PatchChoice),
    /// How several files come together.
    Together(ScanTogether),
    /// What is worked.
    Work(ScanWork),
    /// What lines are laid on.
    Lines(ScanLines),
    /// Where the scanner's frame stands in that of what carries the part; `None`: nobody knows.
    Scanner(Mount, Option<Frame>),
}

impl ScanEdit {
    /// Whether two of them change the same thing, so that they are one step within one drag.
    pub(super) fn goes_on_from(&self, earlier: &ScanEdit) -> bool {
        let place = |edit: &ScanEdit| match edit {
            ScanEdit::RemoveStep(at) | ScanEdit::AlterStep(at, _) => Some(*at),
            _ => None,
        };
        std::mem::discriminant(self) == std::mem::discriminant(earlier) && place(self) == place(earlier)
    }

    /// Applies it. Places that do not exist are passed over.
    pub(super) fn apply(&self, scan: &mut JobScan) {
        match self {
            ScanEdit::Files(files, units) => {
                if scan.files.first() != files.first() || scan.units != *units {
                    scan.transform = None;
                    scan.pairs.clear();
                }
                scan.files.clone_from(files);
                scan.units = *units;
            }
            ScanEdit::OwnScan(file, transform) => {
                scan.files = vec![file.clone()];
                scan.transform = Some(*transform);
                (scan.lines, scan.work) = (ScanLines::Points, ScanWork::Surfaces);
                scan.pairs.clear();
            }
            ScanEdit::AddStep(step) => scan.steps.push(step.clone()),
            ScanEdit::RemoveStep(at) => {
                if *at < scan.steps.len() {
                    scan.steps.remove(*at);
                }
            }
            ScanEdit::AlterStep(at, step) => {
                if let Some(old) = scan.steps.get_mut(*at) {
                    old.clone_from(step);
                }
            }
            ScanEdit::Transform(transform) => scan.transform = *transform,
            ScanEdit::Pairs(pairs) => {
                scan.pairs.clone_from(pairs);
                scan.transform = None;
            }
            ScanEdit::Continued(damage) => scan.continued.clone_from(damage),
            ScanEdit::LeftOut(regions) => scan.left_out.clone_from(regions),
            ScanEdit::Patches(choice) => scan.patches.clone_from(choice),
            ScanEdit::Together(together) => scan.together = *together,
            ScanEdit::Work(work) => scan.work = *work,
            ScanEdit::Lines(lines) => scan.lines = *lines,
            ScanEdit::Scanner(Mount::ToolInHand, frame) => scan.base_from_scan.clone_from(frame),
            ScanEdit::Scanner(Mount::PartInHand, frame) => scan.flange_from_scan.clone_from(frame),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::model::ContinuedKind;
    use crate::document::{Document, Edit, IfChanged, Job, UndoStep, job_file, save};

    fn step(voxel_mm: f64) -> Step {
        Step::Thin { voxel_mm }
    }

    fn file(name: &str) -> ScanFile {
        ScanFile { file: name.into(), sha256: "ab".into() }
    }

    /// A document after these edits, each a step of its own.
    fn after(edits: &[ScanEdit]) -> Document {
        let mut doc = Document::default();
        for edit in edits {
            doc.apply(&Edit::Scan(Box::new(edit.clone())), &[], None);
        }
        doc
    }

    const ONE: [f64; 16] = [0.0, -1.0, 0.0, 5.0, 1.0, 0.0, 0.0, 6.0, 0.0, 0.0, 1.0, 7.0, 0.0, 0.0, 0.0, 1.0];

    fn all_kinds() -> Vec<ScanEdit> {
        let region = ScanRegion::Box { min_mm: [0.0; 3], max_mm: [1.0, 2.0, 3.0] };
        let erase = Step::Erase { centres: vec![[1.0, 2.0, 3.0]], radius_mm: 2.0 };
        vec![
            ScanEdit::Files(vec![file("worn.e57"), file("more.e57")], Units::M),
            ScanEdit::OwnScan(file("alone.e57"), ONE),
            ScanEdit::Files(vec![file("worn.e57"), file("more.e57")], Units::M),
            ScanEdit::AddStep(Step::OUTLIERS),
            ScanEdit::AddStep(step(0.5)),
            ScanEdit::AddStep(erase),
            ScanEdit::AlterStep(1, step(0.25)),
            ScanEdit::RemoveStep(0),
            ScanEdit::Pairs(vec![PickedPair { model_mm: [1.0; 3], scan_mm: [2.0; 3] }]),
            ScanEdit::Transform(Some(ONE)),
            ScanEdit::Continued(vec![ContinuedDamage {
                by: ContinuedKind::Revolved,
                damaged: vec![region],
                sound: vec![region, region],
            }]),
            ScanEdit::LeftOut(vec![region, ScanRegion::Sphere { centre_mm: [9.0; 3], radius_mm: 4.0 }]),
            ScanEdit::Patches(PatchChoice::At(vec![[1.0, 2.0, 3.0]])),
            ScanEdit::Together(ScanTogether::Overlap),
            ScanEdit::Work(ScanWork::Patches),
            ScanEdit::Lines(ScanLines::Facets),
            ScanEdit::Scanner(Mount::ToolInHand, Some(Frame::new([800.0, 0.0, 300.0], [90.0, 0.0, 180.0]))),
            ScanEdit::Scanner(Mount::PartInHand, Some(Frame::new([0.0, 0.0, 80.0], [0.0, 90.0, 0.0]))),
        ]
    }

    #[test]
    fn every_change_is_a_step_of_undo_and_stands_in_the_file() {
        let edits = all_kinds();
        let mut doc = after(&edits);
        assert_eq!(doc.job().scan.steps.len(), 2);
        assert_eq!(doc.job().scan.steps[0], step(0.25));
        let folder = tempfile::tempdir().expect("a folder");
        doc.save(&folder.path().join("a.toml"), IfChanged::Refuse).expect("saves");
        assert_eq!(save::read(&folder.path().join("a.toml")).expect("reads"), *doc.job());
        for edit in edits.iter().rev() {
            assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(Edit::Scan(Box::new(edit.clone())))));
            doc.undo();
        }
        assert_eq!(doc.job().scan, JobScan::default());
    }

    #[test]
    fn what_was_found_in_another_frame_goes_with_it() {
        let found = |files: Vec<ScanFile>, units| {
            let mut edits = all_kinds();
            edits.push(ScanEdit::Files(files, units));
            let doc = after(&edits);
            let scan = &doc.job().scan;
            assert_eq!((scan.steps.len(), scan.left_out.len(), scan.base_from_scan.is_some()), (2, 2, true));
            (scan.transform.is_some(), scan.pairs.len())
        };
        // The first file's frame is the scan's: others may come and go.
        assert_eq!(found(vec![file("worn.e57")], Units::M), (true, 1));
        assert_eq!(found(vec![file("worn.e57")], Units::Mm), (false, 0));
        assert_eq!(found(vec![file("more.e57")], Units::M), (false, 0));
        assert!(!after(&[ScanEdit::Files(Vec::new(), Units::Mm)]).job().scan.is_there());
    }

    #[test]
    fn steps_that_are_not_there_change_nothing_and_a_drag_of_one_is_one() {
        let none = after(&[ScanEdit::RemoveStep(0), ScanEdit::AlterStep(3, step(1.0))]);
        assert_eq!((none.job(), none.undo_step()), (&Job::default(), None));
        let mut doc = after(&[ScanEdit::AddStep(step(1.0)), ScanEdit::AddStep(step(1.0))]);
        let mut drag = |at, voxel_mm| {
            doc.apply(&Edit::Scan(Box::new(ScanEdit::AlterStep(at, step(voxel_mm)))), &[], Some("drag"));
        };
        drag(0, 2.0);
        drag(0, 3.0);
        drag(1, 4.0);
        doc.undo();
        assert_eq!(doc.job().scan.steps, [step(3.0), step(1.0)]);
        doc.undo();
        assert_eq!(doc.job().scan.steps, [step(1.0), step(1.0)]);
    }

    #[test]
    fn a_file_without_the_table_has_no_scan_and_paths_follow_the_job() {
        let job = job_file::parse("version = 2\n[layers]\nspacing_mm = 1").expect("reads");
        assert_eq!(job.scan, JobScan::default());
        assert!(!job.scan.is_there());
        let text = "[scan]\nunits = \"m\"\n[[scan.files]]\nfile = \"../scans/a.e57\"\n";
        let job = job_file::parse(text).expect("reads");
        let (from, to) = (std::path::Path::new("/x/jobs/a.toml"), std::path::Path::new("/x/out/b/job.toml"));
        let moved = crate::document::files::rebased(&job, Some(from), to).expect("rebases");
        assert_eq!(moved.scan.files[0].file, "../../scans/a.e57");
    }
}
