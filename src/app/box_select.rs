//! Surfaces inside a box that is drawn in the view, as far as they are seen there.

use super::context::Context;
use crate::view::{Camera, ViewSize};
use nalgebra::{Point2, Point3};
use std::collections::BTreeSet;

/// Facets of a surface that are looked at until one is seen.
const TRIES: usize = 24;

impl Context<'_> {
    /// The surfaces of which a facet has its middle between two corners, px, and is seen.
    pub fn surfaces_in_box(self, camera: &Camera, size: ViewSize, [a, b]: [Point2<f64>; 2]) -> BTreeSet<u32> {
        let (low, high) = (a.inf(&b), a.sup(&b));
        let Some(part) = &self.derived.part else { return BTreeSet::new() };
        let (mesh, place) = (&part.mesh, self.scene_from_part());
        let is_inside = |at: &Point3<f64>| {
            let px = camera.project(at, size)?;
            let px = Point2::new(px.0, px.1);
            (px >= low && px <= high).then_some(px)
        };
        let faces_eye = |facet: usize, px: Point2<f64>| {
            let (_, along) = camera.ray_through(px, size);
            (place * mesh.normals[facet]).dot(&along) < 0.0
        };
        let is_seen = |n: u32, facets: &[u32]| {
            let middles = facets.iter().filter_map(|&f| {
                let px = is_inside(&(place * mesh.centroid(f as usize)))?;
                faces_eye(f as usize, px).then_some(px)
            });
            middles.take(TRIES).any(|px| {
                let picked = self.picked_at(camera.ray_through(px, size));
                picked.and_then(|(facet, _)| self.surface_of(facet)) == Some(n)
            })
        };
        let all = self.derived.surfaces.list.iter().filter(|s| !self.session.hidden.contains(&s.number));
        all.filter(|s| is_seen(s.number, &s.facets)).map(|s| s.number).collect()
    }
}
