//! The border that offset lines start from, as a thick line on the part.

use crate::part::Hasher;
use crate::path::strategy::offset::Border;
use crate::view::{Depth, LineItem, LineSegment};
use nalgebra::Isometry3;
use std::sync::Arc;

/// Brighter than any surface, and no colour of a state.
const COLOR: [u8; 4] = [255, 222, 0, 255];
/// Several times as wide as path lines.
const WIDTH_PX: f32 = 6.0;

/// The line of a border.
pub fn item(border: &Border) -> LineItem {
    let digest = border.edges.iter().flatten().fold(Hasher::default(), |h, p| h.f64s(p.coords.as_slice()));
    let ends = border.edges.iter().map(|e| e.map(|p| [p.x as f32, p.y as f32, p.z as f32]));
    LineItem {
        key: digest.finish().0 as u64,
        segments: Arc::new(ends.map(|[a, b]| LineSegment { a, b, color: COLOR }).collect()),
        width_px: WIDTH_PX,
        depth: Depth::Tested,
        scene_from_item: Isometry3::identity(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    #[test]
    fn another_border_is_another_line() {
        let edge = |x: f64| [Point3::new(x, 0.0, 0.0), Point3::new(x, 1.0, 0.0)];
        let border = |x: f64| Border { length_mm: 2.0, edges: vec![edge(x), edge(x + 1.0)] };
        let (one, same, other) = (item(&border(0.0)), item(&border(0.0)), item(&border(5.0)));
        assert_eq!(one.segments.len(), 2);
        assert_eq!((one.key, &one.segments), (same.key, &same.segments));
        assert_ne!(one.key, other.key, "same key is same data");
    }
}
