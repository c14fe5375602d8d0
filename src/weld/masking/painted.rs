//! Strokes of a brush that add pixels to a mask or take them away.

use crate::weld::raster::Mask;

/// A stroke of a round brush.
#[derive(Clone, Debug, PartialEq)]
pub struct BrushStroke {
    /// Where its middle went, u and v, pixels.
    pub way_px: Vec<[f64; 2]>,
    /// Radius of the brush, pixels.
    pub radius_px: f64,
    /// Whether it adds pixels; else it takes them away.
    pub adds: bool,
}

crate::part::keyed!(BrushStroke { way_px, radius_px, adds });

/// The mask after the strokes, the last one on top.
pub fn painted(mask: &Mask, strokes: &[BrushStroke]) -> Mask {
    let mut painted = mask.clone();
    for stroke in strokes {
        let way = &stroke.way_px;
        // A dot is a way from its place to itself.
        let ways = way.windows(2).map(|w| [w[0], w[1]]).chain(way.first().map(|p| [*p, *p]));
        ways.for_each(|way| line(&mut painted, way, stroke.radius_px, stroke.adds));
    }
    painted
}

/// All pixels whose middle lies within the radius of a straight way.
fn line(mask: &mut Mask, [from, to]: [[f64; 2]; 2], radius_px: f64, adds: bool) {
    let all = [from[0], from[1], to[0], to[1], radius_px];
    if !(all.iter().all(|x| x.is_finite()) && radius_px >= 0.0) {
        return;
    }
    let along = [to[0] - from[0], to[1] - from[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    // The casts take what is below 0 as 0.
    let span = |k: usize, count: usize| {
        let first = (from[k].min(to[k]) - radius_px).ceil() as usize;
        let end = (from[k].max(to[k]) + radius_px + 1.0).floor().max(0.0) as usize;
        first..end.min(count)
    };
    let (columns, width) = (span(0, mask.width), mask.width);
    for v in span(1, mask.height) {
        for u in columns.clone() {
            let off = [u as f64 - from[0], v as f64 - from[1]];
            let dot = off[0] * along[0] + off[1] * along[1];
            let share = if squared > 0.0 { (dot / squared).clamp(0.0, 1.0) } else { 0.0 };
            let [x, y] = [off[0] - share * along[0], off[1] - share * along[1]];
            if x * x + y * y <= radius_px * radius_px
                && let Some(pixel) = mask.values.get_mut(v * width + u)
            {
                *pixel = adds;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn stroke(way_px: &[[f64; 2]], radius_px: f64, adds: bool) -> BrushStroke {
        BrushStroke { way_px: way_px.to_vec(), radius_px, adds }
    }

    #[test]
    fn a_stroke_is_a_capsule_and_the_next_one_cuts_it() {
        let empty = Mask::filled(200, 100, false);
        let one = painted(&empty, &[stroke(&[[30.0, 50.0], [120.0, 50.0]], 20.0, true)]);
        let exact = PI * 400.0 + 90.0 * 40.0;
        assert!((one.count() as f64 / exact - 1.0).abs() < 0.03, "{} {exact}", one.count());
        let cut = painted(&one, &[stroke(&[[75.0, 50.0]], 20.0, false)]);
        assert!((cut.count() as f64 / (exact - PI * 400.0) - 1.0).abs() < 0.03, "{}", cut.count());
        assert_eq!((cut.at(75, 50), cut.at(30, 50), cut.at(120, 69)), (Some(&false), Some(&true), Some(&true)));
    }

    #[test]
    fn strokes_outside_and_without_sense_change_nothing() {
        let mask = Mask::filled(20, 10, true);
        let strokes = [
            stroke(&[[-50.0, -50.0], [-30.0, 5.0]], 10.0, false),
            stroke(&[[1e300, 5.0], [-1e300, 5.0]], 1.0, true),
            stroke(&[[f64::NAN, 5.0]], 10.0, false),
            stroke(&[[5.0, 5.0]], -1.0, false),
            stroke(&[[5.0, 5.0]], f64::INFINITY, false),
            stroke(&[], 5.0, false),
        ];
        assert_eq!(painted(&mask, &strokes), mask);
        assert_eq!(painted(&mask, &[stroke(&[[5.0, 5.0]], 0.0, false)]).count(), 199);
    }
}
