//! The search for tilts in two degrees of freedom, on parts for which the free directions are known:
//! under a roof, between fins, where two roofs overlap, on the samples beside the section plane.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::Job;
use clearbeam::part::SurfaceId;
use clearbeam::path::Order;
use clearbeam::planning::report::Report;
use clearbeam::pose::clearance::free_set;
use clearbeam::pose::tilt::{Pin, Tilt, TiltSide};
use clearbeam::pose::{BeamInterference, Correction, Target, TargetState};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Point3, Vector3};
use parts::{Planned, block, job, on, part, planned, planned_at, sample, sheet};

const RATE: f64 = 5.0;

fn searched(direction: &str, spacing_mm: f64) -> Job {
    let mut job = job(direction, spacing_mm);
    job.path.correction = Correction::Clearance;
    job
}

/// A floor 20 mm long in y and blocks over it.
fn floor(blocks: &[([f64; 3], [f64; 3])]) -> Triangles {
    let mut out = sheet(&[[-10.0, 0.0], [10.3, 0.0]], 20.0);
    for (low, high) in blocks {
        out.extend(block(*low, *high));
    }
    out
}

/// A roof 5 mm over the floor, from x = −12 to 0.
fn roof() -> Triangles {
    floor(&[([-12.0, -1.0, 5.0], [0.0, 21.0, 6.0])])
}

fn at_floor(triangles: &Triangles, job: Job) -> Planned {
    planned_at(triangles, &[[9.0, 10.0, 0.0]], job)
}

fn lit(p: &Planned) -> impl Iterator<Item = &Target> {
    p.targets().filter(|t| t.state != TargetState::Blocked)
}

fn atan_deg(x: f64) -> f64 {
    libm::atan(x).to_degrees()
}

#[test]
fn between_fins_the_free_directions_are_those_of_the_closed_form() {
    let (wide, high) = (6.0, 8.0);
    let fins = floor(&[([-1.0, -40.0, 0.0], [0.0, 60.0, high]), ([wide, -40.0, 0.0], [wide + 1.0, 60.0, high])]);
    let part = part(&fins);
    let beam = BeamInterference::on(&part);
    let mut tried = 0;
    for x in [0.5, 2.0, 3.1, 5.3] {
        let set = free_set(&beam, &Point3::new(x, 10.2, 0.0), &Vector3::z(), &Vector3::y(), 45.0);
        assert_eq!(set.len(), 241);
        for d in set {
            // Where the beam is as high as the fins.
            let there = x + high * d.axis.x / d.axis.z;
            if there.abs() > 0.1 && (there - wide).abs() > 0.1 {
                assert_eq!(d.is_free, there > 0.0 && there < wide, "{x} {d:?}");
                tried += 1;
            }
        }
    }
    assert!(tried > 900, "{tried}");
}

#[test]
fn under_a_roof_the_beam_leans_out_by_the_least_that_is_free() {
    let mut job = searched("x", 1.0);
    job.path.max_step_mm = 1.0;
    let p = at_floor(&roof(), job.clone());
    // Away from the roof's ends lead and lag do not help: the way out is to lean.
    let inner = |t: &&Target| t.p.x < -0.1 && t.p.x > -4.5 && (t.p.y - 10.0).abs() < 3.0;
    let mut tried = 0;
    for t in p.targets().filter(inner) {
        assert_eq!(t.state, TargetState::Corrected, "{t:?}");
        let least = atan_deg(-t.p.x / 5.0);
        assert!(t.tilt_deg() > least && t.tilt_deg() < least + 3.0, "{} for {least}: {t:?}", t.tilt_deg());
        tried += 1;
    }
    assert!(tried > 16, "{tried}");
    assert!(p.report().max_tilt_rate_deg_per_mm <= RATE + 1e-6);
    assert!(p.plan.passes.iter().filter(|l| l.targets[0].p.x > -4.5).all(|l| l.splits.is_empty()));
    // Deeper than the greatest tilt reaches nothing is free.
    assert!(
        p.targets()
            .filter(|t| t.p.x < -5.1 && t.p.x > -6.9 && (t.p.y - 10.0).abs() < 3.0)
            .all(|t| t.state == TargetState::Blocked)
    );
    // Within the section plane none of it is free.
    job.path.correction = Correction::SectionPlane;
    let q = at_floor(&roof(), job);
    assert!(q.targets().filter(inner).all(|t| t.state == TargetState::Blocked));
    let report = p.report();
    let [own, other] = report.corrections.as_slice() else { panic!("both corrections are told") };
    assert_eq!((own.correction, other.correction), ("clearance", "section-plane"));
    assert!((own.blocked_mm - report.blocked_mm).abs() < 1e-9 && other.blocked_mm > own.blocked_mm + 20.0);
}

#[test]
fn a_roof_over_half_the_line_is_met_by_a_ramp() {
    let half = floor(&[([-12.0, 10.0, 5.0], [2.5, 31.0, 6.0])]);
    let p = at_floor(&half, searched("x", 1.0));
    let line = p.plan.passes.iter().find(|l| l.targets[0].p.x.abs() < 0.6).expect("a line");
    assert!(line.splits.is_empty() && line.targets.iter().all(|t| t.state != TargetState::Blocked));
    assert!(line.max_tilt_rate_deg_mm() <= RATE + 1e-6);
    // It rises as late as the rate allows, from nothing.
    let tilted = line.targets.iter().filter(|t| t.tilt_deg() > 0.5).map(|t| t.p.y).fold(f64::INFINITY, f64::min);
    assert!(tilted > 1.0 && tilted < 10.0, "{tilted}");
}

#[test]
fn where_the_two_sides_need_opposite_tilts_the_pass_is_split_and_the_wall_named() {
    let both = floor(&[([-12.0, -20.0, 5.0], [3.0, 10.0, 6.0]), ([-3.0, 10.0, 5.0], [12.0, 40.0, 6.0])]);
    let mut job = searched("x", 1.0);
    job.layers.order = Order::OneWay;
    let p = at_floor(&both, job);
    let roofs = [p.surface_at([0.0, 5.0, 5.0]), p.surface_at([0.0, 15.0, 5.0])];
    let mut tried = 0;
    for (number, line) in p.plan.passes.iter().enumerate().filter(|(_, l)| l.targets[0].p.x.abs() < 0.8) {
        assert!(line.targets.iter().all(|t| t.state != TargetState::Blocked));
        let [split] = line.splits.as_slice() else { panic!("{} splits", line.splits.len()) };
        let (before, behind) = (&line.targets[split.point - 1], &line.targets[split.point]);
        assert_eq!(before.p, behind.p);
        assert!(before.laser && !behind.laser && line.targets[split.point + 1].laser);
        assert!(before.a.x * behind.a.x < 0.0, "{before:?} {behind:?}");
        assert_eq!(line.lit_pieces().len(), 2);
        let report = p.report();
        let told = report.splits.iter().find(|s| s.pass == number).expect("told");
        assert!(told.point == split.point && told.by_surface.is_some_and(|s| roofs.contains(&s)), "{told:?}");
        tried += 1;
    }
    assert!(tried > 0);
    assert!(p.report().max_tilt_rate_deg_per_mm <= RATE + 1e-6);
    p.files();
}

#[test]
fn a_forbidden_side_is_not_taken() {
    let mut job = searched("x", 1.0);
    job.layers.order = Order::OneWay;
    let open = at_floor(&roof(), job.clone());
    let inner = |t: &&Target| t.p.x < -1.0 && t.p.x > -4.5 && (t.p.y - 10.0).abs() < 3.0;
    let side = open.targets().find(inner).map(|t| t.o.cross(&t.n).x).expect("a target");
    let (out, other) = if side > 0.0 { (TiltSide::Right, TiltSide::Left) } else { (TiltSide::Left, TiltSide::Right) };
    let surface = SurfaceId(open.plan.passes[0].surface);
    job.settings.change(surface, |s| s.tilt.forbidden = vec![other]);
    let p = at_floor(&roof(), job.clone());
    assert!(p.targets().filter(inner).all(|t| t.state == TargetState::Corrected && t.a.x > 0.0));
    job.settings.change(surface, |s| s.tilt.forbidden = vec![out]);
    let p = at_floor(&roof(), job);
    assert!(p.targets().filter(inner).all(|t| t.state == TargetState::Blocked));
    assert!(lit(&p).all(|t| t.a.x < libm::sin(1.01f64.to_radians())));
}

#[test]
fn the_least_tilt_is_kept_everywhere() {
    let mut job = searched("x", 1.0);
    let surface = SurfaceId(at_floor(&roof(), job.clone()).plan.passes[0].surface);
    job.settings.change(surface, |s| s.tilt.least_deg = 6.0);
    let p = at_floor(&roof(), job);
    assert!(lit(&p).all(|t| t.tilt_deg() > 6.0 - 1e-5 && t.tilt_deg() < 45.0 + 1e-5));
    // Where nothing is in the way it leads, and counts as free.
    let away: Vec<_> = p.targets().filter(|t| t.p.x > 1.0).collect();
    assert!(!away.is_empty());
    for t in away {
        assert!(t.state == TargetState::Free && (t.tilt_deg() - 6.0).abs() < 1e-6 && t.a.dot(&t.o) > -1e-9, "{t:?}");
        assert!((t.a.y.abs() - libm::sin(6f64.to_radians())).abs() < 1e-6);
    }
    assert!(p.report().max_tilt_rate_deg_per_mm <= RATE + 1e-6);
}

#[test]
fn a_pin_draws_the_beam() {
    let mut job = searched("x", 1.0);
    let plain = at_floor(&roof(), job.clone());
    let number = plain.plan.passes.iter().position(|l| l.targets[0].p.x > 4.0).expect("a line");
    let surface = SurfaceId(plain.plan.passes[0].surface);
    let tilt = Tilt { lead_deg: 5.0, lean_deg: 20.0 };
    job.settings.change(surface, |s| s.pins = vec![Pin { line: number as u32, at_mm: 10.0, tilt }]);
    let p = at_floor(&roof(), job);
    for (k, (line, before)) in p.plan.passes.iter().zip(&plain.plan.passes).enumerate() {
        if k != number {
            assert_eq!(line, before);
            continue;
        }
        let start = line.targets[0].p;
        for t in &line.targets {
            let off = ((t.p - start).norm() - 10.0).abs();
            if off < 0.5 {
                let found = Tilt::of(&t.a, &t.n, &t.o);
                assert!((found.vector() - tilt.vector()).norm() < 5.0 * (off + 0.1), "{found:?}");
            }
            assert!(off < 4.3 || t.tilt_deg() < 1e-6);
        }
        assert!(line.targets.iter().any(|t| t.tilt_deg() > 20.0));
        assert!(line.max_tilt_rate_deg_mm() <= RATE + 1e-6);
    }
}

#[test]
fn a_turned_part_gets_the_same_beams() {
    let turn = |p: [f64; 3]| {
        let (s, c) = (0.6, 0.8);
        [p[0] * c - p[1] * s + 7.0, p[0] * s + p[1] * c - 3.0, p[2] + 11.0]
    };
    let shallow = floor(&[([-12.0, -1.0, 5.0], [-6.0, 12.0, 6.0])]);
    let plain = at_floor(&shallow, searched("x", 1.0)).report();
    let turned: Triangles = shallow.into_iter().map(|t| t.map(turn)).collect();
    let turned = planned_at(&turned, &[turn([9.0, 10.0, 0.0])], searched("0.8,0.6,0", 1.0)).report();
    assert!((plain.blocked_mm - turned.blocked_mm).abs() < 0.3, "{} {}", plain.blocked_mm, turned.blocked_mm);
    assert!((plain.max_tilt_deg - turned.max_tilt_deg).abs() < 0.6);
    assert_eq!(plain.splits.len(), turned.splits.len());
}

/// The report of both corrections; the search blocks no more, and keeps to the rate.
fn compared(what: &str, p: &Planned) -> Report {
    let report = p.report();
    let [own, other] = report.corrections.as_slice() else { panic!("both corrections are told") };
    assert!(own.blocked_mm <= other.blocked_mm + 1e-6, "{what}: {} for {}", own.blocked_mm, other.blocked_mm);
    assert!(report.max_tilt_rate_deg_per_mm <= RATE + 1e-6, "{what}: {}", report.max_tilt_rate_deg_per_mm);
    report
}

/// Looks half a degree by half a degree for what the search may have missed.
fn nothing_is_free(what: &str, p: &Planned, stride: usize) {
    let beam = BeamInterference::on(&p.part);
    let blocked: Vec<&Target> = p.targets().filter(|t| t.state == TargetState::Blocked).collect();
    let steps = (2.0 * p.job.path.max_tilt_deg) as i32;
    for t in blocked.iter().step_by(stride) {
        for i in -steps..=steps {
            for j in -steps..=steps {
                let tilt = Tilt { lead_deg: 0.5 * f64::from(i), lean_deg: 0.5 * f64::from(j) };
                if tilt.angle_deg() <= p.job.path.max_tilt_deg {
                    let a = tilt.axis(&t.n, &t.o);
                    assert!(!beam.is_free(&t.p, &a), "{what}: {tilt:?} is free at {t:?}");
                }
            }
        }
    }
}

#[test]
fn no_sample_has_more_blocked_than_by_the_section_plane() {
    for half_angle in [20.0, 30.0, 40.0] {
        for max_tilt_deg in [45.0, 75.0] {
            let mut job = searched("y", 4.0);
            job.path.max_tilt_deg = max_tilt_deg;
            let p = planned(part(&solids::v_groove(half_angle, 8.0, 6.0, 40.0)), job);
            let what = format!("groove of {half_angle}°, tilts to {max_tilt_deg}°");
            let report = compared(&what, &p);
            assert!(max_tilt_deg < 75.0 || report.blocked_mm < 1e-9, "{what}: {}", report.blocked_mm);
            nothing_is_free(&what, &p, 17);
        }
    }
    let p = planned(part(&sample("workpiece")), searched("z", 5.0));
    compared("workpiece", &p);
    nothing_is_free("workpiece", &p, 5);
    let mut job = on(searched("z", 2.5), &[1, 7, 12, 40]);
    job.beam.defocus_mm = 3.0;
    let p = planned(part(&sample("worm_gear")), job);
    compared("worm gear", &p);
    nothing_is_free("worm gear", &p, 40);
}

#[test]
fn a_closed_line_begins_and_ends_with_the_same_beam() {
    // A ring around a cylinder under a brim that hides it all round: its normals are free nowhere.
    let mut cup = solids::cylinder(10.0, 4.0, 90);
    for k in 0..90 {
        let at = |k: usize, r: f64, z: f64| {
            let a = k as f64 / 90.0 * std::f64::consts::TAU;
            [r * libm::cos(a), r * libm::sin(a), z]
        };
        let [a, b, c, d] = [at(k, 14.0, -1.0), at(k + 1, 14.0, -1.0), at(k + 1, 14.0, 3.0), at(k, 14.0, 3.0)];
        cup.extend([[a, b, c], [a, c, d]]);
    }
    let p = planned_at(&cup, &[[-10.0, 0.0, 2.0]], searched("z", 1.0));
    let mut tried = 0;
    for pass in p.plan.passes.iter().filter(|l| l.closed) {
        let (first, last) = (&pass.targets[0], &pass.targets[pass.targets.len() - 1]);
        assert!(first.p == last.p && first.a == last.a && first.state == last.state);
        let blocked = pass.targets.iter().find(|t| t.state == TargetState::Blocked);
        assert!(blocked.is_none(), "{blocked:?}");
        tried += usize::from(first.state == TargetState::Corrected);
    }
    assert!(tried > 0);
    assert!(p.report().max_tilt_rate_deg_per_mm <= RATE + 1e-6);
}
