//! The facets of a cut, recognised in another order, with other corners first, and after a motion.
//!
//! Corners are rounded to a grid and hashed; the three hashes of a facet are summed, so that it does
//! not matter which corner comes first. f32 coordinates that were moved differ in their last digits,
//! so a coordinate that lies beside a boundary of the grid is tried on both sides. In another
//! tessellation the facets are others, and are not found.

use super::segmentation::Segmentation;
use nalgebra::{Point3, Similarity3};
use std::collections::BTreeMap;

/// The spacing of the grid, in units of the file: 2⁻¹⁴ of the part's diagonal (some µm), but 64 times
/// the grain of its f32 coordinates at least.
pub(super) fn grid(diagonal: f64, farthest: f64) -> f64 {
    (diagonal / f64::from(1 << 14)).max(farthest / f64::from(1 << 18)).max(f64::MIN_POSITIVE)
}

/// Twelve hexadecimal digits a facet: among a million facets one pair in five hundred million agrees
/// by chance.
pub(super) fn hash_facets(now: &Segmentation, facets: &[u32], grid: f64) -> String {
    let mut digests: Vec<u64> = facets
        .iter()
        .map(|&f| {
            let cells = now.corners(f).map(|p| cell(std::array::from_fn(|k| rounded(p[k], grid).0)));
            digest(cells)
        })
        .collect();
    digests.sort_unstable();
    digests.iter().map(|d| format!("{d:012x}")).collect()
}

/// The facets of a surface whose hashes were kept; `None` unless every one of them is found.
pub(super) fn find_facets(
    now: &Segmentation,
    surface: u32,
    written: &str,
    grid: f64,
    new_from_old: &Similarity3<f64>,
) -> Option<Vec<u32>> {
    let mut wanted: BTreeMap<u64, usize> = BTreeMap::new();
    let mut open = 0;
    for digits in written.as_bytes().chunks(12) {
        let number = std::str::from_utf8(digits).ok().and_then(|d| u64::from_str_radix(d, 16).ok())?;
        *wanted.entry(number).or_default() += 1;
        open += 1;
    }
    let old_from_new = new_from_old.inverse();
    let mut facets = Vec::with_capacity(open);
    for &f in now.facets(surface) {
        let corners = now.corners(f);
        let grain = corners.iter().flat_map(|p| p.iter()).fold(0.0f64, |m, x| m.max(x.abs())) * old_from_new.scaling();
        // Half a unit in the last place of f32 is 2⁻²⁵; two of them, turned, and the fit of the motion.
        let slack = (grain / f64::from(1 << 21) + grid / 64.0).min(grid / 4.0);
        let tried = corners.map(|p| cells(&old_from_new.transform_point(&p), grid, slack));
        if let Some(hit) = all_of(&tried).find(|d| wanted.get(d).is_some_and(|n| *n > 0)) {
            wanted.entry(hit).and_modify(|n| *n -= 1);
            facets.push(f);
        }
    }
    (facets.len() == open).then_some(facets)
}

/// The whole number of a coordinate on the grid, and how far above its lower boundary it lies, 0 to 1.
fn rounded(x: f64, grid: f64) -> (i64, f64) {
    // Shifted by an odd share, so that round figures do not lie on boundaries.
    let at = x / grid + 0.381_966;
    (at.floor() as i64, at - at.floor())
}

/// The cells that a corner may have been in: one, or up to eight beside boundaries.
fn cells(p: &Point3<f64>, grid: f64, slack: f64) -> Vec<u64> {
    let mut all = vec![[0i64; 3]];
    for k in 0..3 {
        let (at, above) = rounded(p[k], grid);
        let beside = match slack / grid {
            s if above < s => Some(at.saturating_sub(1)),
            s if above > 1.0 - s => Some(at.saturating_add(1)),
            _ => None,
        };
        let count = all.len();
        if let Some(other) = beside {
            all.extend_from_within(..);
            all[count..].iter_mut().for_each(|c| c[k] = other);
        }
        all[..count].iter_mut().for_each(|c| c[k] = at);
    }
    all.into_iter().map(cell).collect()
}

fn all_of([a, b, c]: &[Vec<u64>; 3]) -> impl Iterator<Item = u64> {
    a.iter().flat_map(move |&x| b.iter().flat_map(move |&y| c.iter().map(move |&z| digest([x, y, z]))))
}

/// A cell of the grid, hashed.
fn cell(at: [i64; 3]) -> u64 {
    at.iter().fold(0x9e37_79b9_7f4a_7c15, |h, &x| mixed(h ^ x as u64))
}

/// A facet, whichever corner comes first; 48 bits.
fn digest(cells: [u64; 3]) -> u64 {
    mixed(cells.iter().fold(0u64, |sum, c| sum.wrapping_add(*c))) >> 16
}

/// SplitMix64: every bit of the result depends on every bit of `x`.
fn mixed(x: u64) -> u64 {
    let mut z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Wherever a corner lies, what noise makes of it is among the cells tried.
        #[test]
        fn noise_within_the_slack_is_tried(p in prop::array::uniform3(-50.0..50.0f64), noise in prop::array::uniform3(-1.0..1.0f64),
                                           on in prop::array::uniform3(prop::bool::ANY)) {
            let (grid, slack) = (0.01, 0.001);
            // Some coordinates exactly on a boundary.
            let p: [f64; 3] = std::array::from_fn(|k| if on[k] { ((p[k] / grid).round() - 0.381_966) * grid } else { p[k] });
            let other = Point3::from(std::array::from_fn::<f64, 3, _>(|k| p[k] + 0.999 * slack * noise[k]));
            let was = cell(p.map(|x| rounded(x, grid).0));
            let tried = cells(&other, grid, slack);
            prop_assert!(tried.contains(&was));
            prop_assert!(tried.len() <= 8);
        }

        #[test]
        fn the_first_corner_does_not_matter(c in prop::array::uniform3(any::<u64>())) {
            let one = digest(c);
            prop_assert_eq!(digest([c[1], c[2], c[0]]), one);
            prop_assert_eq!(digest([c[2], c[1], c[0]]), one);
            prop_assert_ne!(digest([c[0] ^ 1, c[1], c[2]]), one);
        }
    }
}
