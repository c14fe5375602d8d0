//! What happens between the poses of the NACHI program: the focus in the air keeps clear of the part,
//! and the beam with the laser on meets nothing, also as the controller really moves.
//!
//! Asked to go from pose to pose, a controller moves the flange straight and turns it at constant
//! rate. Part in hand, the focus on the part then leaves the straight way between two targets by
//! about `L·(1 − cos(θ/2))`, L the distance from flange to focus and θ the turn of the move.

#[path = "common/nachi_text.rs"]
mod nachi_text;
#[path = "common/parts.rs"]
mod parts;

use clearbeam::cell::Cell;
use clearbeam::part::bvh::ray_hit_mm;
use clearbeam::part::distance::point_triangle;
use nachi_text::{air, frame_on_part, gear, lit, read, text, workpiece};
use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use parts::{Planned, cell};
use rayon::prelude::*;

/// Least distance of the focus from the part on a way given by shares, sampled every half millimetre.
fn nearest(
    p: &Planned,
    from: &Point3<f64>,
    to: &Point3<f64>,
    focus: impl Fn(f64) -> Point3<f64>,
) -> (f64, Point3<f64>) {
    let steps = ((to - from).norm() / 0.5).ceil().max(8.0) as usize;
    let facets = 0..p.part.mesh.facets.len();
    (0..=steps)
        .map(|k| focus(k as f64 / steps as f64))
        .map(|x| (facets.clone().map(|f| point_triangle(&x, &p.part.mesh.corners(f))).fold(f64::MAX, f64::min), x))
        .fold((f64::MAX, *from), |a, b| if b.0 < a.0 { b } else { a })
}

/// The path frame of a controller that moves the flange straight and turns it at constant rate.
fn by_the_flange(cell: &Cell, from: &Isometry3<f64>, to: &Isometry3<f64>, t: f64) -> Isometry3<f64> {
    let at = from.translation.vector.lerp(&to.translation.vector, t);
    let pose = Isometry3::from_parts(Translation3::from(at), from.rotation.slerp(&to.rotation, t));
    frame_on_part(cell, &pose)
}

fn keeps_clear(p: &Planned, straight: bool) {
    let cell = cell();
    let moves = air(&read(&text(p)));
    assert!(moves.len() > 50);
    let focus = |pose: &Isometry3<f64>| Point3::from(frame_on_part(&cell, pose).translation.vector);
    let worst = moves
        .par_iter()
        .map(|(from, to)| {
            let (a, b) = (focus(from), focus(to));
            let found = nearest(p, &a, &b, |t| {
                if straight { a + (b - a) * t } else { by_the_flange(&cell, from, to, t).translation.vector.into() }
            });
            (
                found.0,
                format!("{a} to {b} at {}, turned by {}°", found.1, from.rotation.angle_to(&to.rotation).to_degrees()),
            )
        })
        .reduce(|| (f64::MAX, String::new()), |a, b| if b.0 < a.0 { b } else { a });
    assert!(worst.0 >= 0.3, "{} mm from the part: {}", worst.0, worst.1);
}

#[test]
fn air_moves_keep_clear_of_the_workpiece() {
    keeps_clear(&workpiece(), true);
}

#[test]
fn air_moves_keep_clear_of_the_worm_gear() {
    keeps_clear(&gear(), true);
}

/// The controller moves the flange straight, not the focus on the part.
#[test]
fn air_moves_keep_clear_of_the_workpiece_as_the_flange_goes() {
    keeps_clear(&workpiece(), false);
}

#[test]
fn air_moves_keep_clear_of_the_worm_gear_as_the_flange_goes() {
    keeps_clear(&gear(), false);
}

/// Six poses on the way between two lit targets as the flange goes: the beam meets nothing from
/// 0.1 mm before the spot on, the spot being where the axis meets the part nearest to D.
fn beams_are_free(p: &Planned) {
    let (cell, check) = (cell(), p.checker());
    let lit = lit(p, &read(&text(p)));
    let corners: Vec<_> = (0..p.part.mesh.facets.len()).map(|f| p.part.mesh.corners(f)).collect();
    let moves: Vec<_> = lit.windows(2).filter(|w| w[1].way.is_some()).collect();
    let hits: Vec<String> = moves
        .par_iter()
        .flat_map_iter(|w| (1..7).map(move |k| (w, k as f64 / 7.0)))
        .filter_map(|(w, t)| {
            let frame = by_the_flange(&cell, &w[0].flange, &w[1].flange, t);
            let a = frame.rotation * Vector3::z();
            let start = Point3::from(frame.translation.vector - a * (p.job.beam.defocus_mm + 1.5));
            let off = |t: &f64| (t - 1.5).abs();
            let met = corners.iter().filter_map(|c| ray_hit_mm(c, &start, &a)).filter(|t| off(t) < 1.5);
            let spot = start + a * met.min_by(|s, t| off(s).total_cmp(&off(t)))?;
            check.hit(&spot, &a, 0.1)?;
            let turn = w[0].flange.rotation.angle_to(&w[1].flange.rotation).to_degrees();
            let aside = (spot - (w[0].row.p + (w[1].row.p - w[0].row.p) * t)).norm();
            Some(format!("at {spot}, {aside} mm beside the planned spot, on a move that turns by {turn}°"))
        })
        .collect();
    assert!(hits.is_empty(), "{} of {} poses hit the part, first {}", hits.len(), moves.len() * 6, hits[0]);
}

#[test]
fn beams_are_free_on_the_workpiece_as_the_flange_goes() {
    beams_are_free(&workpiece());
}

#[test]
fn beams_are_free_on_the_worm_gear_as_the_flange_goes() {
    beams_are_free(&gear());
}
