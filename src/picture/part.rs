//! The part: facets in the colours of their surfaces, creases as lines.

use super::palette::{Palette, Rgb, mixed, scan, state};
use crate::part::{Hasher, Mesh, Part, Surfaces};
use crate::view::{Bounds, MeshItem};
use nalgebra::{Isometry3, Point3};
use std::collections::BTreeSet;
use std::sync::Arc;

/// How surfaces are shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartLook {
    /// Surfaces to clean: shown in their strong colour.
    pub chosen: Vec<u32>,
    /// Selected ones: brighter.
    pub selected: BTreeSet<u32>,
    /// The one under the cursor.
    pub hovered: Option<u32>,
    /// Not shown.
    pub hidden: BTreeSet<u32>,
    /// Chosen ones are not shown (P1 Fig. 3).
    pub hide_chosen: bool,
    /// One grey for all (P1 Fig. 2).
    pub plain: bool,
    /// Facets that no line reaches.
    pub missed: Arc<Vec<u32>>,
    /// Facets that do not count when a scan is laid: grey.
    pub left_out: Arc<Vec<u32>>,
}

/// The part's buffers, kept while part and surfaces stay.
#[derive(Clone, Debug)]
pub struct PartPicture {
    key: u64,
    positions: Arc<Vec<[f32; 3]>>,
    edges: Arc<Vec<[[f32; 3]; 2]>>,
    palette: Palette,
    /// The box around the part, mm.
    pub bounds: Bounds,
}

fn f32s(p: &Point3<f64>) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}

impl PartPicture {
    /// Builds the buffers.
    pub fn new(part: &Part, surfaces: &Surfaces) -> PartPicture {
        let mesh = &part.mesh;
        let key = Hasher::default().digest(part.digest).u32s(&surfaces.of_facet).finish();
        let apart_mm = SIDES_APART * mesh.diagonal();
        let shown = |f: usize| shown_corners(mesh, f, apart_mm);
        let positions = (0..mesh.facets.len()).flat_map(shown).map(|p| f32s(&p)).collect();
        let edges = creases(mesh, surfaces);
        let (min, max) = mesh.bounds();
        PartPicture {
            key: key.0 as u64,
            positions: Arc::new(positions),
            edges: Arc::new(edges),
            palette: Palette::new(mesh, surfaces),
            bounds: Bounds { min, max },
        }
    }

    /// Colour of a surface in the view, as its swatch in the lists.
    pub fn swatch(&self, surface: u32, chosen: bool) -> Rgb {
        self.palette.color(surface, chosen)
    }

    /// The part under a look.
    pub fn item(&self, surfaces: &Surfaces, look: &PartLook) -> MeshItem {
        let mut colors: Vec<[u8; 4]> = surfaces.of_facet.iter().map(|&n| self.facet_color(n, look)).collect();
        for &f in look.missed.iter() {
            if let Some(c) = colors.get_mut(f as usize).filter(|c| c[3] > 0) {
                let [r, g, b] = mixed([c[0], c[1], c[2]], state::MISSED, 0.7);
                *c = [r, g, b, c[3]];
            }
        }
        for &f in look.left_out.iter() {
            if let Some(c) = colors.get_mut(f as usize).filter(|c| c[3] > 0) {
                let [r, g, b] = scan::LEFT_OUT;
                *c = [r, g, b, c[3]];
            }
        }
        let flat: Vec<u32> = colors.iter().map(|c| u32::from_le_bytes(*c)).collect();
        let nothing_hidden = colors.iter().all(|c| c[3] > 0);
        MeshItem {
            geometry_key: if nothing_hidden { self.key } else { self.key ^ 1 },
            positions: self.positions.clone(),
            colors_key: Hasher::default().u32s(&flat).finish().0 as u64,
            facet_colors: Arc::new(colors),
            edges: nothing_hidden.then(|| self.edges.clone()),
            scene_from_item: Isometry3::identity(),
        }
    }

    fn facet_color(&self, surface: u32, look: &PartLook) -> [u8; 4] {
        let chosen = look.chosen.contains(&surface);
        if look.hidden.contains(&surface) || (look.hide_chosen && chosen) {
            return [0; 4];
        }
        let own = self.palette.color(surface, chosen);
        let mut color = match (look.plain, chosen) {
            (true, _) => state::PLAIN,
            (false, true) => own,
            // What is not chosen steps back, so that what is stands out.
            (false, false) => mixed(own, [150, 152, 156], 0.25),
        };
        if look.selected.contains(&surface) {
            color = mixed(color, [255, 214, 64], 0.55);
        }
        if look.hovered == Some(surface) {
            color = mixed(color, [255, 255, 255], 0.35);
        }
        [color[0], color[1], color[2], 255]
    }
}

/// How far the two sides of a sheet without thickness are drawn apart, share of the part's diagonal: else each would
/// show through the other. A hundredth of a pixel or so.
const SIDES_APART: f64 = 1e-5;

fn shown_corners(mesh: &Mesh, facet: usize, apart_mm: f64) -> [Point3<f64>; 3] {
    let corners = mesh.corners(facet);
    match mesh.back_of(facet as u32) {
        Some(_) => corners.map(|p| p + mesh.normals[facet] * apart_mm),
        None => corners,
    }
}

/// Edges between surfaces, and open ones.
fn creases(mesh: &Mesh, surfaces: &Surfaces) -> Vec<[[f32; 3]; 2]> {
    (0..mesh.edges.len())
        .filter(|&e| {
            let mut pairs = mesh.pairs(e as u32).peekable();
            let parts = |[f, g]: [u32; 2]| surfaces.of_facet[f as usize] != surfaces.of_facet[g as usize];
            pairs.peek().is_none() || pairs.any(parts)
        })
        .map(|e| mesh.edges[e].map(|v| f32s(&mesh.vertices[v as usize])))
        .collect()
}
