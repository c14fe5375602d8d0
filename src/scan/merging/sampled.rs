//! A cloud made ready to be laid on another: thinned, and points spread over its skin with fitted normals.

use super::cloud_surface::CloudSurface;
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::Neighbours;
use crate::scan::normals::plane_around;
use crate::scan::registration::noise::noise_mm;
use crate::scan::registration::thinned::Thinned;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Voxels along the diagonal, as registration has them.
const VOXELS: f64 = 75.0;
/// Points with normals: 0.4 mm apart on a shaft of 150 mm.
const POINTS: usize = 60_000;
/// Neighbours that a plane is fitted through.
const NEIGHBOURS: usize = 20;
/// A plane that its points scatter about by more than so many times the noise lies across an edge, and tells nothing.
const FLAT_TO: f64 = 4.0;

/// A cloud with some of its points.
#[derive(Clone, Debug)]
pub(super) struct Sampled {
    pub(super) thinned: Thinned,
    /// Of the cloud by itself, as a standard deviation.
    pub(super) noise_mm: f64,
    /// Points spread over the skin, the same from each voxel.
    pub(super) points: Vec<Point3<f64>>,
    /// Their unit normals, on the side of the cloud's own where it has them; zero beside edges.
    pub(super) normals: Vec<Vector3<f64>>,
}

impl Sampled {
    /// Of a cloud whose box has about this diagonal.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub(super) fn new(cloud: &Cloud, diagonal_mm: f64, progress: &Progress) -> Result<Sampled, Cancelled> {
        let thinned = Thinned::new(cloud, &[], diagonal_mm / VOXELS, progress)?;
        let noise_mm = noise_mm(cloud, &thinned);
        let neighbours = Neighbours::new(cloud, progress)?;
        let spread = thinned.spread(POINTS);
        let fitted = |near: &mut Vec<_>, &(_, index): &(u32, u32)| {
            progress.check()?;
            let point = cloud.point(index as usize);
            neighbours.nearest(&point, NEIGHBOURS + 1, near);
            near.retain(|n| n.index != index);
            let is_flat = |variance_mm2: f64| variance_mm2 <= (FLAT_TO * noise_mm) * (FLAT_TO * noise_mm);
            let plane = plane_around(cloud, index, near).filter(|p| noise_mm == 0.0 || is_flat(p.variance_mm2));
            let normal = plane.map_or_else(Vector3::zeros, |p| p.normal);
            let outward = cloud.normal(index as usize).unwrap_or(normal);
            Ok((point, if normal.dot(&outward) < 0.0 { -normal } else { normal }))
        };
        let all: Vec<(Point3<f64>, Vector3<f64>)> =
            spread.par_iter().map_init(Vec::new, fitted).collect::<Result<_, Cancelled>>()?;
        let (points, normals) = all.into_iter().unzip();
        Ok(Sampled { thinned, noise_mm, points, normals })
    }

    /// Every so manieth of the points with their normals, about `count` of them.
    pub(super) fn fewer(&self, count: usize) -> (Vec<Point3<f64>>, Vec<Vector3<f64>>) {
        let stride = self.points.len().div_ceil(count.max(1)).max(1);
        let of = |k: usize| (self.points[k], self.normals[k]);
        (0..self.points.len()).step_by(stride).map(of).unzip()
    }

    /// What others are laid on.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub(super) fn surface(&self, progress: &Progress) -> Result<CloudSurface<'_>, Cancelled> {
        CloudSurface::new(&self.points, &self.normals, progress)
    }
}
