//! Numbers facets by their surfaces: the cut of the merge tree at α, hysteresis, islands absorbed, and the
//! operator's own merges, splits and cuts.

use super::merge_tree::{MergeTree, below};
use super::surface::listed;
use super::surface_rule::{SurfaceEdit, SurfaceRule};
use super::topology::{Mesh, NO_EDGE};
use super::union_find::UnionFind;
use std::collections::{BTreeMap, BTreeSet};

/// Surface number of each facet, as edits go on.
#[derive(Clone, Debug, Default)]
pub(super) struct Numbering {
    /// The number of each facet's surface.
    pub of_facet: Vec<u32>,
    /// The highest number that was ever given out.
    pub last_number: u32,
}

/// Numbers sets of facets from 1 in the order of their lowest facet.
fn numbered(sets: &mut UnionFind, count: usize) -> Vec<u32> {
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
    let mut chains = UnionFind::new(mesh.vertices.len());
    for (e, _) in dihedral_deg.iter().enumerate().filter(|(_, d)| **d >= weak) {
        chains.join(mesh.edges[e][0], mesh.edges[e][1]);
    }
    let mut is_strong = vec![false; mesh.vertices.len()];
    for (e, _) in dihedral_deg.iter().enumerate().filter(|(_, d)| **d >= strong) {
        is_strong[chains.root(mesh.edges[e][0]) as usize] = true;
    }
    let mut sets = UnionFind::new(mesh.facets.len());
    for (e, d) in dihedral_deg.iter().enumerate() {
        let crease = *d >= weak && is_strong[chains.root(mesh.edges[e][0]) as usize];
        if !crease && d.is_finite() {
            mesh.pairs(e as u32).for_each(|[f, g]| sets.join(f, g));
        }
    }
    numbered(&mut sets, mesh.facets.len())
}

/// Absorbs surfaces below `min_area_mm2`, the smallest first, by the neighbour whose common border
/// has the smallest mean dihedral angle, weighed by length. An island without neighbours stays.
fn absorb_islands(mesh: &Mesh, dihedral_deg: &[f64], min_area_mm2: f64, of_facet: &mut Vec<u32>) {
    let mut islands = listed(mesh, of_facet);
    let mut sets = UnionFind::new(islands.len() + 1);
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
                for g in beside(mesh, f, e) {
                    let other = sets.root(of_facet[g as usize]);
                    if other as usize != root {
                        let border = borders.entry(other).or_default();
                        border.0 += length * dihedral_deg[e as usize].min(180.0);
                        border.1 += length;
                    }
                }
            }
        }
        let mean = |(sum, length): &(f64, f64)| if *length > 0.0 { sum / length } else { 0.0 };
        let best = borders.iter().min_by(|a, b| mean(a.1).total_cmp(&mean(b.1)));
        if let Some((&other, _)) = best {
            let (keep, gone) = (root.min(other as usize), root.max(other as usize));
            sets.join(root as u32, other);
            area[keep] += area[gone];
            let moved = std::mem::take(&mut members[gone]);
            members[keep].extend(moved);
        }
    }
    let mut facet_sets = UnionFind::new(of_facet.len());
    for facets in &members {
        for pair in facets.windows(2) {
            facet_sets.join(pair[0], pair[1]);
        }
    }
    *of_facet = numbered(&mut facet_sets, of_facet.len());
}

/// The facets beside one at an edge: on a sheet with both sides in the file only the one on the same side.
fn beside(mesh: &Mesh, facet: u32, edge: u32) -> impl Iterator<Item = u32> {
    let on_its_side = mesh.back_of(facet).map(|_| mesh.across(facet, edge));
    let all = if on_its_side.is_some() { &[][..] } else { mesh.edge_facets(edge) };
    on_its_side.flatten().into_iter().chain(all.iter().copied())
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
            let mut sets = UnionFind::new(of_facet.len());
            for (e, &d) in dihedral_deg.iter().enumerate() {
                if d < below(*angle_deg) {
                    let own = |pair: &[u32; 2]| pair.iter().all(|&f| of_facet[f as usize] == *split);
                    mesh.pairs(e as u32).filter(own).for_each(|[f, g]| sets.join(f, g));
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
