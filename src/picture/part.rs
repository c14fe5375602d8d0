//! The part: facets in the colours of their surfaces, creases as lines.

use super::palette::{Palette, Rgb, mixed, scan, state};
use crate::part::surfaces::Surface;
use crate::part::{Digest, Hasher, Mesh, Part, Surfaces};
use crate::view::{Bounds, MeshEdges, MeshItem};
use nalgebra::{Isometry3, Point3};
use rayon::prelude::*;
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
    /// Of the facets, whichever surfaces they are in.
    key: Digest,
    positions: Arc<Vec<[f32; 3]>>,
    /// Of the surfaces.
    surfaces_key: Digest,
    edges: MeshEdges,
    palette: Palette,
    /// The box around the part, mm.
    pub bounds: Bounds,
}

fn f32s(p: &Point3<f64>) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}

impl PartPicture {
    /// Builds the buffers; those of the facets are taken over from a picture of the same part.
    pub fn new(part: &Part, surfaces: &Surfaces, before: Option<&PartPicture>) -> PartPicture {
        let mesh = &part.mesh;
        let before = before.filter(|before| before.key == part.digest);
        let surfaces_key = Hasher::default().digest(part.digest).u32s(&surfaces.of_facet).finish();
        let creases = creases(mesh, surfaces);
        let lines = creases.iter().map(|&e| mesh.edges[e as usize].map(|v| f32s(&mesh.vertices[v as usize]))).collect();
        let (min, max) = mesh.bounds();
        PartPicture {
            key: part.digest,
            positions: before.map_or_else(|| Arc::new(shown_positions(mesh)), |before| before.positions.clone()),
            surfaces_key,
            edges: MeshEdges { key: surfaces_key.0 as u64, lines: Arc::new(lines) },
            palette: Palette::new(mesh, surfaces, &creases),
            bounds: Bounds { min, max },
        }
    }

    /// Colour of a surface in the view, as its swatch in the lists.
    pub fn swatch(&self, surface: u32, chosen: bool) -> Rgb {
        self.palette.color(surface, chosen)
    }

    /// The part under a look.
    pub fn item(&self, surfaces: &Surfaces, look: &PartLook) -> MeshItem {
        let chosen: BTreeSet<u32> = look.chosen.iter().copied().collect();
        let shown = |s: &Surface| self.surface_color(s.number, chosen.contains(&s.number), look);
        let of_surface: Vec<[u8; 4]> = surfaces.list.iter().map(shown).collect();
        let key = Hasher::default().digest(self.surfaces_key).bytes(of_surface.as_flattened());
        let key = key.u32s(&look.missed).u32s(&look.left_out).finish();
        let mut colors = vec![[0; 4]; surfaces.of_facet.len()];
        for (s, color) in surfaces.list.iter().zip(&of_surface) {
            s.facets.iter().for_each(|&f| colors[f as usize] = *color);
        }
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
        let nothing_hidden = of_surface.iter().all(|color| color[3] > 0);
        MeshItem {
            geometry_key: self.key.0 as u64,
            positions: self.positions.clone(),
            colors_key: key.0 as u64,
            facet_colors: Arc::new(colors),
            edges: nothing_hidden.then(|| self.edges.clone()),
            scene_from_item: Isometry3::identity(),
        }
    }

    fn surface_color(&self, surface: u32, chosen: bool, look: &PartLook) -> [u8; 4] {
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

fn shown_positions(mesh: &Mesh) -> Vec<[f32; 3]> {
    let apart_mm = SIDES_APART * mesh.diagonal();
    let shown = |facet: usize| shown_corners(mesh, facet, apart_mm).map(|p| f32s(&p));
    (0..mesh.facets.len()).into_par_iter().flat_map_iter(shown).collect()
}

fn shown_corners(mesh: &Mesh, facet: usize, apart_mm: f64) -> [Point3<f64>; 3] {
    let corners = mesh.corners(facet);
    match mesh.back_of(facet as u32) {
        Some(_) => corners.map(|p| p + mesh.normals[facet] * apart_mm),
        None => corners,
    }
}

/// Edges between surfaces, and open ones.
fn creases(mesh: &Mesh, surfaces: &Surfaces) -> Vec<u32> {
    let parts = |[f, g]: [u32; 2]| surfaces.of_facet[f as usize] != surfaces.of_facet[g as usize];
    let is_crease = |e: &u32| {
        let mut pairs = mesh.pairs(*e).peekable();
        pairs.peek().is_none() || pairs.any(parts)
    };
    (0..mesh.edges.len() as u32).into_par_iter().filter(is_crease).collect()
}
