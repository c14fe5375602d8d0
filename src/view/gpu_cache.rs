//! The buffers on the graphics card, by key: uploaded when an item is first seen, dropped when it is no longer in
//! the scene.

use super::cloud::CloudItem;
use super::gpu_cloud::{CloudColors, CloudPlaces};
use super::gpu_mesh::{MeshColors, MeshGeometry};
use super::gpu_strokes::{Dots, Lines, QuadIndices};
use super::scene::{LineSegment, MeshItem, Rgba, Scene};
use std::collections::{HashMap, HashSet};
use three_d::Context;

/// Crease lines: dark enough to part two facets of one colour, too faint to look like a path.
const EDGE_COLOR: Rgba = [14, 18, 26, 170];

/// The buffers. Looked up by key only, so hash order decides nothing.
pub(super) struct GpuCache {
    context: Context,
    pub geometry: HashMap<u64, MeshGeometry>,
    /// By geometry and colour key.
    pub colors: HashMap<(u64, u64), MeshColors>,
    pub edges: HashMap<u64, Lines>,
    pub lines: HashMap<u64, Lines>,
    pub dots: HashMap<u64, Dots>,
    pub cloud_places: HashMap<u64, CloudPlaces>,
    /// By geometry and colour key.
    pub cloud_colors: HashMap<(u64, u64), CloudColors>,
    pub indices: QuadIndices,
    /// Buffers made so far, for tests of the reuse.
    pub uploads: u64,
}

impl GpuCache {
    pub fn new(context: &Context) -> Self {
        Self {
            context: context.clone(),
            geometry: HashMap::new(),
            colors: HashMap::new(),
            edges: HashMap::new(),
            lines: HashMap::new(),
            dots: HashMap::new(),
            cloud_places: HashMap::new(),
            cloud_colors: HashMap::new(),
            indices: QuadIndices::new(context),
            uploads: 0,
        }
    }

    /// Brings the buffers in line with the scene: uploads what is missing, drops what is no longer in it. A mesh of more
    /// facets than a moving camera may see has a coarser one beside it.
    pub fn follow(&mut self, scene: &Scene, moving_facets: usize) {
        self.drop_unused(scene);
        self.follow_clouds(scene);
        let Self { context, geometry, colors, edges, lines, dots, indices, uploads, .. } = self;
        for item in &scene.meshes {
            let shape = geometry.entry(item.geometry_key).or_insert_with(|| {
                *uploads += 1;
                MeshGeometry::upload(context, item, moving_facets)
            });
            colors.entry(color_key(item)).or_insert_with(|| {
                *uploads += 1;
                MeshColors::upload(context, item, shape)
            });
            if let Some(creases) = &item.edges {
                edges.entry(creases.key).or_insert_with(|| {
                    *uploads += 1;
                    let dark = creases.lines.iter().map(|&[a, b]| LineSegment { a, b, color: EDGE_COLOR });
                    Lines::upload(context, dark, indices)
                });
            }
        }
        for item in &scene.lines {
            lines.entry(item.key).or_insert_with(|| {
                *uploads += 1;
                Lines::upload(context, item.segments.iter().copied(), indices)
            });
        }
        for item in &scene.points {
            dots.entry(item.key).or_insert_with(|| {
                *uploads += 1;
                Dots::upload(context, &item.points, indices)
            });
        }
    }

    fn follow_clouds(&mut self, scene: &Scene) {
        let Self { context, cloud_places, cloud_colors, uploads, .. } = self;
        for item in &scene.clouds {
            cloud_places.entry(item.geometry_key).or_insert_with(|| {
                *uploads += 1;
                CloudPlaces::upload(context, item)
            });
            cloud_colors.entry(cloud_color_key(item)).or_insert_with(|| {
                *uploads += 1;
                CloudColors::upload(context, item)
            });
        }
    }

    /// First, so that a new part never needs room beside the old one.
    fn drop_unused(&mut self, scene: &Scene) {
        let meshes = || scene.meshes.iter();
        let shown: HashSet<_> = meshes().map(|item| item.geometry_key).collect();
        self.geometry.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = meshes().filter_map(|item| Some(item.edges.as_ref()?.key)).collect();
        self.edges.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = meshes().map(color_key).collect();
        self.colors.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = scene.lines.iter().map(|item| item.key).collect();
        self.lines.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = scene.points.iter().map(|item| item.key).collect();
        self.dots.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = scene.clouds.iter().map(|item| item.geometry_key).collect();
        self.cloud_places.retain(|key, _| shown.contains(key));
        let shown: HashSet<_> = scene.clouds.iter().map(cloud_color_key).collect();
        self.cloud_colors.retain(|key, _| shown.contains(key));
    }
}

/// Names the colours of an item among all items.
pub(super) fn color_key(item: &MeshItem) -> (u64, u64) {
    (item.geometry_key, item.colors_key)
}

/// Names the colours of a cloud among all clouds.
pub(super) fn cloud_color_key(item: &CloudItem) -> (u64, u64) {
    (item.geometry_key, item.colors_key)
}
