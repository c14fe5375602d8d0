//! The first guess of a bead: pixels that stand above the parent, and a way along them.
//!
//! Medians of 5 × 5 heights against a threshold by their noise; of the areas in one piece the one that most of the mask
//! lies on. The way is the longest of the shortest ways within it, where steps near the rim are dear, so that it keeps to
//! the middle and any open line will do; a ring is cut somewhere.

use crate::weld::pixel_distance::distances_px;
use crate::weld::raster::{Mask, Raster};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Half the side of the square whose median is taken, px.
const HALF_PX: usize = 2;
/// The median of 25 heights has a quarter of the noise of one; six times that is chance nowhere.
const SIGMAS: f64 = 1.5;
/// A bead lower than this is none, mm: what a skin is off a cubic.
const LEAST_MM: f64 = 0.5;

/// The height from which on a median stands out of the noise, mm.
pub(in crate::weld) fn threshold_mm(noise_mm: f64) -> f64 {
    (SIGMAS * noise_mm).max(LEAST_MM)
}

/// The medians of 5 × 5 heights; not a number where fewer than six were measured.
pub(in crate::weld) fn medians(heights: &Raster<f32>) -> Raster<f32> {
    let (width, height) = (heights.width, heights.height);
    let mut values = vec![f32::NAN; heights.values.len()];
    let mut near = Vec::with_capacity(25);
    for v in 0..height {
        for u in 0..width {
            near.clear();
            for row in v.saturating_sub(HALF_PX)..(v + HALF_PX + 1).min(height) {
                let from = row * width + u.saturating_sub(HALF_PX);
                let end = row * width + (u + HALF_PX + 1).min(width);
                near.extend(heights.values[from..end].iter().copied().filter(|h| h.is_finite()));
            }
            if near.len() >= 6 {
                let middle = near.len() / 2;
                values[v * width + u] = *near.select_nth_unstable_by(middle, f32::total_cmp).1;
            }
        }
    }
    Raster { width, height, values }
}

/// The area above the threshold, in one piece, that has the most pixels in the mask; `None`: none has any.
pub(super) fn standing_area(medians: &Raster<f32>, mask: &Mask, threshold_mm: f64) -> Option<Mask> {
    let (width, height) = (medians.width, medians.height);
    let stands = |i: usize| f64::from(medians.values[i]) > threshold_mm;
    let mut seen = vec![false; medians.values.len()];
    let mut best: (usize, Vec<usize>) = (0, Vec::new());
    for start in 0..seen.len() {
        if seen[start] || !stands(start) {
            continue;
        }
        seen[start] = true;
        let mut area = vec![start];
        let mut next = 0;
        while let Some(&i) = area.get(next) {
            next += 1;
            for (j, _) in beside(i, width, height) {
                if !seen[j] && stands(j) {
                    seen[j] = true;
                    area.push(j);
                }
            }
        }
        let inside = area.iter().filter(|i| mask.values[**i]).count();
        if inside > best.0 {
            best = (inside, area);
        }
    }
    let (inside, area) = best;
    let mut values = vec![false; seen.len()];
    area.into_iter().for_each(|i| values[i] = true);
    (inside > 0).then_some(Mask { width, height, values })
}

/// How much dearer a step is on the rim; it falls with the distance from there.
const RIM: f32 = 12.0;

/// The longest of the shortest ways within an area, by pixels.
pub(super) fn way_along(area: &Mask) -> Vec<[usize; 2]> {
    let Some(start) = area.values.iter().position(|on| *on) else { return Vec::new() };
    let from_rim = distances_px(&area.map(|on| !on));
    let dear = from_rim.map(|d| (1.0 + RIM / d.max(1.0)).min(1.0 + RIM) as u32);
    let (end, _) = furthest(area, &dear, start);
    let (other, before) = furthest(area, &dear, end);
    let mut way = Vec::new();
    let mut at = other;
    loop {
        way.push([at % area.width, at / area.width]);
        match before.get(at) {
            Some(&b) if b != usize::MAX && b != at => at = b,
            _ => return way,
        }
    }
}

/// The pixel that is furthest from another within an area, and the pixel before each on the way (Dijkstra; steps of 5,
/// and of 7 across corners, times how dear the pixel is).
fn furthest(area: &Mask, dear: &Raster<u32>, from: usize) -> (usize, Vec<usize>) {
    let mut lengths = vec![u32::MAX; area.values.len()];
    let mut before = vec![usize::MAX; area.values.len()];
    let mut open = BinaryHeap::from([Reverse((0, from))]);
    lengths[from] = 0;
    let mut last = from;
    while let Some(Reverse((length, i))) = open.pop() {
        if length > lengths[i] {
            continue;
        }
        last = i;
        for (j, step) in beside(i, area.width, area.height) {
            let length = length + step * dear.values[j];
            if area.values[j] && length < lengths[j] {
                (lengths[j], before[j]) = (length, i);
                open.push(Reverse((length, j)));
            }
        }
    }
    (last, before)
}

/// The up to eight pixels beside one, and how far off they are.
fn beside(i: usize, width: usize, height: usize) -> impl Iterator<Item = (usize, u32)> {
    let (u, v) = (i % width, i / width);
    let around = [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)];
    around.into_iter().filter_map(move |(du, dv): (isize, isize)| {
        let (u, v) = (u.checked_add_signed(du)?, v.checked_add_signed(dv)?);
        let step = if du == 0 || dv == 0 { 5 } else { 7 };
        (u < width && v < height).then_some((v * width + u, step))
    })
}
