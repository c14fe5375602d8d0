//! Points with normals as a surface that other points are laid on: the foot is the nearest point's plane.
//!
//! A point counts only where it has a partner: beside which it lies no further along the surface than points are apart,
//! and whose normal is near its own. So what only one of the scans saw pulls nowhere.

use crate::part::bvh::closest_search::ClosestHint;
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::Neighbours;
use crate::scan::registration::surface::{Row, Surface};
use nalgebra::{Isometry3, Point3, Vector3};
use std::f64::consts::PI;

/// How far from its partner along the surface a point may lie, in spacings. Of points thrown at random one in 500 has no
/// other within 1.4 spacings.
const BESIDE: f64 = 1.5;
/// Cosine of the greatest angle between the normals of partners, 60°.
const LEAST_COSINE: f64 = 0.5;
/// Points whose spacing is looked at, and neighbours of each.
const PROBES: usize = 500;
const NEIGHBOURS: usize = 8;

/// Points of one cloud, and where they are looked up.
#[derive(Clone, Debug)]
pub(super) struct CloudSurface<'a> {
    points: &'a [Point3<f64>],
    normals: &'a [Vector3<f64>],
    neighbours: Neighbours,
    /// As if on a square grid, mm.
    spacing_mm: f64,
}

impl<'a> CloudSurface<'a> {
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub(super) fn new(
        points: &'a [Point3<f64>],
        normals: &'a [Vector3<f64>],
        progress: &Progress,
    ) -> Result<CloudSurface<'a>, Cancelled> {
        let neighbours = Neighbours::new(&Cloud::of_points(points), progress)?;
        let stride = points.len().div_ceil(PROBES).max(1);
        let mut near = Vec::new();
        let reach2 = points.iter().step_by(stride).map(|p| {
            neighbours.nearest(p, NEIGHBOURS + 1, &mut near);
            near.last().map_or(0.0, |n| n.squared)
        });
        let mut reach2: Vec<f32> = reach2.collect();
        let middle = reach2.len() / 2;
        let reach2 = if reach2.is_empty() { 0.0 } else { *reach2.select_nth_unstable_by(middle, f32::total_cmp).1 };
        let spacing_mm = (PI * f64::from(reach2) / NEIGHBOURS as f64).sqrt();
        Ok(CloudSurface { points, normals, neighbours, spacing_mm })
    }

    /// The point nearest to a place, within a distance.
    pub(super) fn closest(&self, at: &Point3<f64>, within_mm: f64) -> Option<Point3<f64>> {
        self.neighbours.nearest_one(at, within_mm).map(|n| self.points[n.index as usize])
    }

    /// As points with these normals find it. `signed`: whether both clouds' normals know outside from inside;
    /// `reach_mm`: how far off a partner may be.
    pub(super) fn for_points<'s>(&'s self, normals: &'s [Vector3<f64>], signed: bool, reach_mm: f64) -> Partners<'s> {
        Partners { surface: self, normals, signed, reach_mm }
    }
}

/// Points of another cloud on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Partners<'a> {
    surface: &'a CloudSurface<'a>,
    normals: &'a [Vector3<f64>],
    signed: bool,
    reach_mm: f64,
}

impl Surface for Partners<'_> {
    fn row(&self, point: usize, at: &Point3<f64>, pose: &Isometry3<f64>, _: Option<&Row>) -> Option<Row> {
        let on = self.surface;
        let partner = on.neighbours.nearest_one(at, self.reach_mm)?.index;
        let normal = on.normals[partner as usize];
        let cosine = normal.dot(&(pose.rotation * self.normals[point]));
        if (if self.signed { cosine } else { cosine.abs() }) < LEAST_COSINE {
            return None;
        }
        let d = at - on.points[partner as usize];
        let off_mm = d.dot(&normal);
        let beside_mm = (d - normal * off_mm).norm();
        (beside_mm <= BESIDE * on.spacing_mm).then(|| Row {
            at: *at,
            normal,
            off_mm,
            distance_mm: off_mm.abs(),
            to_crease_mm: f64::INFINITY,
            hint: ClosestHint::default(),
        })
    }

    fn crease_mm(&self) -> f64 {
        0.0
    }
}
