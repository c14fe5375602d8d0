//! What a depth camera makes of the scene: noise, holes in blobs, and pixels at the bead's rim that fly between it and
//! the skin.

use super::files::DEPTH_UNITS_PER_MM;
use super::seen::Seen;
use super::{HEIGHT, WIDTH, normals};
use crate::sample::FixedNumbers;

/// Share of pixels without a depth.
const HOLES: f64 = 0.03;
/// Half of the width over which noise is averaged twice to make blobs, pixels: those are 10 pixels across.
const BLOB_PX: usize = 5;
/// Share of the pixels at the bead's rim that fly, and how far: before and behind, mm.
const FLYING: f64 = 0.05;
const FLIGHT_MM: [f64; 2] = [-15.0, 5.0];

/// Depths in units of the file, row by row; 0: none.
pub(super) fn depths(seen: &[Seen], noise_mm: f64, seed: u64) -> Vec<u16> {
    let mut numbers = FixedNumbers::new(seed.wrapping_mul(2));
    let is_hole = holes(&mut numbers);
    let is_bead = |i: usize| seen.get(i).is_some_and(|s| s.bead.is_some());
    let mut all = Vec::with_capacity(seen.len());
    let noises = normals(&mut numbers, seen.len());
    for (i, ((s, is_hole), noise)) in seen.iter().zip(is_hole).zip(noises).enumerate() {
        // All numbers are drawn, so that noise and holes stay where they are if the bead moves.
        let (flies, flight) = (numbers.share() < FLYING, numbers.share());
        let near = [i.wrapping_sub(1), i + 1, i.wrapping_sub(WIDTH), i + WIDTH];
        let is_rim = near.into_iter().any(|j| is_bead(j) != is_bead(i));
        let off_mm = if flies && is_rim { FLIGHT_MM[0] + flight * (FLIGHT_MM[1] - FLIGHT_MM[0]) } else { 0.0 };
        let units = (s.depth_mm + noise_mm * noise + off_mm) * DEPTH_UNITS_PER_MM;
        all.push(if is_hole { 0 } else { units.round().clamp(0.0, 65_535.0) as u16 });
    }
    all
}

/// Where noise, averaged over neighbours, is greatest.
fn holes(numbers: &mut FixedNumbers) -> Vec<bool> {
    let noise: Vec<f64> = (0..WIDTH * HEIGHT).map(|_| numbers.share() - 0.5).collect();
    let once = averaged(&averaged(&noise, 1, WIDTH), WIDTH, HEIGHT);
    let twice = averaged(&averaged(&once, 1, WIDTH), WIDTH, HEIGHT);
    let mut order = twice.clone();
    let kept = ((1.0 - HOLES) * order.len() as f64) as usize;
    let (_, level, _) = order.select_nth_unstable_by(kept, f64::total_cmp);
    twice.iter().map(|x| x > level).collect()
}

/// Sums over neighbours along one direction: `step` to the next value, `count` values to a line; none beyond its ends.
fn averaged(values: &[f64], step: usize, count: usize) -> Vec<f64> {
    let sum = |i: usize| {
        let place = i / step % count;
        let span = place.saturating_sub(BLOB_PX)..(place + BLOB_PX + 1).min(count);
        let line = i - place * step;
        span.clone().filter_map(|k| values.get(line + k * step)).sum::<f64>() / span.len() as f64
    };
    (0..values.len()).map(sum).collect()
}
