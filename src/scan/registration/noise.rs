//! The noise of a scan by itself: how far its points stand off planes through their neighbours. No model is asked, so a
//! fit can be measured by it.
//!
//! On a cloud with few points to the voxel neighbours lie far apart, and what is round counts as noise: it is said too
//! large then, never too small.

use super::super::Cloud;
use super::thinned::Thinned;
use crate::scan::SIGMA_OF_MEDIAN;
use nalgebra::{Matrix3, Point3, SymmetricEigen, Vector3};
use rayon::prelude::*;

/// Points looked at, and neighbours of each.
const PROBES: usize = 500;
const NEIGHBOURS: usize = 20;
/// Points of a voxel that are asked, evenly taken: where points lie closer together than they scatter, the nearest ones
/// make a ball, and its plane is any. So many leave a disc of a quarter of a voxel: 0.5 mm on a shaft of 150 mm.
const OF_VOXEL: usize = 80;
/// What a plane through 20 points takes of the height of the one in its middle: √(20/19).
const PLANE_TAKES: f64 = 1.026;

/// The standard deviation of the points along the normal, mm; 0 where there are too few.
pub(super) fn noise_mm(cloud: &Cloud, thinned: &Thinned) -> f64 {
    let probes = thinned.spread(PROBES.min(thinned.middles.len()));
    let off = |&(voxel, point): &(u32, u32)| {
        let at = cloud.point(point as usize);
        let around = thinned.around(voxel as usize).flat_map(|v| evenly(thinned.points_of(v), OF_VOXEL));
        let mut near: Vec<(f64, u32)> = around.map(|i| ((cloud.point(i as usize) - at).norm_squared(), i)).collect();
        if near.len() < NEIGHBOURS {
            return None;
        }
        near.select_nth_unstable_by(NEIGHBOURS - 1, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.truncate(NEIGHBOURS);
        near.sort_unstable_by_key(|n| n.1);
        let points: Vec<Point3<f64>> = near.iter().map(|n| cloud.point(n.1 as usize)).collect();
        Some(off_plane_mm(&at, &points))
    };
    let mut offs: Vec<f64> = probes.par_iter().filter_map(off).collect();
    let middle = offs.len() / 2;
    if offs.is_empty() {
        return 0.0;
    }
    PLANE_TAKES * SIGMA_OF_MEDIAN * *offs.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// At most so many of a list.
fn evenly(all: &[u32], most: usize) -> impl Iterator<Item = u32> + '_ {
    let some = all.len().min(most);
    (0..some).map(move |i| all[i * all.len() / some])
}

/// How far a point stands off the plane nearest to others.
fn off_plane_mm(at: &Point3<f64>, points: &[Point3<f64>]) -> f64 {
    let share = 1.0 / points.len().max(1) as f64;
    let middle = points.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + (p - at)) * share;
    let spread = points.iter().fold(Matrix3::zeros(), |s: Matrix3<f64>, p| {
        let d = p - at - middle;
        s + d * d.transpose()
    });
    let eigen = SymmetricEigen::new(spread);
    middle.dot(&eigen.eigenvectors.column(eigen.eigenvalues.imin())).abs()
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::{part_of, scan};
    use super::*;
    use crate::progress::Progress;
    use crate::sample::scan_maker::ScanRecipe;
    use crate::sample::solids;

    #[test]
    fn the_noise_put_on_is_found() {
        let part = part_of(&solids::cube(40.0));
        for (noise_mm, points) in [(0.02, 60_000), (0.06, 400_000)] {
            let (cloud, _) = scan(&part, &ScanRecipe { noise_mm, ..ScanRecipe::of(points, 1) });
            let thinned = Thinned::new(&cloud, &[], 40.0 * 3f64.sqrt() / 75.0, &Progress::default());
            let found = noise_mm_of(&cloud, &thinned.expect("not cancelled"));
            assert!((found / noise_mm - 1.0).abs() < 0.15, "{found} of {noise_mm}");
        }
    }

    use super::noise_mm as noise_mm_of;
}
