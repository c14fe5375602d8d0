//! Feature surfaces: which facets belong to which, their numbers and areas. How they come about is in `numbering`.
//!
//! Numbers count from 1 in the order of the lowest facet. Merging keeps the lowest number,
//! splitting appends new ones: so the settings of surface 7 stay those of surface 7.

use super::fill::Fill;
use super::ground::Ground;
use super::measured::MeasuredPoints;
use super::merge_tree::MergeTree;
use super::numbering::Numbering;
use super::surface::listed;
use super::topology::{Mesh, NO_EDGE};
use super::{SurfaceEdit, SurfaceRule};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

pub use super::surface::Surface;

/// The number of a feature surface, as a type of its own wherever something refers to the surface for good.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SurfaceId(pub u32);

impl fmt::Display for SurfaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// All feature surfaces of a part.
#[derive(Clone, Debug, Default)]
pub struct Surfaces {
    /// Surface number of each facet.
    pub of_facet: Vec<u32>,
    /// The surfaces in the order of their numbers.
    pub list: Vec<Surface>,
    /// Facet normals, on the side to be worked on: outward, or turned where the operator said so.
    pub normals: Vec<Vector3<f64>>,
    /// The highest number that was ever given out: the next surface gets the one after it.
    pub last_number: u32,
    /// Those that a scan tells to work, in place of those that a job chooses; `None` where no scan does.
    pub worked: Option<Vec<SurfaceId>>,
    /// Normals at vertices that say more than the facets around them do, by surface and vertex: see
    /// [`Surfaces::vertex_normal`].
    pub vertex_normals: Vec<VertexNormal>,
    /// What beads are to fill of patches.
    pub fills: Vec<Fill>,
    /// What is ground off them.
    pub grounds: Vec<Ground>,
    /// Points that lines are laid through; `None`: they lie on the facets.
    pub measured: Option<Arc<MeasuredPoints>>,
}

/// The normal that a surface has at a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexNormal {
    /// Number of the surface.
    pub surface: u32,
    /// The vertex.
    pub vertex: u32,
    /// Of unit length, on the side to be worked on.
    pub normal: Vector3<f64>,
}

impl Surfaces {
    /// Segments a part. `flipped` names surfaces whose other side is to be worked on.
    pub fn new(
        mesh: &Mesh,
        tree: &MergeTree,
        dihedral_deg: &[f64],
        rule: &SurfaceRule,
        edits: &[SurfaceEdit],
        flipped: &[u32],
    ) -> Surfaces {
        let mut numbering = Numbering::new(mesh, tree, dihedral_deg, rule);
        for edit in edits {
            numbering.apply(mesh, dihedral_deg, edit);
        }
        let Numbering { of_facet, last_number } = numbering;
        let mut normals = mesh.normals.clone();
        for (f, n) in normals.iter_mut().enumerate() {
            if flipped.contains(&of_facet[f]) {
                *n = -*n;
            }
        }
        let list = listed(mesh, &of_facet);
        Surfaces {
            of_facet,
            list,
            normals,
            last_number,
            worked: None,
            vertex_normals: Vec::new(),
            fills: Vec::new(),
            grounds: Vec::new(),
            measured: None,
        }
    }

    /// Their numbers, ascending.
    pub fn ids(&self) -> impl Iterator<Item = SurfaceId> + '_ {
        self.list.iter().map(|s| SurfaceId(s.number))
    }

    /// The surface of that number.
    pub fn get(&self, number: u32) -> Option<&Surface> {
        self.list.binary_search_by_key(&number, |s| s.number).ok().map(|i| &self.list[i])
    }

    /// The normal of a surface at a vertex, where facets there are pieces of others that were cut and not moved: what it
    /// was before. `None`: as the facets of the surface around the vertex have it.
    pub fn vertex_normal(&self, surface: u32, vertex: u32) -> Option<Vector3<f64>> {
        let at = self.vertex_normals.binary_search_by_key(&(surface, vertex), |n| (n.surface, n.vertex)).ok()?;
        Some(self.vertex_normals[at].normal)
    }

    /// What beads are to fill of a surface; `None`: it is no patch, or no bead fills it.
    pub fn fill(&self, number: u32) -> Option<&Fill> {
        self.fills.iter().find(|f| f.surface == number)
    }

    /// What is ground off a surface; `None`: nothing is.
    pub fn ground(&self, number: u32) -> Option<&Ground> {
        self.grounds.iter().find(|g| g.surface == number)
    }

    /// Numbers of the surfaces that share an edge with this one, ascending.
    pub fn neighbours(&self, mesh: &Mesh, number: u32) -> Vec<u32> {
        let mut found: Vec<u32> = self
            .get(number)
            .into_iter()
            .flat_map(|s| &s.facets)
            .flat_map(|&f| mesh.facet_edges[f as usize])
            .filter(|&e| e != NO_EDGE)
            .flat_map(|e| mesh.edge_facets(e))
            .map(|&g| self.of_facet[g as usize])
            .filter(|&n| n != number)
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

#[cfg(test)]
mod tests {
    use super::super::merge_tree::dihedral_angles;
    use super::*;
    use crate::part::raw_part::RawFacet;

    /// Quads of unit width; each bends by so many degrees and is so long.
    fn strip(quads: &[(f64, f64)]) -> Mesh {
        let (mut at, mut angle) = ((0.0, 0.0), 0.0f64);
        let mut raw: Vec<RawFacet> = Vec::new();
        for (bend, length) in quads {
            angle += bend.to_radians();
            let to = (at.0 + length * libm::cos(angle), at.1 + length * libm::sin(angle));
            let p = |q: (f64, f64), y: f32| [q.0 as f32, y, q.1 as f32];
            raw.push([p(at, 0.0), p(to, 0.0), p(to, 1.0)]);
            raw.push([p(at, 0.0), p(to, 1.0), p(at, 1.0)]);
            at = to;
        }
        Mesh::weld(&raw, 1.0)
    }

    fn segment(mesh: &Mesh, rule: SurfaceRule, edits: &[SurfaceEdit]) -> Vec<u32> {
        let dihedral = dihedral_angles(mesh);
        let tree = MergeTree::new(mesh, &dihedral);
        let s = Surfaces::new(mesh, &tree, &dihedral, &rule, edits, &[]);
        s.of_facet.iter().step_by(2).copied().collect()
    }

    const PLAIN: SurfaceRule = SurfaceRule { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };

    #[test]
    fn islands_go_to_the_smoothest_neighbour() {
        // A sliver between a 60° and a 25° bend belongs to what is behind the 25°.
        let mesh = strip(&[(0.0, 5.0), (60.0, 0.1), (25.0, 5.0), (40.0, 5.0)]);
        assert_eq!(segment(&mesh, PLAIN, &[]), [1, 2, 3, 4]);
        assert_eq!(segment(&mesh, SurfaceRule { min_area_mm2: 1.0, ..PLAIN }, &[]), [1, 2, 2, 3]);
    }

    #[test]
    fn weak_creases_count_only_along_a_strong_one() {
        let mesh = strip(&[(0.0, 1.0), (15.0, 1.0), (30.0, 1.0)]);
        assert_eq!(segment(&mesh, PLAIN, &[]), [1, 1, 2]);
        // Rim edges are strong creases here and every rung touches the rim.
        assert_eq!(segment(&mesh, SurfaceRule { hysteresis_deg: 10.0, ..PLAIN }, &[]), [1, 2, 3]);
        assert_eq!(segment(&mesh, SurfaceRule { hysteresis_deg: 16.0, ..PLAIN }, &[]), [1, 1, 2]);
    }

    #[test]
    fn edits_never_shift_numbers() {
        let mesh = strip(&[(0.0, 1.0), (30.0, 1.0), (30.0, 1.0), (10.0, 1.0), (30.0, 1.0)]);
        assert_eq!(segment(&mesh, PLAIN, &[]), [1, 2, 3, 3, 4]);
        let merge = SurfaceEdit::Merge { merge: vec![2, 1] };
        let split = SurfaceEdit::Split { split: 3, angle_deg: 5.0 };
        assert_eq!(segment(&mesh, PLAIN, std::slice::from_ref(&merge)), [1, 1, 3, 3, 4]);
        assert_eq!(segment(&mesh, PLAIN, &[merge.clone(), split.clone()]), [1, 1, 3, 5, 4]);
        // Facets 4 to 7 are the two quads of surface 3; those of others are passed over.
        let cut = |cut: u32, facets: &[u32]| SurfaceEdit::Cut { cut, facets: facets.to_vec() };
        assert_eq!(segment(&mesh, PLAIN, &[cut(3, &[0, 6, 7, 99])]), [1, 2, 3, 5, 4]);
        assert_eq!(segment(&mesh, PLAIN, &[merge, cut(3, &[4, 5]), cut(1, &[2, 3])]), [1, 6, 5, 3, 4]);
        assert_eq!(segment(&mesh, PLAIN, &[cut(3, &[4, 5, 6, 7]), split]), [1, 2, 3, 5, 4], "all of it: no number");
    }
}
