//! Sample `connecting_rod`: an engine's connecting rod (P1 Fig. 2c), lying flat.
//!
//! Big end ring about the z axis, small end ring 110 mm along +x, a straight shank between them that
//! runs into both rings with tangent fillets, and a pocket in each side that makes it an I-beam. All
//! walls are square to the faces; no split cap, no bolts.
//!
//! Surfaces at 20°: 1 upper face, 2 lower face, 3 the rim all round, 4 big bore, 5 small bore,
//! 6 and 7 wall and floor of the upper pocket, 8 and 9 of the lower.

use super::outline::{Flat, arc, at_z, circle, degrees};
use super::shell::{Facing, Point, Shell, Triangles};

/// Where the small end's axis stands, mm along x.
const LENGTH: f64 = 110.0;
/// Half the thickness, mm; half the thickness left between the pockets.
const HALF: f64 = 9.0;
const HALF_WEB: f64 = 3.5;
/// Radii of rings and bores, mm.
const BIG_RING: f64 = 29.0;
const BIG_BORE: f64 = 21.0;
const SMALL_RING: f64 = 16.0;
const SMALL_BORE: f64 = 9.5;
/// Half the width of the shank and the radius of its fillets, mm.
const SHANK: f64 = 10.5;
const FILLET: f64 = 14.0;
/// The pocket: a slot with round ends, centres and radius, mm.
const POCKET: [f64; 2] = [47.0, 78.0];
const POCKET_RADIUS: f64 = 6.5;

/// Distance along x from a ring's axis to the fillet's centre, and the angle (degrees) at which the
/// fillet touches the ring, seen from the ring's axis.
fn fillet(ring: f64) -> (f64, f64) {
    let (reach, up) = (ring + FILLET, SHANK + FILLET);
    let along = (reach * reach - up * up).sqrt();
    (along, degrees(libm::atan2(up, along)))
}

/// The outline, counter-clockwise from the big ring's upper fillet: tangents run through throughout.
fn outline() -> Vec<Flat> {
    let ((big, big_deg), (small, small_deg)) = (fillet(BIG_RING), fillet(SMALL_RING));
    let up = SHANK + FILLET;
    let mut points = arc([0.0, 0.0], BIG_RING, big_deg, 360.0 - big_deg, 96);
    // A fillet is curved the other way: its arc runs clockwise. Where it meets the ring, the ring's
    // point is kept; the shank's straight edge joins the two fillets.
    points.extend(arc([big, -up], FILLET, 180.0 - big_deg, 90.0, 12).split_off(1));
    points.extend(without_last(arc([LENGTH - small, -up], FILLET, 90.0, small_deg, 12)));
    points.extend(arc([LENGTH, 0.0], SMALL_RING, small_deg - 180.0, 180.0 - small_deg, 64));
    points.extend(arc([LENGTH - small, up], FILLET, -small_deg, -90.0, 12).split_off(1));
    points.extend(without_last(arc([big, up], FILLET, -90.0, big_deg - 180.0, 12)));
    points
}

fn without_last(mut points: Vec<Flat>) -> Vec<Flat> {
    points.pop();
    points
}

/// The pocket's outline.
fn pocket() -> Vec<Flat> {
    let mut points = arc([POCKET[1], 0.0], POCKET_RADIUS, -90.0, 90.0, 24);
    points.extend(arc([POCKET[0], 0.0], POCKET_RADIUS, 90.0, 270.0, 24));
    points
}

/// The rod's facets.
pub(super) fn triangles() -> Triangles {
    let (rim, slot) = (outline(), pocket());
    let big = circle([0.0, 0.0], BIG_BORE, 120);
    let small = circle([LENGTH, 0.0], SMALL_BORE, 72);
    let at = |points: &[Flat]| -> [Vec<Point>; 2] { [at_z(points, HALF), at_z(points, -HALF)] };
    let ([rim_up, rim_low], [slot_up, slot_low]) = (at(&rim), at(&slot));
    let ([big_up, big_low], [small_up, small_low]) = (at(&big), at(&small));

    let mut shell = Shell::new();
    shell.face(Facing::PlusZ, &rim_up, &[&big_up, &small_up, &slot_up]);
    shell.face(Facing::MinusZ, &rim_low, &[&big_low, &small_low, &slot_low]);
    shell.wall(&rim_low, &rim_up, 5);
    shell.wall(&big_up, &big_low, 5);
    shell.wall(&small_up, &small_low, 5);
    let (floor_up, floor_low) = (at_z(&slot, HALF_WEB), at_z(&slot, -HALF_WEB));
    shell.wall(&slot_up, &floor_up, 2);
    shell.face(Facing::PlusZ, &floor_up, &[]);
    // Against the axis again: from the floor down to the pocket's mouth.
    shell.wall(&floor_low, &slot_low, 2);
    shell.face(Facing::MinusZ, &floor_low, &[]);
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, surfaces};
    use super::*;
    use std::f64::consts::PI;

    fn area(points: &[Flat]) -> f64 {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
    }

    #[test]
    fn size_volume_facets_and_surfaces() {
        let part = triangles();
        let skin = closed("connecting_rod", &part);
        assert!((2_000..6_000).contains(&part.len()), "{} facets", part.len());
        assert_eq!(skin.euler(), 2 - 2 * 2);
        assert!((skin.low[0] + 29.0).abs() < 0.01 && (skin.high[0] - 126.0).abs() < 0.01);
        let bores = area(&circle([0.0, 0.0], BIG_BORE, 120)) + area(&circle([0.0, 0.0], SMALL_BORE, 72));
        let expected = 2.0 * HALF * (area(&outline()) - bores) - 2.0 * (HALF - HALF_WEB) * area(&pocket());
        assert!((skin.volume / expected - 1.0).abs() < 1e-5, "{} {expected}", skin.volume);
        assert_eq!(surfaces(&part, 20.0).len(), 9);
    }

    #[test]
    fn the_outline_turns_by_less_than_a_crease() {
        let points = outline();
        let n = points.len();
        let heading = |i: usize| {
            let (p, q) = (points[i % n], points[(i + 1) % n]);
            libm::atan2(q[1] - p[1], q[0] - p[0])
        };
        for i in 0..n {
            let turn = libm::remainder(heading(i + 1) - heading(i), 2.0 * PI) * 180.0 / PI;
            assert!(turn.abs() < 12.0, "{turn}° at {:?}", points[(i + 1) % n]);
        }
    }
}
