//! Numbers that look random and are the same in every run on every machine: SplitMix64, with what scans need of it.
//!
//! Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014. Good enough to scatter points; nothing
//! of it is secret.

use nalgebra::{Quaternion, UnitQuaternion, UnitVector3, Vector3};
use std::f64::consts::TAU;

/// A sequence of numbers that its seed determines.
#[derive(Clone, Debug)]
pub struct FixedNumbers(u64);

impl FixedNumbers {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> FixedNumbers {
        FixedNumbers(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Evenly spread over [0, 1), in steps of 2⁻⁵³.
    pub fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Evenly spread over 0 to `count` − 1; 0 if `count` is 0.
    pub fn index(&mut self, count: usize) -> usize {
        ((u128::from(self.next()) * count as u128) >> 64) as usize
    }

    /// Normally distributed with mean 0 and deviation 1 along each axis (Box and Muller, 1958).
    pub fn normal_vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| {
            let radius = (-2.0 * libm::log(1.0 - self.share())).sqrt();
            radius * libm::cos(TAU * self.share())
        })
    }

    /// A direction; all are as likely.
    pub fn direction(&mut self) -> UnitVector3<f64> {
        let z = 2.0 * self.share() - 1.0;
        let (radius, angle) = ((1.0 - z * z).max(0.0).sqrt(), TAU * self.share());
        UnitVector3::new_normalize(Vector3::new(radius * libm::cos(angle), radius * libm::sin(angle), z))
    }

    /// A turn; all are as likely (Shoemake, "Uniform random rotations", Graphics Gems III, 1992).
    pub fn turn(&mut self) -> UnitQuaternion<f64> {
        let (u, a, b) = (self.share(), TAU * self.share(), TAU * self.share());
        let (low, high) = ((1.0 - u).sqrt(), u.sqrt());
        let q = Quaternion::new(high * libm::cos(b), low * libm::sin(a), low * libm::cos(a), high * libm::sin(b));
        UnitQuaternion::new_normalize(q)
    }

    /// Puts values into another order; all orders are as likely.
    pub fn shuffle<T>(&mut self, values: &mut [T]) {
        for last in (1..values.len()).rev() {
            values.swap(last, self.index(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first numbers of seed 1234567, as the reference implementation prints them.
    #[test]
    fn the_sequence_is_that_of_its_paper() {
        let mut numbers = FixedNumbers::new(1_234_567);
        let first = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([numbers.next(), numbers.next(), numbers.next()], first);
    }

    #[test]
    fn moments_are_those_of_the_distributions() {
        let mut numbers = FixedNumbers::new(7);
        let count = 40_000;
        let (mut squares, mut fourths, mut along, mut turned) = (0.0, 0.0, Vector3::zeros(), Vector3::zeros());
        for _ in 0..count {
            let v = numbers.normal_vector();
            squares += v.norm_squared() / 3.0;
            fourths += v.iter().map(|x| x * x * x * x).sum::<f64>() / 3.0;
            along += numbers.direction().map(|x| x * x);
            turned += (numbers.turn() * Vector3::x()).map(|x| x * x);
        }
        let n = f64::from(count);
        assert!((squares / n - 1.0).abs() < 0.02 && (fourths / n - 3.0).abs() < 0.15, "{squares} {fourths}");
        for mean in [along / n, turned / n] {
            assert!(mean.iter().all(|m| (m - 1.0 / 3.0).abs() < 0.01), "{mean}");
        }
        let mut order: Vec<usize> = (0..100).collect();
        numbers.shuffle(&mut order);
        assert_ne!(order, (0..100).collect::<Vec<_>>());
        order.sort_unstable();
        assert_eq!(order, (0..100).collect::<Vec<_>>());
    }
}
