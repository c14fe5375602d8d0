//! Sample `front_shaft`: front shaft of an automobile's transmission (P1 Fig. 2b), upright.
//!
//! Axis z, from the journal's end (z = 0, with a blind centre hole) over the steps of the journal
//! and the shaft tube to a yoke (z = 130 to 180.3) with two ears and coaxial cross holes along x.
//! Everything shares its loops: the tube springs from a circle in the yoke's back face. No splines,
//! no fillets.
//!
//! Surfaces at 20°: 1 conical bottom and 2 wall of the centre hole, 3 end face, 4 chamfer, 5 first
//! journal, 6 shoulder, 7 second journal, 8 collar's lower face, 9 collar, 10 collar's upper face,
//! 11 shaft tube, 12 yoke's back, 13 and 14 its sides (normals −y and +y), 15 fork bottom,
//! 16 to 19 ear at +x (outer face, inner face, rounded end, cross hole), 20 to 23 ear at −x.

use super::outline::{Flat, arc, at_x, at_z, circle, rectangle, ring};
use super::shell::{Facing, Point, Shell, Triangles};

const SIDES: usize = 96;
/// Profile from the centre hole's bottom to the tube's upper end: (radius, z) in mm, and the number
/// of rows to the next corner. The centre hole's own point is [`DRILL_POINT`].
const PROFILE: [(f64, f64, usize); 11] = [
    (3.0, 16.0, 4),
    (3.0, 0.0, 1),
    (9.0, 0.0, 1),
    (10.0, 1.0, 8),
    (10.0, 32.0, 1),
    (13.0, 32.0, 6),
    (13.0, 55.0, 1),
    (18.0, 55.0, 2),
    (18.0, 60.0, 1),
    (14.0, 60.0, 14),
    (14.0, YOKE, 0),
];
/// Height of the drill's point in the centre hole, mm (118° point).
const DRILL_POINT: f64 = 17.8;

/// The yoke's back face and the bottom of its fork, z in mm.
const YOKE: f64 = 130.0;
const FORK: f64 = 142.0;
/// Half the yoke's width (y), and where the ears begin and end (|x|), mm.
const HALF_WIDTH: f64 = 15.0;
const INNER: f64 = 16.0;
const OUTER: f64 = 25.0;
/// Cross holes and rounded ends of the ears are round about (y, z) = (0, CROSS); radii in mm.
const CROSS: f64 = 163.0;
const CROSS_RADIUS: f64 = 8.0;
/// The rounded end begins at 30°, so that it meets the straight sides in a crease: radius
/// HALF_WIDTH / cos 30°.
const EAR_DEG: f64 = 30.0;
const EAR_RADIUS: f64 = 17.320_508_075_688_775;
/// Where the straight sides of the ears end, z in mm.
const SPRING: f64 = CROSS + EAR_RADIUS / 2.0;

/// The rounded end of an ear, (y, z), from +y to −y, both ends on the straight sides.
fn ear_end() -> Vec<Flat> {
    let mut points = arc([0.0, CROSS], EAR_RADIUS, EAR_DEG, 180.0 - EAR_DEG, 32);
    // The ends lie on the sides exactly, where the U-shaped faces have the same points.
    if let [first, .., last] = points.as_mut_slice() {
        (*first, *last) = ([HALF_WIDTH, SPRING], [-HALF_WIDTH, SPRING]);
    }
    points
}

/// The ear's outline, (y, z), from a given height up.
fn ear(bottom: f64) -> Vec<Flat> {
    let mut points = vec![[-HALF_WIDTH, bottom], [HALF_WIDTH, bottom]];
    points.extend(ear_end());
    points
}

/// The yoke's U in the plane y, (x, z).
fn fork(y: f64) -> Vec<Point> {
    let corners = [
        [-OUTER, YOKE],
        [OUTER, YOKE],
        [OUTER, SPRING],
        [INNER, SPRING],
        [INNER, FORK],
        [-INNER, FORK],
        [-INNER, SPRING],
        [-OUTER, SPRING],
    ];
    corners.iter().map(|c| [c[0], y, c[1]]).collect()
}

/// One ear: `outer` and `inner` are its faces' x.
fn add_ear(shell: &mut Shell, outer: f64, inner: f64) {
    let hole = circle([0.0, CROSS], CROSS_RADIUS, 72);
    let (hole_out, hole_in) = (at_x(&hole, outer), at_x(&hole, inner));
    let facing = [Facing::PlusX, Facing::MinusX];
    let [out, inwards] = if outer > 0.0 { facing } else { [facing[1], facing[0]] };
    shell.face(out, &at_x(&ear(YOKE), outer), &[&hole_out]);
    shell.face(inwards, &at_x(&ear(FORK), inner), &[&hole_in]);
    let end = ear_end();
    let (low, high) = (at_x(&end, outer.min(inner)), at_x(&end, outer.max(inner)));
    for i in 1..end.len() {
        shell.quad(low[i - 1], low[i], high[i], high[i - 1]);
    }
    if outer > 0.0 {
        shell.wall(&hole_out, &hole_in, 4);
    } else {
        shell.wall(&hole_in, &hole_out, 4);
    }
}

/// The shaft's facets.
pub(super) fn triangles() -> Triangles {
    let mut shell = Shell::new();
    let loops: Vec<Vec<Point>> = PROFILE.iter().map(|(r, z, _)| ring(*r, *z, SIDES)).collect();
    shell.fan_from([0.0, 0.0, DRILL_POINT], &loops[0]);
    for (pair, corner) in loops.windows(2).zip(&PROFILE) {
        shell.wall(&pair[0], &pair[1], corner.2);
    }
    let back = at_z(&rectangle([-OUTER, -HALF_WIDTH], [OUTER, HALF_WIDTH]), YOKE);
    shell.face(Facing::MinusZ, &back, &[&loops[PROFILE.len() - 1]]);
    shell.face(Facing::MinusY, &fork(-HALF_WIDTH), &[]);
    shell.face(Facing::PlusY, &fork(HALF_WIDTH), &[]);
    shell.face(Facing::PlusZ, &at_z(&rectangle([-INNER, -HALF_WIDTH], [INNER, HALF_WIDTH]), FORK), &[]);
    add_ear(&mut shell, OUTER, INNER);
    add_ear(&mut shell, -OUTER, -INNER);
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, surfaces};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn size_facets_and_surfaces() {
        let part = triangles();
        let skin = closed("front_shaft", &part);
        // Two cross holes: genus 2.
        assert_eq!(skin.euler(), 2 - 2 * 2);
        assert_eq!((skin.low[2], skin.low[0], skin.high[0]), (0.0, -25.0, 25.0));
        assert!((skin.high[2] - CROSS - EAR_RADIUS).abs() < 1e-3, "{:?}", skin.high);
        assert_eq!(surfaces(&part, 20.0).len(), 23);
    }

    #[test]
    fn volume_of_journal_and_yoke() {
        let frustum =
            |a: &(f64, f64, usize), b: &(f64, f64, usize)| PI / 3.0 * (b.1 - a.1) * (a.0 * a.0 + a.0 * b.0 + b.0 * b.0);
        let turned: f64 = PROFILE.windows(2).map(|w| frustum(&w[0], &w[1])).sum();
        let drill = PI / 3.0 * 9.0 * (DRILL_POINT - 16.0);
        let segment = EAR_RADIUS * EAR_RADIUS * (PI / 3.0 - 3.0f64.sqrt() / 4.0);
        let ear = 2.0 * HALF_WIDTH * (SPRING - FORK) + segment - PI * CROSS_RADIUS * CROSS_RADIUS;
        let yoke = 4.0 * OUTER * HALF_WIDTH * (FORK - YOKE) + 2.0 * (OUTER - INNER) * ear;
        let expected = turned - drill + yoke;
        let volume = closed("front_shaft", &triangles()).volume;
        assert!((volume / expected - 1.0).abs() < 2e-3, "{volume} {expected}");
    }
}
