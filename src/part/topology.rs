//! Topology of P2 4.1 (P1 2.1): unique vertices, edges and facets, and the three rules.
//!
//! 1. facet → its three edges and three vertices: [`Mesh::facet_edges`], [`Mesh::facets`];
//! 2. edge → its two vertices and its facets: [`Mesh::edges`], [`Mesh::edge_facets`];
//! 3. vertex → its facets: [`Mesh::vertex_facets`].
//!
//! Corners become vertices in `weld`. Duplicate and degenerate facets stay, marked, so that numbers agree with the
//! file's. Of a sheet that has both sides in the file each side is a surface of its own: see [`Mesh::pairs`].

use super::angle::between_deg;
use super::edges::{Edges, Incidence};
use super::raw_part::RawFacet;
use super::sides::Sides;
use super::triangle::normal_and_area;
use super::weld::{Weld, Welded};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

pub use super::bounds::bounds_of;
pub use super::edges::NO_EDGE;

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
    bounds: (Point3<f64>, Point3<f64>),
    at_edge: Incidence,
    at_vertex: Incidence,
    sides: Sides,
}

/// What is wrong with a facet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FacetDefect {
    /// Nothing: a proper facet.
    #[default]
    None,
    /// Two corners are one vertex, or all lie on one line.
    Degenerate,
    /// An earlier facet has the same vertices, and is not its other side (see [`Mesh::back_of`]).
    Duplicate,
}

impl Mesh {
    /// Welds facets in file units by equal coordinates alone, and builds the topology; `mm_per_unit` scales afterwards.
    pub fn weld(raw: &[RawFacet], mm_per_unit: f64) -> Mesh {
        Mesh::from_welded(Welded::new(raw, Weld::Exact), mm_per_unit)
    }

    /// Builds the topology over welded facets.
    pub fn from_welded(welded: Welded, mm_per_unit: f64) -> Mesh {
        // Nobody else holds this progress, so it is not cancelled.
        Mesh::built(welded, mm_per_unit, &Progress::default()).unwrap_or_default()
    }

    /// Builds the topology over welded facets, as long as nobody wants that to end.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn built(welded: Welded, mm_per_unit: f64, progress: &Progress) -> Result<Mesh, Cancelled> {
        let at = |p: &[f32; 3]| Point3::from(p.map(f64::from)) * mm_per_unit;
        Mesh::over(welded.points.iter().map(at).collect(), welded.facets, welded.edges, progress)
    }

    /// Builds the topology over vertices and facets that are already unique (indices in range).
    pub fn from_indexed(vertices: Vec<Point3<f64>>, facets: Vec<[u32; 3]>) -> Mesh {
        // Nor this.
        Mesh::from_indexed_under(&Progress::default(), vertices, facets).unwrap_or_default()
    }

    /// The mesh of facets over numbered vertices, as long as nobody wants the work to end.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn from_indexed_under(
        progress: &Progress,
        vertices: Vec<Point3<f64>>,
        facets: Vec<[u32; 3]>,
    ) -> Result<Mesh, Cancelled> {
        let edges = Edges::built(vertices.len(), &facets, progress)?;
        Mesh::over(vertices, facets, edges, progress)
    }

    fn over(
        vertices: Vec<Point3<f64>>,
        facets: Vec<[u32; 3]>,
        edges: Edges,
        progress: &Progress,
    ) -> Result<Mesh, Cancelled> {
        let at_vertex = Incidence::built(vertices.len(), &facets, progress)?;
        let sides = Sides::built(&facets, &edges, progress)?;
        let Edges { ends, of_facet, facets: at_edge } = edges;
        let (edges, facet_edges) = (ends, of_facet);
        let mut mesh = Mesh { vertices, facets, edges, facet_edges, at_edge, at_vertex, sides, ..Mesh::default() };
        mesh.update_geometry_under(progress)?;
        Ok(mesh)
    }

    /// Computes normals, areas, defects and the box around all from the vertices; to be called when those have moved.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so; they are not all there then.
    pub fn update_geometry_under(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        let count = self.facets.len();
        self.bounds = bounds_of(self.vertices.iter().copied());
        (self.normals, self.areas) = (Vec::with_capacity(count), Vec::with_capacity(count));
        self.defects = vec![FacetDefect::None; count];
        for &f in self.sides.repeated() {
            self.defects[f as usize] = FacetDefect::Duplicate;
        }
        for f in 0..count {
            progress.check_at(f)?;
            let (normal, area) = normal_and_area(&self.corners(f)).unwrap_or_default();
            self.normals.push(normal);
            self.areas.push(area);
            if area == 0.0 {
                self.defects[f] = FacetDefect::Degenerate;
            }
        }
        Ok(())
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
        self.at_edge.of(edge)
    }

    /// Facets at a vertex, each once, in file order.
    pub fn vertex_facets(&self, vertex: u32) -> &[u32] {
        self.at_vertex.of(vertex)
    }

    /// The two facets of an edge that has exactly two.
    pub fn two_facets(&self, edge: u32) -> Option<[u32; 2]> {
        self.edge_facets(edge).try_into().ok()
    }

    /// Neighbours over an edge: the two facets of an edge that has exactly two, and of a sheet with both sides in
    /// the file one pair on either side; none where a side ends there, at open edges, and at edges of more facets.
    pub fn pairs(&self, edge: u32) -> impl Iterator<Item = [u32; 2]> {
        let facets = self.edge_facets(edge);
        let pairs = if facets.iter().any(|&f| self.back_of(f).is_some()) {
            self.sides.pairs(facets, |f| self.runs_forward(f, edge))
        } else {
            [self.two_facets(edge), None]
        };
        pairs.into_iter().flatten()
    }

    /// The neighbour of a facet over one of its edges.
    pub fn across(&self, facet: u32, edge: u32) -> Option<u32> {
        if edge == NO_EDGE {
            return None;
        }
        let pair = self.pairs(edge).find(|pair| pair.contains(&facet))?;
        Some(if pair[0] == facet { pair[1] } else { pair[0] })
    }

    /// Whether two neighbours run through their edge in opposite directions, as they do on one side of a surface.
    pub fn is_smooth(&self, [f, g]: [u32; 2], edge: u32) -> bool {
        self.runs_forward(f, edge) != self.runs_forward(g, edge)
    }

    /// The two facets of an edge that has exactly two, if they run through it in opposite directions; `None` for
    /// open edges, edges of three facets, and Möbius seams.
    pub fn smooth_pair(&self, edge: u32) -> Option<[u32; 2]> {
        self.two_facets(edge).filter(|pair| self.is_smooth(*pair, edge))
    }

    /// The facet with the same vertices that is the other side of this one, on a sheet that has both sides in the file.
    pub fn back_of(&self, facet: u32) -> Option<u32> {
        self.sides.back_of(facet)
    }

    /// The side of a sheet that a ray along `dir` comes to: the facet that it meets, or that one's back.
    pub fn side_towards(&self, facet: u32, dir: &Vector3<f64>) -> u32 {
        let is_from_behind = self.normals[facet as usize].dot(dir) > 0.0;
        self.back_of(facet).filter(|_| is_from_behind).unwrap_or(facet)
    }

    /// How many facets have the vertices of an earlier one and are its other side.
    pub fn back_count(&self) -> usize {
        (0..self.facets.len() as u32).filter(|&f| self.back_of(f).is_some_and(|g| g < f)).count()
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
        self.bounds
    }

    /// Diagonal of the box, mm.
    pub fn diagonal(&self) -> f64 {
        let (lo, hi) = self.bounds();
        (hi - lo).norm()
    }
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
        assert_eq!(mesh.defects, [FacetDefect::None; 2], "the other side of a sheet");
        let twice = Mesh::weld(&[raw[0], raw[0]], 25.4);
        assert_eq!(twice.defects, [FacetDefect::None, FacetDefect::Duplicate]);
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
