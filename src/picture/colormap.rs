//! Colours for numbers: along any row of colours, and viridis, which is even to the eye, to colour-blind eyes, and in
//! grey.

use super::palette::{Rgb, mixed};

/// Viridis at eighths of its way (Smith and van der Walt, CC0).
const VIRIDIS: [Rgb; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

/// The colour at a share of the way, 0 to 1; what is beyond takes the end's.
pub fn viridis(share: f64) -> Rgb {
    along(&VIRIDIS, share)
}

/// The colour at a share of the way through colours at equal distances; what is beyond takes the end's, and so does NaN
/// the first.
pub fn along<const N: usize>(colors: &[Rgb; N], share: f64) -> Rgb {
    let last = N - 1;
    let at = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) * last as f64 };
    let k = at as usize;
    mixed(colors[k], colors[(k + 1).min(last)], (at - k as f64) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_from_dark_to_light() {
        let grey = |c: Rgb| 0.2126 * f64::from(c[0]) + 0.7152 * f64::from(c[1]) + 0.0722 * f64::from(c[2]);
        let greys: Vec<f64> = (0..=64).map(|i| grey(viridis(f64::from(i) / 64.0))).collect();
        assert!(greys.windows(2).all(|w| w[1] > w[0]));
        assert_eq!((viridis(-1.0), viridis(2.0), viridis(f64::NAN)), (VIRIDIS[0], VIRIDIS[8], VIRIDIS[0]));
    }
}
