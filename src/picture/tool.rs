//! Head, beam and clamps, or a contact tool (its core, without its round edge), as they stand at a target: the bodies that
//! the proof is about.

use super::palette::Rgb;
use super::solid::ColoredSolid;
use crate::beam::{Frustum, Head, Obstacle, Tool, ToolGeometry};
use crate::part::{Hasher, Part};
use crate::view::MeshItem;
use nalgebra::{Isometry3, Translation3};
use std::sync::Arc;

const HEAD: Rgb = [196, 200, 208];
/// The beam.
pub const LIGHT: Rgb = [255, 120, 70];
const CLAMP: Rgb = [120, 126, 138];
const ABRASIVE: Rgb = [150, 110, 70];
/// The part is seen through the head.
const HEAD_ALPHA: u8 = 120;
const LIGHT_ALPHA: u8 = 110;

/// Solids of a tool, made once.
pub struct ToolPicture {
    head: Vec<ColoredSolid>,
    facets: Option<MeshItem>,
    light: Vec<ColoredSolid>,
    defocus_mm: f64,
    clamps: Vec<MeshItem>,
}

impl ToolPicture {
    /// The solids; `body` is what the plan was made with, and tells how wide the beam is.
    pub fn new(tool: &Tool, body: Option<&ToolGeometry<'_>>) -> ToolPicture {
        let turned = |f: &Frustum, color, alpha| {
            ColoredSolid::turned(
                &[[0.0, f.t0_mm], [f.r0_mm, f.t0_mm], [f.r1_mm, f.t1_mm], [0.0, f.t1_mm]],
                color,
                alpha,
            )
        };
        let head = match &tool.head {
            Some(Head::Stack(_)) => body.map_or(&[][..], |b| &b.head),
            _ => &[],
        };
        // What grinds stands in place of head and beam.
        let contact = body.and_then(|b| b.contact.as_ref().map(|c| (b, c)));
        let (head, abrasive) = match contact {
            Some((b, contact)) => (&b.head[..], &contact.core[..]),
            None => (head, &[][..]),
        };
        let with_head = body.filter(|b| b.has_head);
        ToolPicture {
            head: abrasive
                .iter()
                .map(|f| turned(f, ABRASIVE, 255))
                .chain(head.iter().map(|f| turned(f, HEAD, HEAD_ALPHA)))
                .collect(),
            facets: tool
                .head
                .as_ref()
                .filter(|_| contact.is_none())
                .and_then(Head::solid)
                .map(|p| facets(p, HEAD, HEAD_ALPHA)),
            light: with_head
                .map_or_else(Vec::new, |b| b.beam_with(0.0).iter().map(|f| turned(f, LIGHT, LIGHT_ALPHA)).collect()),
            defocus_mm: body.map_or(0.0, |b| b.defocus_mm),
            clamps: tool.clamps.iter().map(obstacle).collect(),
        }
    }

    /// Head and beam with the focus in a path frame.
    pub fn at(&self, scene_from_focus: &Isometry3<f64>, with_light: bool) -> Vec<MeshItem> {
        // The solids are measured from the spot.
        let spot = scene_from_focus * Translation3::new(0.0, 0.0, -self.defocus_mm);
        let light = self.light.iter().filter(|_| with_light);
        let mut out: Vec<MeshItem> = self.head.iter().chain(light).map(|s| s.at(spot)).collect();
        out.extend(self.facets.iter().map(|f| MeshItem { scene_from_item: *scene_from_focus, ..f.clone() }));
        out
    }

    /// What stands on the part.
    pub fn clamps(&self, scene_from_part: &Isometry3<f64>) -> impl Iterator<Item = MeshItem> + '_ {
        let place = *scene_from_part;
        self.clamps.iter().map(move |c| MeshItem { scene_from_item: place * c.scene_from_item, ..c.clone() })
    }
}

/// A body of facets where it stands.
pub(super) fn obstacle(o: &Obstacle) -> MeshItem {
    MeshItem { scene_from_item: o.at(), ..facets(o.solid(), CLAMP, 255) }
}

/// The facets of a file in its own frame, in one colour.
pub(super) fn facets(part: &Part, [r, g, b]: Rgb, alpha: u8) -> MeshItem {
    let mesh = &part.mesh;
    let corners = (0..mesh.facets.len()).flat_map(|f| mesh.corners(f));
    MeshItem {
        geometry_key: Hasher::default().digest(part.digest).finish().0 as u64,
        positions: Arc::new(corners.map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect()),
        colors_key: u64::from(u32::from_be_bytes([r, g, b, alpha])),
        facet_colors: Arc::new(vec![[r, g, b, alpha]; mesh.facets.len()]),
        edges: None,
        scene_from_item: Isometry3::identity(),
    }
}
