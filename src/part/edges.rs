//! The edges of facets: numbered by their lower vertex, with the facets at each; and, by the same lists, the facets
//! at each vertex. Numbers alone: nothing here knows where vertices are.

use crate::progress::{Cancelled, Progress};

/// In `Edges::of_facet`: the two corners are one vertex.
pub const NO_EDGE: u32 = u32::MAX;

/// Edges of facets over numbered vertices.
#[derive(Clone, Debug, Default)]
pub(super) struct Edges {
    /// Vertices of each edge, the lower first.
    pub ends: Vec<[u32; 2]>,
    /// Edge k of a facet joins its corners k and k + 1; [`NO_EDGE`] where those are one vertex.
    pub of_facet: Vec<[u32; 3]>,
    /// The facets at each edge.
    pub facets: Incidence,
}

impl Edges {
    /// The edges of facets whose corners are below `vertex_count`.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(vertex_count: usize, facets: &[[u32; 3]], progress: &Progress) -> Result<Edges, Cancelled> {
        let (ends, of_facet) = unique_edges(vertex_count, facets, progress)?;
        let facets = Incidence::built(ends.len(), &of_facet, progress)?;
        Ok(Edges { ends, of_facet, facets })
    }
}

/// For each of a number of things the facets that name it, each once, in file order.
#[derive(Clone, Debug, Default)]
pub(super) struct Incidence {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Incidence {
    /// `names`: of each facet what it names, below `count`, or [`NO_EDGE`].
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(count: usize, names: &[[u32; 3]], progress: &Progress) -> Result<Incidence, Cancelled> {
        let (start, list) = incidence(count, names, progress)?;
        Ok(Incidence { start, list })
    }

    /// The facets that name a thing.
    pub fn of(&self, thing: u32) -> &[u32] {
        &self.list[self.start[thing as usize] as usize..self.start[thing as usize + 1] as usize]
    }
}

/// Vertices of each edge, and edges of each facet.
type UniqueEdges = (Vec<[u32; 2]>, Vec<[u32; 3]>);

/// Unique edges by lower and higher vertex, grouped by the lower; and the edges of each facet.
fn unique_edges(vertex_count: usize, facets: &[[u32; 3]], progress: &Progress) -> Result<UniqueEdges, Cancelled> {
    // All half edges, bucketed by their lower vertex; equal ones are then few steps apart.
    let ends = |f: &[u32; 3], k: usize| {
        let (a, b) = (f[k], f[(k + 1) % 3]);
        (a.min(b), a.max(b))
    };
    let mut start = vec![0u32; vertex_count + 1];
    for f in facets {
        for k in 0..3 {
            start[ends(f, k).0 as usize + 1] += 1;
        }
    }
    for i in 0..vertex_count {
        start[i + 1] += start[i];
    }
    let mut fill = start.clone();
    let mut half = vec![(0u32, 0u32); facets.len() * 3];
    for (i, f) in facets.iter().enumerate() {
        progress.check_at(i)?;
        for k in 0..3 {
            let (lo, hi) = ends(f, k);
            half[fill[lo as usize] as usize] = (hi, (3 * i + k) as u32);
            fill[lo as usize] += 1;
        }
    }
    let mut edges: Vec<[u32; 2]> = Vec::with_capacity(facets.len() * 3 / 2 + 3);
    let mut facet_edges = vec![[NO_EDGE; 3]; facets.len()];
    for lo in 0..vertex_count {
        progress.check_at(lo)?;
        let bucket = &mut half[start[lo] as usize..start[lo + 1] as usize];
        bucket.sort_unstable();
        let mut last = None;
        for &(hi, corner) in bucket.iter().filter(|(hi, _)| *hi != lo as u32) {
            if last != Some(hi) {
                edges.push([lo as u32, hi]);
                last = Some(hi);
            }
            facet_edges[corner as usize / 3][corner as usize % 3] = edges.len() as u32 - 1;
        }
    }
    Ok((edges, facet_edges))
}

/// For each of `count` things the facets that name it, each facet once.
fn incidence(count: usize, names: &[[u32; 3]], progress: &Progress) -> Result<(Vec<u32>, Vec<u32>), Cancelled> {
    let once = |f: &[u32; 3], k: usize| f[k] != NO_EDGE && !f[..k].contains(&f[k]);
    let mut start = vec![0u32; count + 1];
    for f in names {
        for k in (0..3).filter(|&k| once(f, k)) {
            start[f[k] as usize + 1] += 1;
        }
    }
    for i in 0..count {
        start[i + 1] += start[i];
    }
    let mut fill = start.clone();
    let mut list = vec![0u32; start[count] as usize];
    for (i, f) in names.iter().enumerate() {
        progress.check_at(i)?;
        for k in (0..3).filter(|&k| once(f, k)) {
            list[fill[f[k] as usize] as usize] = i as u32;
            fill[f[k] as usize] += 1;
        }
    }
    Ok((start, list))
}
