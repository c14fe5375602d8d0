//! Sample `camshaft`: a camshaft with four lobes (P3), lying along x.
//!
//! From the nose with its keyway (x = 0) over a thrust collar to three journals, four lobes of which the noses stand 90°
//! apart (firing order 1-3-4-2: up, +y, −y, down), and a hexagon for the spanner. Both ends have centre holes. Lobes are
//! cylinders over `CamLobe`'s outline and stand clear of each other, so a beam along the normal is free. No oil bores,
//! no fillets.
//!
//! Most of its skin turns about its axis into itself: noses, keyway and hexagon alone tell its turn, and collar and
//! spacing which end is which.
//!
//! Surfaces at 20°: 25, 31, 52 and 58 are the running surfaces of the lobes, 19, 46 and 64 the journals, 9 the nose, 36 to
//! 41 the hexagon, 15 the collar's thrust face; [`WORN_SURFACE`] is what the job repairs.

use super::cam_lobe::CamLobe;
use super::outline::{Flat, arc, at_x, circle, degrees, radians};
use super::shell::{Facing, Triangles};
use super::turning::Turning;

/// The outline of all lobes. Its nose has a radius of 4.1 mm, the flanks at most 53 mm.
pub(super) const LOBE: CamLobe = CamLobe { base_mm: 15.0, lift_mm: 8.0, half_rad: 1.3 };
/// Corners of a lobe's outline: chords within 0.002 mm of it.
pub(super) const LOBE_SIDES: usize = 256;
/// Corners of circles: chords within 0.005 mm of them.
const SIDES: usize = 144;

/// Radii, mm.
const CORE: f64 = 9.5;
const JOURNAL: f64 = 13.0;
const COLLAR: f64 = 18.0;
const NOSE: f64 = 9.0;
/// Half the hexagon's width across flats, mm.
const HALF_ACROSS_FLATS: f64 = 11.0;
/// Chamfers of 45°, mm.
const CHAMFER: f64 = 0.6;

/// The keyway: half its width, the height of its floor above the axis, where it ends, mm.
const HALF_KEY: f64 = 3.0;
const KEY_FLOOR: f64 = 5.5;
const KEY_END: f64 = 17.0;
/// Where the nose ends, mm.
const NOSE_END: f64 = 24.0;

/// What a stretch of the shaft is in section.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Section {
    Core,
    Collar,
    Journal,
    /// With the angle of its nose from +y towards +z, degrees.
    Lobe(f64),
    Hexagon,
}

/// The stretches behind the nose: what, and how long, mm.
const STRETCHES: [(Section, f64); 17] = [
    (Section::Collar, 5.0),
    (Section::Core, 5.0),
    (Section::Journal, 18.0),
    (Section::Core, 8.0),
    (Section::Lobe(90.0), LOBE_WIDTH),
    (Section::Core, 9.0),
    (Section::Lobe(0.0), LOBE_WIDTH),
    (Section::Core, 7.0),
    (Section::Hexagon, 12.0),
    (Section::Core, 6.0),
    (Section::Journal, 18.0),
    (Section::Core, 8.0),
    (Section::Lobe(WORN_NOSE_DEG), LOBE_WIDTH),
    (Section::Core, 9.0),
    (Section::Lobe(270.0), LOBE_WIDTH),
    (Section::Core, 8.0),
    (Section::Journal, 18.0),
];
const LOBE_WIDTH: f64 = 16.0;

/// Which of [`STRETCHES`] is the lobe that the scan of this sample shows worn, and where its nose looks to, degrees.
const WORN_STRETCH: usize = 12;
pub(super) const WORN_NOSE_DEG: f64 = 180.0;
/// The number of its surface at 20°.
pub const WORN_SURFACE: u32 = 52;

/// Where the running surface of the worn lobe begins and ends, x in mm.
pub(super) fn worn_span() -> [f64; 2] {
    let before: f64 = STRETCHES[..WORN_STRETCH].iter().map(|s| s.1).sum();
    [NOSE_END + before + CHAMFER, NOSE_END + before + LOBE_WIDTH - CHAMFER]
}

impl Section {
    /// The outline, (y, z), offset inwards.
    fn outline(self, inset_mm: f64) -> Vec<Flat> {
        let round = |radius: f64| circle([0.0, 0.0], radius - inset_mm, SIDES);
        match self {
            Section::Core => round(CORE),
            Section::Collar => round(COLLAR),
            Section::Journal => round(JOURNAL),
            Section::Lobe(nose_deg) => LOBE.points(&LOBE.angles(LOBE_SIDES), inset_mm, radians(nose_deg)),
            Section::Hexagon => circle([0.0, 0.0], HALF_ACROSS_FLATS / libm::cos(radians(30.0)), 6),
        }
    }

    fn chamfer_mm(self) -> f64 {
        if matches!(self, Section::Core | Section::Hexagon) { 0.0 } else { CHAMFER }
    }
}

/// The nose's outline round to the keyway's edges, counter-clockwise from the one at −y.
fn nose_arc(radius: f64) -> Vec<Flat> {
    let edge = degrees(libm::asin(HALF_KEY / radius));
    arc([0.0, 0.0], radius, 90.0 + edge, 450.0 - edge, SIDES - 12)
}

/// The nose's outline with the keyway.
fn keyed(radius: f64) -> Vec<Flat> {
    let mut points = nose_arc(radius);
    points.extend([[HALF_KEY, KEY_FLOOR], [-HALF_KEY, KEY_FLOOR]]);
    points
}

/// The part of the nose's circle that the keyway takes, without its ends, from +y to −y.
fn over_key() -> Vec<Flat> {
    let edge = degrees(libm::asin(HALF_KEY / NOSE));
    let whole = arc([0.0, 0.0], NOSE, 90.0 - edge, 90.0 + edge, 12);
    whole[1..12].to_vec()
}

/// The nose with its keyway and centre hole.
fn nose() -> Turning {
    let mut turning = Turning::begun(keyed(NOSE - CHAMFER));
    turning.wall(CHAMFER, keyed(NOSE));
    turning.wall(KEY_END, keyed(NOSE));
    let (round, over) = (nose_arc(NOSE), over_key());
    let mut end = vec![[-HALF_KEY, KEY_FLOOR], [HALF_KEY, KEY_FLOOR]];
    end.extend(round.last());
    end.extend(&over);
    end.extend(round.first());
    turning.shell.face(Facing::MinusX, &at_x(&end, KEY_END), &[]);
    let whole = [round, over].concat();
    turning.outline = whole.clone();
    turning.wall(NOSE_END, whole);
    turning
}

/// The camshaft's facets.
pub(super) fn triangles() -> Triangles {
    let mut turning = nose();
    for (section, length_mm) in STRETCHES {
        let (chamfer, end) = (section.chamfer_mm(), turning.x + length_mm);
        turning.shoulder(section.outline(chamfer));
        if chamfer > 0.0 {
            turning.wall(turning.x + chamfer, section.outline(0.0));
        }
        turning.wall(end - chamfer, section.outline(0.0));
        if chamfer > 0.0 {
            turning.wall(end, section.outline(chamfer));
        }
    }
    turning.ended()
}

#[cfg(test)]
mod tests {
    use super::super::check::{self, closed, surfaces};
    use super::super::shell::Point;
    use super::super::turning::{CONE_DEPTH, MOUTH, PILOT, PILOT_DEPTH, POINT_DEPTH};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn size_facets_and_surfaces() {
        let part = triangles();
        let skin = closed("camshaft", &part);
        assert!(part.len() < 45_000, "{} facets", part.len());
        assert_eq!(skin.euler(), 2);
        assert_eq!(skin.low[0], 0.0);
        let length: f64 = NOSE_END + STRETCHES.iter().map(|s| s.1).sum::<f64>();
        assert!((skin.high[0] - length).abs() < 1e-4);
        let nose = LOBE.base_mm + LOBE.lift_mm;
        for reach in [skin.high[1], skin.high[2], -skin.low[1], -skin.low[2]] {
            assert!((reach - nose).abs() < 1e-4, "{skin:?}");
        }
        let surfaces = surfaces(&part, 20.0);
        let first = |number: usize| part[surfaces[number - 1][0]];
        let area = |number: usize| -> f64 {
            let cross = |t: &[Point; 3]| check::cross(check::sub(t[1], t[0]), check::sub(t[2], t[0]));
            surfaces[number - 1].iter().map(|&f| check::dot(cross(&part[f]), cross(&part[f])).sqrt() / 2.0).sum()
        };
        assert_eq!(surfaces.len(), 69);
        let [from, to] = worn_span();
        for number in 1..=surfaces.len() {
            let (x, n) = (check::centroid(&first(number))[0], check::normal(&first(number)));
            let worn = n[0].abs() < 0.1 && (from..to).contains(&x);
            assert_eq!(worn, number as u32 == WORN_SURFACE, "surface {number}");
        }
        let running = |around: f64, width: f64| around * (width - 2.0 * CHAMFER);
        let lobe = running(LOBE.length_mm(), LOBE_WIDTH);
        let journal = running(2.0 * PI * JOURNAL, 18.0);
        for (numbers, expected) in [(vec![25, 31, 52, 58], lobe), (vec![19, 46, 64], journal)] {
            for number in numbers {
                assert!((area(number) / expected - 1.0).abs() < 1e-3, "{number}: {} {expected}", area(number));
            }
        }
    }

    /// Volumes of stretches: prisms over circles, the hexagon and the lobe's area by Minkowski's ∮ (h² − h'²)/2 dφ.
    #[test]
    fn volume_is_that_of_its_sections() {
        let lobe_area = |inset: f64| {
            let steps = 200_000;
            let at = |i: i32| {
                let u = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(steps);
                let (h, first) = (
                    LOBE.base_mm - inset + LOBE.lift_mm * (1.0 - u * u) * (1.0 - u * u),
                    4.0 * LOBE.lift_mm * u * (1.0 - u * u) / LOBE.half_rad,
                );
                0.5 * (h * h - first * first) * 2.0 * LOBE.half_rad / f64::from(steps)
            };
            let base = LOBE.base_mm - inset;
            (0..steps).map(at).sum::<f64>() + (PI - LOBE.half_rad) * base * base
        };
        let area = |section: Section, inset: f64| match section {
            Section::Core => PI * CORE * CORE,
            Section::Collar => PI * (COLLAR - inset) * (COLLAR - inset),
            Section::Journal => PI * (JOURNAL - inset) * (JOURNAL - inset),
            Section::Lobe(_) => lobe_area(inset),
            Section::Hexagon => 2.0 * 3f64.sqrt() * HALF_ACROSS_FLATS * HALF_ACROSS_FLATS,
        };
        let mut expected = PI * NOSE * NOSE * NOSE_END - PI * CHAMFER * CHAMFER * (NOSE - CHAMFER / 3.0);
        let over = NOSE * NOSE * libm::asin(HALF_KEY / NOSE) + HALF_KEY * (NOSE * NOSE - HALF_KEY * HALF_KEY).sqrt();
        expected -= (over - 2.0 * HALF_KEY * KEY_FLOOR) * KEY_END;
        for (section, length) in STRETCHES {
            let c = section.chamfer_mm();
            // Area is a quadratic of the inset, so Simpson's rule is exact over a chamfer.
            let slope = (area(section, 0.0) + 4.0 * area(section, c / 2.0) + area(section, c)) / 6.0;
            expected += area(section, 0.0) * (length - 2.0 * c) + 2.0 * c * slope;
        }
        let cone = CONE_DEPTH / 3.0 * (MOUTH * MOUTH + MOUTH * PILOT + PILOT * PILOT);
        let pilot = PILOT * PILOT * (PILOT_DEPTH - CONE_DEPTH + (POINT_DEPTH - PILOT_DEPTH) / 3.0);
        expected -= 2.0 * PI * (cone + pilot);
        let volume = closed("camshaft", &triangles()).volume;
        assert!((volume / expected - 1.0).abs() < 5e-4, "{volume} {expected}");
    }
}
