//! What is shown, as plain data: no OpenGL here, so that a scene can be built on any thread and
//! tests can look inside it.
//!
//! Every item names its data with a key. **Same key = same data**: the renderer then reuses what
//! is already on the graphics card and does not look at the data again. Derive keys from a hash
//! of the inputs; two items of one kind may share a key only if they share the data. Where an item
//! stands is no part of its data: what moves keeps its key.

use super::cloud::CloudItem;
use nalgebra::Isometry3;
use std::sync::Arc;

/// 8-bit sRGB colour and straight (not premultiplied) alpha.
pub type Rgba = [u8; 4];

/// Everything in one picture, drawn in this order: background, meshes, clouds, crease lines of the meshes,
/// tested lines and points, then lines and points on top.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Colour of the upper edge of the picture.
    pub background_top: [u8; 3],
    /// Colour of the lower edge; between them a vertical gradient.
    pub background_bottom: [u8; 3],
    /// Triangles.
    pub meshes: Vec<MeshItem>,
    /// Lines of constant width on the screen.
    pub lines: Vec<LineItem>,
    /// Round dots of constant size on the screen.
    pub points: Vec<PointItem>,
    /// Measured points by the million.
    pub clouds: Vec<CloudItem>,
    /// What is cut away of one of the meshes.
    pub cut: Option<MeshCut>,
}

/// A plane below which a mesh is not drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshCut {
    /// Whose facets.
    pub geometry_key: u64,
    /// Unit normal and distance in the item's frame: what has `normal · p + distance` below 0 is cut away.
    pub plane: [f32; 4],
}

/// Triangles with one colour per facet, or per corner.
#[derive(Debug, Clone)]
pub struct MeshItem {
    /// Names `positions`.
    pub geometry_key: u64,
    /// Three corners per facet, counter-clockwise seen from outside, nothing shared: so a
    /// colour ends where its facet ends.
    pub positions: Arc<Vec<[f32; 3]>>,
    /// Names `facet_colors` for this geometry; a new key uploads colours only.
    pub colors_key: u64,
    /// One colour per facet; or one per corner, which then run into each other. Alpha 0 hides the facet (all
    /// corners the same), alpha below 255 lets shine through (unsorted: meant for envelopes and beams, not for parts).
    pub facet_colors: Arc<Vec<Rgba>>,
    /// Crease lines, drawn thin and dark over the facets.
    pub edges: Option<MeshEdges>,
    /// Where it stands.
    pub scene_from_item: Isometry3<f64>,
}

/// Lines along edges of a mesh.
#[derive(Debug, Clone)]
pub struct MeshEdges {
    /// Names `lines`.
    pub key: u64,
    /// Both ends of each, in the item's frame.
    pub lines: Arc<Vec<[[f32; 3]; 2]>>,
}

/// One straight piece of a line, in one colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineSegment {
    /// Start, mm.
    pub a: [f32; 3],
    /// End, mm.
    pub b: [f32; 3],
    /// Colour of the whole piece.
    pub color: Rgba,
}

/// Lines that keep their width in pixels at any zoom.
#[derive(Debug, Clone)]
pub struct LineItem {
    /// Names `segments`.
    pub key: u64,
    /// The pieces; a polyline is a row of pieces that share ends.
    pub segments: Arc<Vec<LineSegment>>,
    /// Width in physical pixels.
    pub width_px: f32,
    /// Hidden behind meshes or not.
    pub depth: Depth,
    /// Where it stands.
    pub scene_from_item: Isometry3<f64>,
}

/// Round dots that keep their size in pixels at any zoom.
#[derive(Debug, Clone)]
pub struct PointItem {
    /// Names `points`.
    pub key: u64,
    /// Centre in mm, and colour.
    pub points: Arc<Vec<([f32; 3], Rgba)>>,
    /// Diameter in physical pixels.
    pub size_px: f32,
    /// Hidden behind meshes or not.
    pub depth: Depth,
    /// Where it stands.
    pub scene_from_item: Isometry3<f64>,
}

/// Whether meshes hide a line or a dot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Depth {
    /// Hidden behind what is nearer; lies cleanly on a surface it coincides with.
    #[default]
    Tested,
    /// Always seen.
    OnTop,
}

impl Default for Scene {
    /// An empty scene on the dark background.
    fn default() -> Self {
        Self {
            background_top: [58, 66, 78],
            background_bottom: [28, 31, 37],
            meshes: Vec::new(),
            lines: Vec::new(),
            points: Vec::new(),
            clouds: Vec::new(),
            cut: None,
        }
    }
}

impl MeshItem {
    /// Number of whole facets; a rest of one or two corners is not drawn.
    pub fn facet_count(&self) -> usize {
        self.positions.len() / 3
    }
}

impl Scene {
    /// Number of points in all clouds.
    pub fn cloud_points(&self) -> u64 {
        self.clouds.iter().map(|cloud| u64::from(cloud.count())).sum()
    }

    /// One number per thing that decides the picture: equal stamps, equal pictures (as long as
    /// keys keep their promise). Compared as a whole, so that no two scenes can be confused.
    pub(super) fn stamp(&self) -> Vec<u64> {
        let [top, bottom] =
            [self.background_top, self.background_bottom].map(|[r, g, b]| u64::from(u32::from_be_bytes([0, r, g, b])));
        let counts = [self.meshes.len(), self.lines.len(), self.points.len()].map(|count| count as u64);
        let mut stamp = [[top, bottom].as_slice(), &counts].concat();
        let cut = self.cut.into_iter();
        stamp.extend(
            cut.flat_map(|cut| [cut.geometry_key].into_iter().chain(cut.plane.map(|c| u64::from(c.to_bits())))),
        );
        for mesh in &self.meshes {
            stamp.extend([mesh.geometry_key, mesh.colors_key]);
            // Their number first, or keys could run into each other.
            stamp.push(u64::from(mesh.edges.is_some()));
            stamp.extend(mesh.edges.iter().map(|edges| edges.key));
            stamp.extend(place(&mesh.scene_from_item));
        }
        for line in &self.lines {
            stamp.extend([line.key, size_and_depth(line.width_px, line.depth)]);
            stamp.extend(place(&line.scene_from_item));
        }
        for dots in &self.points {
            stamp.extend([dots.key, size_and_depth(dots.size_px, dots.depth)]);
            stamp.extend(place(&dots.scene_from_item));
        }
        for cloud in &self.clouds {
            stamp.extend(cloud.stamp());
            stamp.extend(place(&cloud.scene_from_item));
        }
        stamp
    }
}

fn size_and_depth(size_px: f32, depth: Depth) -> u64 {
    u64::from(size_px.to_bits()) << 1 | u64::from(depth == Depth::OnTop)
}

fn place(scene_from_item: &Isometry3<f64>) -> impl Iterator<Item = u64> {
    let (t, q) = (scene_from_item.translation.vector, scene_from_item.rotation.coords);
    [t.x, t.y, t.z, q.x, q.y, q.z, q.w].into_iter().map(f64::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamp_sees_colours_edges_and_widths() {
        let mesh = MeshItem {
            geometry_key: 1,
            positions: Arc::new(vec![[0.0; 3]; 3]),
            colors_key: 2,
            facet_colors: Arc::new(vec![[1, 2, 3, 255]]),
            edges: None,
            scene_from_item: Isometry3::identity(),
        };
        let scene_from_item = Isometry3::identity();
        let line = LineItem { key: 3, segments: Arc::default(), width_px: 2.0, depth: Depth::Tested, scene_from_item };
        let scene = Scene { meshes: vec![mesh], lines: vec![line], ..Scene::default() };
        let stamp = scene.stamp();
        assert_eq!(stamp, scene.clone().stamp());

        let changes: [fn(&mut Scene); 8] = [
            |s| s.cut = Some(MeshCut { geometry_key: 1, plane: [0.0, 0.0, 1.0, 2.0] }),
            |s| s.meshes[0].colors_key = 9,
            |s| s.meshes[0].edges = Some(MeshEdges { key: 0, lines: Arc::default() }),
            |s| s.meshes[0].edges = Some(MeshEdges { key: 5, lines: Arc::default() }),
            |s| s.lines[0].width_px = 3.0,
            |s| s.lines[0].depth = Depth::OnTop,
            |s| s.background_top = [0; 3],
            |s| s.meshes[0].scene_from_item.translation.x = 0.5,
        ];
        for change in changes {
            let mut other = scene.clone();
            change(&mut other);
            assert_ne!(stamp, other.stamp());
        }
    }
}
