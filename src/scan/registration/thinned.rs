//! A cloud in voxels: what coarse and fine registration, noise and coverage look at in place of a million points.
//!
//! Voxels are sorted by place and their points by number, so everything taken from them has a fixed order. A voxel with
//! fewer than three points is dropped: that alone takes out nearly all of 1 % outliers. Only where it would take out more
//! than a fifth of the points is the cloud itself so thin, and everything stays.

use super::super::Cloud;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::ops::Range;

/// As many points as are looked at, in a fixed stride: of 20 million every tenth. 200 to the voxel on the usual part.
const MOST_POINTS: usize = 2_000_000;
/// Fewest points of a voxel that counts.
const FEWEST_IN_VOXEL: usize = 3;
/// Share of points that dropping lone ones may cost.
const LONE_SHARE: f64 = 0.2;
/// Bits of a voxel's number along each axis, and its middle. 2 million voxels are 28 000 diagonals of the model: what
/// lies further off is put at the end.
const BITS: u32 = 21;
const HALF: f64 = (1u32 << (BITS - 1)) as f64;

/// Voxels with their points.
#[derive(Clone, Debug, Default)]
pub(in crate::scan) struct Thinned {
    /// Edge of a voxel, mm.
    pub(in crate::scan) cell_mm: f64,
    /// Mean of the points of each voxel, scan frame.
    pub(in crate::scan) middles: Vec<Point3<f64>>,
    keys: Vec<u64>,
    ranges: Vec<Range<u32>>,
    order: Vec<u32>,
}

impl Thinned {
    /// Sorts points that are not left out into voxels.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(in crate::scan) fn new(
        cloud: &Cloud,
        left_out: &[bool],
        cell_mm: f64,
        progress: &Progress,
    ) -> Result<Thinned, Cancelled> {
        let stride = cloud.len().div_ceil(MOST_POINTS).max(1);
        let origin = cloud.origin;
        let taken = (0..cloud.len().div_ceil(stride)).into_par_iter().map(|i| i * stride);
        let mut keyed: Vec<(u64, u32)> = taken
            .filter(|&i| !left_out.get(i).is_some_and(|out| *out))
            .filter_map(|i| Some((key_of(&cell_of(&(cloud.point(i) - origin), cell_mm)?), i as u32)))
            .collect();
        progress.check()?;
        keyed.par_sort_unstable();
        progress.check()?;
        let mut ranges: Vec<Range<u32>> = Vec::new();
        for same in keyed.chunk_by(|a, b| a.0 == b.0) {
            let from = ranges.last().map_or(0, |r| r.end);
            ranges.push(from..from + same.len() as u32);
        }
        let is_lone = |r: &Range<u32>| r.len() < FEWEST_IN_VOXEL;
        let lone: usize = ranges.iter().filter(|r| is_lone(r)).map(Range::len).sum();
        if (lone as f64) <= LONE_SHARE * keyed.len() as f64 {
            ranges.retain(|r| !is_lone(r));
        }
        let order: Vec<u32> = keyed.iter().map(|k| k.1).collect();
        let mean = |r: &Range<u32>| {
            let sum = order[r.start as usize..r.end as usize]
                .iter()
                .fold(Vector3::zeros(), |sum: Vector3<f64>, &i| sum + (cloud.point(i as usize) - origin));
            origin + sum / r.len() as f64
        };
        let middles = ranges.par_iter().map(mean).collect();
        let keys = ranges.iter().map(|r| keyed[r.start as usize].0).collect();
        Ok(Thinned { cell_mm, middles, keys, ranges, order })
    }

    /// Numbers of a voxel's points in the cloud, ascending.
    pub(in crate::scan) fn points_of(&self, voxel: usize) -> &[u32] {
        let r = &self.ranges[voxel];
        &self.order[r.start as usize..r.end as usize]
    }

    /// How many points lie in voxels that count.
    pub(in crate::scan) fn point_count(&self) -> usize {
        self.ranges.iter().map(Range::len).sum()
    }

    /// About `count` points, as many from each voxel, with the voxel of each: even over the skin, however the scanner
    /// moved. Fewer where voxels hold fewer.
    pub(in crate::scan) fn spread(&self, count: usize) -> Vec<(u32, u32)> {
        let voxels = self.ranges.len();
        if count <= voxels {
            return (0..count).map(|i| i * voxels / count).map(|v| (v as u32, self.points_of(v)[0])).collect();
        }
        let each = count.div_ceil(voxels.max(1));
        let of_voxel = |v: usize| {
            let points = self.points_of(v);
            let some = each.min(points.len());
            (0..some).map(move |i| (v as u32, points[i * points.len() / some]))
        };
        (0..voxels).flat_map(of_voxel).collect()
    }

    /// The middles of so many voxels, evenly spaced; of all where there are fewer.
    pub(in crate::scan) fn spread_middles(&self, count: usize) -> impl Iterator<Item = Point3<f64>> + '_ {
        let (voxels, count) = (self.middles.len(), count.min(self.middles.len()));
        (0..count).map(move |i| self.middles[i * voxels / count])
    }

    /// The voxel itself and those of the 26 around it that count.
    pub(in crate::scan) fn around(&self, voxel: usize) -> impl Iterator<Item = usize> + '_ {
        let at = cell_of_key(self.keys[voxel]);
        (0..27i64).filter_map(move |i| {
            let side = [at[0] + i / 9 - 1, at[1] + i / 3 % 3 - 1, at[2] + i % 3 - 1];
            self.keys.binary_search(&key_of(&side)).ok()
        })
    }
}

/// In which cell a place lies, from the cell of the origin; `None` for what is no number.
fn cell_of(offset: &Vector3<f64>, cell_mm: f64) -> Option<[i64; 3]> {
    let cell = |x: f64| (x / cell_mm).floor().clamp(1.0 - HALF, HALF - 2.0);
    offset.iter().all(|x| x.is_finite()).then(|| [0, 1, 2].map(|k| cell(offset[k]) as i64))
}

fn key_of(cell: &[i64; 3]) -> u64 {
    cell.iter().fold(0, |key, &c| key << BITS | (c + HALF as i64) as u64)
}

fn cell_of_key(key: u64) -> [i64; 3] {
    [2, 1, 0].map(|k| (key >> (k * BITS) & ((1 << BITS) - 1)) as i64 - HALF as i64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Each point lies in the voxel of its own place, neighbours are those that touch it.
        #[test]
        fn voxels_are_what_they_say(places in prop::collection::vec(prop::array::uniform3(-9.0..9.0f64), 1..200)) {
            let points: Vec<Point3<f64>> = places.into_iter().map(Point3::from).collect();
            let cloud = Cloud::of_points(&points);
            let thin = Thinned::new(&cloud, &[], 2.5, &Progress::default()).expect("not cancelled");
            let cell = |i: u32| cell_of(&(cloud.point(i as usize) - cloud.origin), 2.5).expect("finite");
            for v in 0..thin.middles.len() {
                let mine = thin.points_of(v);
                prop_assert!(mine.iter().all(|&i| cell(i) == cell(mine[0])));
                let mean = mine.iter().fold(Vector3::zeros(), |s: Vector3<f64>, &i| s + cloud.point(i as usize).coords);
                prop_assert!((thin.middles[v].coords - mean / mine.len() as f64).norm() < 1e-5);
                let touching = |w: &usize| {
                    let (a, b) = (cell(mine[0]), cell(thin.points_of(*w)[0]));
                    (0..3).all(|k| (a[k] - b[k]).abs() <= 1)
                };
                let expected: Vec<usize> = (0..thin.middles.len()).filter(touching).collect();
                let mut found: Vec<usize> = thin.around(v).collect();
                found.sort_unstable();
                prop_assert_eq!(found, expected);
            }
        }
    }

    #[test]
    fn lone_points_go_unless_most_are_lone_and_marked_ones_always() {
        let wall = |n: u32| (0..n).map(|i| Point3::new(f64::from(i % 40), f64::from(i / 40), 0.0));
        let mut points: Vec<Point3<f64>> = wall(1600).collect();
        points.push(Point3::new(20.0, 20.0, 300.0));
        let cloud = Cloud::of_points(&points);
        let thin =
            |cell: f64, out: &[bool]| Thinned::new(&cloud, out, cell, &Progress::default()).expect("not cancelled");
        let thick = thin(4.0, &[]);
        assert!(thick.middles.iter().all(|m| m.z < 10.0));
        let spread = thick.spread(300);
        assert!(spread.iter().all(|&(v, i)| thick.points_of(v as usize).contains(&i)));
        assert!(spread.len() >= 250, "{}", spread.len());
        assert_eq!(thin(0.5, &[]).point_count(), 1601, "all are lone");
        let out: Vec<bool> = (0..1601).map(|i| i == 1600).collect();
        assert_eq!(thin(0.5, &out).point_count(), 1600);
    }
}
