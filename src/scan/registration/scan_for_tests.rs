//! Points measured on a skin of facets, made by a fixed sequence: even over the area, seen from one side, with noise and
//! outliers, in some pose. For tests and the bench of registration.

use nalgebra::{Isometry3, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};

/// What a scan is made like.
#[derive(Clone, Copy, Debug)]
pub struct ScanOf {
    /// How many points.
    pub points: usize,
    /// Share of the skin that is not seen.
    pub missing: f64,
    /// Standard deviation along each axis, mm.
    pub noise_mm: f64,
    /// Share of points that lie anywhere.
    pub outliers: f64,
    /// Which pose and side.
    pub pose: u64,
}

/// The fixed sequence (splitmix64).
struct Sequence(u64);

impl Sequence {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Normally distributed (Box and Muller).
    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.unit(), self.unit());
        (-2.0 * libm::log(u)).sqrt() * libm::cos(2.0 * std::f64::consts::PI * v)
    }

    fn normals(&mut self) -> Vector3<f64> {
        Vector3::new(self.normal(), self.normal(), self.normal())
    }
}

/// The points in the scan's frame, and `model_from_scan`.
pub fn measured(facets: &[[Point3<f64>; 3]], of: &ScanOf) -> (Vec<Point3<f64>>, Isometry3<f64>) {
    let mut sequence = Sequence(0x5eed + 7919 * of.pose);
    let crossed = |[a, b, c]: &[Point3<f64>; 3]| (b - a).cross(&(c - a));
    let mut sums = Vec::with_capacity(facets.len());
    let mut area = 0.0;
    for f in facets {
        area += crossed(f).norm();
        sums.push(area);
    }
    let all = facets.iter().flatten();
    let (lo, hi) = all.fold((facets[0][0], facets[0][0]), |(lo, hi), p| (lo.inf(p), hi.sup(p)));
    let (size, middle) = ((hi - lo).norm(), lo + (hi - lo) * 0.5);
    let seen_from = sequence.normals().normalize();
    let good = (of.points as f64 * (1.0 - of.outliers)) as usize;
    let whole = (good as f64 / (1.0 - of.missing)) as usize;
    let mut sampled: Vec<(f64, Point3<f64>)> = (0..whole)
        .map(|_| {
            let at = sequence.unit() * area;
            let [a, b, c] = facets[sums.partition_point(|s| *s <= at).min(facets.len() - 1)];
            let (mut u, mut v) = (sequence.unit(), sequence.unit());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let p = a + (b - a) * u + (c - a) * v;
            let n = crossed(&[a, b, c]).normalize();
            (-((p - middle).dot(&seen_from) / size + 0.7 * n.dot(&seen_from)), p)
        })
        .collect();
    let by_sight = |a: &(f64, Point3<f64>), b: &(f64, Point3<f64>)| a.0.total_cmp(&b.0);
    if good < whole {
        sampled.select_nth_unstable_by(good, by_sight);
        sampled.truncate(good);
    }
    let mut points: Vec<Point3<f64>> = sampled.into_iter().map(|(_, p)| p + sequence.normals() * of.noise_mm).collect();
    while points.len() < of.points {
        let share = Vector3::new(sequence.unit(), sequence.unit(), sequence.unit()).map(|x| 1.4 * x - 0.2);
        points.push(lo + (hi - lo).component_mul(&share));
    }
    let turn = Quaternion::new(sequence.normal(), sequence.normal(), sequence.normal(), sequence.normal());
    let scan_from_model =
        Isometry3::from_parts(Translation3::from(sequence.normals() * 100.0), UnitQuaternion::new_normalize(turn));
    (points.iter().map(|p| scan_from_model * p).collect(), scan_from_model.inverse())
}
