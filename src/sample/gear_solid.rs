//! A helical gear of any number of facets, for benches (10 k, 100 k, 1 M): size, not shape, matters.
//!
//! Teeth with flat flanks, bore, plane ends; width 40, root radius 40, tip radius 46, bore radius 12
//! mm, turned by 25° over the width. Four surfaces per tooth (root, two flanks, tip land), two ends
//! and the bore at 20°. The teeth of the sample `worm_gear` are another matter: see there.

use super::outline::radians;
use super::shell::{Point, Shell, Triangles};

const WIDTH: f64 = 40.0;
const BORE: f64 = 12.0;
const ROOT: f64 = 40.0;
const TIP: f64 = 46.0;
const TURN_DEG: f64 = 25.0;
/// Corners of a tooth in shares of the pitch and radius: root, rising flank, tip, falling flank, root.
const TOOTH: [(f64, f64); 6] = [(0.0, ROOT), (0.22, ROOT), (0.40, TIP), (0.66, TIP), (0.84, ROOT), (1.0, ROOT)];

/// The gear: `teeth` teeth, `k` points on a flank and on a tip (half as many on either part of the
/// root), `layers` rows along z, `caprings` rings on an end.
///
/// Facets: 4·teeth·(3·k + 2·max(k/2, 1))·(layers + caprings). So (14, 4, 8, 3) makes 9 856,
/// (40, 8, 15, 4) 97 280, and (40, 24, 54, 11) 998 400.
pub fn helical_gear(teeth: usize, k: usize, layers: usize, caprings: usize) -> Triangles {
    let outline = outline(teeth, k);
    // A row of points at height z, drawn in from the outline (0) to the bore (1).
    let row = |z: f64, inwards: f64| -> Vec<Point> {
        let turn = radians(TURN_DEG) * z / WIDTH;
        let place = |(angle, radius): &(f64, f64)| {
            let r = if inwards == 1.0 { BORE } else { radius + inwards * (BORE - radius) };
            [r * libm::cos(angle + turn), r * libm::sin(angle + turn), z]
        };
        outline.iter().map(place).collect()
    };
    let height = |i: usize| {
        if i == layers { WIDTH } else { WIDTH * i as f64 / layers as f64 }
    };
    let inwards = |i: usize| {
        if i == caprings { 1.0 } else { i as f64 / caprings as f64 }
    };

    let mut shell = Shell::new();
    shell.tube(&(0..=layers).map(|i| row(height(i), 0.0)).collect::<Vec<_>>());
    shell.tube(&(0..=layers).rev().map(|i| row(height(i), 1.0)).collect::<Vec<_>>());
    shell.tube(&(0..=caprings).rev().map(|i| row(0.0, inwards(i))).collect::<Vec<_>>());
    shell.tube(&(0..=caprings).map(|i| row(WIDTH, inwards(i))).collect::<Vec<_>>());
    shell.into_triangles()
}

/// The outline as (angle in radians, radius in mm), counter-clockwise.
fn outline(teeth: usize, k: usize) -> Vec<(f64, f64)> {
    let pitch = radians(360.0 / teeth as f64);
    let mut points = Vec::new();
    for tooth in 0..teeth {
        for (s, pair) in TOOTH.windows(2).enumerate() {
            let n = if s == 0 || s == 4 { (k / 2).max(1) } else { k };
            for i in 0..n {
                let f = i as f64 / n as f64;
                let share = pair[0].0 + f * (pair[1].0 - pair[0].0);
                let radius = pair[0].1 + f * (pair[1].1 - pair[0].1);
                points.push((pitch * (tooth as f64 + share), radius));
            }
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::super::check::{Skin, closed, surfaces};
    use super::*;

    #[test]
    fn counts_surfaces_and_genus() {
        let part = helical_gear(14, 4, 8, 3);
        let skin = closed("helical_gear", &part);
        assert_eq!((skin.facets, skin.euler()), (9_856, 0));
        assert_eq!(surfaces(&part, 20.0).len(), 4 * 14 + 3);
        assert_eq!(helical_gear(5, 1, 1, 1).len(), 4 * 5 * 5 * 2);
    }

    #[test]
    fn the_large_one_welds_too() {
        let part = helical_gear(40, 8, 15, 4);
        assert_eq!(part.len(), 97_280);
        Skin::weld(&part).assert_closed("helical_gear 100k", 1e-3);
        assert_eq!(surfaces(&part, 20.0).len(), 163);
    }
}
