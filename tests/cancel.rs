//! Work that is cancelled ends soon, wherever it is: as a number of looks, not of seconds.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{Obstacle, Tool};
use clearbeam::document::segmented;
use clearbeam::part::file::PartFileError;
use clearbeam::part::{Placement, Source, Units, Weld};
use clearbeam::planning::export::{self, ExportError, ExportInput, ExportOf, ExportOptions};
use clearbeam::planning::{self, PlanCache, PlanError};
use clearbeam::pose::Correction;
use clearbeam::progress::Progress;
use clearbeam::sample::{solids, stl_bytes};
use clearbeam::text::program_comment;
use parts::{Case, block, cylinder, job, on, part, setup, surface_at};

/// Looks that work may still make after it was cancelled: none of them does more than test one pose.
const MOST_LOOKS: usize = 200_000;

/// The floor between fins, with a clamp above it.
fn finned(correction: Correction, with_head: bool) -> Case {
    let part = part(&solids::fin_row(3, 2.0, 4.0, 15.0, 12.0, 7.0));
    let mut job = job("x", 2.0);
    job.path.correction = correction;
    let surfaces = segmented(&part, &job);
    let job = on(job, &[surface_at(&part, &surfaces, [4.0, 6.0, 0.0])]);
    let mut setup = setup();
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("clamp.stl"), stl_bytes(&block([-3.0; 3], [3.0; 3]))).expect("written");
    let mut clamp = Obstacle::named("clamp.stl".into());
    clamp.position_mm = [4.0, 6.0, 40.0];
    clamp.load(Some(dir.path())).expect("an STL");
    setup.tool = Tool { head: with_head.then(|| cylinder(6.0).head).flatten(), clamps: vec![clamp], ..Tool::default() };
    Case { part, surfaces, job, setup }
}

/// Runs work that is cancelled earlier and later, up to where it is done before.
fn at_every_stage<V, E>(name: &str, is_cancelled: impl Fn(&E) -> bool, work: impl Fn(&Progress) -> Result<V, E>) {
    let mut last = 1;
    let mut cancelled = 0;
    loop {
        let progress = Progress::ending_after(last);
        match work(&progress) {
            Ok(_) if progress.looks() < last => break,
            Ok(_) => panic!("{name}: cancelled after {last} looks, and done"),
            Err(e) => assert!(is_cancelled(&e), "{name}: another error after {last} looks"),
        }
        let more = progress.looks() - last;
        assert!(more <= MOST_LOOKS, "{name}: cancelled after {last} looks, it looked {more} times more");
        cancelled += 1;
        last += 1 + 2 * last;
    }
    assert!(cancelled > 1, "{name}: cancelled {cancelled} times");
}

#[test]
fn planning_ends_wherever_it_is() {
    for (correction, with_head) in
        [(Correction::None, false), (Correction::SectionPlane, true), (Correction::Clearance, true)]
    {
        let case = finned(correction, with_head);
        let name = format!("{correction:?}");
        at_every_stage(
            &name,
            |e| *e == PlanError::Cancelled,
            |progress| case.plan_with(&PlanCache::default(), progress),
        );
    }
}

#[test]
fn a_part_is_not_built_to_its_end() {
    let source = Source::from_bytes(&stl_bytes(&solids::sphere(10.0, 200, 100))).expect("a readable part");
    at_every_stage(
        "a part",
        |why: &Option<PartFileError>| why.is_none(),
        |progress| {
            let built = source.part(Units::Mm, Weld::Exact, &Placement::default(), &[], progress);
            built.map_err(Some).and_then(|part| part.ok_or(None))
        },
    );
}

#[test]
fn dose_and_export_end_wherever_they_are() {
    let case = finned(Correction::SectionPlane, false);
    let plan = case.plan();
    let Case { part, surfaces, job, setup } = &case;
    at_every_stage(
        "dose",
        |e| *e == PlanError::Cancelled,
        |progress| planning::dose(part, surfaces, &plan, job, setup, progress),
    );
    let options = ExportOptions { dose: true, ..ExportOptions::default() };
    let input = ExportInput {
        job,
        part,
        surfaces,
        setup,
        plan: &plan,
        findings: &[],
        wording: program_comment,
        options,
        page: None,
    };
    let of = ExportOf { job: "part".into(), part: "part.stl".into() };
    at_every_stage("export", |e| matches!(e, ExportError::Cancelled), |progress| export::files(&input, &of, progress));
}
