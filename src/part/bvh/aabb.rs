//! An axis-aligned box.

use nalgebra::Point3;

/// An axis-aligned box, mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aabb {
    /// Lowest corner.
    pub(super) lo: [f64; 3],
    /// Highest corner.
    pub(super) hi: [f64; 3],
}

impl Aabb {
    /// A box around nothing.
    pub(super) const NONE: Aabb = Aabb { lo: [f64::INFINITY; 3], hi: [f64::NEG_INFINITY; 3] };

    /// The box around a facet.
    #[inline]
    pub(super) fn of(corners: &[Point3<f64>; 3]) -> Aabb {
        corners.iter().fold(Aabb::NONE, |b, p| b.with(&Aabb { lo: [p.x, p.y, p.z], hi: [p.x, p.y, p.z] }))
    }

    /// The box around two boxes.
    #[inline]
    pub(super) fn with(&self, o: &Aabb) -> Aabb {
        Aabb {
            lo: std::array::from_fn(|k| smaller(self.lo[k], o.lo[k])),
            hi: std::array::from_fn(|k| larger(self.hi[k], o.hi[k])),
        }
    }

    /// The middle along an axis.
    #[inline]
    pub(super) fn middle(&self, k: usize) -> f64 {
        0.5 * (self.lo[k] + self.hi[k])
    }

    /// Half of its surface area, mm².
    #[inline]
    pub(super) fn half_area(&self) -> f64 {
        let d: [f64; 3] = std::array::from_fn(|k| (self.hi[k] - self.lo[k]).max(0.0));
        d[0] * d[1] + d[1] * d[2] + d[2] * d[0]
    }
}

/// `f64::min` for numbers: one instruction, where that one looks for NaN as well.
#[inline]
pub(super) fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// `f64::max` for numbers.
#[inline]
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}
