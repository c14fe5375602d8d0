//! Joins the corners of seams, but for those where a facet would fold: where it would lose a corner, become a line, look
//! elsewhere, or come to lie on another. The end of a real slot is such a place, and what is refused there is refused all along the slot.

use super::seams::{Seam, point};
use super::{Joined, Welded};
use crate::part::edges::Edges;
use crate::part::triangle::normal_and_area;
use crate::part::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// A facet whose normal turns by more than 60° looks elsewhere: the cosine. So much do slivers turn whose height is
/// what corners move; at 90° and more they would be turned over.
const TURN_COSINE: f64 = 0.5;
/// So often is what folds refused with what hangs on it along its own slot; then with all that hangs together.
const ROUNDS: usize = 4;

/// The facets after the seams are closed; `None` where none can be.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn joined(
    points: &[[f32; 3]],
    facets: &[[u32; 3]],
    mut seams: Vec<Seam>,
    progress: &Progress,
) -> Result<Option<Welded>, Cancelled> {
    let mut round = 0;
    let root_of = loop {
        if seams.is_empty() {
            return Ok(None);
        }
        let groups = Groups::new(points.len(), &seams);
        let folding = groups.folding(points, facets, progress)?;
        if folding.is_empty() {
            break groups.root_of;
        }
        seams = groups.without(folding, &seams, round >= ROUNDS);
        round += 1;
    };
    renumbered(points, facets, &root_of, progress).map(Some)
}

/// Vertices that are to be one, by the lowest of them.
struct Groups {
    root_of: Vec<u32>,
    /// How many vertices each has, by its lowest.
    size: Vec<u32>,
}

impl Groups {
    fn new(count: usize, seams: &[Seam]) -> Groups {
        let mut sets = UnionFind::new(count);
        for Seam { ends: [one, two] } in seams {
            (0..2).for_each(|k| sets.join(one[k], two[k]));
        }
        let root_of: Vec<u32> = (0..count as u32).map(|v| sets.root(v)).collect();
        let mut size = vec![0; count];
        root_of.iter().for_each(|&r| size[r as usize] += 1);
        Groups { root_of, size }
    }

    fn root(&self, vertex: u32) -> u32 {
        self.root_of[vertex as usize]
    }

    /// The groups that make a facet fold.
    fn folding(
        &self,
        points: &[[f32; 3]],
        facets: &[[u32; 3]],
        progress: &Progress,
    ) -> Result<BTreeSet<u32>, Cancelled> {
        let mut found = BTreeSet::new();
        for (number, corners) in facets.iter().enumerate() {
            progress.check_at(number)?;
            let after = corners.map(|v| self.root(v));
            if after == *corners {
                continue;
            }
            let moved = (0..3).filter(|&k| after[k] != corners[k]).map(|k| after[k]);
            let is_whole = |c: &[u32; 3]| c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
            if !is_whole(corners) {
                continue;
            }
            let shape = |c: &[u32; 3]| normal_and_area(&c.map(|v| point(&points[v as usize])));
            let folds = match (shape(corners), shape(&after)) {
                _ if !is_whole(&after) => true,
                (Some((before, _)), Some((now, _))) => before.dot(&now) < TURN_COSINE,
                (Some(_), None) => true,
                (None, _) => false,
            };
            if folds {
                found.extend(moved);
            }
        }
        self.add_doubled(facets, &mut found);
        progress.check()?;
        Ok(found)
    }

    /// Adds the groups that lay a facet on another.
    fn add_doubled(&self, facets: &[[u32; 3]], found: &mut BTreeSet<u32>) {
        let sorted = |mut corners: [u32; 3]| {
            corners.sort_unstable();
            corners
        };
        let is_near = |corners: &&[u32; 3]| corners.iter().any(|&v| self.size[self.root(v) as usize] > 1);
        let after = |corners: &[u32; 3]| (sorted(corners.map(|v| self.root(v))), sorted(*corners));
        let mut near: Vec<([u32; 3], [u32; 3])> = facets.iter().filter(is_near).map(after).collect();
        near.par_sort_unstable();
        for same in near.chunk_by(|a, b| a.0 == b.0).filter(|same| same.iter().any(|f| f.1 != same[0].1)) {
            found.extend(same.iter().flat_map(|f| f.1).filter(|&v| self.root(v) != v).map(|v| self.root(v)));
        }
    }

    /// The seams that are left when these groups are refused, and what goes with them: the whole run of a seam whose
    /// corners are two and two, as on both lips of a slot; or, `with_all`, whatever hangs together with them.
    fn without(&self, mut refused: BTreeSet<u32>, seams: &[Seam], with_all: bool) -> Vec<Seam> {
        let mut at: Vec<(u32, usize)> = Vec::with_capacity(2 * seams.len());
        for (i, seam) in seams.iter().enumerate() {
            at.extend(seam.ends[0].map(|v| (self.root(v), i)));
        }
        at.sort_unstable();
        let mut is_left = vec![true; seams.len()];
        let mut next: Vec<u32> = refused.iter().copied().collect();
        while let Some(group) = next.pop() {
            let from = at.partition_point(|a| a.0 < group);
            for &(_, i) in at[from..].iter().take_while(|a| a.0 == group) {
                is_left[i] = false;
                for other in seams[i].ends[0].map(|v| self.root(v)) {
                    if (with_all || self.size[other as usize] == 2) && refused.insert(other) {
                        next.push(other);
                    }
                }
            }
        }
        seams.iter().zip(is_left).filter(|(_, left)| *left).map(|(seam, _)| *seam).collect()
    }
}

/// Vertices in the order of first appearance, without those that went into another.
fn renumbered(
    points: &[[f32; 3]],
    facets: &[[u32; 3]],
    root_of: &[u32],
    progress: &Progress,
) -> Result<Welded, Cancelled> {
    let mut joined = Joined::default();
    let (mut kept, mut number) = (Vec::with_capacity(points.len()), Vec::with_capacity(points.len()));
    for (v, (p, &root)) in points.iter().zip(root_of).enumerate() {
        if root as usize == v {
            number.push(kept.len() as u32);
            kept.push(*p);
        } else {
            number.push(number[root as usize]);
            joined.corners += 1;
            joined.within = joined.within.max((point(p) - point(&points[root as usize])).norm());
        }
    }
    let facets: Vec<[u32; 3]> = facets.iter().map(|f| f.map(|v| number[v as usize])).collect();
    let edges = Edges::built(kept.len(), &facets, progress)?;
    Ok(Welded { points: kept, facets, joined, edges })
}
