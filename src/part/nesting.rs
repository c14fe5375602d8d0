//! Which closed sheets lie within which: bodies in voids of other bodies.

use super::bounds::bounds_of;
use super::box_tree::{Bounds, BoxTree};
use super::bvh::Bvh;
use super::topology::Mesh;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

/// Rays by which it is told whether a point lies within a sheet: two of them decide where one happens to run through
/// an edge.
const RAYS: [Vector3<f64>; 3] =
    [Vector3::new(0.36, 0.48, 0.8), Vector3::new(-0.6, 0.64, 0.48), Vector3::new(0.28, -0.96, 0.1)];

/// The closed sheets of a mesh.
pub(super) struct Nesting<'a> {
    mesh: &'a Mesh,
    sheet_of: &'a [u32],
    tree: BoxTree,
    /// Rays are needed by few parts.
    bvh: Option<Bvh>,
}

impl<'a> Nesting<'a> {
    /// `sheet_of`: the sheet of each facet; `closed`: the sheets that count, with their facets.
    pub fn new<'s>(mesh: &'a Mesh, sheet_of: &'a [u32], closed: impl Iterator<Item = (u32, &'s [u32])>) -> Nesting<'a> {
        // Fewer facets than a tetrahedron has hold nothing.
        let holding = closed.filter(|(_, facets)| facets.len() >= 4);
        let tree = BoxTree::new(holding.map(|(s, facets)| (bounds(mesh, facets), s)).collect());
        Nesting { mesh, sheet_of, tree, bvh: None }
    }

    /// Number of other closed sheets around the sheet of these facets.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn depth(&mut self, sheet: u32, facets: &[u32], progress: &Progress) -> Result<usize, Cancelled> {
        let mut around = self.tree.around(&bounds(self.mesh, facets), || {});
        around.retain(|&t| t != sheet);
        let (false, Some(&first)) = (around.is_empty(), facets.first()) else { return Ok(0) };
        let point = self.mesh.centroid(first as usize);
        let mut votes = vec![0; around.len()];
        for ray in &RAYS {
            let crossings = self.crossings(&around, &point, ray, progress)?;
            votes.iter_mut().zip(crossings).for_each(|(votes, n)| *votes += n % 2);
        }
        Ok(votes.iter().filter(|&&v| v >= 2).count())
    }

    /// How often a ray crosses each of these sheets.
    fn crossings(
        &mut self,
        sheets: &[u32],
        point: &Point3<f64>,
        ray: &Vector3<f64>,
        progress: &Progress,
    ) -> Result<Vec<u32>, Cancelled> {
        let mut count = vec![0; sheets.len()];
        let bvh = match &mut self.bvh {
            Some(bvh) => bvh,
            none => none.insert(Bvh::built(self.mesh, progress)?),
        };
        bvh.visit_ray(point, ray, 0.0, f64::INFINITY, 0.0, |facet, corners| {
            if let Ok(i) = sheets.binary_search(&self.sheet_of[facet as usize]) {
                count[i] += u32::from(crosses(corners, point, ray));
            }
            f64::INFINITY
        });
        Ok(count)
    }
}

fn bounds(mesh: &Mesh, facets: &[u32]) -> Bounds {
    bounds_of(facets.iter().flat_map(|&f| mesh.corners(f as usize)))
}

fn crosses([a, b, c]: &[Point3<f64>; 3], point: &Point3<f64>, ray: &Vector3<f64>) -> bool {
    let (e1, e2, s) = (b - a, c - a, point - a);
    let p = ray.cross(&e2);
    let det = e1.dot(&p);
    let (u, q) = (s.dot(&p) / det, s.cross(&e1));
    let v = ray.dot(&q) / det;
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && e2.dot(&q) / det > 0.0
}
