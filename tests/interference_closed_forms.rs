//! Which points interfere, on parts for which that is known in closed form: fins, blind hole, V-groove.
//! Where the corrected beams go is in `correction_closed_forms.rs`.
//!
//! A beam closer than `GRAZE_MM` to a facet interferes. So over a plane floor just the strip of
//! that width at a wall's foot does, and between parallel walls every horizontal beam.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::pose::interference::GRAZE_MM;
use clearbeam::pose::{Correction, TargetState};
use clearbeam::sample::{Triangles, solids};
use nalgebra::Point3;
use parts::{Planned, job, near, planned_at};

fn uncorrected(direction: &str, spacing_mm: f64) -> clearbeam::document::Job {
    let mut job = job(direction, spacing_mm);
    job.path.correction = Correction::None;
    job
}

/// A target interferes just where `depth(p) < 0`, within `width` of which no claim is made.
fn interferes_where(p: &Planned, depth: impl Fn(&Point3<f64>) -> f64, width: f64) {
    let (mut hit, mut clear) = (0, 0);
    for t in p.targets().filter(|t| depth(&t.p).abs() > width) {
        assert_eq!(t.normal_hits.is_some(), depth(&t.p) < 0.0, "{t:?}");
        assert!(t.state != TargetState::Blocked || t.normal_hits.is_some(), "{t:?}");
        (hit, clear) = (hit + usize::from(t.normal_hits.is_some()), clear + usize::from(t.normal_hits.is_none()));
    }
    assert!(hit + clear > 20, "{hit} hit, {clear} clear");
}

/// Three fins 2 mm thick, 4 mm apart and 15 mm high; floors between x = 2 and 6, 8 and 12.
fn fins() -> Triangles {
    solids::fin_row(3, 2.0, 4.0, 15.0, 50.0, 7.0)
}

#[test]
fn floors_between_fins_are_free_but_at_the_foot() {
    let p = planned_at(&fins(), &[[4.0, 25.0, 0.0], [10.0, 25.0, 0.0]], uncorrected("y", 3.0));
    let to_wall =
        |q: &Point3<f64>| (q.x - 2.0).abs().min((q.x - 6.0).abs()).min((q.x - 8.0).abs()).min((12.0 - q.x).abs());
    interferes_where(&p, |q| to_wall(q) - GRAZE_MM, 1e-6);
    // Each line loses its two feet, found to 0.05 mm.
    for pass in &p.plan.passes {
        let lit = pass.length_mm(|_, to| to.laser);
        let lost = 4.0 - lit;
        assert!((2.0 * GRAZE_MM..=2.0 * (GRAZE_MM + 0.05)).contains(&lost), "{lost}");
    }
}

#[test]
fn walls_between_fins_are_blocked_and_outer_walls_free() {
    let inner = planned_at(&fins(), &[[6.0, 25.0, 7.0], [8.0, 25.0, 7.0]], job("y", 3.0));
    for t in inner.targets() {
        assert_eq!((t.state, t.laser, t.normal_hits.is_some()), (TargetState::Blocked, false, true), "{t:?}");
    }
    // Fin 2 has its walls at 6 and 8; opposite stand those at 2 and 12.
    let opposite = [[6.0, 2.0], [8.0, 12.0]];
    for problem in inner.report().problems {
        let [_, x] = *opposite.iter().find(|o| inner.surface_at([o[0], 25.0, 7.0]) == problem.surface).expect("chosen");
        let row = inner.plan.passes[problem.pass.expect("a pass")].targets[problem.point.expect("a point")];
        // At the foot the beam runs in the floor before it meets the wall, at the top it meets wall
        // and land at once.
        if row.p.z >= 15.0 - GRAZE_MM {
            continue;
        }
        let by = if row.p.z <= GRAZE_MM { [0.5 * (row.p.x + x), 25.0, 0.0] } else { [x, 25.0, 7.0] };
        assert_eq!((problem.cause.word(), problem.by_surface), ("beam", Some(inner.surface_at(by))), "{row:?}");
    }
    let outer = planned_at(&fins(), &[[0.0, 25.0, 7.0], [14.0, 25.0, 7.0], [7.0, 25.0, 15.0]], job("y", 3.0));
    assert!(outer.targets().all(|t| t.state == TargetState::Free && t.a == t.n));
}

#[test]
fn a_blind_hole_has_a_free_floor_and_a_blocked_wall() {
    let (radius, sides) = (5.0, 64);
    let hole = solids::blind_hole(30.0, radius, 12.0, sides);
    let wall = planned_at(&hole, &[[radius, 0.0, -6.0]], job("z", 1.0));
    assert!(wall.targets().all(|t| t.state == TargetState::Blocked && t.normal_hits.is_some()));
    assert_eq!(wall.report().work_mm, 0.0);
    let floor = planned_at(&hole, &[[0.0, 0.0, -12.0]], uncorrected("y", 0.7));
    let half = std::f64::consts::PI / sides as f64;
    // Distance to the nearest of the flat sides.
    let to_wall = |q: &Point3<f64>| {
        let side = |k: usize| half * (2 * k + 1) as f64;
        let out = |k: usize| q.x * libm::cos(side(k)) + q.y * libm::sin(side(k));
        radius * libm::cos(half) - (0..sides).map(out).fold(f64::MIN, f64::max)
    };
    interferes_where(&floor, |q| to_wall(q) - GRAZE_MM, 1e-5);
}

/// Depth below the lands from which flank points of a groove meet the opposite edge with a beam
/// `tilt(share of the way down)` off the vertical: the beam reaches z = 0 at the other edge.
fn first_blocked(half_width: f64, depth: f64, tilt: impl Fn(f64) -> f64) -> f64 {
    let beyond = |s: f64| -(1.0 - s) * half_width + s * depth * libm::tan(tilt(s)) - half_width;
    let (mut low, mut high) = (0.0, 1.0 - 1e-9);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if beyond(middle) < 0.0 { low = middle } else { high = middle }
    }
    low * depth
}

/// The depth of the first blocked row, and of the last free one above it.
fn edge_of_shade(p: &Planned, pass: usize) -> (f64, f64) {
    let rows = &p.plan.passes[pass].targets;
    let depth = |which: bool| rows.iter().filter(move |t| t.normal_hits.is_some() == which).map(|t| -t.p.z);
    (depth(true).fold(f64::MAX, f64::min), depth(false).fold(f64::MIN, f64::max))
}

#[test]
fn a_groove_shades_its_flanks_from_the_closed_depth_on() {
    let (depth, land) = (8.0, 6.0);
    for half_angle in [20.0f64, 30.0, 40.0] {
        let half_width = depth * libm::tan(half_angle.to_radians());
        let groove = solids::v_groove(half_angle, depth, land, 40.0);
        let at = [-0.5 * half_width, 20.0, -0.5 * depth];
        // By themselves flanks have one normal, 90° − β off the vertical: W·sin(2β)/2.
        let closed = half_width * libm::sin(2.0 * half_angle.to_radians());
        let own = (90.0 - half_angle).to_radians();
        near("the formula", first_blocked(half_width, depth, |_| own), closed, 1e-9);
        let p = planned_at(&groove, &[at], uncorrected("y", 3.0));
        // With their lands they are one surface: the normal turns from the mean of both to the flank's.
        let mut wide = uncorrected("y", 3.0);
        wide.surfaces.angle_deg = 90.0 - half_angle + 0.5;
        let joined = planned_at(&groove, &[at], wide);
        let on_land = joined.targets().filter(|t| t.p.z == 0.0).count();
        assert!(on_land > 10, "land and flank are one surface");
        let turning = first_blocked(half_width, depth, |s| {
            let (top, foot) = (0.5 * own, own);
            let mean = |f: fn(f64) -> f64| (1.0 - s) * f(top) + s * f(foot);
            libm::atan2(mean(libm::sin), mean(libm::cos))
        });
        for (p, expected) in [(p, closed), (joined, turning)] {
            for pass in 0..p.plan.passes.len() {
                let (blocked, free) = edge_of_shade(&p, pass);
                assert!(
                    (blocked - expected).abs() < 0.1 && (free - expected).abs() < 0.1,
                    "{blocked} {free} {expected}"
                );
                assert!(free < blocked);
            }
        }
    }
}
