//! Feature surfaces at every angle at once (P1 2.2).
//!
//! "Facets connected through edges of dihedral angle < α" is single-linkage clustering: edges are
//! sorted by angle once and joined in that order; the joins form a tree, and any α is a cut of it.
//! Dragging the α slider is then one pass over the tree, whatever the part.

use super::angle;
use super::topology::{FacetDefect, Mesh};
use super::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};
use nalgebra::Vector3;
use rayon::prelude::*;

/// Dihedral angle at an edge, degrees: the angle between the normals of its two facets (P1 Eq. 1).
/// `f64::INFINITY`, a crease at any α, where the edge is open, has more than two facets, or two
/// that disagree in winding. Of a sheet with both sides in the file the angle is that of either side.
///
/// A facet without area has no normal; it takes that of the facet across its longest edge, whose
/// sliver it is, so that it neither joins what it lies between nor shatters it.
pub fn dihedral_angles(mesh: &Mesh) -> Vec<f64> {
    // Nobody else holds this progress, so it is not cancelled.
    dihedral_angles_under(&Progress::default(), mesh).unwrap_or_default()
}

/// The angle at each edge as [`dihedral_angles`] has it, as long as nobody wants the work to end.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn dihedral_angles_under(progress: &Progress, mesh: &Mesh) -> Result<Vec<f64>, Cancelled> {
    let lent = |f: usize| progress.check_at(f).map(|()| lent_normal(mesh, f));
    let normals = (0..mesh.facets.len()).into_par_iter().map(lent).collect::<Result<Vec<Vector3<f64>>, Cancelled>>()?;
    let angle = |e: u32| match mesh.pairs(e).next() {
        // Both sides of a sheet bend by the same angle.
        Some([f, g]) if mesh.is_smooth([f, g], e) || mesh.is_fold([f, g], e) => {
            angle::between_deg(&normals[f as usize], &normals[g as usize])
        }
        _ => f64::INFINITY,
    };
    (0..mesh.edges.len() as u32).into_par_iter().map(|e| progress.check_at(e as usize).map(|()| angle(e))).collect()
}

fn lent_normal(mesh: &Mesh, facet: usize) -> Vector3<f64> {
    let mut f = facet;
    // A few steps: slivers come in strips, seldom longer.
    for _ in 0..8 {
        if mesh.defects[f] != FacetDefect::Degenerate {
            return mesh.normals[f];
        }
        let length = |e: u32| {
            let [a, b] = mesh.edges[e as usize];
            (mesh.vertices[a as usize] - mesh.vertices[b as usize]).norm_squared()
        };
        let across = mesh.facet_edges[f]
            .iter()
            .filter_map(|&e| mesh.across(f as u32, e).filter(|&g| mesh.is_smooth([f as u32, g], e)).map(|g| (e, g)))
            .max_by(|a, b| length(a.0).total_cmp(&length(b.0)));
        let Some((_, next)) = across.filter(|(_, next)| *next as usize != facet) else { break };
        f = next as usize;
    }
    mesh.normals[f]
}

/// The tree of joins over the facets.
#[derive(Clone, Debug, Default)]
pub struct MergeTree {
    facets: usize,
    /// Parent of facets (first) and joins (behind them, in order of angle); itself for a root.
    parent: Vec<u32>,
    /// Angle at which a join happens, degrees; 0 for facets.
    height_deg: Vec<f64>,
}

impl MergeTree {
    /// Builds the tree from the dihedral angle of each edge.
    pub fn new(mesh: &Mesh, dihedral_deg: &[f64]) -> MergeTree {
        // Nor this.
        MergeTree::built(mesh, dihedral_deg, &Progress::default()).unwrap_or_default()
    }

    /// Builds the tree from the dihedral angle of each edge, as long as nobody wants that to end.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(mesh: &Mesh, dihedral_deg: &[f64], progress: &Progress) -> Result<MergeTree, Cancelled> {
        let count = mesh.facets.len();
        let mut parent: Vec<u32> = (0..count as u32).collect();
        let mut height_deg = vec![0.0; count];
        parent.reserve(count);
        height_deg.reserve(count);
        let mut sets = UnionFind::new(count);
        // Topmost join of each set, kept at its representative.
        let mut top: Vec<u32> = (0..count as u32).collect();
        let (mut edges, ends) = in_ranges(dihedral_deg);
        let mut begin = 0;
        for end in ends {
            // Most edges lie within what flatter ones have joined (Osipov et al., The Filter-Kruskal Minimum Spanning
            // Tree Algorithm, 2009): they need no sorting.
            let mut open = 0;
            let range = &mut edges[begin..end];
            for i in 0..range.len() {
                progress.check_at(i)?;
                if mesh.pairs(range[i].1).any(|[f, g]| sets.root(f) != sets.root(g)) {
                    range.swap(open, i);
                    open += 1;
                }
            }
            begin = end;
            range[..open].par_sort_unstable();
            for (i, &(bits, e)) in range[..open].iter().enumerate() {
                progress.check_at(i)?;
                for [f, g] in mesh.pairs(e) {
                    let (a, b) = (sets.root(f), sets.root(g));
                    if a == b {
                        continue;
                    }
                    let join = parent.len() as u32;
                    parent.push(join);
                    height_deg.push(f64::from_bits(bits));
                    parent[top[a as usize] as usize] = join;
                    parent[top[b as usize] as usize] = join;
                    sets.join(a, b);
                    top[a.min(b) as usize] = join;
                }
            }
        }
        Ok(MergeTree { facets: count, parent, height_deg })
    }

    /// Surface of each facet at angle α, numbered from 1 in the order of their lowest facet; and
    /// their count.
    pub fn cut(&self, alpha_deg: f64) -> (Vec<u32>, u32) {
        let limit = below(alpha_deg);
        // Parents stand behind their children, so one pass from the end sees each parent first.
        let mut top: Vec<u32> = (0..self.parent.len() as u32).collect();
        for i in (0..self.parent.len()).rev() {
            let p = self.parent[i] as usize;
            if p != i && self.height_deg[p] < limit {
                top[i] = top[p];
            }
        }
        let mut number = vec![0u32; self.parent.len()];
        let mut count = 0;
        let surfaces = top[..self.facets]
            .iter()
            .map(|&t| {
                let n = &mut number[t as usize];
                if *n == 0 {
                    count += 1;
                    *n = count;
                }
                *n
            })
            .collect();
        (surfaces, count)
    }
}

/// Edges that are no crease at every angle, in ranges of angle, the flattest first, and where each range ends. Edges are
/// pairs of their angle's bits, which are in the order of the angles, and their number.
fn in_ranges(dihedral_deg: &[f64]) -> (Vec<(u64, u32)>, Vec<usize>) {
    // Sign, exponent and four bits more: sixteen ranges from an angle to its double.
    let range = |angle_deg: &f64| (angle_deg.to_bits() >> 48) as usize;
    let edges = || dihedral_deg.iter().zip(0..).filter(|(angle, _)| angle.is_finite());
    let mut ends = vec![0; 1 << 16];
    for (angle, _) in edges() {
        ends[range(angle)] += 1;
    }
    let mut before = 0;
    for end in &mut ends {
        before += std::mem::replace(end, before);
    }
    let mut out = vec![(0, 0); before];
    for (angle, e) in edges() {
        let at = &mut ends[range(angle)];
        out[*at] = (angle.to_bits(), e);
        *at += 1;
    }
    ends.dedup();
    (out, ends)
}

/// Angles below this join at α: "θ ≥ α is a crease" must hold for a right angle at α = 90°, which
/// f64 computes to some 1e-14°. Wider it may not be: f32 coordinates scatter a true 20° by 1e-4°,
/// and those edges fall to either side, as they do in any other program.
pub fn below(alpha_deg: f64) -> f64 {
    alpha_deg - 1e-9
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::raw_part::RawFacet;
    use proptest::prelude::*;

    /// A strip of quads bent by the given angles (degrees) from one to the next.
    fn strip(bends: &[f64]) -> Mesh {
        let (mut x, mut z, mut a) = (0.0, 0.0, 0.0f64);
        let mut line = vec![(0.0, 0.0)];
        for bend in std::iter::once(&0.0).chain(bends) {
            a += bend.to_radians();
            x += libm::cos(a);
            z += libm::sin(a);
            line.push((x, z));
        }
        let raw: Vec<RawFacet> = line
            .windows(2)
            .flat_map(|w| {
                let p = |i: usize, y: f32| [w[i].0 as f32, y, w[i].1 as f32];
                [[p(0, 0.0), p(1, 0.0), p(1, 1.0)], [p(0, 0.0), p(1, 1.0), p(0, 1.0)]]
            })
            .collect();
        Mesh::weld(&raw, 1.0)
    }

    #[test]
    fn the_angle_itself_is_a_crease() {
        let mesh = strip(&[90.0, 10.0, 19.9, 90.0]);
        let tree = MergeTree::new(&mesh, &dihedral_angles(&mesh));
        assert_eq!(tree.cut(90.0).0, [1, 1, 2, 2, 2, 2, 2, 2, 3, 3]);
        assert_eq!(tree.cut(90.1).1, 1);
        assert_eq!(tree.cut(5.0).1, 5);
    }

    proptest! {
        /// The cut equals a plain flood over the edges below α.
        #[test]
        fn a_cut_is_a_flood(bends in prop::collection::vec(0.0..60.0f64, 1..20), alpha in 1.0..60.0f64) {
            let mesh = strip(&bends);
            let tree = MergeTree::new(&mesh, &dihedral_angles(&mesh));
            prop_assume!(bends.iter().all(|b| (b - alpha).abs() > 1e-2));
            let mut number = 1;
            let mut expected = vec![1, 1];
            for b in &bends {
                number += u32::from(*b >= alpha);
                expected.extend([number, number]);
            }
            prop_assert_eq!(tree.cut(alpha).0, expected);
        }
    }
}
