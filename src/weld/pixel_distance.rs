//! How far each pixel lies from the nearest one of a mask (Felzenszwalb and Huttenlocher 2012: exact, two passes).
//!
//! Pixels are taken as square: no camera that the images come from has other ones by more than a few per mille.

use super::raster::{Mask, Raster};

/// Distance of each pixel's centre from that of the nearest pixel of the mask, px; infinite where the mask is empty.
pub fn distances_px(to: &Mask) -> Raster<f32> {
    let (width, height) = (to.width, to.height);
    let mut squares: Vec<f64> = to.values.iter().map(|on| if *on { 0.0 } else { f64::INFINITY }).collect();
    let mut envelope = Envelope::default();
    let mut line = Vec::new();
    for column in 0..width {
        line.clear();
        line.extend(squares.iter().skip(column).step_by(width).copied());
        let nearest = envelope.lowered(&line);
        for (into, value) in squares.iter_mut().skip(column).step_by(width).zip(nearest) {
            *into = *value;
        }
    }
    for row in squares.chunks_mut(width.max(1)) {
        line.clear();
        line.extend_from_slice(row);
        row.copy_from_slice(envelope.lowered(&line));
    }
    Raster { width, height, values: squares.into_iter().map(|d| d.sqrt() as f32).collect() }
}

/// The mask with all pixels that lie within a distance of it.
pub fn dilated(mask: &Mask, by_px: f64) -> Mask {
    let values = distances_px(mask).values.into_iter().map(|d| f64::from(d) <= by_px).collect();
    Mask { width: mask.width, height: mask.height, values }
}

/// The least of parabolas along a line; kept for its memory.
#[derive(Default)]
struct Envelope {
    /// Where the parabolas of the envelope stand, how high, and where each begins to be the lowest.
    parabolas: Vec<(f64, f64, f64)>,
    lowest: Vec<f64>,
}

impl Envelope {
    /// The least over j of `(i − j)² + heights[j]`, for each i.
    fn lowered(&mut self, heights: &[f64]) -> &[f64] {
        self.parabolas.clear();
        for (at, &high) in heights.iter().enumerate().filter(|(_, high)| high.is_finite()) {
            let at = at as f64;
            let mut from = f64::NEG_INFINITY;
            while let Some(&(before, low, begins)) = self.parabolas.last() {
                from = ((high + at * at) - (low + before * before)) / (2.0 * (at - before));
                if from > begins {
                    break;
                }
                self.parabolas.pop();
                from = f64::NEG_INFINITY;
            }
            self.parabolas.push((at, high, from));
        }
        self.lowest.clear();
        let mut parabolas = self.parabolas.iter().peekable();
        let mut current = parabolas.next();
        for i in 0..heights.len() {
            let i = i as f64;
            while parabolas.peek().is_some_and(|next| next.2 <= i) {
                current = parabolas.next();
            }
            self.lowest.push(current.map_or(f64::INFINITY, |(at, high, _)| (i - at) * (i - at) + high));
        }
        &self.lowest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Against every pair of pixels.
        #[test]
        fn distances_are_those_of_the_nearest_pixel(width in 1..9usize, values in prop::collection::vec(prop::bool::weighted(0.2), 1..60)) {
            let height = values.len() / width;
            let mask = Mask { width, height, values: values[..width * height].to_vec() };
            let place = |i: usize| [(i % width) as f64, (i / width) as f64];
            for (i, found) in distances_px(&mask).values.iter().enumerate() {
                let on = mask.values.iter().enumerate().filter(|(_, on)| **on);
                let nearest = on.map(|(j, _)| {
                    let ([x, y], [a, b]) = (place(i), place(j));
                    ((x - a) * (x - a) + (y - b) * (y - b)).sqrt()
                }).fold(f64::INFINITY, f64::min);
                prop_assert!(*found == nearest as f32);
            }
        }
    }
}
