//! The light of the scene: skin in a gradient with a gloss band across, a brighter bead with ripples, bright ground metal
//! with its grooves, scratches, spatter, and the camera's noise.

use super::seen::Seen;
use super::{HEIGHT, WIDTH, normals};
use crate::sample::FixedNumbers;

/// Standard deviation of the camera's noise, levels.
const NOISE: f64 = 4.0;
/// Number of scratches, and of specks of spatter.
const SCRATCHES: usize = 60;
const SPECKS: usize = 40;
/// Part of a scratch that shows on the bead, which is rougher than any.
const ON_BEAD: f64 = 0.3;
/// Weights of a point's neighbours in the lens: a normal curve of 0.7 pixels.
const LENS: [f64; 3] = [0.570, 0.207, 0.008];

/// Levels from 0 to 255, row by row.
pub(super) fn levels(seen: &[Seen], seed: u64) -> Vec<u8> {
    let mut numbers = FixedNumbers::new(seed.wrapping_mul(2).wrapping_add(1));
    let damage = damage(&mut numbers);
    let grooves: Vec<f64> = normals(&mut numbers, 512);
    let bare: Vec<f64> = seen.iter().enumerate().map(|(i, s)| level(seen, i, s, &grooves)).collect();
    let shares = seen.iter().map(|s| if s.bead.is_some() { ON_BEAD } else { 1.0 });
    let marked: Vec<f64> = bare.iter().zip(&damage).zip(shares).map(|((b, d), share)| b + share * d).collect();
    let sharp = through_lens(&through_lens(&marked, 1, WIDTH), WIDTH, HEIGHT);
    let noise = normals(&mut numbers, sharp.len());
    sharp.iter().zip(noise).map(|(x, n)| (x + NOISE * n).round().clamp(0.0, 255.0) as u8).collect()
}

/// The level without damage and noise.
fn level(seen: &[Seen], i: usize, s: &Seen, grooves: &[f64]) -> f64 {
    let (u, v) = ((i % WIDTH) as f64 / WIDTH as f64 - 0.5, (i / WIDTH) as f64 / HEIGHT as f64 - 0.5);
    let band = (v - 0.1 - 0.25 * u) / 0.03;
    let light = 105.0 + 64.0 * u + 34.0 * v - 80.0 * (u * u + v * v) + 14.0 * libm::exp(-band * band);
    if let Some(on) = s.bead {
        let ripple = 9.0 * libm::sin(on.x / 1.1 + 0.5 * on.across_mm.abs());
        // Flanks that look away from the lamp, up and to the left, are darker.
        let depth = |j: usize| seen.get(j).map_or(s.depth_mm, |o| o.depth_mm);
        let away =
            (depth(i + 1) - depth(i.saturating_sub(1)) + depth(i + WIDTH) - depth(i.saturating_sub(WIDTH))) * 1.2;
        return 0.92 * light + 62.0 + ripple - 12.0 * away.clamp(-1.0, 1.0);
    }
    let groove = (0.8 * s.at[0] + 1.1 * s.at[1] + 200.0) / 0.6;
    let [one, next] = [0, 1].map(|k| grooves.get((groove as usize + k) % 512).copied().unwrap_or_default());
    let metal = 48.0 + 5.0 * (one + (next - one) * groove.fract());
    light + s.ground * metal
}

/// Scratches and specks: what they add to the level of each pixel.
fn damage(numbers: &mut FixedNumbers) -> Vec<f64> {
    let mut damage = vec![0.0; WIDTH * HEIGHT];
    for k in 0..SCRATCHES + SPECKS {
        let from = [numbers.share() * WIDTH as f64, numbers.share() * HEIGHT as f64];
        let (angle, length) = (std::f64::consts::PI * numbers.share(), 20.0 + 140.0 * numbers.share());
        let (is_bright, radius) = (numbers.share() < 0.6, 0.5 + numbers.index(2) as f64);
        if k < SCRATCHES {
            let to = [from[0] + length * libm::cos(angle), from[1] + length * libm::sin(angle)];
            mark(&mut damage, [from, to], 0.0, if is_bright { 45.0 } else { -28.0 });
        } else {
            mark(&mut damage, [from, from], radius, 60.0);
        }
    }
    damage
}

/// A straight mark, with a rim that fades over a pixel.
fn mark(damage: &mut [f64], [from, to]: [[f64; 2]; 2], radius: f64, level: f64) {
    let along = [to[0] - from[0], to[1] - from[1]];
    let squared = (along[0] * along[0] + along[1] * along[1]).max(1e-9);
    let span = |k: usize, count: usize| {
        let [low, high] = [from[k].min(to[k]) - radius - 1.0, from[k].max(to[k]) + radius + 2.0];
        low.max(0.0) as usize..(high.max(0.0) as usize).min(count)
    };
    for v in span(1, HEIGHT) {
        for u in span(0, WIDTH) {
            let off = [u as f64 - from[0], v as f64 - from[1]];
            let share = ((off[0] * along[0] + off[1] * along[1]) / squared).clamp(0.0, 1.0);
            let distance = libm::hypot(off[0] - share * along[0], off[1] - share * along[1]);
            damage[v * WIDTH + u] += level * (radius + 1.0 - distance).clamp(0.0, 1.0);
        }
    }
}

/// Blurred along one direction: `step` to the next value, `count` values to a line. Border values go on.
fn through_lens(values: &[f64], step: usize, count: usize) -> Vec<f64> {
    let blurred = |i: usize| {
        let place = i / step % count;
        let at = |off: isize| {
            let moved = place.saturating_add_signed(off).min(count - 1);
            values.get(i + moved * step - place * step).copied().unwrap_or_default()
        };
        LENS[0] * at(0) + LENS[1] * (at(-1) + at(1)) + LENS[2] * (at(-2) + at(2))
    };
    (0..values.len()).map(blurred).collect()
}
