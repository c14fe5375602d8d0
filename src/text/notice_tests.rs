//! The findings of a plan as people read them: the worst first, each with its number, its surface and what helps.

use super::{Naming, notice_line};
use crate::cell::Setup;
use crate::cell::motion::{RefusalCause, RefusalReason};
use crate::document::{Chosen, Job, segmented};
use crate::part::{Part, PartFinding, Placement, SurfaceId, Units};
use crate::planning::remark::{Remark, ToolpathRemark};
use crate::planning::report::{NotDone, Notice, PlanFinding, Problem, Report, Unproven, notices_worst_first};
use crate::planning::{PlanCache, plan};
use crate::pose::{Correction, ToolBody};
use crate::program::OffSpeed;
use crate::progress::Progress;
use crate::sample::{solids, stl_bytes};

/// The report of a cube whose top and bottom lie in the planes, and its job, in which surface 3 has a name.
fn cube() -> (Report, Job) {
    let part = Part::from_bytes(&stl_bytes(&solids::cube(20.0)), Units::Mm, &Placement::default(), &[]).expect("ok");
    let mut job = Job::default();
    job.settings.choose(Chosen::All);
    job.layers.direction = "z".parse().expect("a direction");
    job.layers.spacing_mm = 2.0;
    job.path.correction = Correction::SectionPlane;
    job.settings.change(SurfaceId(3), |s| s.name = "Rim".into());
    let (surfaces, setup) = (segmented(&part, &job), Setup::shipped().expect("shipped"));
    let plan = plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()).expect("a plan");
    (Report::new(&plan, &surfaces), job)
}

fn blocked(point: usize, cause: RefusalCause, by_surface: Option<u32>) -> Problem {
    let why = by_surface.is_none().then(|| RefusalReason::OutOfReach { robot: "MZ04".into() });
    let cause = NotDone::Blocked(cause);
    Problem { pass: Some(4), point: Some(point), surface: 3, cause, by_facet: None, by_surface, why }
}

#[test]
fn what_is_unsafe_stands_before_what_is_not_done_and_what_was_found() {
    let (mut report, job) = cube();
    report.surfaces[2].remarks.push(Remark::Toolpath(ToolpathRemark::StopsAtRim { ends: 1 }));
    let rim = Some(SurfaceId(3));
    report.unproven.push(Unproven { tool_body: ToolBody::Head, surface: rim, moves: 1200 });
    let (was, is) = ("a".into(), "b".into());
    report.findings.push(PlanFinding::PartChanged { was, is, kept: vec![[1, 1], [2, 5]], lost: vec![3] });
    let off = OffSpeed { surface: 3, moves: 12, wanted_mm_s: 3.0, possible_mm_s: 2.25, pass: 4, point: 17 };
    report.findings.push(PlanFinding::SlowMove(off));
    report.problems.extend([
        blocked(0, RefusalCause::Reach, None),
        blocked(1, RefusalCause::Beam, Some(5)),
        blocked(2, RefusalCause::Reach, None),
    ]);
    let notices = notices_worst_first(&report, &job, &[PartFinding::OpenEdges { count: 7 }]);
    assert!(notices.is_sorted_by_key(Notice::severity));
    let naming = Naming::of(&job);
    let lines: Vec<String> = notices.iter().map(|n| notice_line(n, &naming)).collect();
    let begins = [
        "1 200 lit moves are not proven: the head would hit surface 3 \"Rim\"; do not run the program",
        "surface 1: no line on its 400.00 mm²: the section planes lie along it",
        "surface 2: no line on its 400.00 mm²: the section planes lie along it",
        "surface 3 \"Rim\": 2 targets refused: out of the robot's reach; such as pass 4, point 0: ",
        "surface 3 \"Rim\": 1 target blocked by surface 5; choose the correction clearance",
        "surface 3 \"Rim\": on 12 lit moves the spot is slower than the 3 mm/s that are set, so it works there for longer: \
         the controller's words allow 2.25 mm/s at pass 4, point 17; set a lower speed, or choose",
        "surface 3 \"Rim\": 1 line end stops at the rim",
        "the part's file has changed since the job was saved; all that is to be cleaned was found again; \
         surface 2 is 5 now; not found: surface 3",
        "7 open edges",
    ];
    assert_eq!(lines.len(), begins.len(), "{lines:#?}");
    for (line, begin) in lines.iter().zip(begins) {
        assert!(line.starts_with(begin), "{line}\n{begin}");
    }
    let part_missed = Notice::Missed { surface: SurfaceId(1), missed_mm2: 40.0, area_mm2: 400.0, by_planes: true };
    let told = "surface 1: 40.00 of 400.00 mm² missed by the planes; try direction auto";
    assert_eq!(notice_line(&part_missed, &naming), told);
    assert!(lines[3].ends_with("; move the part nearer to the middle of the robot's reach"), "{}", lines[3]);
}

#[test]
fn remarks_are_codes_and_figures_in_the_report() {
    let remarks = [
        Remark::Toolpath(ToolpathRemark::LayersAlike),
        Remark::Toolpath(ToolpathRemark::TooShort { pieces: 2, length_mm: 1.5, shortest_mm: 1.0 }),
        Remark::Toolpath(ToolpathRemark::Lines(crate::path::LinesFinding::NoBorder { surface: 4 })),
    ];
    let json = serde_json::to_value(remarks).expect("JSON");
    let told = serde_json::json!([
        { "code": "layers_alike" },
        { "code": "too_short", "pieces": 2, "length_mm": 1.5, "shortest_mm": 1.0 },
        { "code": "no_border", "surface": 4 },
    ]);
    assert_eq!(json, told);
}
