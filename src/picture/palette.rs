//! Colours of surfaces: ten pairs (muted, strong) that colour-blind people tell apart, after Paul
//! Tol's light and bright schemes; surfaces that share an edge get different ones.

use crate::part::{Mesh, Surfaces};
use std::collections::{BTreeMap, BTreeSet};

/// An opaque colour.
pub type Rgb = [u8; 3];

const PAIRS: [(Rgb, Rgb); 10] = [
    ([126, 163, 204], [0, 101, 189]),
    ([222, 158, 132], [214, 84, 20]),
    ([222, 210, 150], [204, 160, 0]),
    ([222, 172, 186], [214, 50, 120]),
    ([158, 205, 222], [0, 158, 208]),
    ([122, 186, 166], [0, 138, 104]),
    ([190, 200, 124], [134, 154, 0]),
    ([184, 168, 212], [118, 70, 186]),
    ([198, 182, 160], [146, 98, 48]),
    ([168, 178, 186], [92, 110, 126]),
];

/// The colours of states, the same everywhere.
pub mod state {
    use super::Rgb;
    /// Along the normal.
    pub const FREE: Rgb = [22, 48, 130];
    /// Tilted out of the way.
    pub const CORRECTED: Rgb = [236, 132, 0];
    /// Laser off.
    pub const BLOCKED: Rgb = [222, 22, 34];
    /// Done before a stop.
    pub const DONE: Rgb = [150, 154, 162];
    /// Lines that are laid, and not planned yet.
    pub const LAID: Rgb = [70, 76, 88];
    /// Connecting moves.
    pub const AIR: Rgb = [130, 136, 146];
    /// Facets that no line reaches.
    pub const MISSED: Rgb = [200, 40, 160];
    /// The part without colours (P1 Fig. 2).
    pub const PLAIN: Rgb = [92, 94, 98];
}

/// Colours of scans, and of how they lie off the model. Missing, surplus, within the tolerance and not scanned are at
/// least 8 of OKLab's hundredths apart to every kind of colour blindness, and all stand out from the dark view.
pub mod scan {
    use super::Rgb;
    /// Points without colours of their own.
    pub const POINTS: Rgb = [184, 194, 208];
    /// Points that cleaning drops.
    pub const DROPPED: Rgb = [255, 128, 0];
    /// As the model.
    pub const WITHIN: Rgb = [196, 214, 196];
    /// No point there, or no model near the point.
    pub const NOT_SCANNED: Rgb = [112, 114, 120];
    /// Less than the model, from the tolerance to the limit.
    pub const MISSING: [Rgb; 3] = [[250, 198, 64], [242, 132, 30], [222, 52, 30]];
    /// Less than the limit.
    pub const MORE_MISSING: Rgb = [214, 70, 184];
    /// More than the model, from the tolerance to the limit.
    pub const SURPLUS: [Rgb; 3] = [[120, 196, 244], [72, 146, 255], [66, 102, 246]];
    /// More than the limit.
    pub const MORE_SURPLUS: Rgb = [172, 130, 244];
    /// Facets that do not count when a scan is laid.
    pub const LEFT_OUT: Rgb = [78, 80, 86];
    /// What an operator sets: brush strokes, boxes, planes, picked points.
    pub const REGION: Rgb = [250, 222, 70];
    /// Outlines of patches.
    pub const OUTLINE: Rgb = [20, 22, 26];
}

/// Colour of each surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Palette(BTreeMap<u32, usize>);

impl Palette {
    /// Gives each surface the least used colour that no neighbour with a lower number has; neighbours meet at one of
    /// the edges `creases`.
    pub fn new(mesh: &Mesh, surfaces: &Surfaces, creases: &[u32]) -> Palette {
        let mut neighbours: BTreeMap<u32, BTreeSet<u32>> = BTreeMap::new();
        for &e in creases {
            for pair in mesh.edge_facets(e).windows(2) {
                let (a, b) = (surfaces.of_facet[pair[0] as usize], surfaces.of_facet[pair[1] as usize]);
                if a != b {
                    neighbours.entry(a.max(b)).or_default().insert(a.min(b));
                }
            }
        }
        let mut colors: BTreeMap<u32, usize> = BTreeMap::new();
        let mut used = [0usize; PAIRS.len()];
        for s in &surfaces.list {
            let taken: Vec<usize> =
                neighbours.get(&s.number).into_iter().flatten().filter_map(|n| colors.get(n).copied()).collect();
            let best = (0..PAIRS.len()).min_by_key(|c| (taken.contains(c), used[*c], *c)).unwrap_or(0);
            used[best] += 1;
            colors.insert(s.number, best);
        }
        Palette(colors)
    }

    /// Colour of a surface: muted, or strong when it is to be cleaned.
    pub fn color(&self, surface: u32, strong: bool) -> Rgb {
        let pair = PAIRS[self.0.get(&surface).copied().unwrap_or(9)];
        if strong { pair.1 } else { pair.0 }
    }
}

/// `a` with a share of `b`.
pub fn mixed(a: Rgb, b: Rgb, share: f32) -> Rgb {
    std::array::from_fn(|k| (f32::from(a[k]) * (1.0 - share) + f32::from(b[k]) * share).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{MergeTree, SurfaceRule, merge_tree::dihedral_angles};

    #[test]
    fn neighbours_differ() {
        let raw: Vec<[[f32; 3]; 3]> =
            crate::sample::solids::cube(2.0).iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        let mesh = Mesh::weld(&raw, 1.0);
        let dihedral = dihedral_angles(&mesh);
        let rule = SurfaceRule { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
        let surfaces = Surfaces::new(&mesh, &MergeTree::new(&mesh, &dihedral), &dihedral, &rule, &[], &[]);
        let all: Vec<u32> = (0..mesh.edges.len() as u32).collect();
        let palette = Palette::new(&mesh, &surfaces, &all);
        for s in &surfaces.list {
            for n in surfaces.neighbours(&mesh, s.number) {
                assert_ne!(palette.color(s.number, false), palette.color(n, false));
            }
        }
    }
}
