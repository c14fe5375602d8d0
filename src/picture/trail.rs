//! The trail: the way of the spot with the laser on, up to a moment.

use crate::pose::Pass;
use crate::program::{Moment, Timeline};
use crate::view::{Depth, LineItem, LineSegment};
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

/// Segments of one item: whole ones are uploaded once, only the last one changes.
const PIECE: usize = 512;
/// What is done; unlike the colour of any state of a target.
const COLOR: [u8; 4] = [88, 208, 166, 255];

/// The spot's way on the part, in the part frame.
#[derive(Clone, Debug)]
pub struct Trail {
    key: u64,
    /// Defocus distance on the ways, mm.
    defocus_mm: Vec<f64>,
    /// Ways with the laser on, in order, and the stop that each ends at.
    segments: Vec<LineSegment>,
    stops: Vec<usize>,
    pieces: Vec<Arc<Vec<LineSegment>>>,
}

impl Trail {
    /// The whole way of a program. `key` changes with it.
    pub fn new(timeline: &Timeline, passes: &[Pass], key: u64) -> Trail {
        let (mut segments, mut stops, mut all_mm) = (Vec::new(), Vec::new(), Vec::new());
        let (mut before, mut defocus_mm) = (None, 0.0);
        for (i, stop) in timeline.stops().iter().enumerate() {
            // Stops between targets are on the way to one of the same pass, behind one of it.
            defocus_mm =
                stop.target.and_then(|(pass, _)| passes.get(pass)).map_or(defocus_mm, |p| p.settings.defocus_mm);
            let flange = timeline.robot().forward(&stop.joints_deg);
            let spot = spot(&timeline.setup().focus_for(&flange), defocus_mm);
            if let (true, Some(before)) = (stop.lit, before) {
                segments.push(segment(&before, &spot));
                stops.push(i);
                all_mm.push(defocus_mm);
            }
            before = Some(spot);
        }
        let pieces = segments.chunks_exact(PIECE).map(|c| Arc::new(c.to_vec())).collect();
        Trail { key, defocus_mm: all_mm, segments, stops, pieces }
    }

    /// The trail at a moment.
    pub fn until(&self, moment: &Moment, scene_from_part: Isometry3<f64>) -> Vec<LineItem> {
        let done = self.stops.partition_point(|&s| s < moment.stop);
        let item = |number: usize, key: u64, segments| LineItem {
            key: self.key.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (number as u64) << 32 ^ key,
            segments,
            width_px: 2.0,
            depth: Depth::Tested,
            scene_from_item: scene_from_part,
        };
        let whole = done / PIECE;
        let mut items: Vec<LineItem> =
            self.pieces.iter().take(whole).enumerate().map(|(i, piece)| item(i, 0, piece.clone())).collect();
        let mut last = self.segments.get(whole * PIECE..done).unwrap_or_default().to_vec();
        if let (true, Some(way), Some(&defocus_mm)) = (moment.lit, self.segments.get(done), self.defocus_mm.get(done)) {
            let here = spot(&moment.part_from_focus, defocus_mm);
            last.push(LineSegment { b: f32s(&here), ..*way });
        }
        if !last.is_empty() {
            // Named by where it ends: that is what changes from moment to moment.
            let end = last.last().map_or([0.0; 3], |s| s.b);
            let name = crate::part::Hasher::default().f64s(&end.map(f64::from)).u32s(&[last.len() as u32]);
            items.push(item(whole, name.finish().0 as u64 | 1, Arc::new(last)));
        }
        items
    }
}

fn spot(part_from_focus: &Isometry3<f64>, defocus_mm: f64) -> Point3<f64> {
    part_from_focus * Point3::from(Vector3::new(0.0, 0.0, -defocus_mm))
}

fn segment(a: &Point3<f64>, b: &Point3<f64>) -> LineSegment {
    LineSegment { a: f32s(a), b: f32s(b), color: COLOR }
}

fn f32s(p: &Point3<f64>) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}
