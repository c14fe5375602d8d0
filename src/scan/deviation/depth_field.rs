//! How much is missing at each place of the model: depths at the vertices of a mesh that is as fine as the scan resolves,
//! linear between them. It holds the part of the model that a patch needs and stops there: the facets that were not
//! refined stay as the part has them.

use nalgebra::Point3;

/// Depths over a refined piece of the model. Part frame, mm.
///
/// Only facets that were refined, and those that had to be cut so that neighbours share their new vertices, are in
/// it; a refined facet is covered by its triangles exactly once, wound like it. Corners of the part keep their exact
/// coordinates, and a corner that several facets share is one vertex here too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DepthField {
    /// Places of the vertices.
    pub vertices: Vec<Point3<f64>>,
    /// Vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// The facet of the part that each triangle is a piece of; ascending.
    pub parent: Vec<u32>,
    /// Depth at each vertex: above 0 where material is missing, below it where there is too much; NaN where nothing was
    /// scanned.
    pub depth_mm: Vec<f64>,
}
