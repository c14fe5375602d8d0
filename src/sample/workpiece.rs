//! Sample `workpiece`: the test workpiece of P1 (Fig. 2d, 9, 12 to 15), standing upright.
//!
//! A plate, x from −50 to 50, y from 0 (front, normal −y) to 12, z from 0 to 80 mm. On the front a
//! round lug boss, a crater, and beside the crater (towards −x, so that sections z = const cut both)
//! a square convex plate. The crater is a spherical cap whose slope far from the block looks at it:
//! along the normal the beam meets the block less than 20 mm away, and a tilt of some 20° in the
//! section plane frees it. P1 gives no dimensions. The crater is Ø16 and its rim 66° steep because the
//! beam crosses the whole crater before it meets the block: across a Ø24 crater of 45° no point would
//! meet it within D = 20 mm, and for an endless ray the block would have to be 26 mm high.
//!
//! Surfaces at 20°, by their numbers: 1 plate front, 2 crater, 3 top of the lug boss, 4 its wall,
//! 5 top of the block, 6 to 9 its sides, 10 to 13 the holes, 14 plate back, 15 to 18 the plate's rims.

use super::outline::{Flat, at_y, circle, rectangle};
use super::shell::{Facing, Point, Shell, Triangles};

/// Corners of the plate seen from the front, (x, z), mm.
const PLATE: [Flat; 2] = [[-50.0, 0.0], [50.0, 80.0]];
/// Thickness of the plate, mm.
const THICKNESS: f64 = 12.0;

/// Centre of the crater's rim, (x, z), mm.
const CRATER: Flat = [8.0, 46.1];
/// Radius of the rim and depth of the crater, mm.
const CRATER_RIM: f64 = 8.0;
const CRATER_DEPTH: f64 = 5.2;
const CRATER_SIDES: usize = 120;
const CRATER_ROWS: usize = 28;

/// The block, (x, z) corners and height, mm. It stands 0.5 mm beside the crater's rim; its upper and
/// lower walls keep clear of planes at whole, half and quarter millimetres.
const BLOCK: [Flat; 2] = [[-26.5, 33.1], [-0.5, 59.1]];
const BLOCK_HEIGHT: f64 = 16.0;

/// The lug boss: centre (x, z), radius, height, mm.
const LUG: Flat = [30.0, 20.3];
const LUG_RADIUS: f64 = 13.0;
const LUG_HEIGHT: f64 = 6.0;

/// Through-holes: centre (x, z) and radius, mm.
const HOLES: [(Flat, f64); 4] = [([-38.0, 12.3], 4.0), ([-38.6, 67.7], 4.0), ([38.3, 66.9], 5.0), ([11.7, 70.6], 3.0)];

/// The radius of the crater's sphere, mm.
fn crater_radius() -> f64 {
    (CRATER_RIM * CRATER_RIM + CRATER_DEPTH * CRATER_DEPTH) / (2.0 * CRATER_DEPTH)
}

/// The centre of the crater's sphere: in front of the plate, where all normals of the crater meet.
fn crater_centre() -> Point {
    [CRATER[0], CRATER_DEPTH - crater_radius(), CRATER[1]]
}

/// Rings of the crater from the rim inwards, evenly spaced in angle; the bottom point is not among them.
fn crater_rings() -> Vec<Vec<Point>> {
    let (radius, centre) = (crater_radius(), crater_centre());
    let rim_angle = libm::asin(CRATER_RIM / radius);
    (0..CRATER_ROWS)
        .map(|k| {
            let angle = rim_angle * (CRATER_ROWS - k) as f64 / CRATER_ROWS as f64;
            // The rim is written as given, so that it lies in the plate's front exactly.
            let (r, y) = if k == 0 {
                (CRATER_RIM, 0.0)
            } else {
                (radius * libm::sin(angle), centre[1] + radius * libm::cos(angle))
            };
            at_y(&circle(CRATER, r, CRATER_SIDES), y)
        })
        .collect()
}

/// The workpiece's facets.
pub(super) fn triangles() -> Triangles {
    let plate = rectangle(PLATE[0], PLATE[1]);
    let (front, back) = (at_y(&plate, 0.0), at_y(&plate, THICKNESS));
    let crater = crater_rings();
    let lug = circle(LUG, LUG_RADIUS, 128);
    let (lug_foot, lug_top) = (at_y(&lug, 0.0), at_y(&lug, -LUG_HEIGHT));
    let block = rectangle(BLOCK[0], BLOCK[1]);
    let (block_foot, block_top) = (at_y(&block, 0.0), at_y(&block, -BLOCK_HEIGHT));
    let holes: Vec<[Vec<Point>; 2]> = HOLES
        .iter()
        .map(|(centre, radius)| {
            let bore = circle(*centre, *radius, 72);
            [at_y(&bore, 0.0), at_y(&bore, THICKNESS)]
        })
        .collect();

    let mut shell = Shell::new();
    let mut openings: Vec<&[Point]> = vec![&crater[0], &lug_foot, &block_foot];
    openings.extend(holes.iter().map(|h| h[0].as_slice()));
    shell.face(Facing::MinusY, &front, &openings);

    shell.tube(&crater);
    if let Some(last) = crater.last() {
        shell.fan(last, [CRATER[0], CRATER_DEPTH, CRATER[1]]);
    }
    shell.face(Facing::MinusY, &lug_top, &[]);
    shell.wall(&lug_foot, &lug_top, 4);
    shell.face(Facing::MinusY, &block_top, &[]);
    shell.strip(&block_foot, &block_top);
    for [at_front, at_back] in &holes {
        shell.wall(at_front, at_back, 6);
    }
    let exits: Vec<&[Point]> = holes.iter().map(|h| h[1].as_slice()).collect();
    shell.face(Facing::PlusY, &back, &exits);
    shell.strip(&back, &front);
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{centroid, closed, dot, first_hit, normal, sub, surfaces, unit};
    use super::super::outline::radians;
    use super::*;
    use std::f64::consts::PI;

    fn polygon(radius: f64, sides: usize) -> f64 {
        0.5 * sides as f64 * radius * radius * libm::sin(2.0 * PI / sides as f64)
    }

    #[test]
    fn size_volume_and_facets() {
        let part = triangles();
        let skin = closed("workpiece", &part);
        assert!((5_000..15_000).contains(&part.len()), "{} facets", part.len());
        assert_eq!((skin.low, skin.high), ([-50.0, -16.0, 0.0], [50.0, 12.0, 80.0]));
        // Four through-holes make the genus 4.
        assert_eq!(skin.euler(), 2 - 2 * 4);
        let cap = PI * CRATER_DEPTH * CRATER_DEPTH * (crater_radius() - CRATER_DEPTH / 3.0);
        let bores: f64 = HOLES.iter().map(|(_, r)| THICKNESS * polygon(*r, 72)).sum();
        let expected =
            100.0 * 80.0 * 12.0 + 26.0 * 26.0 * BLOCK_HEIGHT + LUG_HEIGHT * polygon(LUG_RADIUS, 128) - bores - cap;
        assert!((skin.volume - expected).abs() < 0.004 * cap, "{} {expected}", skin.volume);
    }

    #[test]
    fn eighteen_surfaces_in_the_order_of_the_header() {
        let part = triangles();
        let all = surfaces(&part, 20.0);
        assert_eq!(all.len(), 18);
        let area = |k: usize| -> f64 {
            let double = |i: &usize| {
                let n = super::super::check::cross(sub(part[*i][1], part[*i][0]), sub(part[*i][2], part[*i][0]));
                dot(n, n).sqrt() / 2.0
            };
            all[k - 1].iter().map(double).sum()
        };
        let crater = 2.0 * PI * crater_radius() * CRATER_DEPTH;
        assert!((area(2) / crater - 1.0).abs() < 3e-3, "{} {crater}", area(2));
        assert!((area(3) - polygon(LUG_RADIUS, 128)).abs() < 1e-2);
        assert!((area(5) - 676.0).abs() < 1e-2);
        for (k, (_, radius)) in HOLES.iter().enumerate() {
            assert!((area(10 + k) / (2.0 * PI * radius * THICKNESS) - 1.0).abs() < 2e-3);
        }
    }

    #[test]
    fn the_rim_is_a_crease_all_round() {
        let part = triangles();
        let all = surfaces(&part, 20.0);
        let rim = |i: &&usize| part[**i].iter().filter(|p| p[1] == 0.0).count() == 2;
        let at_rim: Vec<&usize> = all[1].iter().filter(rim).collect();
        assert_eq!(at_rim.len(), CRATER_SIDES);
        for i in at_rim {
            let angle = libm::acos(-normal(&part[*i])[1]) * 180.0 / PI;
            assert!((60.0..67.0).contains(&angle), "{angle}°");
        }
    }

    /// P1 Fig. 9: the block meets the beam along the crater's normal, at D = 20 mm too, and a tilt
    /// in the section plane away from the block frees every point.
    #[test]
    fn the_block_shades_the_far_slope_and_a_tilt_frees_it() {
        let part = triangles();
        let all = surfaces(&part, 20.0);
        let block: Vec<usize> = (5..=9).flat_map(|k| all[k - 1].iter().copied()).collect();
        let (mut tried, mut shaded, mut within_20, mut largest) = (0, 0, 0, 0.0f64);
        for i in all[1].iter().step_by(7) {
            let p = centroid(&part[*i]);
            let n = unit(sub(crater_centre(), p));
            tried += 1;
            let Some((along, facet)) = first_hit(&part, p, n, 0.05) else {
                continue;
            };
            assert!(block.contains(&facet), "shaded by facet {facet} at {p:?}");
            assert!(p[0] > CRATER[0], "only the slope that looks at the block");
            shaded += 1;
            within_20 += usize::from(along < 20.0);
            let free = (1..=40).map(f64::from).find(|tilt| {
                let (s, c) = (libm::sin(radians(*tilt)), libm::cos(radians(*tilt)));
                // About the axis z, from −x over −y towards +x.
                let a = [n[0] * c - n[1] * s, n[0] * s + n[1] * c, n[2]];
                first_hit(&part, p, a, 0.05).is_none()
            });
            largest = largest.max(free.expect("free within 40°"));
        }
        println!("{tried} tried, {shaded} shaded, {within_20} within 20 mm, tilt {largest}°");
        assert!(shaded * 10 > tried && within_20 * 40 > tried, "{tried} {shaded} {within_20}");
        assert!(largest <= 30.0, "{largest}°");
    }
}
