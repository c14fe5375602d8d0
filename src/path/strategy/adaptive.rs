//! Heights of planes whose lines lie one spacing apart on the surface, however it slopes.
//!
//! Planes at distance d give lines `d / sin∠(n, m)` apart. At every height the greatest of these
//! factors counts, over the facets crossed there; from plane to plane its integral is one spacing.
//! Facets within 10° of the planes are left out: they are missed whatever the heights are, and
//! would draw the planes together without end.

use crate::part::{Mesh, surfaces::Surface};
use crate::path::live_facets::{PARALLEL_DEG, live};
use nalgebra::Vector3;
use std::collections::BinaryHeap;

/// Heights along `normal` (unit), ascending, mm: no two neighbouring lines lie farther apart on the
/// surface than `spacing_mm`, and somewhere they lie so far apart. The first and the last are at most
/// half of that, on the surface, from its rims. Empty where the surface has no proper facet.
pub fn heights_mm(mesh: &Mesh, surface: &Surface, normal: &Vector3<f64>, spacing_mm: f64) -> Vec<f64> {
    let bands = bands(mesh, surface, normal);
    let whole: f64 = bands.iter().map(|b| (b.high - b.low) * b.stretch).sum();
    if bands.is_empty() || !whole.is_finite() || spacing_mm.is_nan() || spacing_mm <= 0.0 {
        return Vec::new();
    }
    // A hair less, as for families of equal heights.
    let count = (whole / spacing_mm - 1e-4).ceil().max(1.0);
    let first = 0.5 * (whole - (count - 1.0) * spacing_mm);
    let mut out = Vec::with_capacity(count as usize);
    let mut before = 0.0;
    for band in &bands {
        let length = (band.high - band.low) * band.stretch;
        while (out.len() as f64) < count && first + out.len() as f64 * spacing_mm <= before + length {
            let into = (first + out.len() as f64 * spacing_mm - before).max(0.0);
            out.push((band.low + into / band.stretch).min(band.high));
        }
        before += length;
    }
    out
}

/// A range of heights with one greatest stretch of distances.
struct Band {
    low: f64,
    high: f64,
    stretch: f64,
}

fn bands(mesh: &Mesh, surface: &Surface, normal: &Vector3<f64>) -> Vec<Band> {
    let parallel_sine = libm::sin(PARALLEL_DEG.to_radians());
    // Facets by their lowest corner; those that are missed in any case stretch nothing.
    let mut facets: Vec<(f64, f64, f64)> = live(mesh, surface)
        .map(|f| {
            let h = mesh.corners(f).map(|p| p.coords.dot(normal));
            let sine = mesh.normals[f].cross(normal).norm();
            let stretch = if sine < parallel_sine { 1.0 } else { 1.0 / sine };
            (h[0].min(h[1]).min(h[2]), h[0].max(h[1]).max(h[2]), stretch)
        })
        .collect();
    facets.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.2.total_cmp(&b.2)));
    let mut stops: Vec<f64> = facets.iter().flat_map(|f| [f.0, f.1]).collect();
    stops.sort_unstable_by(f64::total_cmp);
    stops.dedup();
    if let [only] = stops[..] {
        return vec![Band { low: only, high: only, stretch: 1.0 }];
    }
    let mut open: BinaryHeap<(u64, u64)> = BinaryHeap::new();
    let mut next = facets.iter().peekable();
    stops
        .windows(2)
        .map(|w| {
            while let Some(f) = next.next_if(|f| f.0 <= w[0]) {
                open.push((f.2.to_bits(), order(f.1)));
            }
            while open.peek().is_some_and(|top| top.1 <= order(w[0])) {
                open.pop();
            }
            // Between two islands no facet is open.
            let stretch = open.peek().map_or(1.0, |top| f64::from_bits(top.0));
            Band { low: w[0], high: w[1], stretch }
        })
        .collect()
}

/// A key in the order of the numbers.
fn order(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}
