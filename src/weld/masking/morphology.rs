//! Opening and closing of a mask by discs: specks and scratches go, small holes close (P4, 3).
//!
//! A disc is all pixels within half of its diameter of its middle. A pixel stays in erosion where each row of the disc
//! about it is filled; how far to both sides each row is filled around a pixel is counted once, so a disc costs one
//! comparison a row and pixel. Beyond the border nothing is known: it neither takes away nor adds.

use crate::progress::{Cancelled, Progress};
use crate::weld::raster::{Mask, Raster};

/// Eroded, then dilated: what no disc fits into goes.
///
/// # Errors
/// [`Cancelled`].
pub fn opened(mask: &Mask, diameter_px: u32, progress: &Progress) -> Result<Mask, Cancelled> {
    dilated(&eroded(mask, diameter_px, progress)?, diameter_px, progress)
}

/// Dilated, then eroded: gaps that no disc fits into are filled.
///
/// # Errors
/// [`Cancelled`].
pub fn closed(mask: &Mask, diameter_px: u32, progress: &Progress) -> Result<Mask, Cancelled> {
    eroded(&dilated(mask, diameter_px, progress)?, diameter_px, progress)
}

/// Pixels within a disc's radius of the mask.
///
/// # Errors
/// [`Cancelled`].
pub fn dilated(mask: &Mask, diameter_px: u32, progress: &Progress) -> Result<Mask, Cancelled> {
    let outside = mask.map(|m| !m);
    Ok(eroded(&outside, diameter_px, progress)?.map(|m| !m))
}

/// Pixels about which a disc lies within the mask.
///
/// # Errors
/// [`Cancelled`].
pub fn eroded(mask: &Mask, diameter_px: u32, progress: &Progress) -> Result<Mask, Cancelled> {
    if diameter_px < 2 || mask.is_empty() || !mask.is_whole() {
        return Ok(mask.clone());
    }
    let (width, height) = (mask.width, mask.height);
    let filled = filled(mask);
    let halves = half_widths(diameter_px);
    let mut values = mask.values.clone();
    for (v, row) in values.chunks_exact_mut(width).enumerate() {
        progress.check_at(v * width)?;
        for (down, half) in halves.iter().enumerate() {
            let above = v.checked_sub(down);
            let below = Some(v + down).filter(|r| *r < height && down > 0);
            for near in [above, below].into_iter().flatten() {
                let near = &filled[near * width..][..width];
                row.iter_mut().zip(near).for_each(|(stays, n)| *stays &= n > half);
            }
        }
    }
    Ok(Raster { width, height, values })
}

/// Of each row of a disc, from its middle on, how many pixels lie to either side of the middle one.
fn half_widths(diameter_px: u32) -> Vec<u16> {
    let squared = u64::from(diameter_px) * u64::from(diameter_px);
    let half = |down: u64| (squared - 4 * down * down).isqrt() / 2;
    // Images of more than 65 535 pixels along a side are not read.
    (0..=u64::from(diameter_px) / 2).map(|down| u16::try_from(half(down)).unwrap_or(u16::MAX - 1)).collect()
}

/// Of each pixel, how far the mask goes on from it to both sides, itself counted; 0 outside of the mask.
fn filled(mask: &Mask) -> Vec<u16> {
    let mut filled = vec![0u16; mask.values.len()];
    let on = |run: u16, is_set: bool| if is_set { run.saturating_add(1) } else { 0 };
    for (out, row) in filled.chunks_exact_mut(mask.width).zip(mask.values.chunks_exact(mask.width)) {
        let mut run = u16::MAX;
        for (n, is_set) in out.iter_mut().zip(row) {
            run = on(run, *is_set);
            *n = run;
        }
        run = u16::MAX;
        for (n, is_set) in out.iter_mut().zip(row).rev() {
            run = on(run, *is_set);
            *n = run.min(*n);
        }
    }
    filled
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::FixedNumbers;

    fn speckled(width: usize, height: usize, share: f64, seed: u64) -> Mask {
        let mut numbers = FixedNumbers::new(seed);
        Raster { width, height, values: (0..width * height).map(|_| numbers.share() < share).collect() }
    }

    /// Pixel by pixel, disc by disc.
    fn eroded_slowly(mask: &Mask, diameter: u32) -> Mask {
        let stays = |u: usize, v: usize| {
            mask.pixels().all(|([a, b], m)| {
                let (x, y) = (a.abs_diff(u), b.abs_diff(v));
                *m || 4 * (x * x + y * y) > (diameter * diameter) as usize
            })
        };
        Raster { values: mask.pixels().map(|([u, v], _)| stays(u, v)).collect(), ..*mask }
    }

    #[test]
    fn discs_are_those_of_brute_force() {
        for (seed, diameter) in (0..).zip([1u32, 2, 3, 4, 5, 7, 9, 12, 60]) {
            for share in [0.5, 0.9, 0.99] {
                let mask = speckled(37, 23, share, seed);
                let progress = Progress::default();
                let fast = eroded(&mask, diameter, &progress).expect("nobody cancels");
                assert_eq!(fast, eroded_slowly(&mask, diameter), "{diameter} {share}");
                let wide = dilated(&mask, diameter, &progress).expect("nobody cancels");
                assert_eq!(wide, eroded_slowly(&mask.map(|m| !m), diameter).map(|m| !m), "{diameter} {share}");
            }
        }
    }

    /// Opening only takes away, closing only adds, and neither does anything the second time.
    #[test]
    fn opening_and_closing_are_done_once() {
        let progress = Progress::default();
        for seed in 0..8 {
            let mask = speckled(50, 40, 0.8, seed);
            let opened_once = opened(&mask, 3, &progress).expect("nobody cancels");
            let closed_once = closed(&mask, 5, &progress).expect("nobody cancels");
            for ((before, o), c) in mask.values.iter().zip(&opened_once.values).zip(&closed_once.values) {
                assert!((!o || *before) && (*c || !before));
            }
            assert_eq!(opened(&opened_once, 3, &progress), Ok(opened_once));
            assert_eq!(closed(&closed_once, 5, &progress), Ok(closed_once));
        }
    }
}
