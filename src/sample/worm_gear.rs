//! Sample `worm_gear`: the worm gear of P1 (Fig. 2a, 7, 8), teeth outwards, axis z.
//!
//! 26 helical teeth, tip Ø60, width 18, helix 10°. In every section z = const a tooth gap is one
//! smooth line: straight flank, root arc, straight flank, the flanks 22° off the gap's centre line
//! and tangent to the arc. So each gap is one feature surface at 20°; its shape and what the beam
//! meets in it are in `tooth_gap.rs`. Shaft hole and six pin holes; no hub, no throat.
//!
//! Surfaces at 20°: 2i + 1 gap i and 2i + 2 the tip land after it (i = 0 to 25), 53 lower and
//! 54 upper end face, 55 shaft hole, 56 to 61 pin holes.

use super::outline::{Flat, at_z, circle, degrees, on_circle, radians, ring};
use super::shell::{Facing, Point, Shell, Triangles};
use super::tooth_gap::{HALF_GAP, TEETH, TIP, gap, placed, twist};

/// Face width, mm.
const WIDTH: f64 = 18.0;
/// Chords on a tip land; rows along the width.
const TIP_CHORDS: usize = 3;
const ROWS: usize = 8;

/// Shaft hole, pin holes and the circle they stand on, and the circle under the teeth: radii, mm.
const SHAFT: f64 = 8.0;
const PIN: f64 = 2.5;
const PIN_CIRCLE: f64 = 15.0;
const PINS: usize = 6;
const WEB: f64 = 22.5;
const WEB_SIDES: usize = 6 * TEETH;

/// Half the angle that a gap takes between its tips, degrees.
fn half_gap_deg() -> f64 {
    degrees(libm::asin(HALF_GAP / TIP))
}

/// The whole section at height z, counter-clockwise from the first corner of gap 0.
fn section(z: f64) -> Vec<Point> {
    let gap = gap();
    let land_deg = 360.0 / TEETH as f64 - 2.0 * half_gap_deg();
    let mut points: Vec<Flat> = Vec::new();
    for i in 0..TEETH {
        points.extend(gap.iter().map(|p| placed(*p, i, z)));
        for k in 1..TIP_CHORDS {
            let angle = radians(half_gap_deg() + land_deg * k as f64 / TIP_CHORDS as f64);
            points.push(placed([TIP * libm::sin(angle), TIP * libm::cos(angle)], i, z));
        }
    }
    at_z(&points, z)
}

/// The circle under the teeth at height z, turned with the section and begun under its first point.
fn web(z: f64) -> Vec<Point> {
    let start = degrees(twist() * z) - half_gap_deg();
    let angle = |k: usize| start + 360.0 * k as f64 / WEB_SIDES as f64;
    let points: Vec<Flat> = (0..WEB_SIDES).map(|k| on_circle([0.0, 0.0], WEB, angle(k))).collect();
    at_z(&points, z)
}

/// The gear's facets.
pub(super) fn triangles() -> Triangles {
    let layers: Vec<Vec<Point>> = (0..=ROWS).map(|k| section(WIDTH * k as f64 / ROWS as f64)).collect();
    let pins: Vec<Vec<Flat>> =
        (0..PINS).map(|k| circle(on_circle([0.0, 0.0], PIN_CIRCLE, 360.0 * k as f64 / PINS as f64), PIN, 36)).collect();
    let holes_at = |z: f64| -> Vec<Vec<Point>> {
        let pins = pins.iter().map(|p| at_z(p, z));
        std::iter::once(ring(SHAFT, z, 96)).chain(pins).collect()
    };
    let (low, high) = (holes_at(0.0), holes_at(WIDTH));
    let (web_low, web_high) = (web(0.0), web(WIDTH));

    let mut shell = Shell::new();
    shell.tube(&layers);
    shell.zip(&web_low, &layers[0]);
    shell.face(Facing::MinusZ, &web_low, &low.iter().map(Vec::as_slice).collect::<Vec<_>>());
    shell.zip(&layers[ROWS], &web_high);
    shell.face(Facing::PlusZ, &web_high, &high.iter().map(Vec::as_slice).collect::<Vec<_>>());
    for (k, (at_low, at_high)) in low.iter().zip(&high).enumerate() {
        shell.wall(at_high, at_low, if k == 0 { 6 } else { 4 });
    }
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, cross, normal, surfaces};
    use super::super::tooth_gap::{FLANK_CHORDS, ROOT_CHORDS};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn size_facets_and_surfaces() {
        let part = triangles();
        let skin = closed("worm_gear", &part);
        assert!((10_000..25_000).contains(&part.len()), "{} facets", part.len());
        assert_eq!(skin.euler(), 2 - 2 * 7);
        assert!((skin.high[0] - 30.0).abs() < 0.05 && skin.high[2] == 18.0);
        let all = surfaces(&part, 20.0);
        assert_eq!(all.len(), 2 * TEETH + 2 + 1 + PINS);
        for i in 0..TEETH {
            let chords = 2 * FLANK_CHORDS + ROOT_CHORDS;
            assert_eq!(all[2 * i].len(), 2 * ROWS * chords, "gap {i}");
            assert_eq!(all[2 * i + 1].len(), 2 * ROWS * TIP_CHORDS, "tip land {i}");
        }
    }

    /// The end faces do not fold over, and their area is the section's: so the rings do not cross.
    #[test]
    fn end_faces_are_plane_and_of_the_right_area() {
        let part = triangles();
        let all = surfaces(&part, 20.0);
        let outline = section(0.0);
        let n = outline.len();
        let shoelace = |i: usize| {
            let (p, q) = (outline[i], outline[(i + 1) % n]);
            (p[0] * q[1] - p[1] * q[0]) / 2.0
        };
        let polygon = |r: f64, n: f64| 0.5 * n * r * r * libm::sin(2.0 * PI / n);
        let expected = (0..n).map(shoelace).sum::<f64>() - polygon(SHAFT, 96.0) - 6.0 * polygon(PIN, 36.0);
        for (k, up) in [(52, -1.0), (53, 1.0)] {
            let mut area = 0.0;
            for i in &all[k] {
                let t = part[*i];
                assert!((normal(&t)[2] - up).abs() < 1e-12);
                let e = [1, 2].map(|c| [t[c][0] - t[0][0], t[c][1] - t[0][1], 0.0]);
                area += cross(e[0], e[1])[2] * up / 2.0;
            }
            assert!((area - expected).abs() < 1e-3, "{area} {expected}");
        }
    }
}
