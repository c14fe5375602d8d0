//! Edges by Canny (1986), on the masked area and a rim around it alone (P4, 3): elsewhere scratches have edges as well.

use super::morphology::dilated;
use crate::progress::{Cancelled, Progress};
use crate::weld::raster::{GreyImage, Mask, Raster};

/// How far around the mask edges are looked for: diameter of the disc, pixels. The outline of the mask lies within two
/// pixels of the edge.
const RIM_PX: u32 = 9;
/// Slope from which on an edge goes on, and that it needs somewhere, levels a pixel. Noise of 5 levels, smoothed by 1.2
/// pixels, has slopes of about 1; the flank of a bead 40 levels brighter than the skin has 10 to 20.
const SLOPES: [f32; 2] = [4.0, 8.0];
/// Tangent of 22.5°: directions are told in eighths of a turn.
const EIGHTH: f32 = 0.414_213_56;

/// The edges in and around a mask, a pixel wide.
///
/// # Errors
/// [`Cancelled`].
pub fn edges(image: &GreyImage, mask: &Mask, progress: &Progress) -> Result<Mask, Cancelled> {
    let (width, height) = (image.width, image.height);
    let mut edges = Mask::filled(width, height, false);
    if image.size() != mask.size() || !image.is_whole() || !mask.is_whole() || width < 3 || height < 3 {
        return Ok(edges);
    }
    let near = dilated(mask, RIM_PX, progress)?;
    let slopes = slopes(image, &near);
    let size = |u: usize, v: usize| slopes.values[v * width + u][2];
    let mut stack = Vec::new();
    let mut goes_on = Mask::filled(width, height, false);
    for v in 1..height - 1 {
        progress.check_at(v * width)?;
        for u in 1..width - 1 {
            let [x, y, here] = slopes.values[v * width + u];
            if here < SLOPES[0] {
                continue;
            }
            let [before, after] = if y.abs() < EIGHTH * x.abs() {
                [size(u - 1, v), size(u + 1, v)]
            } else if x.abs() < EIGHTH * y.abs() {
                [size(u, v - 1), size(u, v + 1)]
            } else if (x > 0.0) == (y > 0.0) {
                [size(u - 1, v - 1), size(u + 1, v + 1)]
            } else {
                [size(u + 1, v - 1), size(u - 1, v + 1)]
            };
            // Of two that are alike the first is taken, so that no edge is two pixels wide.
            if here > before && here >= after {
                goes_on.values[v * width + u] = true;
                if here >= SLOPES[1] {
                    stack.push([u, v]);
                }
            }
        }
    }
    while let Some([u, v]) = stack.pop() {
        if std::mem::replace(&mut edges.values[v * width + u], true) {
            continue;
        }
        let around = (v - 1..=v + 1).flat_map(|b| (u - 1..=u + 1).map(move |a| [a, b]));
        stack.extend(around.filter(|[a, b]| goes_on.values[b * width + a] && !edges.values[b * width + a]));
    }
    Ok(edges)
}

/// Slope along u, along v, and its size, levels a pixel, by Sobel's weights; 0 off the mask and along the border.
fn slopes(image: &GreyImage, near: &Mask) -> Raster<[f32; 3]> {
    let (width, height) = (image.width, image.height);
    let mut slopes = Raster::filled(width, height, [0.0f32; 3]);
    for v in 1..height - 1 {
        let [above, here, below] = [v - 1, v, v + 1].map(|r| image.row(r));
        let wanted = near.row(v);
        for u in (1..width - 1).filter(|u| wanted[*u]) {
            let x = above[u + 1] - above[u - 1] + 2.0 * (here[u + 1] - here[u - 1]) + below[u + 1] - below[u - 1];
            let y = below[u - 1] - above[u - 1] + 2.0 * (below[u] - above[u]) + below[u + 1] - above[u + 1];
            slopes.values[v * width + u] = [x / 8.0, y / 8.0, (x * x + y * y).sqrt() / 8.0];
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::super::smoothing::smoothed;
    use super::*;

    /// A bright disc has a ring of edges, a pixel wide, at its radius; a second disc outside of the mask has none.
    #[test]
    fn a_masked_disc_has_its_rim() {
        let off = |u: usize, v: usize, x: f64| libm::hypot(u as f64 - x, v as f64 - 40.0);
        let level = |u: usize, v: usize| if off(u, v, 50.0) < 25.0 || off(u, v, 130.0) < 20.0 { 160.0 } else { 100.0 };
        let image = Raster { width: 170, height: 80, values: (0..13_600).map(|i| level(i % 170, i / 170)).collect() };
        let mask = image.map(|x| *x > 130.0);
        let mask = Raster { values: mask.pixels().map(|([u, _], m)| *m && u < 90).collect(), ..mask };
        let found = edges(&smoothed(&image, 1.2), &mask, &Progress::default()).expect("nobody cancels");
        let all: Vec<f64> = found.pixels().filter(|(_, e)| **e).map(|([u, v], _)| off(u, v, 50.0)).collect();
        assert!(all.iter().all(|r| (r - 24.7).abs() < 1.2), "{all:?}");
        // A ring of eight-connected pixels has 4·√2·r of them, one of four-connected ones 8·r.
        assert!((139..=197).contains(&all.len()), "{}", all.len());
        for degrees in 0..360 {
            let (s, c) = (libm::sin(f64::from(degrees).to_radians()), libm::cos(f64::from(degrees).to_radians()));
            let near = |([u, v], edge): ([usize; 2], &bool)| {
                *edge && libm::hypot(u as f64 - 50.0 - 24.7 * c, v as f64 - 40.0 - 24.7 * s) < 1.5
            };
            assert!(found.pixels().any(near), "the ring is closed at {degrees}°");
        }
    }

    #[test]
    fn images_without_pixels_have_no_edges() {
        for (width, height) in [(0, 0), (1, 5), (2, 2)] {
            let found =
                edges(&GreyImage::filled(width, height, 1.0), &Mask::filled(width, height, true), &Progress::default());
            assert_eq!(found, Ok(Mask::filled(width, height, false)));
        }
        let sizes_differ = edges(&GreyImage::filled(9, 9, 1.0), &Mask::filled(8, 9, true), &Progress::default());
        assert_eq!(sizes_differ.map(|e| e.count()), Ok(0));
    }
}
