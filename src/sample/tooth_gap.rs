//! The section of a tooth gap of the sample `worm_gear`, and what its normals do (P1 Fig. 7, 8).
//!
//! What the normals do, with the gap's width W = 5.2 mm between the tips: a flank point less than
//! W·sin(44°)/2 = 1.8 mm below the tip is free, every lower one is shaded by the opposite flank, and
//! so are the sides of the root arc. The rays of the last free points left and right meet on the
//! centre line in O, and the gap is convex, so O sees all of it. Two things no smooth gap can avoid:
//! O lies *inside* the gap (1.0 mm below the tips), because the ray of a last free point just passes
//! the opposite tip; and the arc's middle (about ±32°) is free along its normal, so the shaded
//! points of a gap are two runs. The end rays of such a run both just pass the opposite tip, so they
//! meet near it: corrected by itself a run clears the tip by 0.07 mm if its ends lie 0.05 mm inside
//! the free parts, by 0.3 mm if 0.2 mm.

use super::outline::{Flat, on_circle, radians};

/// Number of teeth, and so of gaps.
pub(super) const TEETH: usize = 26;
/// Radius of the tips, mm.
pub(super) const TIP: f64 = 30.0;
/// Helix angle at the tips: how far the section turns along z.
const HELIX_DEG: f64 = 10.0;
/// Half the gap's width between the tips, mm; a flank's angle to the gap's centre line; the arc.
pub(super) const HALF_GAP: f64 = 2.6;
const FLANK_DEG: f64 = 22.0;
const ROOT_RADIUS: f64 = 0.86;
/// Chords on a flank and on the root arc.
pub(super) const FLANK_CHORDS: usize = 6;
pub(super) const ROOT_CHORDS: usize = 16;

/// Turn of the section per mm of height, radians.
pub(super) fn twist() -> f64 {
    libm::tan(radians(HELIX_DEG)) / TIP
}

/// Radius of the tip corners' height on the centre line, and of the root arc's centre, mm.
fn gap_radii() -> (f64, f64) {
    let corner = (TIP * TIP - HALF_GAP * HALF_GAP).sqrt();
    let apex = corner - HALF_GAP / libm::tan(radians(FLANK_DEG));
    (corner, apex + ROOT_RADIUS / libm::sin(radians(FLANK_DEG)))
}

/// A gap's section, (u across, v outwards), from the corner at −u over the root to the corner at +u.
pub(super) fn gap() -> Vec<Flat> {
    let (corner, centre) = gap_radii();
    // Where the arc ends, its radius stands square on the flank.
    let (from, to) = (180.0 + FLANK_DEG, 360.0 - FLANK_DEG);
    let foot = on_circle([0.0, centre], ROOT_RADIUS, from);
    let tip = [-HALF_GAP, corner];
    let mut left: Vec<Flat> = Vec::new();
    for k in 0..FLANK_CHORDS {
        let f = k as f64 / FLANK_CHORDS as f64;
        left.push([tip[0] + f * (foot[0] - tip[0]), tip[1] + f * (foot[1] - tip[1])]);
    }
    let mut points = left.clone();
    for k in 0..=ROOT_CHORDS {
        let angle = from + (to - from) * k as f64 / ROOT_CHORDS as f64;
        points.push(on_circle([0.0, centre], ROOT_RADIUS, angle));
    }
    points.extend(left.iter().rev().map(|p| [-p[0], p[1]]));
    points
}

/// (u, v) of gap `i` in the part's (x, y) at height z.
pub(super) fn placed(p: Flat, i: usize, z: f64) -> Flat {
    let angle = radians(360.0 * i as f64 / TEETH as f64) + twist() * z;
    let (s, c) = (libm::sin(angle), libm::cos(angle));
    [p[1] * c - p[0] * s, p[1] * s + p[0] * c]
}

#[cfg(test)]
mod tests {
    use super::super::check::{cross, dot, first_hit, normal, surfaces, unit};
    use super::super::shell::Point;
    use super::super::worm_gear::triangles;
    use super::*;
    use std::f64::consts::PI;

    /// A point of gap 0 in a section, with its normal in the part and in the section plane.
    struct GapPoint {
        p: Point,
        n: Point,
        flat: Point,
        /// Distance along the profile from the first tip corner, mm.
        way: f64,
    }

    /// Points of gap 0 at height z every 0.04 mm or so, from corner to corner.
    fn spots(z: f64) -> Vec<GapPoint> {
        let (corner, centre) = gap_radii();
        let a = radians(FLANK_DEG);
        let foot = on_circle([0.0, centre], ROOT_RADIUS, 180.0 + FLANK_DEG);
        let flank = libm::hypot(foot[0] + HALF_GAP, foot[1] - corner);
        let arc = ROOT_RADIUS * (PI - 2.0 * a);
        let total = 2.0 * flank + arc;
        let steps = 320;
        (1..steps)
            .map(|k| {
                let way = total * k as f64 / steps as f64;
                let mirrored = way > total / 2.0;
                let s = if mirrored { total - way } else { way };
                let (mut p, mut n) = if s < flank {
                    let f = s / flank;
                    let p = [-HALF_GAP + f * (foot[0] + HALF_GAP), corner + f * (foot[1] - corner)];
                    (p, [libm::cos(a), libm::sin(a)])
                } else {
                    let t = a + (s - flank) / ROOT_RADIUS;
                    let n = [libm::cos(t), libm::sin(t)];
                    ([-ROOT_RADIUS * n[0], centre - ROOT_RADIUS * n[1]], n)
                };
                if mirrored {
                    (p[0], n[0]) = (-p[0], -n[0]);
                }
                let (p, n) = (placed(p, 0, z), placed(n, 0, z));
                // The screw's surface: its normal leans along z by the twist.
                let lean = twist() * (p[1] * n[0] - p[0] * n[1]);
                GapPoint { p: [p[0], p[1], z], n: unit([n[0], n[1], lean]), flat: [n[0], n[1], 0.0], way }
            })
            .collect()
    }

    #[test]
    fn mesh_normals_are_those_of_the_spots() {
        let part = triangles();
        let all = surfaces(&part, 20.0);
        for spot in spots(9.3).iter().step_by(5) {
            let back = spot.n.map(|x| -x);
            let above = std::array::from_fn(|c| spot.p[c] + 0.3 * spot.n[c]);
            let (along, i) = first_hit(&part, above, back, 0.0).expect("the gap's own skin");
            assert!((along - 0.3).abs() < 0.01 && all[0].contains(&i), "{along}");
            assert!(dot(normal(&part[i]), spot.n) > 0.99);
        }
    }

    /// P1 Fig. 7: normals of the root and the lower flanks meet the opposite tooth, within 3 mm too;
    /// the intersection O of the last free rays left and right sees every point between.
    #[test]
    fn lower_flanks_are_shaded_and_seen_from_o() {
        let part = triangles();
        for z in [0.6, 9.3, 17.2] {
            let spots = spots(z);
            let hit = |p: Point, a: Point| first_hit(&part, p, a, 0.03).map(|h| h.0);
            let shaded: Vec<Option<f64>> = spots.iter().map(|s| hit(s.p, s.n).or(hit(s.p, s.flat))).collect();
            let first = shaded.iter().position(Option::is_some).expect("left flank is shaded");
            let last = shaded.iter().rposition(Option::is_some).expect("right flank is shaded");
            let within_3 = shaded.iter().flatten().filter(|t| **t < 3.0).count();
            assert!(first > 10 && last + 10 < spots.len() && within_3 > 60, "{first} {last} {within_3}");
            let free_middle = shaded[first..last].iter().filter(|s| s.is_none()).count();

            let (left, right) = (&spots[first - 1], &spots[last + 1]);
            let across = cross(left.flat, right.flat)[2];
            let to_right = [right.p[0] - left.p[0], right.p[1] - left.p[1], 0.0];
            let k = cross(to_right, right.flat)[2] / across;
            let o: Point = std::array::from_fn(|c| left.p[c] + k * left.flat[c]);
            let below_tips = gap_radii().0 - libm::hypot(o[0], o[1]);
            println!(
                "z {z}: free to {:.2} mm of {:.2} along the flank, {within_3} within 3 mm, {free_middle} free in the \
                 middle, O {below_tips:.2} mm below the tips",
                left.way,
                spots[spots.len() - 1].way,
            );
            assert!((0.5..1.5).contains(&below_tips));
            for spot in &spots[first..=last] {
                let to_o: Point = unit(std::array::from_fn(|c| o[c] - spot.p[c]));
                assert!(hit(spot.p, to_o).is_none(), "z {z}: not seen at {:.2} mm", spot.way);
            }
        }
    }
}
