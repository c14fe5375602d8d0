//! Facets that have the vertices of an earlier one: repeated ones, which say nothing new, and the other sides of sheets.
//!
//! A sheet without thickness can be exported with both sides: each facet, and the same facet wound the other way. Its
//! sides are two surfaces that meet nowhere, though all their vertices and edges are the same. A body some of whose
//! facets have such a twin is no sheet: there a twin is a fault of the export, and repeated.

use super::edges::{Edges, NO_EDGE};
use super::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};

/// No facet.
const NONE: u32 = u32::MAX;

/// What is known of facets with the same vertices. Empty for most parts.
#[derive(Clone, Debug, Default)]
pub(super) struct Sides {
    /// Facets that an earlier one makes needless, ascending.
    repeated: Vec<u32>,
    /// The other side of each facet, or [`NONE`]; no entries where no sheet has both sides.
    back: Vec<u32>,
}

impl Sides {
    /// Looks at facets and their edges.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(facets: &[[u32; 3]], edges: &Edges, progress: &Progress) -> Result<Sides, Cancelled> {
        let (mut repeated, mut backs) = (Vec::new(), Vec::new());
        for f in 0..facets.len() {
            progress.check_at(f)?;
            let earlier = earlier_with_the_same_vertices(facets, edges, f);
            if earlier.iter().any(|&g| is_wound_alike(&facets[g as usize], &facets[f])) {
                repeated.push(f as u32);
            } else if let Some(&first) = earlier.first() {
                backs.push([first, f as u32]);
            }
        }
        if backs.is_empty() {
            return Ok(Sides { repeated, back: Vec::new() });
        }
        let mut back = vec![NONE; facets.len()];
        for &[f, g] in &backs {
            (back[f as usize], back[g as usize]) = (g, f);
        }
        let mut shells = UnionFind::new(facets.len());
        for e in 0..edges.ends.len() as u32 {
            progress.check_at(e as usize)?;
            edges.facets.of(e).windows(2).for_each(|pair| shells.join(pair[0], pair[1]));
        }
        let mut is_sheet = vec![true; facets.len()];
        for f in (0..facets.len()).filter(|&f| edges.of_facet[f].iter().all(|&e| e != NO_EDGE)) {
            if back[f] == NONE && repeated.binary_search(&(f as u32)).is_err() {
                is_sheet[shells.root(f as u32) as usize] = false;
            }
        }
        let is_sheet: Vec<bool> = (0..facets.len() as u32).map(|f| is_sheet[shells.root(f) as usize]).collect();
        repeated.extend(backs.iter().map(|b| b[1]).filter(|&f| !is_sheet[f as usize]));
        repeated.sort_unstable();
        back.iter_mut().zip(&is_sheet).filter(|(_, is_sheet)| !**is_sheet).for_each(|(b, _)| *b = NONE);
        let back = if back.iter().all(|&b| b == NONE) { Vec::new() } else { back };
        Ok(Sides { repeated, back })
    }

    /// Facets that an earlier one makes needless, ascending.
    pub fn repeated(&self) -> &[u32] {
        &self.repeated
    }

    /// The other side of a facet of a sheet.
    pub fn back_of(&self, facet: u32) -> Option<u32> {
        self.back.get(facet as usize).copied().filter(|&g| g != NONE)
    }

    /// The neighbours over an edge of a sheet, one pair on each side. On one side facets run through their edge in
    /// opposite directions. At the rim, and where more than two sheets meet, there are none.
    pub fn pairs(&self, at_edge: &[u32], runs_forward: impl Fn(u32) -> Option<bool>) -> [Option<[u32; 2]>; 2] {
        let mut own = at_edge.iter().copied().filter(|&f| self.back_of(f).is_some());
        let four = [own.next(), own.next(), own.next(), own.next()];
        let ([Some(f), Some(a), Some(b), Some(c)], None) = (four, own.next()) else { return [None; 2] };
        let goes_on = |g: &u32| self.back_of(*g) != Some(f) && runs_forward(*g) != runs_forward(f);
        let Some(g) = [a, b, c].into_iter().find(goes_on) else { return [None; 2] };
        [Some([f, g]), self.back_of(f).zip(self.back_of(g)).map(<[u32; 2]>::from)]
    }
}

/// Facets before `f` with its three vertices, ascending; none for a facet that has a vertex twice.
fn earlier_with_the_same_vertices(facets: &[[u32; 3]], edges: &Edges, f: usize) -> Vec<u32> {
    let sorted = |f: usize| {
        let mut v = facets[f];
        v.sort_unstable();
        v
    };
    let at = edges.of_facet[f];
    if at.contains(&NO_EDGE) {
        return Vec::new();
    }
    // They share all three edges, so the one with the fewest facets will do.
    let at = at.map(|e| edges.facets.of(e)).into_iter().min_by_key(|list| list.len()).unwrap_or_default();
    if at.len() < 2 {
        return Vec::new();
    }
    at.iter().copied().filter(|&g| (g as usize) < f && sorted(g as usize) == sorted(f)).collect()
}

/// Whether two facets with the same vertices are wound the same way.
fn is_wound_alike(f: &[u32; 3], g: &[u32; 3]) -> bool {
    (0..3).any(|k| [g[k], g[(k + 1) % 3], g[(k + 2) % 3]] == *f)
}

#[cfg(test)]
mod tests {
    use super::super::topology::{FacetDefect, Mesh};
    use nalgebra::Point3;

    /// A bent strip of two quads: facets wound alike.
    const STRIP: [[u32; 3]; 4] = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]];

    fn mesh(facets: &[[u32; 3]]) -> Mesh {
        let at = |i: u32| Point3::new(f64::from(i % 3), f64::from(i / 3), if i % 3 == 2 { 0.2 } else { 0.0 });
        Mesh::from_indexed((0..6).map(at).collect(), facets.to_vec())
    }

    fn turned(f: &[u32; 3]) -> [u32; 3] {
        [f[1], f[0], f[2]]
    }

    #[test]
    fn a_sheet_with_both_sides_has_pairs_on_either_and_none_at_the_rim() {
        let front = mesh(&STRIP);
        let both = mesh(&STRIP.iter().copied().chain(STRIP.iter().map(turned)).collect::<Vec<_>>());
        assert_eq!(both.defects, [FacetDefect::None; 8]);
        assert_eq!((both.back_count(), both.edges.len()), (4, front.edges.len()));
        for e in 0..front.edges.len() as u32 {
            let one: Vec<[u32; 2]> = front.pairs(e).collect();
            let two: Vec<[u32; 2]> = both.pairs(e).collect();
            let back: Vec<[u32; 2]> = one.iter().map(|pair| pair.map(|f| f + 4)).collect();
            assert_eq!(two, [one, back].concat(), "edge {e}");
            assert!(two.iter().all(|&pair| both.is_smooth(pair, e)));
        }
        let over = both.facet_edges[0][1];
        assert_eq!((both.across(0, over), both.across(4, over)), (Some(3), Some(7)));
    }

    #[test]
    fn a_body_with_one_facet_turned_over_is_no_sheet() {
        let all: Vec<[u32; 3]> = STRIP.iter().copied().chain([turned(&STRIP[1])]).collect();
        let dirty = mesh(&all);
        assert_eq!((dirty.defects[4], dirty.back_count()), (FacetDefect::Duplicate, 0));
        assert!(dirty.pairs(dirty.facet_edges[4][0]).next().is_none(), "an edge of three facets");
    }

    #[test]
    fn facets_that_a_sheet_has_twice_on_one_side_are_repeated() {
        let sides = STRIP.iter().copied().chain(STRIP.iter().map(turned));
        let all: Vec<[u32; 3]> = sides.chain([[1, 4, 0], turned(&STRIP[0])]).collect();
        let sheet = mesh(&all);
        assert_eq!(sheet.defects[8..], [FacetDefect::Duplicate; 2]);
        assert_eq!((sheet.back_of(0), sheet.back_of(8)), (Some(4), None));
        let edge = sheet.facet_edges[0][1];
        assert_eq!(sheet.pairs(edge).collect::<Vec<_>>(), [[0, 3], [4, 7]]);
    }
}
