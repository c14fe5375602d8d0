//! Feature surfaces: the cut of the merge tree at α, islands absorbed, hysteresis, and the
//! operator's own merges and splits.
//!
//! Numbers count from 1 in the order of the lowest facet. Merging keeps the lowest number,
//! splitting appends new ones: so the settings of surface 7 stay those of surface 7.

use super::merge_tree::{MergeTree, Sets, below};
use super::topology::{Mesh, NO_EDGE};
use super::{Hasher, Keyed};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The number of a feature surface, as a type of its own wherever something refers to the surface for good.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SurfaceId(pub u32);

impl fmt::Display for SurfaceId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// How facets become surfaces before the operator's own edits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceRule {
    /// Dihedral angle from which an edge is a crease, degrees (α of P1).
    pub angle_deg: f64,
    /// Surfaces smaller than this are absorbed by the neighbour with the smoothest border; 0 = off.
    pub min_area_mm2: f64,
    /// An edge from this angle on is a crease too where a chain of such edges leads to a crease
    /// of α; 0 = off.
    pub hysteresis_deg: f64,
}

/// One edit of the operator, in the order made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum SurfaceEdit {
    /// These become one, under the lowest of the numbers.
    Merge {
        /// Surface numbers.
        merge: Vec<u32>,
    },
    /// This one is cut again at a lower angle; the part with the lowest facet keeps the number.
    Split {
        /// Surface number.
        split: u32,
        /// The local angle, degrees.
        angle_deg: f64,
    },
    /// These of its facets become a surface of their own, under the next number.
    Cut {
        /// Surface number.
        cut: u32,
        /// Facets, those of other surfaces are passed over.
        facets: Vec<u32>,
    },
}

super::keyed!(SurfaceRule { angle_deg, min_area_mm2, hysteresis_deg });

impl Keyed for SurfaceEdit {
    fn feed(&self, into: &mut Hasher) {
        match self {
            SurfaceEdit::Merge { merge } => {
                "merge".feed(into);
                merge.feed(into);
            }
            SurfaceEdit::Split { split, angle_deg } => {
                "split".feed(into);
                split.feed(into);
                angle_deg.feed(into);
            }
            SurfaceEdit::Cut { cut, facets } => {
                "cut".feed(into);
                cut.feed(into);
                facets.feed(into);
            }
        }
    }
}

/// One feature surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Its number.
    pub number: u32,
    /// Its facets in file order.
    pub facets: Vec<u32>,
    /// Its area, mm².
    pub area_mm2: f64,
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
}

/// Surface number of each facet, as edits go on.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbering {
    /// The number of each facet's surface.
    pub of_facet: Vec<u32>,
    /// The highest number that was ever given out.
    pub last_number: u32,
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
        Surfaces { of_facet, list, normals, last_number }
    }

    /// Their numbers, ascending.
    pub fn ids(&self) -> impl Iterator<Item = SurfaceId> + '_ {
        self.list.iter().map(|s| SurfaceId(s.number))
    }

    /// The surface of that number.
    pub fn get(&self, number: u32) -> Option<&Surface> {
        self.list.binary_search_by_key(&number, |s| s.number).ok().map(|i| &self.list[i])
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

/// The surfaces of a numbering, in the order of their numbers.
pub(super) fn listed(mesh: &Mesh, of_facet: &[u32]) -> Vec<Surface> {
    let mut list: BTreeMap<u32, Surface> = BTreeMap::new();
    for (f, &number) in of_facet.iter().enumerate() {
        let s = list.entry(number).or_insert_with(|| Surface { number, ..Default::default() });
        s.facets.push(f as u32);
        s.area_mm2 += mesh.areas[f];
    }
    list.into_values().collect()
}

/// Numbers sets of facets from 1 in the order of their lowest facet.
fn numbered(sets: &mut Sets, count: usize) -> Vec<u32> {
    let mut numbers = vec![0u32; count];
    let mut next = 0;
    (0..count as u32)
        .map(|f| {
            let n = &mut numbers[sets.root(f) as usize];
            if *n == 0 {
                next += 1;
                *n = next;
            }
            *n
        })
        .collect()
}

/// Canny's double threshold on edges: weak creases count where they continue a strong one.
fn with_hysteresis(mesh: &Mesh, dihedral_deg: &[f64], rule: &SurfaceRule) -> Vec<u32> {
    let (weak, strong) = (below(rule.hysteresis_deg), below(rule.angle_deg));
    // Creases hang together at vertices; a chain counts if it holds a strong one.
    let mut chains = Sets::new(mesh.vertices.len());
    for (e, _) in dihedral_deg.iter().enumerate().filter(|(_, d)| **d >= weak) {
        chains.join(mesh.edges[e][0], mesh.edges[e][1]);
    }
    let mut is_strong = vec![false; mesh.vertices.len()];
    for (e, _) in dihedral_deg.iter().enumerate().filter(|(_, d)| **d >= strong) {
        is_strong[chains.root(mesh.edges[e][0]) as usize] = true;
    }
    let mut sets = Sets::new(mesh.facets.len());
    for (e, d) in dihedral_deg.iter().enumerate() {
        let crease = *d >= weak && is_strong[chains.root(mesh.edges[e][0]) as usize];
        if let (false, true, Some([f, g])) = (crease, d.is_finite(), mesh.two_facets(e as u32)) {
            sets.join(f, g);
        }
    }
    numbered(&mut sets, mesh.facets.len())
}

/// Absorbs surfaces below `min_area_mm2`, the smallest first, by the neighbour whose common border
/// has the smallest mean dihedral angle, weighed by length. An island without neighbours stays.
fn absorb_islands(mesh: &Mesh, dihedral_deg: &[f64], min_area_mm2: f64, of_facet: &mut Vec<u32>) {
    let mut islands = listed(mesh, of_facet);
    let mut sets = Sets::new(islands.len() + 1);
    let mut area: Vec<f64> = std::iter::once(0.0).chain(islands.iter().map(|s| s.area_mm2)).collect();
    let mut members: Vec<Vec<u32>> =
        std::iter::once(Vec::new()).chain(islands.iter_mut().map(|s| std::mem::take(&mut s.facets))).collect();
    let mut order: Vec<u32> = (1..area.len() as u32).collect();
    order.sort_by(|&a, &b| area[a as usize].total_cmp(&area[b as usize]).then(a.cmp(&b)));
    for island in order {
        let root = sets.root(island) as usize;
        if area[root] >= min_area_mm2 {
            continue;
        }
        let mut borders: BTreeMap<u32, (f64, f64)> = BTreeMap::new();
        for &f in &members[root] {
            for e in mesh.facet_edges[f as usize].into_iter().filter(|&e| e != NO_EDGE) {
                let [a, b] = mesh.edges[e as usize];
                let length = (mesh.vertices[a as usize] - mesh.vertices[b as usize]).norm();
                for &g in mesh.edge_facets(e) {
                    let other = sets.root(of_facet[g as usize]);
                    if other as usize != root {
                        let border = borders.entry(other).or_default();
                        border.0 += length * dihedral_deg[e as usize].min(180.0);
                        border.1 += length;
                    }
                }
            }
        }
        let mean = |(sum, length): &(f64, f64)| sum / length.max(1e-12);
        let best = borders.iter().min_by(|a, b| mean(a.1).total_cmp(&mean(b.1)));
        if let Some((&other, _)) = best {
            let (keep, gone) = (root.min(other as usize), root.max(other as usize));
            sets.join(root as u32, other);
            area[keep] += area[gone];
            let moved = std::mem::take(&mut members[gone]);
            members[keep].extend(moved);
        }
    }
    let mut facet_sets = Sets::new(of_facet.len());
    for facets in &members {
        for pair in facets.windows(2) {
            facet_sets.join(pair[0], pair[1]);
        }
    }
    *of_facet = numbered(&mut facet_sets, of_facet.len());
}

impl Numbering {
    /// The surfaces by the rule alone, before the operator's own edits.
    pub(super) fn new(mesh: &Mesh, tree: &MergeTree, dihedral_deg: &[f64], rule: &SurfaceRule) -> Numbering {
        let mut of_facet = if rule.hysteresis_deg > 0.0 && rule.hysteresis_deg < rule.angle_deg {
            with_hysteresis(mesh, dihedral_deg, rule)
        } else {
            tree.cut(rule.angle_deg).0
        };
        if rule.min_area_mm2 > 0.0 {
            absorb_islands(mesh, dihedral_deg, rule.min_area_mm2, &mut of_facet);
        }
        let last_number = of_facet.iter().max().copied().unwrap_or(0);
        Numbering { of_facet, last_number }
    }

    /// Applies one edit; numbers that do not exist are passed over.
    pub(super) fn apply(&mut self, mesh: &Mesh, dihedral_deg: &[f64], edit: &SurfaceEdit) {
        apply(mesh, dihedral_deg, edit, &mut self.of_facet, &mut self.last_number);
    }
}

fn apply(mesh: &Mesh, dihedral_deg: &[f64], edit: &SurfaceEdit, of_facet: &mut [u32], count: &mut u32) {
    match edit {
        SurfaceEdit::Merge { merge } => {
            let Some(&keep) = merge.iter().filter(|n| of_facet.contains(n)).min() else { return };
            for n in of_facet.iter_mut().filter(|n| merge.contains(n)) {
                *n = keep;
            }
        }
        SurfaceEdit::Split { split, angle_deg } => {
            let mut sets = Sets::new(of_facet.len());
            for (e, &d) in dihedral_deg.iter().enumerate() {
                if let (true, Some([f, g])) = (d < below(*angle_deg), mesh.two_facets(e as u32))
                    && of_facet[f as usize] == *split
                    && of_facet[g as usize] == *split
                {
                    sets.join(f, g);
                }
            }
            let mut numbers: BTreeMap<u32, u32> = BTreeMap::new();
            for (f, number) in of_facet.iter_mut().enumerate().filter(|(_, n)| **n == *split) {
                let next = if numbers.is_empty() { *split } else { *count + numbers.len() as u32 };
                *number = *numbers.entry(sets.root(f as u32)).or_insert(next);
            }
            *count += (numbers.len() as u32).saturating_sub(1);
        }
        SurfaceEdit::Cut { cut, facets } => {
            let listed: BTreeSet<u32> = facets.iter().copied().collect();
            let own = |f: usize| of_facet.get(f) == Some(cut);
            let rest = (0..of_facet.len()).any(|f| own(f) && !listed.contains(&(f as u32)));
            let mine: Vec<u32> = listed.iter().copied().filter(|&f| own(f as usize)).collect();
            // The whole surface keeps its number.
            if rest && !mine.is_empty() {
                *count += 1;
                mine.iter().for_each(|&f| of_facet[f as usize] = *count);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::merge_tree::dihedral_angles;
    use super::*;
    use crate::part::stl::RawFacet;

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
