//! From faces to facets: quads are cut in two, crumbs left out, and only vertices that a facet has are kept.

use super::dual::Faces;
use crate::part::union_find::UnionFind;
use nalgebra::Point3;

/// A shell of fewer facets is a crumb: a few strays that stand together, four cells by four.
const CRUMB: u32 = 32;

/// Vertices and facets of a mesh.
pub(super) struct Facets {
    pub vertices: Vec<Point3<f64>>,
    pub facets: Vec<[u32; 3]>,
}

/// Cuts the faces into facets.
pub(super) fn facets(faces: &Faces) -> Facets {
    let quads = faces.quads.iter().flat_map(|q| cut(q, &faces.vertices));
    let all: Vec<[u32; 3]> = quads.chain(faces.triangles.iter().copied()).collect();
    let mut sets = UnionFind::new(faces.vertices.len());
    for &[a, b, c] in &all {
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut size = vec![0u32; faces.vertices.len()];
    all.iter().for_each(|f| size[sets.root(f[0]) as usize] += 1);
    let mut kept: Vec<[u32; 3]> = all.into_iter().filter(|f| size[sets.root(f[0]) as usize] >= CRUMB).collect();
    let mut number = vec![u32::MAX; faces.vertices.len()];
    kept.iter().flatten().for_each(|v| number[*v as usize] = 0);
    let mut vertices = Vec::new();
    for (number, p) in number.iter_mut().zip(&faces.vertices).filter(|(n, _)| **n == 0) {
        *number = vertices.len() as u32;
        vertices.push(*p);
    }
    kept.iter_mut().flatten().for_each(|v| *v = number[*v as usize]);
    Facets { vertices, facets: kept }
}

/// Cuts a quad along the diagonal that leaves the better one of the worse facets: neither thin nor folded over.
fn cut(&[a, b, c, d]: &[u32; 4], vertices: &[Point3<f64>]) -> [[u32; 3]; 2] {
    let [pa, pb, pc, pd] = [a, b, c, d].map(|v| vertices[v as usize]);
    let facing = (pc - pa).cross(&(pd - pb));
    let shape = |[p, q, r]: [Point3<f64>; 3]| {
        let longest = (q - p).norm_squared().max((r - q).norm_squared()).max((p - r).norm_squared());
        (q - p).cross(&(r - p)).dot(&facing) / longest.max(f64::MIN_POSITIVE)
    };
    let one = shape([pa, pb, pc]).min(shape([pa, pc, pd]));
    let other = shape([pb, pc, pd]).min(shape([pb, pd, pa]));
    if one >= other { [[a, b, c], [a, c, d]] } else { [[b, c, d], [b, d, a]] }
}

/// Edges with one facet, as that facet runs along them, by the lower vertex.
pub(super) fn rim_edges(facets: &[[u32; 3]]) -> Vec<[u32; 2]> {
    let sides = facets.iter().flat_map(|f| (0..3).map(|k| [f[k], f[(k + 1) % 3]]));
    let mut all: Vec<([u32; 2], [u32; 2])> = sides.map(|[a, b]| ([a.min(b), a.max(b)], [a, b])).collect();
    all.sort_unstable();
    all.chunk_by(|a, b| a.0 == b.0).filter(|edge| edge.len() == 1).map(|edge| edge[0].1).collect()
}
