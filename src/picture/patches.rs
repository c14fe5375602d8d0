//! The outlines of patches on the model: dark lines, seen on every colour of the scale. Where a patch's
//! number stands is for its owner to say, as it is painted over the view with letters.

use super::palette::scan;
use crate::part::Hasher;
use crate::view::{Depth, LineItem, LineSegment};
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// Wider than path lines, so that a patch is found among them.
const WIDTH_PX: f32 = 3.5;
/// A chosen patch is found among the others.
const CHOSEN_WIDTH_PX: f32 = 7.0;

/// The outline of one patch. Part frame, mm.
#[derive(Clone, Copy, Debug)]
pub struct PatchOutline<'a> {
    /// The pieces of its lines, in any order.
    pub pieces: &'a [[Point3<f64>; 2]],
    /// Chosen ones are wider.
    pub chosen: bool,
}

/// The lines of all patches.
pub fn outlines(patches: &[PatchOutline<'_>]) -> Vec<LineItem> {
    let of = |chosen: bool| patches.iter().filter(move |p| p.chosen == chosen).flat_map(|p| p.pieces);
    vec![item(of(false), WIDTH_PX), item(of(true), CHOSEN_WIDTH_PX)]
}

fn item<'a>(pieces: impl Iterator<Item = &'a [Point3<f64>; 2]>, width_px: f32) -> LineItem {
    let [r, g, b] = scan::OUTLINE;
    let color = [r, g, b, 255];
    let segments: Vec<LineSegment> = pieces
        .map(|piece| piece.map(|p| [p.x as f32, p.y as f32, p.z as f32]))
        .map(|[a, b]| LineSegment { a, b, color })
        .collect();
    let bits = |s: &LineSegment| [s.a, s.b].as_flattened().iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let bits: Vec<u32> = segments.iter().flat_map(bits).collect();
    LineItem {
        key: Hasher::default().u32s(&bits).finish().0 as u64,
        segments: Arc::new(segments),
        width_px,
        depth: Depth::Tested,
        scene_from_item: Isometry3::identity(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chosen_patch_is_drawn_wider() {
        let piece = |x: f64| [[Point3::new(x, 0.0, 0.0), Point3::new(x, 1.0, 0.0)]];
        let (one, two) = (piece(0.0), piece(5.0));
        let patches = [false, true].map(|chosen| PatchOutline { pieces: if chosen { &two } else { &one }, chosen });
        let lines = outlines(&patches);
        assert_eq!(lines.iter().map(|l| l.segments[0].a[0]).collect::<Vec<_>>(), [0.0, 5.0]);
        assert!(lines[1].width_px > lines[0].width_px);
        assert_ne!(lines[0].key, lines[1].key, "same key is same data");
    }
}
