//! Solids in which a beam along the normal meets the part: V-groove, blind hole, row of fins.
//!
//! Sizes in mm. For these the free angle of every point is known in closed form.

use super::outline::{at_z, circle, radians, rectangle};
use super::shell::{Facing, Point, Shell, Triangles};

/// Thickness left under the root of a [`v_groove`], mm.
pub const UNDER_GROOVE: f64 = 5.0;

/// A block with a symmetric V-groove along y (0 to `length`), open to +z: 24 facets.
///
/// The flanks stand `half_angle_deg` off the plane of symmetry x = 0 and meet in the root, `depth`
/// below the lands z = 0; the lands are `width_of_top_lands` wide each; `UNDER_GROOVE` is left
/// under the root.
pub fn v_groove(half_angle_deg: f64, depth: f64, width_of_top_lands: f64, length: f64) -> Triangles {
    let half = depth * libm::tan(radians(half_angle_deg));
    let edge = half + width_of_top_lands;
    let floor = -depth - UNDER_GROOVE;
    let section = [[-edge, floor], [edge, floor], [edge, 0.0], [half, 0.0], [0.0, -depth], [-half, 0.0], [-edge, 0.0]];
    let at = |y: f64| -> Vec<Point> { section.iter().map(|p| [p[0], y, p[1]]).collect() };
    let (front, back) = (at(0.0), at(length));
    let mut shell = Shell::new();
    shell.strip(&back, &front);
    // Fans from the root see the whole section, whatever the angles.
    for k in [5, 6, 0, 1, 2] {
        let next = (k + 1) % 7;
        shell.facet(front[4], front[k], front[next]);
        shell.facet(back[4], back[next], back[k]);
    }
    shell.into_triangles()
}

/// A cube of edge `block` about the z axis, z from −block to 0, with a round blind hole from the top,
/// flat bottom `depth` below it: 4·sides + 12 facets.
pub fn blind_hole(block: f64, hole_radius: f64, depth: f64, sides: usize) -> Triangles {
    let half = block / 2.0;
    let square = rectangle([-half, -half], [half, half]);
    let hole = circle([0.0, 0.0], hole_radius, sides);
    let (low, high) = (at_z(&square, -block), at_z(&square, 0.0));
    let (mouth, bottom) = (at_z(&hole, 0.0), at_z(&hole, -depth));
    let mut shell = Shell::new();
    shell.face(Facing::PlusZ, &high, &[&mouth]);
    shell.strip(&mouth, &bottom);
    shell.face(Facing::PlusZ, &bottom, &[]);
    shell.strip(&low, &high);
    shell.face(Facing::MinusZ, &low, &[]);
    shell.into_triangles()
}

/// A block with `count` upright fins along y (0 to `length`), the outer fins flush with its sides.
///
/// Fins are `thickness` wide and `height` high, `gap` apart, from x = 0 on; the floor between them is
/// z = 0, and the block under it is `base` thick. 16·count − 4 facets.
pub fn fin_row(count: usize, thickness: f64, gap: f64, height: f64, length: f64, base: f64) -> Triangles {
    let pitch = thickness + gap;
    let width = count as f64 * pitch - gap;
    // From the lower left corner counter-clockwise: floor below, then the comb from right to left.
    // The outer fins' sides run down to the bottom without a corner at the floor's height.
    let mut section = vec![[0.0, -base], [width, -base]];
    for k in (0..count).rev() {
        let (left, right) = (k as f64 * pitch, k as f64 * pitch + thickness);
        let foot = |x: f64| [x, 0.0];
        if k + 1 < count {
            section.push(foot(right));
        }
        section.push([if k + 1 == count { width } else { right }, height]);
        section.push([left, height]);
        if k > 0 {
            section.push(foot(left));
        }
    }
    let at = |y: f64| -> Vec<Point> { section.iter().map(|p| [p[0], y, p[1]]).collect() };
    let (front, back) = (at(0.0), at(length));
    let mut shell = Shell::new();
    shell.strip(&back, &front);
    let mut cap = |a: usize, b: usize, c: usize| {
        shell.facet(front[a], front[b], front[c]);
        shell.facet(back[a], back[c], back[b]);
    };
    // By hand, not by earcut: the feet of all fins lie on one line, and earcut would skip some.
    let n = section.len();
    if count == 1 {
        cap(0, 1, 2);
        cap(0, 2, 3);
    } else {
        // The outer fins have one foot each; between them the corners come in fours per fin.
        cap(1, 2, 3);
        cap(1, 3, 4);
        for k in 0..count - 2 {
            let right_foot = 5 + 4 * k;
            cap(right_foot, right_foot + 1, right_foot + 2);
            cap(right_foot, right_foot + 2, right_foot + 3);
        }
        cap(n - 3, n - 2, n - 1);
        cap(n - 3, n - 1, 0);
        // The block under the floor, a fan from the lower right corner over all feet.
        let feet: Vec<usize> = (4..n - 2).filter(|i| section[*i][1] == 0.0).collect();
        for pair in feet.windows(2) {
            cap(1, pair[0], pair[1]);
        }
        cap(1, n - 3, 0);
    }
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, first_hit, surfaces};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn groove_has_the_volume_of_its_section() {
        for angle in [10.0, 30.0, 45.0, 65.0] {
            let part = v_groove(angle, 8.0, 6.0, 40.0);
            let skin = closed("v_groove", &part);
            let half = 8.0 * libm::tan(radians(angle));
            let section = 2.0 * (half + 6.0) * 13.0 - half * 8.0;
            assert_eq!(skin.facets, 24);
            assert!((skin.volume / (section * 40.0) - 1.0).abs() < 1e-6);
            assert_eq!(surfaces(&part, 20.0).len(), 9);
        }
    }

    #[test]
    fn groove_shades_its_lower_flanks() {
        // Free from the lands down by W·sin(2β)/2, W the width on top: here to 4 mm.
        let part = v_groove(30.0, 8.0, 6.0, 40.0);
        let (s, c) = (libm::sin(radians(30.0)), libm::cos(radians(30.0)));
        let free = |down: f64| {
            let x = -(8.0 - down) * libm::tan(radians(30.0));
            first_hit(&part, [x, 17.3, -down], [c, 0.0, s], 1e-3).is_none()
        };
        assert!(free(3.9) && !free(4.1));
    }

    #[test]
    fn hole_and_block() {
        let part = blind_hole(30.0, 5.0, 12.0, 64);
        let skin = closed("blind_hole", &part);
        let circle = 0.5 * 64.0 * 25.0 * libm::sin(2.0 * PI / 64.0);
        assert!((skin.volume / (27_000.0 - 12.0 * circle) - 1.0).abs() < 1e-6);
        assert_eq!(surfaces(&part, 20.0).len(), 8);
        assert_eq!(skin.facets, 4 * 64 + 12);
    }

    #[test]
    fn fins_for_any_count() {
        for count in 1..6 {
            let part = fin_row(count, 2.0, 4.0, 15.0, 50.0, 7.0);
            let skin = closed("fin_row", &part);
            let n = count as f64;
            let section = (6.0 * n - 4.0) * 7.0 + 2.0 * n * 15.0;
            assert!((skin.volume / (section * 50.0) - 1.0).abs() < 1e-6, "{count}");
            assert_eq!(skin.facets, 16 * count - 4, "{count}");
            assert_eq!(surfaces(&part, 20.0).len(), 4 * count + 2, "{count}");
        }
    }
}
