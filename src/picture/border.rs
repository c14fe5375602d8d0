//! The border that offset lines start from, as a thick line on the part.

use super::palette::Rgb;
use crate::part::Hasher;
use crate::path::strategy::offset::Border;
use crate::view::{Depth, LineItem, LineSegment};
use nalgebra::Isometry3;
use std::sync::Arc;

/// Colour and width in pixels: bright on a dark casing, so that it is seen on a surface of any colour.
const STROKES: [(Rgb, f32); 2] = [([20, 22, 26], 8.0), ([255, 212, 0], 4.5)];

/// The lines of a border.
pub fn items(border: &Border) -> Vec<LineItem> {
    let digest = border.edges.iter().flatten().fold(Hasher::default(), |h, p| h.f64s(p.coords.as_slice()));
    let digest = digest.finish();
    let item = |(part, ([red, green, blue], width_px)): (usize, (Rgb, f32))| {
        let color = [red, green, blue, 255];
        let ends = border.edges.iter().map(|e| e.map(|p| [p.x as f32, p.y as f32, p.z as f32]));
        LineItem {
            key: Hasher::default().digest(digest).u32s(&[part as u32]).finish().0 as u64,
            segments: Arc::new(ends.map(|[a, b]| LineSegment { a, b, color }).collect()),
            width_px,
            depth: Depth::Tested,
            scene_from_item: Isometry3::identity(),
        }
    };
    STROKES.into_iter().enumerate().map(item).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    #[test]
    fn another_border_is_another_line() {
        let edge = |x: f64| [Point3::new(x, 0.0, 0.0), Point3::new(x, 1.0, 0.0)];
        let border = |x: f64| Border { length_mm: 2.0, edges: vec![edge(x), edge(x + 1.0)] };
        let (one, same, other) = (items(&border(0.0)), items(&border(0.0)), items(&border(5.0)));
        assert_eq!(one.len(), 2);
        assert!(one.iter().all(|l| l.segments.len() == 2));
        assert!(one[0].width_px > one[1].width_px, "the casing is drawn first and shows beside the line");
        let keys = |items: &[LineItem]| items.iter().map(|l| l.key).collect::<Vec<_>>();
        assert_eq!(keys(&one), keys(&same));
        let all: std::collections::BTreeSet<u64> = [keys(&one), keys(&other)].concat().into_iter().collect();
        assert_eq!(all.len(), 4, "same key is same data");
    }
}
