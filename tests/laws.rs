//! Laws that hold for every part: motion, scale, and the order of facets and corners change nothing
//! but the frame; sums of the report; the same bytes from every run; the laser and the axes of each
//! row of `path.csv`.
//!
//! Sizes are such that no length is a whole number of gaps: there the last bit decides whether a
//! dense line gets one point more, and two tests at the end say whether that shows.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::{Job, segmented};
use clearbeam::part::Placement;
use clearbeam::path::Direction;
use clearbeam::planning::PlanCache;
use clearbeam::pose::{Correction, TargetState};
use clearbeam::progress::Progress;
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Point3, Vector3};
use parts::{Planned, angle_deg, job, near, on, part, placed, planned, planned_at, sample, sheet};
use proptest::prelude::*;

fn cases(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn step() -> Triangles {
    sheet(&[[-3.0, 10.7], [0.0, 10.7], [0.0, 0.0], [11.3, 0.0]], 20.37)
}

/// Parts, a point on each surface to clean, and the direction of their planes; all lines are open.
fn open_lines() -> Vec<(Triangles, Vec<[f64; 3]>, &'static str)> {
    vec![
        (solids::v_groove(30.0, 8.0, 6.1, 21.3), vec![[-2.0, 10.0, -4.5358984], [-8.0, 10.0, 0.0]], "y"),
        (step(), vec![[5.0, 10.0, 0.0], [0.0, 10.0, 5.0]], "y"),
        (step(), vec![[5.0, 10.0, 0.0], [0.0, 10.0, 5.0]], "auto"),
        (solids::cube(10.0), vec![[5.0, 0.0, 5.0], [5.0, 5.0, 10.0]], "1,0.3,-0.2"),
    ]
}

/// The same plan, `onto` the other's frame.
fn same(
    a: &Planned,
    b: &Planned,
    onto: impl Fn(&Point3<f64>) -> Point3<f64>,
    turn: impl Fn(&Vector3<f64>) -> Vector3<f64>,
) {
    assert_eq!(a.plan.passes.len(), b.plan.passes.len());
    for (p, q) in a.plan.passes.iter().zip(&b.plan.passes) {
        assert_eq!((p.closed, p.targets.len()), (q.closed, q.targets.len()));
        for (t, u) in p.targets.iter().zip(&q.targets) {
            assert!((onto(&t.p) - u.p).norm() < 1e-6, "{t:?}\n{u:?}");
            assert_eq!((t.state, t.laser, t.normal_hits.is_some()), (u.state, u.laser, u.normal_hits.is_some()));
            // Turned beams are found to 0.02°.
            assert!(angle_deg(&turn(&t.n), &u.n) < 1e-4 && angle_deg(&turn(&t.a), &u.a) < 0.025, "{t:?}\n{u:?}");
        }
    }
}

/// A sheet with both its sides in the file: each is planned as if the other were not there. In the section plane alone it
/// is so but for the foot of a wall, where the wall's other side blocks a target that would else be tilted.
#[test]
fn the_other_side_of_a_sheet_changes_nothing_on_this_one() {
    let front = step();
    let back: Triangles = front.iter().map(|&[a, b, c]| [b, a, c]).collect();
    let both: Triangles = front.iter().chain(&back).copied().collect();
    let all = segmented(&part(&both), &Job::default());
    let sizes: Vec<usize> = all.list.iter().map(|s| s.facets.len()).collect();
    assert_eq!(sizes, [2; 6], "three faces on either side");
    for correction in [Correction::None, Correction::Clearance] {
        let mut wanted = job("y", 3.1);
        wanted.path.correction = correction;
        for (alone, numbers) in [(&front, [1, 2, 3]), (&back, [4, 5, 6])] {
            let (alone, beside) =
                (planned(part(alone), wanted.clone()), planned(part(&both), on(wanted.clone(), &numbers)));
            same(&alone, &beside, |p| *p, |v| *v);
            assert!(alone.targets().any(|t| t.laser));
        }
    }
}

/// Plans a part as it is and moved, planes moved with it; `auto` moves them by itself. Moves are proven as their program is written, and what is
/// rounded there belongs to a frame: here it is written with all its digits.
fn moved_alike(triangles: &Triangles, on_surfaces: &[[f64; 3]], mut job: Job, rotation_deg: [f64; 3], shift: [f64; 3]) {
    job.cell.dialect = "csv".into();
    let still = planned_at(triangles, on_surfaces, job.clone());
    let placement = Placement { scale: 1.0, rotation_deg, translation_mm: shift };
    let motion = placement.isometry();
    match job.layers.direction {
        Direction::Along(d) => {
            job.layers.direction = Direction::Along((motion.rotation * Vector3::from(d)).into());
        }
        Direction::Auto => job.part.placement = placement,
    }
    job.settings.choose(still.job.settings.choice());
    let moved = planned(placed(triangles, &placement), job);
    same(&still, &moved, |p| motion * p, |v| motion.rotation * v);
}

proptest! {
    #![proptest_config(cases(12))]
    #[test]
    fn a_rigid_motion_changes_nothing_but_the_frame(r in prop::array::uniform3(-180.0..180.0f64),
                                                    t in prop::array::uniform3(-60.0..60.0f64)) {
        for (triangles, points, direction) in open_lines() {
            moved_alike(&triangles, &points, job(direction, 0.83), r, t);
        }
    }

    #[test]
    fn scale_changes_nothing_but_the_size(scale in 0.3..1.19f64) {
        // Convex parts: the width of a beam that grazes does not scale.
        for (triangles, points) in [(solids::cube(10.0), [5.0, 0.0, 5.0]), (solids::cylinder(5.0, 7.0, 40), [5.0, 0.0, 3.0])] {
            let mut job = job("0.1,0.2,1", 0.83);
            let still = planned_at(&triangles, &[points], job.clone());
            job.part.placement.scale = scale;
            job.layers.spacing_mm *= scale;
            job.path.chord_error_mm *= scale;
            job.path.max_step_mm *= scale;
            job.settings.choose(still.job.settings.choice());
            let scaled = planned(placed(&triangles, &job.part.placement), job);
            same(&still, &scaled, |p| p * scale, |v| *v);
            near("length", scaled.report().work_mm, scale * still.report().work_mm, 1e-6);
            near("area", scaled.report().surfaces[0].area_mm2, scale * scale * still.report().surfaces[0].area_mm2, 1e-6);
        }
    }

    #[test]
    fn the_order_of_facets_and_corners_changes_nothing(seed in any::<u64>()) {
        let hole = solids::blind_hole(30.0, 5.0, 12.0, 24);
        let torus = solids::torus(9.0, 3.0, 40, 24);
        let mut all = open_lines();
        all.push((hole, vec![[0.0, 0.0, -12.0], [15.0, 0.0, -15.0]], "0.1,1,0.3"));
        all.push((torus, vec![[12.0, 0.0, 0.0]], "z"));
        for (triangles, points, direction) in all {
            let mut state = seed | 1;
            let mut random = |below: usize| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 33) as usize % below
            };
            let mut mixed = triangles.clone();
            for i in (1..mixed.len()).rev() {
                mixed.swap(i, random(i + 1));
            }
            mixed.iter_mut().for_each(|t| t.rotate_left(random(3)));
            same(&planned_at(&triangles, &points, job(direction, 0.83)),
                 &planned_at(&mixed, &points, job(direction, 0.83)), |p| *p, |v| *v);
        }
    }
}

fn various() -> Vec<Planned> {
    let workpiece = || part(&sample("workpiece"));
    let none = Job {
        path: clearbeam::document::model::PathParameters { correction: Correction::None, ..Default::default() },
        ..job("z", 2.6)
    };
    vec![
        planned(workpiece(), on(job("z", 2.6), &[2, 1, 4, 6])),
        planned(workpiece(), on(none, &[2, 1])),
        planned(part(&solids::fin_row(3, 2.0, 4.0, 15.0, 20.0, 7.0)), job("y", 2.7)),
        planned(part(&solids::v_groove(25.0, 8.0, 6.0, 20.0)), job("y", 1.7)),
        planned(part(&solids::torus(9.0, 3.0, 40, 24)), job("x", 1.1)),
    ]
}

#[test]
fn the_report_adds_up() {
    for p in various() {
        let r = p.report();
        let rows = |s: TargetState| p.targets().filter(|t| t.state == s).count();
        assert_eq!((r.corrected, r.blocked), (rows(TargetState::Corrected), rows(TargetState::Blocked)));
        assert_eq!(r.points, rows(TargetState::Free) + r.corrected + r.blocked);
        assert_eq!(r.passes, p.plan.passes.len());
        assert_eq!(r.interfering, p.targets().filter(|t| t.normal_hits.is_some()).count());
        let whole: f64 = p.plan.passes.iter().map(|l| l.length_mm(|_, _| true)).sum();
        near("work and blocked", r.work_mm + r.blocked_mm, whole, 1e-12);
        assert!(r.corrected_mm <= r.work_mm);
        let sum = |f: fn(&clearbeam::planning::report::SurfaceReport) -> f64| r.surfaces.iter().map(f).sum::<f64>();
        near("points", sum(|s| s.points as f64), r.points as f64, 0.0);
        near("passes", sum(|s| s.passes as f64), r.passes as f64, 0.0);
        near("work", sum(|s| s.work_mm), r.work_mm, 1e-12);
        near("corrected", sum(|s| s.corrected_mm), r.corrected_mm, 1e-12);
        near("blocked", sum(|s| s.blocked_mm), r.blocked_mm, 1e-12);
        near("missed", sum(|s| s.missed_area_mm2), r.missed_area_mm2, 1e-12);
        assert_eq!(r.problems.iter().filter(|q| q.cause.word() == "beam").count(), r.blocked);
        let missed = r.surfaces.iter().filter(|s| s.missed_area_mm2 > 0.0).count();
        assert_eq!(r.problems.iter().filter(|q| q.cause.word() == "missed").count(), missed);
    }
}

#[test]
fn every_run_writes_the_same_bytes() {
    let made = || {
        let job = on(job("z", 2.6), &[2, 1]);
        let p = planned(part(&sample("workpiece")), job);
        p.files().into_iter().map(|f| (f.name, f.bytes)).collect::<Vec<_>>()
    };
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().expect("a pool");
    let one = pool(1).install(made);
    assert_eq!(one.len(), 4);
    assert!(one == pool(2).install(made) && one == made());
}

#[test]
fn a_plan_from_the_cache_is_the_plan() {
    let part = part(&sample("workpiece"));
    let job = on(job("z", 2.6), &[2, 4]);
    let surfaces = segmented(&part, &job);
    let (cache, progress, setup) = (PlanCache::default(), Progress::default(), parts::setup());
    let plan = |job: &Job| clearbeam::planning::plan(&part, &surfaces, job, &setup, &cache, &progress).expect("a plan");
    let first = plan(&job);
    let mut finer = job.clone();
    finer.path.max_step_mm = 1.0;
    assert!(plan(&finer).passes != first.passes && plan(&job).passes == first.passes);
    finer.beam.defocus_mm = 3.0;
    finer.path.max_step_mm = job.path.max_step_mm;
    let nearer = plan(&finer);
    let targets =
        |plan: &clearbeam::planning::Plan| plan.passes.iter().flat_map(|p| p.targets.clone()).collect::<Vec<_>>();
    assert!(targets(&nearer) == targets(&first) && nearer.steps != first.steps, "D moves the focus alone");
    assert!(nearer.passes.iter().all(|p| p.settings.defocus_mm == 3.0));
}

#[test]
fn rows_keep_the_rules_of_path_csv() {
    for p in various() {
        let file = p.files().into_iter().find(|f| f.name == "path.csv").expect("path.csv");
        let text = String::from_utf8(file.bytes).expect("text");
        let (mut lines, d) = (text.lines(), p.job.beam.defocus_mm);
        assert_eq!(
            lines.next(),
            Some("pass,point,surface,laser,state,px,py,pz,nx,ny,nz,ax,ay,az,ox,oy,oz,x,y,z,tilt_deg,clearance_mm")
        );
        let mut before: Option<(usize, usize, bool)> = None;
        let mut count = 0;
        for line in lines {
            let field: Vec<&str> = line.split(',').collect();
            let v = |k: usize| Vector3::from_fn(|i, _| field[k + i].parse::<f64>().expect("a number"));
            let (pass, point): (usize, usize) = (field[0].parse().expect("pass"), field[1].parse().expect("point"));
            let blocked = field[4] == "blocked";
            let follows = before.filter(|b| b.0 == pass);
            assert_eq!(point, follows.map_or(0, |b| b.1 + 1), "{line}");
            assert_eq!(pass, before.map_or(0, |b| b.0 + usize::from(point == 0)), "{line}");
            assert_eq!(field[3] == "1", !blocked && follows.is_some_and(|b| !b.2), "{line}");
            let (p, n, a, o, x) = (v(5), v(8), v(11), v(14), v(17));
            assert!([n, a, o].iter().all(|u| (u.norm() - 1.0).abs() < 1e-9) && a.dot(&o).abs() < 1e-9, "{line}");
            assert!((p + a * d - x).norm() < 1e-9, "{line}");
            assert!((field[20].parse::<f64>().expect("tilt") - angle_deg(&n, &a)).abs() < 1e-6, "{line}");
            assert_eq!(field[4] == "corrected", a != n, "{line}");
            assert_eq!((field.len(), field[21]), (22, ""), "{line}");
            before = Some((pass, point, blocked));
            count += 1;
        }
        assert_eq!(count, p.report().points);
    }
}

/// Planes askew to a groove: a free point whose projected beam is not joins the run, and may need no
/// turn. Then it is free, not corrected by 0°, whatever the last bit of its normal says.
#[test]
fn a_corrected_beam_differs_from_the_normal() {
    let groove = solids::v_groove(30.0, 8.0, 6.1, 21.3);
    let p = planned_at(&groove, &[[-2.0, 10.0, -4.5358984]], job("0.1,1,0.2", 0.83));
    for t in p.targets().filter(|t| t.state == TargetState::Corrected) {
        assert!(angle_deg(&t.a, &t.n) > 1e-6, "corrected by nothing: {t:?}");
    }
}

/// A 10 mm cube at the default spacing: gaps of 0.25 mm go into 10 mm a whole number of times.
#[test]
fn whole_numbers_of_gaps_survive_a_motion() {
    for r in [[10.0, 20.0, 30.0], [70.0, -50.0, 130.0], [3.0, 1.0, 2.0]] {
        moved_alike(&solids::cube(10.0), &[[5.0, 0.0, 5.0]], job("z", 0.5), r, [0.1, 0.2, 0.3]);
    }
}
