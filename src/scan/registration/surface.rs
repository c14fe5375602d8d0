//! What a fit lays points on: where each one's foot is, and how far it stands off the plane there.
//!
//! Of a model the foot is the mesh's nearest point, with the normal of its feature surface, so nothing depends on how
//! densely the model was sampled. How points are weighed and moved is the fit's.

use super::SurfaceNormals;
use crate::part::Part;
use crate::part::bvh::closest_search::{ClosestHint, ClosestSearch};
use nalgebra::{Isometry3, Point3, Vector3};

/// A point against what it is laid on.
#[derive(Clone, Copy, Debug)]
pub(in crate::scan) struct Row {
    /// Where the point is, part frame.
    pub(in crate::scan) at: Point3<f64>,
    /// Normal at its foot; on a crease the direction from there to the point.
    pub(in crate::scan) normal: Vector3<f64>,
    /// How far it stands off the plane square to that, mm.
    pub(in crate::scan) off_mm: f64,
    /// How far it is from the model, mm; infinite for points that do not count, such as those nearest to facets left out.
    pub(in crate::scan) distance_mm: f64,
    /// How far its foot is from a crease or rim of its facet, mm.
    pub(in crate::scan) to_crease_mm: f64,
    /// Where the search on a mesh begins for the pose behind.
    pub(in crate::scan) hint: ClosestHint,
}

impl Row {
    /// Of a point that has nothing to lie on.
    pub(super) fn none() -> Row {
        Row {
            at: Point3::origin(),
            normal: Vector3::zeros(),
            off_mm: f64::INFINITY,
            distance_mm: f64::INFINITY,
            to_crease_mm: f64::INFINITY,
            hint: ClosestHint::default(),
        }
    }
}

/// The model as fits ask it.
#[derive(Clone, Copy)]
pub(in crate::scan) struct Model<'a> {
    pub(in crate::scan) part: &'a Part,
    /// In the part's hierarchy.
    pub(in crate::scan) search: &'a ClosestSearch<'a>,
    pub(in crate::scan) normals: &'a SurfaceNormals,
    /// Facets whose points do not count; those beyond its end do.
    pub(in crate::scan) left_out: &'a [bool],
    /// Points as near to the model, with a foot as near to a crease, may belong to either side of it, mm.
    pub(in crate::scan) crease_mm: f64,
}

/// What points are laid on.
pub(in crate::scan) trait Surface: Sync {
    /// A point of the scan against it, being at a place under a pose; `None` where there is nothing to lie on. `before`:
    /// its row at the pose before.
    fn row(&self, point: usize, at: &Point3<f64>, pose: &Isometry3<f64>, before: Option<&Row>) -> Option<Row>;

    /// Points nearer to it than this, with a foot as near to a crease, do not count, mm.
    fn crease_mm(&self) -> f64;
}

impl Surface for Model<'_> {
    fn row(&self, _: usize, at: &Point3<f64>, _: &Isometry3<f64>, before: Option<&Row>) -> Option<Row> {
        // The facet of the step before is near, so the nearest one is no further.
        let mut hint = before.map_or_else(ClosestHint::default, |r| r.hint);
        let closest = self.search.closest(at, f64::INFINITY, &mut hint)?;
        let to_crease_mm = self.normals.to_crease_mm(&self.part.mesh, &closest);
        let to_point = at - closest.foot;
        let normal = if to_crease_mm == 0.0 {
            to_point.try_normalize(0.0).unwrap_or_else(Vector3::zeros)
        } else {
            self.normals.at(&self.part.mesh, &closest)
        };
        let off_mm = to_point.dot(&normal);
        let counts = !is_in(self.left_out, closest.facet as usize);
        let distance_mm = if counts { closest.distance_mm } else { f64::INFINITY };
        Some(Row { at: *at, normal, off_mm, distance_mm, to_crease_mm, hint })
    }

    fn crease_mm(&self) -> f64 {
        self.crease_mm
    }
}

pub(in crate::scan) fn is_in(set: &[bool], at: usize) -> bool {
    set.get(at).is_some_and(|is_in| *is_in)
}
