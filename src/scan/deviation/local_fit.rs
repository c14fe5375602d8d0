//! The level of some depths at a place, from those around it: a straight line in both directions, fitted with weights
//! that leave out what is far off in depth (Tukey's biweight) and fade with the distance (Epanechnikov's parabola:
//! with even weights up to the last point the level jumps from place to place as points come and go). A mean would tell the depth at the middle of the points instead,
//! and thrown at random 40 points have theirs a tenth of their radius off.

use crate::scan::{SIGMA_OF_MEDIAN, TUKEY, upper_median};

/// Weights are settled to a per cent of the noise after this many rounds.
const ROUNDS: usize = 3;
/// How far the slope is followed, in radii of the points: their middle is nearer but at the rim of a scan. There a
/// slope followed all the way would double the noise.
const FOLLOWED: f64 = 0.35;

/// A depth and where it stands on the surface, told from the place that is asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// Along two directions on the surface, mm.
    pub(super) at: [f64; 2],
    /// mm.
    pub(super) depth: f64,
}

/// The depth at the place itself; 0 without samples.
pub(super) fn level(samples: &[Sample], room: &mut Vec<f64>) -> f64 {
    let radius2 = samples.iter().map(|s| s.at[0] * s.at[0] + s.at[1] * s.at[1]).fold(0.0, f64::max);
    let reach2 = 1.02 * radius2 + f64::MIN_POSITIVE;
    let mut line = [median(room, samples.iter().map(|s| s.depth)), 0.0, 0.0];
    let mut level = line[0];
    for _ in 0..ROUNDS {
        let off = |s: &Sample| s.depth - line[0] - line[1] * s.at[0] - line[2] * s.at[1];
        let width = TUKEY * SIGMA_OF_MEDIAN * median(room, samples.iter().map(|s| off(s).abs()));
        if width.is_nan() || width <= 0.0 {
            break;
        }
        let weight = |s: &Sample| {
            let share = off(s) / width;
            let near = 1.0 - (s.at[0] * s.at[0] + s.at[1] * s.at[1]) / reach2;
            if share.abs() < 1.0 { near * (1.0 - share * share) * (1.0 - share * share) } else { 0.0 }
        };
        let sums = samples.iter().fold([0.0; 9], |mut sums, s| {
            let (w, [x, y], d) = (weight(s), s.at, s.depth);
            for (sum, term) in sums.iter_mut().zip([1.0, x, y, d, x * x, x * y, y * y, x * d, y * d]) {
                *sum += w * term;
            }
            sums
        });
        let share = 1.0 / sums[0];
        let (x, y, d) = (sums[1] * share, sums[2] * share, sums[3] * share);
        let (xx, xy, yy) = (sums[4] * share - x * x, sums[5] * share - x * y, sums[6] * share - y * y);
        let (xd, yd) = (sums[7] * share - x * d, sums[8] * share - y * d);
        // Points on one line tell no slope across it.
        let even = 1e-3 * radius2;
        let determinant = (xx + even) * (yy + even) - xy * xy;
        let slope = [((yy + even) * xd - xy * yd) / determinant, ((xx + even) * yd - xy * xd) / determinant];
        line = [d - slope[0] * x - slope[1] * y, slope[0], slope[1]];
        let far = ((x * x + y * y) / radius2.max(f64::MIN_POSITIVE)).sqrt();
        let followed = if far > FOLLOWED { FOLLOWED / far } else { 1.0 };
        level = d - (slope[0] * x + slope[1] * y) * followed;
    }
    level
}

/// The upper median; 0 without numbers.
fn median(room: &mut Vec<f64>, all: impl Iterator<Item = f64>) -> f64 {
    room.clear();
    room.extend(all);
    upper_median(room).unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A slope is told where the place is, whatever a sixth of the points say, and whatever side they stand on.
        #[test]
        fn a_slope_is_followed_and_strays_are_left_out(slope in prop::array::uniform2(-0.1..0.1f64), level_mm in -1.0..1.0f64,
                                                       shift in prop::array::uniform2(-0.2..0.2f64), stray in 2.0..50.0f64) {
            let mut samples = Vec::new();
            for k in 0..40 {
                // A sunflower of radius 1, so that the points are even.
                let (r, turn) = (((f64::from(k) + 0.5) / 40.0).sqrt(), 2.399_963 * f64::from(k));
                let at = [r * libm::cos(turn) + shift[0], r * libm::sin(turn) + shift[1]];
                let wobble = 1e-3 * f64::from(k % 7 - 3);
                let depth = level_mm + slope[0] * at[0] + slope[1] * at[1] + wobble;
                samples.push(Sample { at, depth: if k % 7 == 2 { depth + stray } else { depth } });
            }
            let found = level(&samples, &mut Vec::new());
            prop_assert!((found - level_mm).abs() < 2e-3, "{found} for {level_mm}");
        }
    }

    #[test]
    fn points_on_a_line_or_none_at_all_are_no_harm() {
        let at = |x: f64| Sample { at: [x, 0.0], depth: 0.2 + 0.1 * x };
        let found = level(&[at(-1.0), at(-0.5), at(0.5), at(1.0), at(0.1)], &mut Vec::new());
        assert!((found - 0.2).abs() < 1e-3, "{found}");
        assert_eq!(level(&[], &mut Vec::new()), 0.0);
        assert_eq!(level(&[at(0.0)], &mut Vec::new()), 0.2);
    }
}
