//! The levels of an image counted, and the threshold from them (P4, 3): a normal curve is laid on the main mode, the
//! skin, and what lies some standard deviations above it is none of it.
//!
//! The deviation is read from the lower flank alone, since what is looked for lies in the upper one: a normal curve is
//! down to half at √(2 ln 2) = 1.177 deviations.

use crate::weld::raster::GreyImage;

/// Number of levels.
pub const LEVELS: usize = 256;
/// The counts are smoothed over so many levels.
const SMOOTHED_OVER: usize = 5;
/// What a mean over five levels, and counting by whole levels, add to a variance: (5² − 1) / 12 + 1 / 12.
const ADDED_VARIANCE: f64 = 25.0 / 12.0;
/// Deviations from the middle of a normal curve to half of its height.
const HALF_HEIGHT: f64 = 1.177_410_022_515_474_7;
/// The least deviation, levels: of an image without noise.
const LEAST_SIGMA: f64 = 0.5;

/// The levels of an image, and the normal curve of its main mode.
#[derive(Clone, Debug, PartialEq)]
pub struct GreyHistogram {
    /// Pixels of each level, 0 to 255.
    pub counts: Vec<u32>,
    /// The counts smoothed: what the mode is read from.
    pub smoothed: Vec<f64>,
    /// The main mode: the level that most pixels have.
    pub mode: f64,
    /// Standard deviation of the main mode, levels.
    pub sigma: f64,
    /// The mode and so many deviations, as asked for.
    pub threshold: f64,
}

impl GreyHistogram {
    /// Of an image; the threshold lies `sigmas` deviations above the mode.
    pub fn of(image: &GreyImage, sigmas: f64) -> GreyHistogram {
        let mut counts = vec![0u32; LEVELS];
        for level in &image.values {
            // The cast takes what is below 0 or no number as 0.
            if let Some(count) = counts.get_mut(((level + 0.5) as usize).min(LEVELS - 1)) {
                *count += 1;
            }
        }
        let smoothed = smoothed(&counts);
        // The lower of two that are alike, so that the flank below it is the nearer one.
        let peak = (0..LEVELS).fold(0, |best, k| if smoothed[k] > smoothed[best] { k } else { best });
        let mode = middle_of_mode(&counts, peak);
        let top = smoothed[peak];
        let at_half = (0..peak).rev().find(|k| smoothed[*k] < 0.5 * top);
        let to_half = at_half.map_or(mode, |k| {
            let share = (0.5 * top - smoothed[k]) / (smoothed[k + 1] - smoothed[k]);
            mode - (k as f64 + share)
        });
        let spread = to_half / HALF_HEIGHT;
        let sigma = (spread * spread - ADDED_VARIANCE).max(LEAST_SIGMA * LEAST_SIGMA).sqrt();
        GreyHistogram { counts, smoothed, mode, sigma, threshold: mode + sigmas * sigma }
    }
}

/// The mean level of what the greatest smoothed count was counted over.
fn middle_of_mode(counts: &[u32], peak: usize) -> f64 {
    let half = SMOOTHED_OVER / 2;
    let near = counts.iter().enumerate().take(peak + half + 1).skip(peak.saturating_sub(half));
    let (sum, count) = near.fold((0.0, 0.0), |(s, n), (k, c)| (s + k as f64 * f64::from(*c), n + f64::from(*c)));
    if count > 0.0 { sum / count } else { peak as f64 }
}

fn smoothed(counts: &[u32]) -> Vec<f64> {
    let half = SMOOTHED_OVER / 2;
    let mean = |k: usize| {
        let window = counts.get(k.saturating_sub(half)..(k + half + 1).min(counts.len())).unwrap_or_default();
        window.iter().map(|c| f64::from(*c)).sum::<f64>() / SMOOTHED_OVER as f64
    };
    (0..counts.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::FixedNumbers;
    use crate::weld::raster::Raster;

    /// Levels of a normal distribution, and a fifth of the pixels bright.
    fn levels(mean: f64, sigma: f64) -> GreyImage {
        let mut numbers = FixedNumbers::new(5);
        let value = |i: usize| {
            if i.is_multiple_of(5) {
                170.0 + 10.0 * numbers.normal_vector().x
            } else {
                mean + sigma * numbers.normal_vector().x
            }
        };
        Raster { width: 400, height: 300, values: (0..120_000).map(value).map(|x| x as f32).collect() }
    }

    #[test]
    fn the_curve_of_the_skin_is_found_beside_a_bright_fifth() {
        for (mean, sigma) in [(100.0, 3.0), (80.0, 8.0), (110.0, 14.0)] {
            let found = GreyHistogram::of(&levels(mean, sigma), 4.0);
            assert!((found.mode - mean).abs() <= 0.15 * sigma + 0.5, "{mean} {sigma}: {}", found.mode);
            assert!((found.sigma / sigma - 1.0).abs() < 0.12, "{mean} {sigma}: {}", found.sigma);
            assert_eq!(found.threshold, found.mode + 4.0 * found.sigma);
            assert_eq!(found.counts.iter().sum::<u32>(), 120_000);
        }
    }

    #[test]
    fn one_level_has_the_least_deviation() {
        for level in [0.0, 100.0, 255.0, f32::NAN] {
            let found = GreyHistogram::of(&Raster::filled(7, 5, level), 4.0);
            assert!(found.sigma >= LEAST_SIGMA && found.sigma < 3.0 && found.threshold.is_finite(), "{found:?}");
        }
    }
}
