//! How noisy a scan is by itself: how far its points stand off what is fitted through their neighbours. No model is asked,
//! so a fit can be measured by it.
//!
//! A surface of second order is fitted, so that what is round counts as noise only where it bends otherwise within twenty
//! points: with planes the noise of the worn camshaft's scan (0.03 mm, four points a mm²) comes out as 0.044 mm.

use super::super::Cloud;
use super::thinned::Thinned;
use crate::scan::normals::plane_through;
use nalgebra::{Matrix6, Point3, Vector3, Vector6};
use rayon::prelude::*;

/// Places looked at, and points about each: the most and the fewest, four more than a surface of second order has numbers.
const PROBES: usize = 1000;
const NEIGHBOURS: usize = 20;
const FEWEST: usize = 10;
/// Unknowns of the surface.
const UNKNOWNS: usize = 6;
/// Which quantile of the places tells the noise, and how many standard deviations of a normal number it lies from the
/// middle. Beside edges the points scatter more, never less: with a fifth of the places there the lower quartile says
/// 4 % too much, the median 7 %.
const QUANTILE: f64 = 0.25;
const QUANTILE_SIGMAS: f64 = -0.6745;
/// Points of a voxel that are asked, evenly taken: where points lie closer together than they scatter, the nearest ones
/// make a ball, and its plane is any. So many leave a disc of a quarter of a voxel: 0.5 mm on a shaft of 150 mm.
const OF_VOXEL: usize = 80;
/// The standard deviation of the points along the normal, mm; 0 where there are too few.
pub(in crate::scan) fn noise_mm(cloud: &Cloud, thinned: &Thinned) -> f64 {
    let probes = thinned.spread(PROBES.min(thinned.middles.len()));
    let of = |&(voxel, point): &(u32, u32)| {
        let at = cloud.point(point as usize);
        let around = thinned.around(voxel as usize).flat_map(|v| evenly(thinned.points_of(v), OF_VOXEL));
        let mut near: Vec<(f64, u32)> = around.map(|i| ((cloud.point(i as usize) - at).norm_squared(), i)).collect();
        if near.len() < FEWEST {
            return None;
        }
        let last = near.len().min(NEIGHBOURS) - 1;
        near.select_nth_unstable_by(last, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.truncate(NEIGHBOURS);
        near.sort_unstable_by_key(|n| n.1);
        let points: Vec<Point3<f64>> = near.iter().map(|n| cloud.point(n.1 as usize)).collect();
        variance_mm2(&at, &points)
    };
    let mut all: Vec<f64> = probes.par_iter().filter_map(of).collect();
    let quantile = (all.len() as f64 * QUANTILE) as usize;
    if all.is_empty() { 0.0 } else { all.select_nth_unstable_by(quantile, f64::total_cmp).1.sqrt() }
}

/// At most so many of a list.
fn evenly(all: &[u32], most: usize) -> impl Iterator<Item = u32> + '_ {
    let some = all.len().min(most);
    (0..some).map(move |i| all[i * all.len() / some])
}

/// The variance of some points about the surface of second order nearest to them, by the quantile of what is left of their
/// squares; `None` where they do not tell a surface.
fn variance_mm2(at: &Point3<f64>, points: &[Point3<f64>]) -> Option<f64> {
    let normal = plane_through(points.iter().copied())?.normal;
    let along = if normal.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() }.cross(&normal).normalize();
    let across = normal.cross(&along);
    let reach_mm = points.iter().map(|p| (p - at).norm()).fold(0.0, f64::max);
    let (mut left, mut right, mut squares) = (Matrix6::zeros(), Vector6::zeros(), 0.0);
    for d in points.iter().map(|p| (p - at) / reach_mm) {
        let (x, y, height) = (d.dot(&along), d.dot(&across), d.dot(&normal));
        let row = Vector6::new(1.0, x, y, x * x, x * y, y * y);
        left += row * row.transpose();
        right += row * height;
        squares += height * height;
    }
    let rest = squares - right.dot(&left.cholesky()?.solve(&right));
    let variance = rest.max(0.0) * reach_mm * reach_mm / quantile_of_squares(points.len() - UNKNOWNS);
    variance.is_finite().then_some(variance)
}

/// The quantile of the sum of so many squares of normal numbers (Wilson and Hilferty 1931: their third root is nearly
/// normal).
fn quantile_of_squares(count: usize) -> f64 {
    let count = count as f64;
    let share = 2.0 / (9.0 * count);
    let root = 1.0 - share + QUANTILE_SIGMAS * share.sqrt();
    count * root * root * root
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::{part_of, scan};
    use super::*;
    use crate::progress::Progress;
    use crate::sample::scan_maker::ScanRecipe;
    use crate::sample::{camshaft_scan, solids};

    fn found_mm(cloud: &Cloud, diagonal_mm: f64) -> f64 {
        let thinned = Thinned::new(cloud, &[], diagonal_mm / 75.0, &Progress::default());
        noise_mm(cloud, &thinned.expect("not cancelled"))
    }

    /// On planes, however dense; on what is round, also where twenty points lie within a fifth of its radius.
    #[test]
    fn the_noise_put_on_is_found() {
        let solids = [solids::cube(40.0), solids::cylinder(6.0, 40.0, 400), solids::sphere(12.0, 300, 150)];
        for (solid, noise_mm, points) in
            [(0, 0.02, 60_000), (0, 0.06, 400_000), (1, 0.03, 7_000), (1, 0.03, 70_000), (2, 0.03, 7_000)]
        {
            let part = part_of(&solids[solid]);
            let (cloud, _) = scan(&part, &ScanRecipe { noise_mm, ..ScanRecipe::of(points, 1) });
            let found = found_mm(&cloud, part.mesh.diagonal());
            assert!((found / noise_mm - 1.0).abs() < 0.1, "{solid}: {found} of {noise_mm}");
        }
    }

    #[test]
    fn the_noise_of_the_camshafts_scan_is_found() {
        let made = camshaft_scan::scan();
        let found = found_mm(&Cloud::of_points(&made.points), 150.0);
        assert!((found / 0.03 - 1.0).abs() < 0.1, "{found}");
    }
}
