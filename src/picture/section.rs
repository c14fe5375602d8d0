//! One section plane seen along its normal: the outline of the whole part there, and the beams of
//! its passes before and after (P1 Fig. 8).

use super::paths::{PathLook, paths};
use crate::part::surfaces::Surface;
use crate::part::{Hasher, Part, Surfaces};
use crate::path::normals::VertexNormals;
use crate::path::section::sections;
use crate::planning::Plan;
use crate::view::{Depth, LineItem, LineSegment};
use std::sync::Arc;

/// Lines of the plane of one pass.
pub fn section(part: &Part, surfaces: &Surfaces, plan: &Plan, pass: usize, look: &PathLook, key: u64) -> Vec<LineItem> {
    let Some(p) = plan.passes.get(pass) else { return Vec::new() };
    let Some(first) = p.targets.first() else { return Vec::new() };
    let height = first.p.coords.dot(&p.plane_normal);
    let whole = Surface { number: 0, facets: (0..part.mesh.facets.len() as u32).collect(), area_mm2: 0.0 };
    let normals = VertexNormals::new(&part.mesh, surfaces, &whole);
    let lines = sections(&part.mesh, &whole, &normals, &p.plane_normal, &[height], 1e-6 * part.mesh.diagonal());
    let f = |q: &nalgebra::Point3<f64>| [q.x as f32, q.y as f32, q.z as f32];
    let mut outline = Vec::new();
    for line in &lines {
        let closing = if line.closed { line.points.first() } else { None };
        let ring: Vec<_> = line.points.iter().chain(closing).collect();
        outline.extend(ring.windows(2).map(|w| LineSegment {
            a: f(&w[0].p),
            b: f(&w[1].p),
            color: [96, 102, 112, 255],
        }));
    }
    let outline_key = Hasher::default().u32s(&[key as u32, (key >> 32) as u32, pass as u32]).f64s(&[height]).finish();
    let mut items = vec![LineItem {
        key: outline_key.0 as u64,
        segments: Arc::new(outline),
        width_px: 2.0,
        depth: Depth::Tested,
        scene_from_item: nalgebra::Isometry3::identity(),
    }];
    // All passes in this plane, not only the one that was asked for.
    for (i, other) in plan.passes.iter().enumerate() {
        let same = other.plane_normal == p.plane_normal
            && other.targets.first().is_some_and(|t| (t.p.coords.dot(&p.plane_normal) - height).abs() < 1e-6);
        if same {
            let look = PathLook { lines: true, beams: true, frames: false, only_pass: Some(i), ..look.clone() };
            items.extend(paths(plan, &look, key));
        }
    }
    items
}
