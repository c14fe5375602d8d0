//! Sample `acetabular_cup`: the open sheet of P2 (3656 facets there, 3655 here).
//!
//! A hemisphere Ø46 on a cylindrical skirt of 5 mm, axis z through the origin. The open rim lies at
//! the bottom, z = 0; the pole is on top, z = 28. One sheet without thickness, normals outwards: it
//! is *not* closed, V − E + F = 1. 85 meridians and 22 rows: a plane between two rings cuts 170
//! edges, so five planes give the 850 points of P2.

use super::outline::{radians, revolved};
use super::shell::{Shell, Triangles};

/// Radius of sphere and skirt, mm.
const RADIUS: f64 = 23.0;
/// Height of the skirt, mm.
const SKIRT: f64 = 5.0;
const MERIDIANS: usize = 85;
const SKIRT_ROWS: usize = 3;
const SPHERE_ROWS: usize = 19;

/// The cup's facets, from the rim upwards.
pub(super) fn triangles() -> Triangles {
    let mut profile: Vec<[f64; 2]> = Vec::new();
    for k in 0..SKIRT_ROWS {
        profile.push([RADIUS, SKIRT * k as f64 / SKIRT_ROWS as f64]);
    }
    for k in 0..SPHERE_ROWS {
        let latitude = radians(90.0 * k as f64 / SPHERE_ROWS as f64);
        profile.push([RADIUS * libm::cos(latitude), SKIRT + RADIUS * libm::sin(latitude)]);
    }
    let rings = revolved(&profile, MERIDIANS);
    let mut shell = Shell::new();
    shell.tube(&rings);
    if let Some(last) = rings.last() {
        shell.fan(last, [0.0, 0.0, SKIRT + RADIUS]);
    }
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{Skin, surfaces};
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn one_open_sheet_of_the_size_of_p2() {
        let cup = triangles();
        let skin = Skin::weld(&cup);
        assert_eq!(cup.len(), 3655);
        assert_eq!(skin.euler(), 1);
        assert_eq!((skin.open_edges, skin.bad_edges), (MERIDIANS, 0));
        assert_eq!(surfaces(&cup, 20.0).len(), 1);
        assert_eq!(skin.low, [-23.0f64.min(skin.low[0].abs()), skin.low[1], 0.0]);
        assert_eq!(skin.high, [23.0, skin.high[1], 28.0]);
        let exact = 2.0 * PI * RADIUS * (RADIUS + SKIRT);
        assert!((skin.area / exact - 1.0).abs() < 2e-3, "{}", skin.area);
    }

    #[test]
    fn normals_look_outwards() {
        for t in triangles() {
            let n = super::super::check::normal(&t);
            let c = super::super::check::centroid(&t);
            let from_centre = [c[0], c[1], (c[2] - SKIRT).max(0.0)];
            assert!(super::super::check::dot(n, from_centre) > 0.99 * RADIUS * 0.99);
        }
    }

    #[test]
    fn five_planes_cut_850_edges() {
        let cup = triangles();
        let crossed = |z: f64| {
            let facets = cup.iter().filter(|t| {
                let above = t.iter().filter(|p| p[2] >= z).count();
                above == 1 || above == 2
            });
            facets.count() // on a closed line as many points as facets
        };
        assert_eq!([2.0, 8.0, 14.0, 20.0, 26.0].map(crossed).iter().sum::<usize>(), 850);
    }
}
