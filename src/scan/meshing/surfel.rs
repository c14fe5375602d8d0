//! A piece of the surface around a point: a quadric over the plane of its neighbours, and how far a place lies off it.

use crate::part::angle::any_square_to;
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY};
use nalgebra::{Matrix6, Point3, Vector3, Vector6};

/// The first round is without robust weights; two more leave a stray point a cell off with none.
const ROUNDS: usize = 3;
/// What is added for the bends, as a share of all weights: where points stand in a row or are few, a plane is fitted.
const STIFFNESS: f64 = 1e-3;
/// Share of the reach of the fit up to which its bends are followed; further off they go on straight.
const FOLLOWED: f64 = 0.6;

/// A neighbour as it counts in a fit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counted {
    pub place: Point3<f64>,
    pub weight: f64,
}

/// A quadric `height = c0 + c1·u + c2·v + c3·u² + c4·uv + c5·v²` over a plane, lengths in mm.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Surfel {
    middle: Point3<f64>,
    u: Vector3<f64>,
    v: Vector3<f64>,
    normal: Vector3<f64>,
    coefficients: [f64; 6],
    followed_mm: f64,
    /// How far the surface is held to go on around it, mm.
    pub reach_mm: f64,
}

/// A place as a surfel sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// Distance to the surface, mm, above 0 outside.
    pub off_mm: f64,
    /// The surface's unit normal there, outward.
    pub normal: Vector3<f64>,
}

impl Surfel {
    /// Fits the quadric over the plane through `middle` across `normal` to points within `radius_mm`. `None` where
    /// they tell none, or where `middle` itself is a stray of theirs.
    pub fn fitted(
        middle: Point3<f64>,
        normal: Vector3<f64>,
        near: &[Counted],
        radius_mm: f64,
        room: &mut Vec<f64>,
    ) -> Option<Surfel> {
        let u = any_square_to(&normal);
        let v = normal.cross(&u);
        let followed_mm = FOLLOWED * radius_mm;
        let mut surfel = Surfel { middle, u, v, normal, followed_mm, ..Surfel::default() };
        let mut width = f64::INFINITY;
        for _ in 0..ROUNDS {
            surfel.solve(near, radius_mm, width)?;
            room.clear();
            room.extend(near.iter().filter(|n| n.weight > 0.0).map(|n| surfel.residual(&n.place).abs()));
            if room.is_empty() {
                return None;
            }
            let half = room.len() / 2;
            let median = *room.select_nth_unstable_by(half, f64::total_cmp).1;
            // Points without noise are off by the rounding of their f32 places.
            width = TUKEY * SIGMA_OF_MEDIAN * median.max(1e-6 * radius_mm);
        }
        (surfel.residual(&middle).abs() < width.max(0.1 * radius_mm)).then_some(surfel)
    }

    fn solve(&mut self, near: &[Counted], radius_mm: f64, width: f64) -> Option<()> {
        let (mut squares, mut right, mut whole) = (Matrix6::zeros(), Vector6::zeros(), 0.0);
        for n in near.iter().filter(|n| n.weight > 0.0) {
            let share = self.residual(&n.place) / width;
            if share.abs() >= 1.0 {
                continue;
            }
            let weight = n.weight * (1.0 - share * share) * (1.0 - share * share);
            let d = (n.place - self.middle) / radius_mm;
            let (u, v) = (d.dot(&self.u), d.dot(&self.v));
            let row = Vector6::new(1.0, u, v, u * u, u * v, v * v);
            squares += row * (row * weight).transpose();
            right += row * (weight * d.dot(&self.normal));
            whole += weight;
        }
        for k in 0..6 {
            squares[(k, k)] += whole * if k < 3 { 1e-9 } else { STIFFNESS };
        }
        let c = squares.cholesky()?.solve(&right);
        let r = radius_mm;
        self.coefficients = [c[0] * r, c[1], c[2], c[3] / r, c[4] / r, c[5] / r];
        self.coefficients.iter().all(|c| c.is_finite()).then_some(())
    }

    /// Height of a point over the quadric, mm.
    fn residual(&self, p: &Point3<f64>) -> f64 {
        let d = p - self.middle;
        let (u, v) = (d.dot(&self.u), d.dot(&self.v));
        let [c0, c1, c2, c3, c4, c5] = self.coefficients;
        d.dot(&self.normal) - (c0 + c1 * u + c2 * v + c3 * u * u + c4 * u * v + c5 * v * v)
    }

    /// How far a place lies off the surface: to first order, exact where it is near.
    pub fn seen(&self, p: &Point3<f64>) -> Seen {
        let d = p - self.middle;
        let (u, v) = (d.dot(&self.u), d.dot(&self.v));
        let [c0, c1, c2, c3, c4, c5] = self.coefficients;
        let far = (u * u + v * v).sqrt();
        let share = if far > self.followed_mm { self.followed_mm / far } else { 1.0 };
        let (bu, bv) = (u * share, v * share);
        let (du, dv) = (c1 + 2.0 * c3 * bu + c4 * bv, c2 + c4 * bu + 2.0 * c5 * bv);
        let bent = c0 + c1 * bu + c2 * bv + c3 * bu * bu + c4 * bu * bv + c5 * bv * bv;
        let height = bent + du * (u - bu) + dv * (v - bv);
        let steep = (1.0 + du * du + dv * dv).sqrt();
        Seen {
            off_mm: (d.dot(&self.normal) - height) / steep,
            normal: (self.normal - self.u * du - self.v * dv) / steep,
        }
    }

    /// Where the surface is beneath its middle.
    pub fn foot(&self) -> Point3<f64> {
        self.middle + self.normal * self.coefficients[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// A paraboloid is told as it is, a stray point in seven left out.
        #[test]
        fn a_paraboloid_is_found_in_spite_of_strays(bend in prop::array::uniform3(-0.05..0.05f64), stray in 0.7..3.0f64,
                                                    at in prop::array::uniform2(-0.5..0.5f64)) {
            let height = |x: f64, y: f64| bend[0] * x * x + bend[1] * x * y + bend[2] * y * y;
            let points: Vec<Counted> = (0..40).map(|k| {
                let (r, turn) = (2.0 * ((f64::from(k) + 0.5) / 40.0).sqrt(), 2.399_963 * f64::from(k));
                let (x, y) = (r * libm::cos(turn), r * libm::sin(turn));
                let off = if k % 7 == 3 { stray } else { 1e-4 * f64::from(k % 5 - 2) };
                Counted { place: Point3::new(x, y, height(x, y) + off), weight: 1.0 }
            }).collect();
            let found = Surfel::fitted(Point3::origin(), Vector3::z(), &points, 2.0, &mut Vec::new()).expect("a surface");
            let above = Point3::new(at[0], at[1], height(at[0], at[1]) + 0.01);
            let seen = found.seen(&above);
            prop_assert!((seen.off_mm - 0.01).abs() < 4e-3, "{}", seen.off_mm);
        }
    }

    #[test]
    fn a_stray_has_no_surface_of_its_own() {
        let points: Vec<Counted> = (0..36)
            .map(|k| Counted { place: Point3::new(f64::from(k % 6) - 2.5, f64::from(k / 6) - 2.5, 0.0), weight: 1.0 })
            .collect();
        let at = |z: f64| Surfel::fitted(Point3::new(0.1, 0.1, z), Vector3::z(), &points, 4.0, &mut Vec::new());
        assert!(at(0.0).is_some());
        assert!(at(0.8).is_none());
        assert!(Surfel::fitted(Point3::origin(), Vector3::z(), &[], 4.0, &mut Vec::new()).is_none());
    }
}
