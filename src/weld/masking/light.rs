//! Light evened out: the background is taken off, and 100 put in its place.
//!
//! The background is the median over a wide window, so that what fills less than half of it (bead, scratches) does not
//! count. It is worked out on the image shrunk to an eighth, by counting; smoothed; and enlarged again by cubics.

use super::smoothing::smoothed;
use crate::progress::{Cancelled, Progress};
use crate::weld::raster::{GreyImage, Raster};

/// The level that stands for the background.
pub const SKIN_LEVEL: f32 = 100.0;
/// Pixels of the image along a side of one of the shrunk image.
const SHRINK: usize = 8;
/// Levels are counted in steps of a quarter: a step in the background is less than the noise of any camera.
const STEPS: f32 = 4.0;
const BINS: usize = 1024;
/// Standard deviation of the background's smoothing, in pixels of the shrunk image: it rounds the median's steps.
const SMOOTHING: f64 = 1.5;

/// The image with even light. `window_px`: side of the median's window; 0 leaves the image as it is.
///
/// # Errors
/// [`Cancelled`].
pub fn evened(grey: &GreyImage, window_px: u32, progress: &Progress) -> Result<GreyImage, Cancelled> {
    if window_px == 0 || grey.is_empty() || !grey.is_whole() {
        return Ok(grey.clone());
    }
    let half = (window_px as usize / SHRINK) / 2;
    let background = smoothed(&median(&shrunk(grey), half, progress)?, SMOOTHING);
    progress.check()?;
    let mut values = grey.values.clone();
    let across: Vec<Cubic> = (0..grey.width).map(|u| Cubic::at(u, background.width)).collect();
    let mut between = vec![0.0f32; background.width];
    for (v, row) in values.chunks_exact_mut(grey.width).enumerate() {
        let down = Cubic::at(v, background.height);
        let rows = down.places.map(|k| background.row(k));
        for (u, mean) in between.iter_mut().enumerate() {
            *mean = (0..4).map(|k| down.weights[k] * rows[k].get(u).copied().unwrap_or_default()).sum();
        }
        for (level, cubic) in row.iter_mut().zip(&across) {
            let under: f32 = (0..4).map(|k| cubic.weights[k] * between[cubic.places[k]]).sum();
            *level = (*level - under + SKIN_LEVEL).clamp(0.0, 255.0);
        }
    }
    Ok(Raster { values, ..*grey })
}

/// Means of blocks; the last of a row or column may be smaller.
fn shrunk(grey: &GreyImage) -> GreyImage {
    let (width, height) = (grey.width.div_ceil(SHRINK), grey.height.div_ceil(SHRINK));
    let mut values = Vec::with_capacity(width * height);
    for rows in grey.values.chunks(SHRINK * grey.width) {
        let mut sums = vec![0.0f32; width];
        for row in rows.chunks_exact(grey.width) {
            sums.iter_mut().zip(row.chunks(SHRINK)).for_each(|(sum, block)| *sum += block.iter().sum::<f32>());
        }
        let down = rows.len() / grey.width;
        let of = |(k, sum): (usize, &f32)| sum / (down * SHRINK.min(grey.width - k * SHRINK)) as f32;
        values.extend(sums.iter().enumerate().map(of));
    }
    Raster { width, height, values }
}

/// Counted levels of a window that moves, and where its median lies (Huang, Yang and Tang 1979).
struct Counted {
    counts: [u32; BINS],
    total: u32,
    bin: usize,
    /// How many lie in bins below that.
    below: u32,
}

impl Counted {
    fn new() -> Counted {
        Counted { counts: [0; BINS], total: 0, bin: 0, below: 0 }
    }

    fn add(&mut self, bin: u16) {
        self.counts[usize::from(bin)] += 1;
        self.total += 1;
        self.below += u32::from(usize::from(bin) < self.bin);
    }

    fn take(&mut self, bin: u16) {
        self.counts[usize::from(bin)] -= 1;
        self.total -= 1;
        self.below -= u32::from(usize::from(bin) < self.bin);
    }

    fn median(&mut self) -> f32 {
        let half = self.total / 2;
        while self.below > half && self.bin > 0 {
            self.bin -= 1;
            self.below -= self.counts[self.bin];
        }
        while self.bin + 1 < BINS && self.below + self.counts[self.bin] <= half {
            self.below += self.counts[self.bin];
            self.bin += 1;
        }
        self.bin as f32 / STEPS
    }
}

/// The median over windows that reach `half` pixels to each side; at the border over what there is.
fn median(image: &GreyImage, half: usize, progress: &Progress) -> Result<GreyImage, Cancelled> {
    // Below 0 and what is no number become 0 in the cast, so each is a bin.
    let bins: Vec<u16> = image.values.iter().map(|x| ((x * STEPS + 0.5) as u16).min(BINS as u16 - 1)).collect();
    let (width, height) = (image.width, image.height);
    let mut values = Vec::with_capacity(bins.len());
    for v in 0..height {
        progress.check()?;
        let rows = v.saturating_sub(half)..(v + half + 1).min(height);
        let column = |u: usize| rows.clone().map(move |r| r * width + u);
        let mut counted = Counted::new();
        (0..half.min(width)).flat_map(column).for_each(|i| counted.add(bins[i]));
        for u in 0..width {
            if u + half < width {
                column(u + half).for_each(|i| counted.add(bins[i]));
            }
            if u > half {
                column(u - half - 1).for_each(|i| counted.take(bins[i]));
            }
            values.push(counted.median());
        }
    }
    Ok(Raster { width, height, values })
}

/// Four places of the shrunk image and their weights, for one pixel (Keys 1981, a = −1/2).
struct Cubic {
    places: [usize; 4],
    weights: [f32; 4],
}

impl Cubic {
    fn at(pixel: usize, count: usize) -> Cubic {
        let place = (pixel as f32 + 0.5) / SHRINK as f32 - 0.5;
        let first = place.floor();
        let t = place - first;
        let places = [-1.0, 0.0, 1.0, 2.0].map(|k| ((first + k).max(0.0) as usize).min(count.saturating_sub(1)));
        let weights = [
            t * (-0.5 + t * (1.0 - 0.5 * t)),
            1.0 + t * t * (-2.5 + 1.5 * t),
            t * (0.5 + t * (2.0 - 1.5 * t)),
            t * t * (-0.5 + 0.5 * t),
        ];
        Cubic { places, weights }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_that_of_sorting() {
        let mut state = 1u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 22) as f32 / STEPS
        };
        let image = Raster::new(13, 9, (0..117).map(|_| next()).collect()).expect("117");
        for half in [0usize, 1, 3, 20] {
            let fast = median(&image, half, &Progress::default()).expect("nobody cancels");
            for ([u, v], level) in fast.pixels() {
                let near = image.pixels().filter(|([a, b], _)| a.abs_diff(u) <= half && b.abs_diff(v) <= half);
                let mut window: Vec<f32> = near.map(|(_, x)| *x).collect();
                window.sort_by(f32::total_cmp);
                assert_eq!(*level, window[window.len() / 2], "{half} {u} {v}");
            }
        }
    }

    /// A slope of light goes, a narrow bright bar along it stays with its height. The bar is two blocks of
    /// the window's fifteen, so the median is the 0.58 quantile of the rest, 0.46 levels too high; a block is 0.4 levels.
    #[test]
    fn slopes_go_and_bars_stay() {
        let level = |u: usize, v: usize| 60.0 + 0.05 * v as f32 + if (152..168).contains(&u) { 40.0 } else { 0.0 };
        let grey = Raster::new(323, 241, (0..323 * 241).map(|i| level(i % 323, i / 323)).collect()).expect("whole");
        let even = evened(&grey, 120, &Progress::default()).expect("nobody cancels");
        for ([u, v], x) in even.pixels().filter(|([u, v], _)| (60..260).contains(u) && (60..180).contains(v)) {
            let exact = if (152..168).contains(&u) { 140.0 } else { 100.0 };
            assert!((x - exact).abs() < 0.8, "{u} {v} {x}");
        }
        assert_eq!(evened(&grey, 0, &Progress::default()), Ok(grey));
        for (width, height) in [(1, 1), (3, 2), (8, 8), (9, 1)] {
            let tiny = evened(&Raster::filled(width, height, 7.0), 248, &Progress::default()).expect("nobody cancels");
            assert!(tiny.values.iter().all(|x| (x - SKIN_LEVEL).abs() < 0.2) && tiny.is_whole());
        }
    }
}
