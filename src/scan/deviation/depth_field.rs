//! How much is missing at each place of the model: depths at the vertices of a mesh that is as fine as the scan resolves,
//! linear between them. It holds the part of the model that a patch needs and stops there: the facets that were not
//! refined stay as the part has them.

use super::refined::refined;
use super::smoothing::Room;
use super::{SmoothedDepths, order};
use crate::part::Part;
use crate::part::topology::FacetDefect;
use crate::progress::{Cancelled, Progress};
use crate::scan::Cloud;
use crate::scan::neighbours::Neighbours;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Longest side of a triangle, in radii of the disc that a depth is smoothed over: finer than anything that is left in
/// the depths. At 10 points/mm² 0.4 mm; without noise area and volume of wear 0.2 mm deep and 20 mm wide come out within
/// 0.1 %.
const CELL: f64 = 0.35;
/// Triangles of a field, about; where more would be needed they are made larger. 60 MB.
const MOST: usize = 500_000;
/// Depths from this share of the least one on are looked at closely: between two points of a scan the depth may be
/// greater than at either.
const LOOKED_AT: f64 = 0.7;

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

impl DepthField {
    /// Depths wherever they, or the surplus, may reach `least_mm`, as fine as the scan resolves.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(
        part: &Part,
        depths: &SmoothedDepths,
        least_mm: f64,
        progress: &Progress,
    ) -> Result<DepthField, Cancelled> {
        let places = depths.places_beyond(LOOKED_AT * least_mm);
        if places.is_empty() {
            return Ok(DepthField::default());
        }
        let near = Neighbours::new(&places, progress)?;
        // A triangle has 0.3 cell² where sides are bisected; the rim around a patch is refined with it.
        let area_mm2 = places.len() as f64 / depths.density_per_mm2().max(1e-12);
        let cell_mm = (CELL * depths.radius_mm()).max((2.0 * area_mm2 / (0.3 * MOST as f64)).sqrt());
        let margin_mm = depths.radius_mm() + cell_mm;
        let is_near = |corners: &[Point3<f64>; 3]| {
            let middle = Point3::from((corners[0].coords + corners[1].coords + corners[2].coords) / 3.0);
            let reach = corners.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
            near.nearest_one(&middle, reach + margin_mm).is_some()
        };
        let is_too_large = |corners: &[Point3<f64>; 3]| {
            let side2 = |k: usize| (corners[(k + 1) % 3] - corners[k]).norm_squared();
            (0..3).any(|k| side2(k) > cell_mm * cell_mm) && is_near(corners)
        };
        let mesh = &part.mesh;
        let proper =
            (0..mesh.facets.len() as u32).into_par_iter().filter(|&f| mesh.defects[f as usize] == FacetDefect::None);
        let taken: Vec<u32> = proper.filter(|&f| is_near(&mesh.corners(f as usize))).collect();
        progress.check()?;
        let made = refined(part, taken.into_iter(), 2 * MOST, is_too_large, progress)?;
        let normals = normals_at(part, made.vertices.len(), &made.triangles, &made.parent);
        // One after the other those that lie side by side, as their points do.
        let order = order::spatial(&Cloud::of_points(&made.vertices));
        let depth_at = |room: &mut Room, &at: &u32| {
            let at = at as usize;
            progress.check_at(at)?;
            Ok(depths.depth_with(&made.vertices[at], &normals[at], room).unwrap_or(f64::NAN))
        };
        let found: Vec<f64> = order.par_iter().map_init(Room::default, depth_at).collect::<Result<_, Cancelled>>()?;
        let mut depth_mm = vec![f64::NAN; made.vertices.len()];
        order.iter().zip(found).for_each(|(&at, depth)| depth_mm[at as usize] = depth);
        Ok(DepthField { vertices: made.vertices, triangles: made.triangles, parent: made.parent, depth_mm })
    }

    /// Corner points of a triangle.
    pub fn corners(&self, triangle: usize) -> [Point3<f64>; 3] {
        self.triangles[triangle].map(|v| self.vertices[v as usize])
    }
}

/// The normals of the facets around each vertex, each once.
fn normals_at(part: &Part, count: usize, triangles: &[[u32; 3]], parent: &[u32]) -> Vec<Vec<Vector3<f64>>> {
    let mut normals: Vec<Vec<Vector3<f64>>> = vec![Vec::new(); count];
    for (triangle, &facet) in triangles.iter().zip(parent) {
        let normal = part.mesh.normals[facet as usize];
        for &v in triangle {
            let of = &mut normals[v as usize];
            if !of.contains(&normal) {
                of.push(normal);
            }
        }
    }
    normals
}
