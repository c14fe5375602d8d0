//! Where the corrected beams go, on parts for which that is known in closed form: to O in a V-groove
//! and between gear teeth, away from the wall of a 90° step; along a wall and beside a ring.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::FirstPlane;
use clearbeam::path::DensePoint;
use clearbeam::pose::interference::GRAZE_MM;
use clearbeam::pose::section_plane::correct;
use clearbeam::pose::{BeamInterference, Target, TargetState};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Point3, Vector3};
use parts::{Planned, angle_deg, block, job, near, on, part, planned, planned_at, sample, sheet};

/// Both flanks as one line without the root, each point with its flank's normal.
fn flanks(half_angle: f64, depth: f64, step: f64, y: f64) -> Vec<DensePoint> {
    let (s, c) = (libm::sin(half_angle.to_radians()), libm::cos(half_angle.to_radians()));
    let count = ((depth - step) / step) as usize;
    let at = |k: usize, side: f64| {
        let d = 0.5 * step + step * k as f64;
        DensePoint { p: Point3::new(side * (depth - d) * s / c, y, -d), n: Vector3::new(-side * c, 0.0, s) }
    };
    (0..count).map(|k| at(k, -1.0)).chain((0..count).rev().map(|k| at(k, 1.0))).collect()
}

#[test]
fn corrected_axes_of_a_groove_point_to_o_on_the_plane_of_symmetry() {
    for half_angle in [20.0, 30.0, 40.0] {
        let part = part(&solids::v_groove(half_angle, 8.0, 6.0, 40.0));
        let beam = BeamInterference::on(&part);
        let points = flanks(half_angle, 8.0, 0.1, 20.3);
        let free: Vec<bool> = points.iter().map(|q| beam.is_free(&q.p, &q.n)).collect();
        let axes = correct(&part, &beam, &points, &free, false, Some(Vector3::y()), None);
        let first = (0..points.len()).find(|&i| axes[i] != Some(points[i].n)).expect("a corrected point");
        // p0 and pn are mirror images: their beams meet above the root at the height
        // z0 + |x0|·tan β (the beam stands 90° − β off the vertical).
        let p0 = points[first - 1].p;
        let o = Point3::new(0.0, p0.y, p0.z - p0.x * libm::tan(half_angle.to_radians()));
        let mut corrected = 0;
        for (q, a) in points.iter().zip(&axes) {
            let a = a.expect("none is blocked");
            assert!(beam.is_free(&q.p, &a), "{q:?} {a:?}");
            if a != q.n {
                corrected += 1;
                assert!(angle_deg(&a, &(o - q.p)) < 0.1, "{q:?}: {a:?} does not point to {o}");
            }
        }
        assert_eq!(corrected, points.len() - 2 * first, "one run over both flanks");
        // Below the depth W·sin(2β)/2 = 2D·sin²β, to a step.
        let shaded = 8.0 * libm::cos(2.0 * half_angle.to_radians());
        assert!((8.0 + points[first].p.z - shaded).abs() < 0.1, "{} for {shaded}", points[first].p.z);
    }
}

/// P1 Eqs 8 and 9 written out in the section plane: where two beams (x, direction) in it meet.
fn crossing(p: [f64; 2], a: [f64; 2], q: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
    let det = a[0] * b[1] - a[1] * b[0];
    let w = [q[0] - p[0], q[1] - p[1]];
    let (k, l) = ((w[0] * b[1] - w[1] * b[0]) / det, (w[0] * a[1] - w[1] * a[0]) / det);
    (k > 0.0 && l > 0.0 && k < 1e3).then(|| [p[0] + k * a[0], p[1] + k * a[1]])
}

#[test]
fn runs_between_gear_teeth_point_to_the_o_of_their_free_neighbours() {
    let mut job = on(job("z", 1.1), &[1, 7]);
    job.beam.defocus_mm = 3.0;
    let p = planned(part(&sample("worm_gear")), job);
    let flat = |v: &Vector3<f64>| [v.x, v.y];
    let mut tried = 0;
    for pass in &p.plan.passes {
        let rows = &pass.targets;
        let mut at = 0;
        while let Some(first) = (at..rows.len()).find(|&i| rows[i].state == TargetState::Corrected) {
            let behind = (first..rows.len()).find(|&i| rows[i].state != TargetState::Corrected).expect("a free end");
            at = behind;
            let (p0, pn) = (&rows[first - 1], &rows[behind]);
            assert_eq!((p0.state, pn.state), (TargetState::Free, TargetState::Free));
            let o = crossing(flat(&p0.p.coords), flat(&p0.n), flat(&pn.p.coords), flat(&pn.n)).expect("O");
            for t in &rows[first..behind] {
                let wanted = Vector3::new(o[0] - t.p.x, o[1] - t.p.y, 0.0);
                let off = angle_deg(&Vector3::new(t.a.x, t.a.y, 0.0), &wanted);
                assert!(off < 0.1, "{off}° off O: {t:?}");
                tried += 1;
            }
        }
    }
    assert!(tried > 100, "{tried} corrected rows");
}

/// A floor from x = 0 to 10 and a wall 10 mm high over its left end.
fn step() -> Triangles {
    sheet(&[[-3.0, 10.0], [0.0, 10.0], [0.0, 0.0], [10.3, 0.0]], 20.0)
}

#[test]
fn at_the_foot_of_a_step_the_beam_leans_away_by_a_degree_or_two() {
    let p = planned_at(&step(), &[[5.0, 10.0, 0.0]], job("y", 1.0));
    let rows: Vec<&Target> = p.targets().filter(|t| t.state != TargetState::Free).collect();
    assert!(rows.len() >= p.plan.passes.len(), "every line begins at the foot");
    for t in rows {
        assert_eq!(t.state, TargetState::Corrected, "{t:?}");
        assert!(t.p.x < GRAZE_MM + 0.05 && (1.0..=3.0).contains(&t.tilt_deg()), "{t:?}");
        assert!(t.a.x > 0.0 && t.a.y.abs() < 1e-12, "away from the wall, in the section plane: {t:?}");
    }
    // The same for the wall's own foot over the floor.
    let p = planned_at(&step(), &[[0.0, 10.0, 5.0]], job("y", 1.0));
    assert!(p.targets().all(|t| t.state != TargetState::Blocked));
    assert!(
        p.targets()
            .filter(|t| t.state == TargetState::Corrected)
            .all(|t| t.a.z > 0.0 && (1.0..=3.0).contains(&t.tilt_deg()))
    );
}

#[test]
fn a_line_along_the_foot_is_blocked_and_says_by_which_wall() {
    let mut job = job("x", 1.0);
    job.layers.offset_mm = FirstPlane::FromLowest(0.5 * GRAZE_MM);
    let p = planned_at(&step(), &[[5.0, 10.0, 0.0]], job);
    let wall = p.surface_at([0.0, 10.0, 5.0]);
    let (along, others) = p.plan.passes.split_first().expect("passes");
    assert!(along.targets.iter().all(|t| t.state == TargetState::Blocked && !t.laser && t.p.x < GRAZE_MM));
    assert!(others.iter().flat_map(|l| &l.targets).all(|t| t.state == TargetState::Free));
    let problems = p.report().problems;
    assert_eq!(problems.len(), along.targets.len());
    assert!(problems.iter().all(|q| (q.pass, q.cause.word(), q.by_surface) == (Some(0), "beam", Some(wall))));
}

/// A cylinder with a post beside it, turned about z.
fn ring_and_post(turn_deg: f64) -> Planned {
    let (s, c) = (libm::sin(turn_deg.to_radians()), libm::cos(turn_deg.to_radians()));
    let turned = |p: [f64; 3]| [p[0] * c - p[1] * s, p[0] * s + p[1] * c, p[2]];
    let mut both = solids::cylinder(10.0, 4.0, 120);
    both.extend(block([16.0, -1.5, -1.0], [18.0, 1.0, 5.0]).into_iter().map(|t| t.map(turned)));
    let opposite = turned([-10.0, 0.0, 2.0]);
    planned_at(&both, &[opposite], job("z", 1.0))
}

#[test]
fn a_run_over_the_seam_of_a_closed_line_is_kept() {
    // A closed line about z begins at its lowest y: there the post stands once, elsewhere else.
    let (seam, elsewhere) = (ring_and_post(-90.0), ring_and_post(60.0));
    let pass = &seam.plan.passes[0];
    let (first, last) = (&pass.targets[0], &pass.targets[pass.targets.len() - 1]);
    assert!(first.normal_hits.is_some(), "the line begins in the shade of the post");
    assert!(pass.closed && first.p == last.p && first.a == last.a && first.state == last.state);
    let (a, b) = (seam.report(), elsewhere.report());
    assert!(a.corrected > 0);
    near("lit", a.work_mm, b.work_mm, 1e-3);
    near("corrected", a.corrected_mm, b.corrected_mm, 0.05);
    assert!((a.blocked_mm - b.blocked_mm).abs() < 0.2, "{} {}", a.blocked_mm, b.blocked_mm);
    near("tilt", a.max_tilt_deg, b.max_tilt_deg, 1e-3);
}
