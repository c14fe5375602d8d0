//! Where a bead ends: beside its centre line, and at the ends of that.
//!
//! A threshold on the height takes the rim off a flat bead (13 % of the width of a cap 4 mm high at 1 mm). Here the whole
//! flank tells where it meets the parent: heights are zero beyond the edge, and before it a parabola that is zero at the
//! edge; of all edges the one with the least squares. The ends may be steps.

use super::line::{Placed, STEP_MM, Station, between};
use nalgebra::{Matrix2, Vector2};

/// Half the length along the bead over which a section is taken together, mm.
pub(super) const ALONG_MM: f64 = 3.0;
/// Width of the bins whose median stands for their points, mm.
const BIN_MM: f64 = 0.5;
/// Edges are tried at this distance, mm, and the best is refined by a parabola.
const TRY_MM: f64 = 0.1;
/// No edge lies nearer to the centre line, mm.
const LEAST_HALF_MM: f64 = 1.0;
/// How far beyond the end of a bead its surroundings are looked at, and how far before it the bead, mm.
const BEYOND_MM: f64 = 8.0;
const BEFORE_MM: f64 = 15.0;

/// The middle of a bin, the median of its heights, and how many there are.
#[derive(Clone, Copy, Debug)]
pub(super) struct BinHeight {
    pub(super) at_mm: f64,
    pub(super) height_mm: f64,
    pub(super) weight: f64,
}

/// The section at a station: its heights across, from right to left.
pub(super) fn section(placed: &[Placed], station: &Station, ends: [f64; 2]) -> Vec<BinHeight> {
    // Near an end the window stays inside and keeps its length: half of one would tell half as much.
    let middle = station.along_mm.min(ends[1] - ALONG_MM).max(ends[0] + ALONG_MM);
    let (from, to) = ((middle - ALONG_MM).max(ends[0]), (middle + ALONG_MM).min(ends[1]));
    binned(between(placed, from, to).iter().map(|p| (p.left_mm, p.height_mm)))
}

/// Heights by their distance beside the line, in bins.
pub(super) fn binned(points: impl Iterator<Item = (f64, f64)>) -> Vec<BinHeight> {
    let mut all: Vec<(f64, f64)> = points.collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let of = |p: &(f64, f64)| (p.0 / BIN_MM).floor();
    let bins = all.chunk_by(|a, b| of(a) == of(b));
    bins.filter_map(|bin| {
        let weight = bin.len() as f64;
        let at_mm = bin.iter().map(|p| p.0).sum::<f64>() / weight;
        // Between the two middle ones where their number is even: the upper one alone would stand too high.
        let mut heights: Vec<f64> = bin.iter().map(|p| p.1).collect();
        heights.sort_by(f64::total_cmp);
        let (a, b) = (heights.get((bin.len() - 1) / 2)?, heights.get(bin.len() / 2)?);
        Some(BinHeight { at_mm, height_mm: 0.5 * (a + b), weight })
    })
    .collect()
}

/// Distance of the edge from the centre line on one side (+1: left), mm; `None`: no flank was found there.
pub(super) fn flank_mm(section: &[BinHeight], side: f64, most_mm: f64) -> Option<f64> {
    let bins = section.iter().map(|b| BinHeight { at_mm: b.at_mm * side, ..*b });
    let bins: Vec<BinHeight> = bins.filter(|b| b.at_mm >= 0.0 && b.at_mm <= most_mm + BEYOND_MM).collect();
    best_edge(&bins, LEAST_HALF_MM, most_mm, |off| Vector2::new(off, off * off))
}

/// Where the bead begins and ends along its line, mm; by the heights near its middle. `about`: where it does about.
pub(super) fn ends_mm(placed: &[Placed], half_band_mm: f64, about: [f64; 2]) -> [Option<f64>; 2] {
    [(-1.0, about[0]), (1.0, about[1])].map(|(sense, end)| {
        let outwards = |p: &Placed| sense * (p.along_mm - end);
        let near = placed.iter().filter(|p| p.left_mm.abs() <= half_band_mm);
        let near = near.map(|p| (outwards(p) + BEFORE_MM, p.height_mm));
        let bins = binned(near.filter(|(at, _)| (0.0..=BEFORE_MM + BEYOND_MM).contains(at)));
        let out = best_edge(&bins, LEAST_HALF_MM, BEFORE_MM + BEYOND_MM - 1.0, |off| Vector2::new(1.0, off))?;
        Some(end + sense * (out - BEFORE_MM))
    })
}

/// Whether anything was measured just beyond an end.
pub(super) fn is_measured_beyond(placed: &[Placed], end_mm: f64, sense: f64) -> bool {
    let [from, to] = if sense > 0.0 { [end_mm, end_mm + 6.0] } else { [end_mm - 6.0, end_mm] };
    let beyond = between(placed, from, to).iter().filter(|p| p.left_mm.abs() < 3.0);
    let furthest = beyond.map(|p| sense * (p.along_mm - end_mm)).fold(0.0, f64::max);
    furthest > 3.0 * STEP_MM
}

/// The edge between `least` and `most` with the least squares: zero beyond it, the terms of the way to it before. Terms
/// may not stand below zero at the edge.
fn best_edge(bins: &[BinHeight], least: f64, most: f64, terms: impl Fn(f64) -> Vector2<f64>) -> Option<f64> {
    let count = ((most - least) / TRY_MM).floor();
    if bins.len() < 4 || !(1.0..=10_000.0).contains(&count) {
        return None;
    }
    let edge_of = |k: usize| least + TRY_MM * k as f64;
    let all: Vec<f64> = (0..=count as usize).map(|k| squares(bins, edge_of(k), &terms)).collect();
    let best = (0..all.len()).min_by(|a, b| all[*a].total_cmp(&all[*b]))?;
    if best == 0 || best + 1 == all.len() {
        return None;
    }
    let (a, b, c) = (all[best - 1], all[best], all[best + 1]);
    let bend = a - 2.0 * b + c;
    let shift = if bend > 0.0 { 0.5 * (a - c) / bend } else { 0.0 };
    Some(edge_of(best) + TRY_MM * shift.clamp(-1.0, 1.0)).filter(|e| e.is_finite())
}

fn squares(bins: &[BinHeight], edge: f64, terms: &impl Fn(f64) -> Vector2<f64>) -> f64 {
    let (mut left, mut right, mut total) = (Matrix2::zeros(), Vector2::zeros(), 0.0);
    for bin in bins {
        total += bin.weight * bin.height_mm * bin.height_mm;
        if bin.at_mm < edge {
            let row = terms(edge - bin.at_mm);
            left += row * row.transpose() * bin.weight;
            right += row * (bin.weight * bin.height_mm);
        }
    }
    let one = |k: usize| {
        if left[(k, k)] > 0.0 { Vector2::ith(k, (right[k] / left[(k, k)]).max(0.0)) } else { Vector2::zeros() }
    };
    let both = left.try_inverse().map(|inverse| inverse * right).filter(|c| c.iter().all(|x| x.is_finite()));
    let coefficients = both.filter(|c| c.x >= 0.0).unwrap_or_else(|| one(1));
    total - 2.0 * coefficients.dot(&right) + coefficients.dot(&(left * coefficients))
}
