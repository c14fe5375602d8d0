//! Noise, spacing and density of a cloud, from a sample of its points and their nearest others.
//!
//! Medians all of them, so that outliers and rims do not count. They are of the whole cloud: one number where a cloud
//! is dense here and thin there says little.

use super::super::cloud::Cloud;
use super::super::neighbours::{Neighbour, Neighbours};
use super::super::normals::plane_through;
use crate::progress::{Cancelled, Progress};
use crate::scan::{SIGMA_OF_MEDIAN, upper_median};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Neighbours of a plane.
const NEIGHBOURS: usize = 20;

/// Points looked at, at most: the median of 20 000 is sure to 1 %.
const SAMPLE: usize = 20_000;

/// What the points of a cloud say of its scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointFigures {
    /// Standard deviation of the points across the surface, mm: 1.4826 × median of the distances to the plane through
    /// 20 neighbours, less the plane's own share. Where those lie within a, curvature adds up to a²/8R on a cylinder of
    /// radius R, a²/4R on a ball; where a is not far above the noise it is told too low: by 1.5 % at a = 8 σ, by 10 %
    /// at a = 4 σ.
    pub noise_mm: f64,
    /// Median distance to the nearest other point, mm.
    pub spacing_mm: f64,
    /// Points per mm² of surface.
    pub density_per_mm2: f64,
}

/// Looks at an even sample of the points; `None` where the cloud has fewer than 21, or they lie on a line.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn point_figures(
    cloud: &Cloud,
    neighbours: &Neighbours,
    progress: &Progress,
) -> Result<Option<PointFigures>, Cancelled> {
    let (count, looked) = (cloud.len(), cloud.len().min(SAMPLE));
    let seen: Vec<Option<[f64; 3]>> = (0..looked)
        .into_par_iter()
        .map_init(Vec::new, |near, i| {
            if i % 64 == 0 {
                progress.check()?;
            }
            Ok(look_at(cloud, neighbours, (i as u64 * count as u64 / looked as u64) as u32, near))
        })
        .collect::<Result<_, Cancelled>>()?;
    let column = |k: usize| upper_median(&mut seen.iter().flatten().map(|s| s[k]).collect::<Vec<_>>());
    let Some([distance, nearest, last_squared]) = column(0).zip(column(1)).zip(column(2)).map(|((a, b), c)| [a, b, c])
    else {
        return Ok(None);
    };
    // The plane's height at the point has a variance of σ²/n from its middle, and of σ²·2/n² from its slope, as the
    // point lies off the middle by the scatter of n points.
    let n = NEIGHBOURS as f64;
    let plane_share = (1.0 + 1.0 / n + 2.0 / (n * n)).sqrt();
    // In a disc that reaches to the n-th of evenly scattered points there are n − 1/3 at the median (gamma
    // distribution).
    let density_per_mm2 = (n - 1.0 / 3.0) / (PI * last_squared);
    Ok(Some(PointFigures { noise_mm: SIGMA_OF_MEDIAN * distance / plane_share, spacing_mm: nearest, density_per_mm2 }))
}

/// Distance to the plane through the others, distance of the nearest one, squared distance of the last one.
fn look_at(cloud: &Cloud, neighbours: &Neighbours, index: u32, near: &mut Vec<Neighbour>) -> Option<[f64; 3]> {
    let point = cloud.point(index as usize);
    neighbours.nearest(&point, NEIGHBOURS + 1, near);
    near.retain(|n| n.index != index);
    near.truncate(NEIGHBOURS);
    let (first, last) = (near.first()?, near.get(NEIGHBOURS - 1)?);
    let plane = plane_through(near.iter().map(|n| cloud.point(n.index as usize)))?;
    let distance = (point - plane.middle).dot(&plane.normal).abs();
    Some([distance, f64::from(first.squared).sqrt(), f64::from(last.squared)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::made_up::Sequence;
    use nalgebra::Point3;

    fn figures(points: &[Point3<f64>]) -> Option<PointFigures> {
        let (cloud, progress) = (Cloud::of_points(points), Progress::default());
        let neighbours = Neighbours::new(&cloud, &progress).expect("nobody cancels");
        point_figures(&cloud, &neighbours, &progress).expect("nobody cancels")
    }

    /// A plane of 40 mm × 40 mm with 10 scattered points a mm²: 20 of them lie within 0.8 mm. In such a cloud the
    /// nearest other is at √(ln 2 / π·10) = 0.1485 mm in the median.
    #[test]
    fn a_planes_noise_spacing_and_density_are_told() {
        for noise_mm in [0.01, 0.03, 0.05, 0.1] {
            let mut sequence = Sequence::new(5);
            let mut points: Vec<Point3<f64>> = (0..16_000)
                .map(|_| {
                    let flat = [sequence.uniform() * 40.0, sequence.uniform() * 40.0];
                    Point3::new(flat[0], flat[1], 0.3 * flat[0] + noise_mm * 1.09f64.sqrt() * sequence.normal())
                })
                .collect();
            let area = 1600.0 * 1.09f64.sqrt();
            points.extend((0..160).map(|_| Point3::from([0, 1, 2].map(|_| sequence.uniform() * 40.0))));
            let found = figures(&points).expect("a plane of points");
            assert!((found.noise_mm / noise_mm - 1.0).abs() < 0.05, "{noise_mm}: {found:?}");
            let density = 16_000.0 / area;
            assert!((found.density_per_mm2 / density - 1.0).abs() < 0.08, "{found:?}");
            let spacing = (std::f64::consts::LN_2 / (PI * density)).sqrt();
            // The nearest other is looked for in space: noise counts in its distance.
            let least = 0.97 * spacing;
            let most = 1.03 * (spacing * spacing + 2.0 * noise_mm * noise_mm).sqrt();
            assert!((least..most).contains(&found.spacing_mm), "{found:?}, {spacing}");
        }
    }

    #[test]
    fn too_few_points_tell_nothing() {
        let points: Vec<Point3<f64>> = (0..20).map(|i| Point3::new(f64::from(i), f64::from(i * i), 0.0)).collect();
        assert_eq!(figures(&points), None);
        assert_eq!(figures(&[]), None);
    }
}
