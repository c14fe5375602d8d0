//! The order in which points of a cloud lie side by side: along a Z-curve (Morton, 1966), of 1024 steps an axis.

use crate::scan::Cloud;
use rayon::prelude::*;

/// All points that are places, so that neighbours in the list are mostly neighbours in space; the same on any number of
/// threads.
pub(super) fn spatial(cloud: &Cloud) -> Vec<u32> {
    let finite = |o: &&[f32; 3]| o.iter().all(|c| c.is_finite());
    let none = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    let (lo, hi) =
        cloud.offsets.iter().filter(finite).fold(none, |(lo, hi), o| {
            (std::array::from_fn(|k| lo[k].min(o[k])), std::array::from_fn(|k| hi[k].max(o[k])))
        });
    let size = (0..3).fold(0f32, |size, k| size.max(hi[k] - lo[k]));
    let scale = if size > 0.0 && size.is_finite() { 1023.0 / size } else { 0.0 };
    let key = |o: &[f32; 3]| {
        let [x, y, z] = std::array::from_fn(|k| spread(((o[k] - lo[k]) * scale) as u64));
        x | y << 1 | z << 2
    };
    let places = (0u64..).zip(&cloud.offsets).filter(|(_, o)| finite(o));
    let mut keyed: Vec<u64> = places.map(|(i, o)| key(o) << 32 | i).collect();
    keyed.par_sort_unstable();
    keyed.into_iter().map(|key| key as u32).collect()
}

/// The ten lowest bits, two zeros between each and the next.
fn spread(x: u64) -> u64 {
    let x = x.min(1023);
    let x = (x | x << 16) & 0x0300_00ff;
    let x = (x | x << 8) & 0x0300_f00f;
    let x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    #[test]
    fn the_curve_visits_octants_one_by_one_and_leaves_out_what_is_no_place() {
        assert_eq!(spread(0b11_0000_0101), 0b001_001_000_000_000_000_000_001_000_001);
        let corner = |i: u32| [i & 1, i >> 1 & 1, i >> 2 & 1].map(|c| f64::from(c) * 7.0);
        let mut points: Vec<Point3<f64>> = (0..8).rev().map(|i| Point3::from(corner(i))).collect();
        points.push(Point3::new(1.0, 1.0, 1.0));
        let mut cloud = Cloud::of_points(&points);
        cloud.offsets.push([f32::NAN, 0.0, 0.0]);
        assert_eq!(spatial(&cloud), [7, 8, 6, 5, 4, 3, 2, 1, 0]);
        assert!(spatial(&Cloud::default()).is_empty());
    }
}
