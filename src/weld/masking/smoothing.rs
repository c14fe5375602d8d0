//! Smoothing by a normal curve, along rows and then along columns; beyond the border the border's pixels go on.

use crate::weld::raster::{GreyImage, Raster};

/// The curve is cut off at so many standard deviations, where it is 0.011 of its height.
const REACH: f64 = 3.0;
/// The widest smoothing, pixels: beyond it an image is one level.
const MOST_PX: f64 = 500.0;

/// The image smoothed by a standard deviation in pixels; unchanged at 0 or less.
pub fn smoothed(image: &GreyImage, deviation_px: f64) -> GreyImage {
    if !(deviation_px > 0.0 && image.is_whole() && !image.is_empty()) {
        return image.clone();
    }
    let weights = weights(deviation_px.min(MOST_PX));
    let (width, height, reach) = (image.width, image.height, weights.len() - 1);
    let mut along = Vec::with_capacity(image.values.len());
    let mut padded = Vec::with_capacity(width + 2 * reach);
    for row in image.values.chunks_exact(width) {
        let [first, last] = [0, width - 1].map(|u| row.get(u).copied().unwrap_or_default());
        padded.clear();
        padded.resize(reach, first);
        padded.extend_from_slice(row);
        padded.resize(width + 2 * reach, last);
        let start = along.len();
        along.resize(start + width, 0.0f32);
        sum_into(&mut along[start..], |k| [&padded[reach - k..][..width], &padded[reach + k..][..width]], &weights);
    }
    let row = |v: usize| &along[v * width..][..width];
    let mut values = vec![0.0f32; along.len()];
    for (v, sum) in values.chunks_exact_mut(width).enumerate() {
        sum_into(sum, |k| [row(v.saturating_sub(k)), row((v + k).min(height - 1))], &weights);
    }
    Raster { width, height, values }
}

/// Adds up pairs of rows, each with its weight.
fn sum_into<'r>(sum: &mut [f32], pair: impl Fn(usize) -> [&'r [f32]; 2], weights: &[f32]) {
    for (k, weight) in weights.iter().enumerate() {
        let [before, after] = pair(k);
        if k == 0 {
            sum.iter_mut().zip(before).for_each(|(s, x)| *s = weight * x);
        } else {
            sum.iter_mut().zip(before.iter().zip(after)).for_each(|(s, (x, y))| *s += weight * (x + y));
        }
    }
}

/// The curve from its middle on, of sum 1 over both sides.
fn weights(deviation_px: f64) -> Vec<f32> {
    let reach = (REACH * deviation_px).ceil().max(1.0) as usize;
    let raw: Vec<f64> =
        (0..=reach).map(|k| libm::exp(-0.5 * (k as f64 / deviation_px) * (k as f64 / deviation_px))).collect();
    let sum = 2.0 * raw.iter().sum::<f64>() - 1.0;
    raw.iter().map(|w| (w / sum) as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A single bright pixel becomes the curve; a level and a slope stay what they are.
    #[test]
    fn a_point_becomes_the_curve_and_a_slope_stays() {
        let mut point = Raster::filled(31, 31, 0.0f32);
        point.values[15 * 31 + 15] = 1000.0;
        let spread = smoothed(&point, 2.0);
        for ([u, v], level) in spread.pixels() {
            let [x, y] = [u, v].map(|c| c as f64 - 15.0);
            let exact = if x.abs().max(y.abs()) > 6.0 {
                0.0
            } else {
                1000.0 * libm::exp(-(x * x + y * y) / 8.0) / (8.0 * std::f64::consts::PI)
            };
            assert!((f64::from(*level) - exact).abs() < 0.25, "{u} {v} {level} {exact}");
        }
        assert!((spread.values.iter().sum::<f32>() - 1000.0).abs() < 1e-2);
        let slope =
            Raster::new(20, 9, (0..180).map(|i| (i % 20) as f32 + 3.0 * (i / 20) as f32).collect()).expect("180");
        let same = smoothed(&slope, 1.0);
        assert!(
            (3..17).all(|u| (3..6).all(|v| (same.at(u, v).expect("in") - slope.at(u, v).expect("in")).abs() < 1e-4))
        );
        assert_eq!((smoothed(&slope, 0.0), smoothed(&slope, f64::NAN)), (slope.clone(), slope));
    }
}
