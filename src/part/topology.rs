//! Topology of P2 4.1 (P1 2.1): unique vertices, edges and facets, and the three rules.
//!
//! 1. facet → its three edges and three vertices: [`Mesh::facet_edges`], [`Mesh::facets`];
//! 2. edge → its two vertices and its facets: [`Mesh::edges`], [`Mesh::edge_facets`];
//! 3. vertex → its facets: [`Mesh::vertex_facets`].
//!
//! Corners are welded where their stored f32 coordinates are equal (−0 = 0); no tolerance.
//! Duplicate and degenerate facets stay, marked, so that numbers agree with the file's.

use super::angle::between_deg;
use super::raw_part::RawFacet;
use super::weld::weld_corners;
use nalgebra::{Point3, Vector3};

/// A triangle mesh with its topology. Lengths mm, part frame.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Unique vertices in order of first appearance.
    pub vertices: Vec<Point3<f64>>,
    /// Vertices of each facet, counter-clockwise seen from outside once oriented.
    pub facets: Vec<[u32; 3]>,
    /// Vertices of each edge, the lower index first.
    pub edges: Vec<[u32; 2]>,
    /// Edge k of a facet joins its corners k and k + 1; [`NO_EDGE`] where those are one vertex.
    pub facet_edges: Vec<[u32; 3]>,
    /// Unit normals from the vertices (never from the file); zero for facets without area.
    pub normals: Vec<Vector3<f64>>,
    /// Areas, mm².
    pub areas: Vec<f64>,
    /// Defect of each facet; facets with one are not planned on.
    pub defects: Vec<FacetDefect>,
    edge_start: Vec<u32>,
    edge_list: Vec<u32>,
    vertex_start: Vec<u32>,
    vertex_list: Vec<u32>,
}

/// In [`Mesh::facet_edges`]: the two corners are one vertex.
pub const NO_EDGE: u32 = u32::MAX;

/// What is wrong with a facet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FacetDefect {
    /// Nothing: a proper facet.
    #[default]
    None,
    /// Two corners are one vertex, or all lie on one line.
    Degenerate,
    /// An earlier facet has the same vertices.
    Duplicate,
}

impl Mesh {
    /// Welds facets in file units and builds the topology; `mm_per_unit` scales afterwards.
    pub fn weld(raw: &[RawFacet], mm_per_unit: f64) -> Mesh {
        let (points, facets) = weld_corners(raw);
        let vertices = points
            .iter()
            .map(|p| Point3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2])) * mm_per_unit)
            .collect();
        Mesh::from_indexed(vertices, facets)
    }

    /// Builds the topology over vertices and facets that are already unique (indices in range).
    pub fn from_indexed(vertices: Vec<Point3<f64>>, facets: Vec<[u32; 3]>) -> Mesh {
        let (edges, facet_edges) = unique_edges(vertices.len(), &facets);
        let (edge_start, edge_list) = incidence(edges.len(), &facet_edges);
        let (vertex_start, vertex_list) = incidence(vertices.len(), &facets);
        let mut mesh = Mesh {
            vertices,
            facets,
            edges,
            facet_edges,
            edge_start,
            edge_list,
            vertex_start,
            vertex_list,
            ..Default::default()
        };
        mesh.update_geometry();
        mesh
    }

    /// Computes normals, areas and defects from the vertices; to be called when those have moved.
    pub fn update_geometry(&mut self) {
        let count = self.facets.len();
        (self.normals, self.areas) = (Vec::with_capacity(count), Vec::with_capacity(count));
        self.defects = vec![FacetDefect::None; count];
        for f in 0..count {
            let [a, b, c] = self.corners(f);
            let cross = (b - a).cross(&(c - a));
            let longest = (b - a).norm_squared().max((c - a).norm_squared()).max((c - b).norm_squared());
            let twice_area = cross.norm();
            // Relative height 1e-9: below what f32 coordinates can tell from a line (1e-7), above
            // the rounding of this product.
            let flat = twice_area <= 1e-9 * longest || !twice_area.is_normal();
            self.normals.push(if flat { Vector3::zeros() } else { cross / twice_area });
            self.areas.push(if flat { 0.0 } else { 0.5 * twice_area });
            if flat {
                self.defects[f] = FacetDefect::Degenerate;
            }
        }
        self.mark_duplicates();
    }

    fn mark_duplicates(&mut self) {
        let sorted = |f: u32| {
            let mut v = self.facets[f as usize];
            v.sort_unstable();
            v
        };
        for f in 0..self.facets.len() {
            let key = sorted(f as u32);
            let earlier = self.vertex_facets(key[0]).iter().any(|&g| (g as usize) < f && sorted(g) == key);
            if earlier && self.defects[f] == FacetDefect::None {
                self.defects[f] = FacetDefect::Duplicate;
            }
        }
    }

    /// Corner points of a facet.
    pub fn corners(&self, facet: usize) -> [Point3<f64>; 3] {
        self.facets[facet].map(|v| self.vertices[v as usize])
    }

    /// Middle of a facet.
    pub fn centroid(&self, facet: usize) -> Point3<f64> {
        let [a, b, c] = self.corners(facet);
        a + ((b - a) + (c - a)) / 3.0
    }

    /// Facets at an edge, each once, in file order.
    pub fn edge_facets(&self, edge: u32) -> &[u32] {
        range(&self.edge_start, &self.edge_list, edge)
    }

    /// Facets at a vertex, each once, in file order.
    pub fn vertex_facets(&self, vertex: u32) -> &[u32] {
        range(&self.vertex_start, &self.vertex_list, vertex)
    }

    /// The two facets of an edge that has exactly two.
    pub fn two_facets(&self, edge: u32) -> Option<[u32; 2]> {
        self.edge_facets(edge).try_into().ok()
    }

    /// The two facets of an edge that run through it in opposite directions, as neighbours on one
    /// side of a surface do; `None` for open edges, edges of three facets, and Möbius seams.
    pub fn smooth_pair(&self, edge: u32) -> Option<[u32; 2]> {
        self.two_facets(edge).filter(|&[f, g]| self.runs_forward(f, edge) != self.runs_forward(g, edge))
    }

    /// Whether the two facets at an edge lie on top of each other, looking the same way: dirty
    /// exports cover a face twice in different triangles. Their winding disagrees at the edge, but
    /// turning one would make it look into the part. All cases seen fold by 0.0°; a knife's edge
    /// with one facet wrongly wound, which must be turned, has ten degrees and more.
    pub fn is_fold(&self, [f, g]: [u32; 2], edge: u32) -> bool {
        self.runs_forward(f, edge) == self.runs_forward(g, edge)
            && between_deg(&self.normals[f as usize], &self.normals[g as usize]) < 1.0
            && [f, g].iter().all(|&h| self.defects[h as usize] != FacetDefect::Degenerate)
    }

    /// Whether the facet passes the edge from its lower to its higher vertex.
    pub fn runs_forward(&self, facet: u32, edge: u32) -> Option<bool> {
        let k = self.facet_edges[facet as usize].iter().position(|&e| e == edge)?;
        Some(self.facets[facet as usize][k] == self.edges[edge as usize][0])
    }

    /// Turns a facet's winding, its edges with it.
    pub fn flip(&mut self, facet: usize) {
        self.facets[facet].swap(1, 2);
        self.facet_edges[facet].swap(0, 2);
        self.normals[facet] = -self.normals[facet];
    }

    /// The box around all vertices, mm.
    pub fn bounds(&self) -> (Point3<f64>, Point3<f64>) {
        bounds_of(self.vertices.iter().copied())
    }

    /// Diagonal of the box, mm.
    pub fn diagonal(&self) -> f64 {
        let (lo, hi) = self.bounds();
        (hi - lo).norm()
    }
}

/// The box around points; empty input gives a box of zero size at the origin.
pub fn bounds_of(points: impl Iterator<Item = Point3<f64>>) -> (Point3<f64>, Point3<f64>) {
    points
        .map(|p| (p, p))
        .reduce(|(lo, hi), (p, _)| (lo.inf(&p), hi.sup(&p)))
        .unwrap_or((Point3::origin(), Point3::origin()))
}

fn range<'a>(start: &[u32], list: &'a [u32], i: u32) -> &'a [u32] {
    &list[start[i as usize] as usize..start[i as usize + 1] as usize]
}

/// Unique edges by lower and higher vertex, grouped by the lower; and the edges of each facet.
fn unique_edges(vertex_count: usize, facets: &[[u32; 3]]) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
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
        for k in 0..3 {
            let (lo, hi) = ends(f, k);
            half[fill[lo as usize] as usize] = (hi, (3 * i + k) as u32);
            fill[lo as usize] += 1;
        }
    }
    let mut edges: Vec<[u32; 2]> = Vec::with_capacity(facets.len() * 3 / 2 + 3);
    let mut facet_edges = vec![[NO_EDGE; 3]; facets.len()];
    for lo in 0..vertex_count {
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
    (edges, facet_edges)
}

/// For each of `count` things the facets that name it, each facet once.
fn incidence(count: usize, names: &[[u32; 3]]) -> (Vec<u32>, Vec<u32>) {
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
        for k in (0..3).filter(|&k| once(f, k)) {
            list[fill[f[k] as usize] as usize] = i as u32;
            fill[f[k] as usize] += 1;
        }
    }
    (start, list)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P2 Fig. 6, Tables 1 and 2: the same six facets, the same edge table.
    #[test]
    fn example_of_p2() {
        let facets = [[1, 2, 3], [1, 3, 4], [3, 6, 4], [4, 6, 5], [3, 7, 6], [2, 7, 3]];
        let at = |v: i32| [v as f32, (v * v) as f32, (v * v * v % 5) as f32];
        let raw: Vec<RawFacet> = facets.iter().map(|f| f.map(at)).collect();
        let mesh = Mesh::weld(&raw, 1.0);
        assert_eq!((mesh.vertices.len(), mesh.edges.len(), mesh.facets.len()), (7, 12, 6));
        let name = |v: u32| mesh.vertices[v as usize].x as u32;
        let mut table: Vec<(u32, u32, Vec<u32>)> = (0..12)
            .map(|e| {
                let [a, b] = mesh.edges[e as usize].map(name);
                (a.min(b), a.max(b), mesh.edge_facets(e).iter().map(|f| f + 1).collect())
            })
            .collect();
        table.sort();
        let expected = [
            (1, 2, vec![1]),
            (1, 3, vec![1, 2]),
            (1, 4, vec![2]),
            (2, 3, vec![1, 6]),
            (2, 7, vec![6]),
            (3, 4, vec![2, 3]),
            (3, 6, vec![3, 5]),
            (3, 7, vec![5, 6]),
            (4, 5, vec![4]),
            (4, 6, vec![3, 4]),
            (5, 6, vec![4]),
            (6, 7, vec![5]),
        ];
        assert_eq!(table, expected);
        assert_eq!(mesh.vertex_facets(2), [0, 1, 2, 4, 5], "rule 3: V3 lies in all facets but F4");
    }

    #[test]
    fn minus_zero_is_zero_and_soup_grows_the_table() {
        let raw: Vec<RawFacet> =
            vec![[[0.0, 0.0, 0.0], [1.0, -0.0, 0.0], [0.0, 1.0, 0.0]], [[-0.0; 3], [0.0, 1.0, -0.0], [1.0, 0.0, 0.0]]];
        let mesh = Mesh::weld(&raw, 25.4);
        assert_eq!((mesh.vertices.len(), mesh.edges.len()), (3, 3));
        assert_eq!(mesh.defects, [FacetDefect::None, FacetDefect::Duplicate]);
        assert!((mesh.areas[0] - 0.5 * 25.4 * 25.4).abs() < 1e-9);
        let soup: Vec<RawFacet> =
            (0..500).map(|i| [[i as f32, 0.0, 0.0], [i as f32, 1.0, 0.0], [i as f32, 0.0, 1.0]]).collect();
        assert_eq!(Mesh::weld(&soup, 1.0).vertices.len(), 1500);
    }

    #[test]
    fn degenerate_facets_are_marked_and_have_no_edge_to_themselves() {
        let raw: Vec<RawFacet> =
            vec![[[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0]], [[0.0; 3], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]]];
        let mesh = Mesh::weld(&raw, 1.0);
        assert_eq!(mesh.defects, [FacetDefect::Degenerate, FacetDefect::Degenerate]);
        assert_eq!(mesh.facet_edges[0][0], NO_EDGE);
        assert_eq!(mesh.edge_facets(mesh.facet_edges[0][1]), [0, 1]);
    }
}
