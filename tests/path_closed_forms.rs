//! Planes and targets in closed form: plane families, chord counts, limits of step and turn, what the
//! planes miss, and spacing on a slope.
//!
//! A circle of radius R needs `ceil(π / acos(1 − dε/R))` chords; lines of planes d apart lie
//! `d / sin∠(n, m)` apart on a surface with normal n.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::path::TransversalLine;
use clearbeam::planning::report::NotDone;
use clearbeam::pose::Correction;
use clearbeam::sample::solids;
use parts::{Planned, angle_deg, cut, job, length, near, part, planned, planned_at, polygon, sample};
use std::f64::consts::PI;

/// Coordinates of a file are f32.
const F32: f64 = 1e-6;

#[test]
fn families_are_centred_and_leave_no_wide_gap() {
    let ball = solids::sphere(10.0, 64, 32);
    for spacing in [0.3, 0.5, 1.7, 7.0, 13.0, 20.0, 31.0] {
        let heights = cut(&ball, [10.0, 0.0, 0.0], "z", spacing).0.heights_mm;
        assert_eq!(heights.len(), (20.0 / spacing).ceil() as usize, "as few as can be");
        let (low, high) = (heights[0] + 10.0, 10.0 - heights[heights.len() - 1]);
        assert!((low - high).abs() < 1e-5 && low <= 0.5 * spacing + 1e-5, "{low} and {high} at {spacing}");
        assert!(heights.windows(2).all(|w| (w[1] - w[0] - spacing).abs() < 1e-9));
    }
    let (family, lines) = cut(&sample("acetabular_cup"), [0.0, 0.0, 28.0], "z", 6.0);
    assert_eq!((family.heights_mm.len(), lines.len()), (5, 5), "P2: five planes");
    family.heights_mm.iter().zip([2.0, 8.0, 14.0, 20.0, 26.0]).for_each(|(h, e)| assert!((h - e).abs() < 1e-5));
}

fn ring(radius: f64, sides: usize, error: f64, max_step: f64, max_turn: f64) -> Planned {
    let mut job = job("z", 2.5);
    (job.path.chord_error_mm, job.path.max_step_mm, job.path.max_turn_deg) = (error, max_step, max_turn);
    planned_at(&solids::cylinder(radius, 5.0, sides), &[[radius, 0.0, 2.5]], job)
}

#[test]
fn circles_need_the_chords_of_the_closed_form() {
    for (radius, error) in [(23.0, 0.5), (23.0, 0.02), (10.0, 0.1), (5.0, 0.3)] {
        let best = (PI / libm::acos(1.0 - error / radius)).ceil() as usize;
        let passes = ring(radius, 1440, error, 1e5, 180.0).plan.passes;
        assert_eq!(passes.len(), 2);
        let chords: Vec<usize> = passes.iter().map(|p| p.targets.len() - 1).collect();
        assert!(chords.iter().all(|c| (best..=best + 1).contains(c)), "R {radius} dε {error}: {chords:?} for {best}");
        assert!(passes.iter().all(|p| p.closed && p.chord_error_mm <= error));
        assert!(passes.iter().all(|p| p.targets.first().map(|t| t.p) == p.targets.last().map(|t| t.p)));
    }
}

fn keeps_its_limits(max_step: f64, max_turn: f64) {
    for pass in ring(10.0, 36, 0.5, max_step, max_turn).plan.passes {
        for w in pass.targets.windows(2) {
            let (step, turn) = ((w[1].p - w[0].p).norm(), angle_deg(&w[0].n, &w[1].n));
            assert!(step <= max_step + 1e-9, "{step} mm where --max-step is {max_step}");
            assert!(turn <= max_turn + 1e-6, "{turn}° where --max-turn is {max_turn}");
        }
    }
}

#[test]
fn steps_and_turns_keep_their_limits() {
    [(5.0, 5.0), (1.5, 90.0), (50.0, 2.5)].into_iter().for_each(|(step, turn)| keeps_its_limits(step, turn));
}

/// The dense line has gaps of up to 0.5 mm and turns of up to 2°; an operator may ask for less.
#[test]
fn a_step_shorter_than_the_dense_gap_is_kept() {
    keeps_its_limits(0.1, 90.0);
}

#[test]
fn a_turn_smaller_than_the_dense_turn_is_kept() {
    keeps_its_limits(50.0, 1.0);
}

#[test]
fn the_planes_miss_what_is_parallel_to_them() {
    let missed = |p: &Planned| p.report().missed_area_mm2;
    near("cube", missed(&planned(part(&solids::cube(10.0)), job("z", 1.0))), 200.0, F32);
    assert_eq!(missed(&planned(part(&solids::cube(10.0)), job("1,1,1", 1.0))), 0.0);
    near("cone's base", missed(&planned(part(&solids::cone(6.0, 8.0, 90)), job("z", 1.0))), polygon(6.0, 90).1, F32);
    let cylinder = planned(part(&solids::cylinder(5.0, 12.0, 48)), job("z", 1.0));
    near("cylinder's ends", missed(&cylinder), 2.0 * polygon(5.0, 48).1, F32);
    assert_eq!(cylinder.report().problems.iter().filter(|p| p.cause == NotDone::Missed).count(), 2);
}

#[test]
fn spacing_on_a_cone_is_d_over_the_sine() {
    let (radius, height, sides, spacing) = (6.0, 8.0, 90, 0.4);
    let mut job = job("z", spacing);
    job.path.correction = Correction::None;
    let p = planned_at(&solids::cone(radius, height, sides), &[[3.0, 0.0, 4.0]], job);
    // The normal of a flat side: (height, apothem).
    let slant = libm::hypot(height, radius * libm::cos(PI / sides as f64));
    let expected = spacing * slant / height;
    let row = &p.report().surfaces[0];
    near("least", row.spacing_min_mm.expect("lines"), expected, F32);
    near("greatest", row.spacing_max_mm.expect("lines"), expected, F32);
    // And so far from line to line it is, down the middle of a side.
    let (_, lines) = cut(&solids::cone(radius, height, sides), [3.0, 0.0, 4.0], "z", spacing);
    let apothem = |l: &TransversalLine| length(l) / (2.0 * sides as f64 * libm::tan(PI / sides as f64));
    for w in lines.windows(2) {
        let rise = w[1].points[0].p.z - w[0].points[0].p.z;
        near("line to line", libm::hypot(rise, apothem(&w[1]) - apothem(&w[0])), expected, 1e-5);
    }
}
