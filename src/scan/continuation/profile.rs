//! A curve over a line: a cubic spline of even intervals, or one level all along. Third differences of its
//! coefficients are held small, so slightly that it counts only where there are no points: a gap is bridged by a
//! parabola.

/// A spline's places; its coefficients are kept with the fit. Lengths mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Profile {
    pub start_mm: f64,
    pub end_mm: f64,
    /// 0: one level all along.
    pub intervals: usize,
}

/// Values of the spline's base functions at a place that are not 0, with their first derivatives, and the first one's
/// number.
pub(super) struct Base {
    pub first: usize,
    pub value: [f64; 4],
    pub slope: [f64; 4],
    pub count: usize,
}

impl Profile {
    /// Number of coefficients.
    pub fn coefficients(&self) -> usize {
        if self.intervals == 0 { 1 } else { self.intervals + 3 }
    }

    /// Whether a place lies on the curve.
    pub fn holds(&self, x_mm: f64) -> bool {
        let beyond = 1e-6 * (self.end_mm - self.start_mm).abs();
        x_mm >= self.start_mm - beyond && x_mm <= self.end_mm + beyond
    }

    /// The base functions at a place; beyond the ends, at the end.
    pub fn base(&self, x_mm: f64) -> Base {
        if self.intervals == 0 {
            return Base { first: 0, value: [1.0, 0.0, 0.0, 0.0], slope: [0.0; 4], count: 1 };
        }
        let per_mm = self.intervals as f64 / (self.end_mm - self.start_mm);
        let at = ((x_mm - self.start_mm) * per_mm).clamp(0.0, self.intervals as f64);
        let first = (at as usize).min(self.intervals - 1);
        let t = at - first as f64;
        let (s, t2, t3) = (1.0 - t, t * t, t * t * t);
        let value = [s * s * s, 3.0 * t3 - 6.0 * t2 + 4.0, -3.0 * t3 + 3.0 * t2 + 3.0 * t + 1.0, t3].map(|b| b / 6.0);
        let slope = [-s * s, 3.0 * t2 - 4.0 * t, -3.0 * t2 + 2.0 * t + 1.0, t2].map(|b| 0.5 * b * per_mm);
        Base { first, value, slope, count: 4 }
    }

    /// Height and slope of the curve at a place.
    pub fn at(&self, x_mm: f64, coefficients: &[f64]) -> [f64; 2] {
        let base = self.base(x_mm);
        (0..base.count).fold([0.0; 2], |[y, dy], k| {
            let c = coefficients[base.first + k];
            [y + c * base.value[k], dy + c * base.slope[k]]
        })
    }

    /// The place on the curve that is nearest to (x, y) of the plane, near x.
    pub fn foot(&self, x_mm: f64, y_mm: f64, coefficients: &[f64]) -> f64 {
        let mut x = x_mm.clamp(self.start_mm, self.end_mm);
        // Gauss and Newton: each step leaves the share height × curvature of the error, a hundredth here.
        for _ in 0..12 {
            let [y, dy] = self.at(x, coefficients);
            x += ((x_mm - x) + (y_mm - y) * dy) / (1.0 + dy * dy);
            x = x.clamp(self.start_mm, self.end_mm);
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Base functions add up to 1, their slopes to 0; a straight line is a spline.
        #[test]
        fn a_line_is_a_spline(intervals in 1..20usize, at in -3.0..8.0f64, slope in -2.0..2.0f64) {
            let profile = Profile { start_mm: -3.0, end_mm: 8.0, intervals };
            let base = profile.base(at);
            prop_assert!((base.value.iter().sum::<f64>() - 1.0).abs() < 1e-12);
            prop_assert!(base.slope.iter().sum::<f64>().abs() < 1e-9);
            let step = 11.0 / intervals as f64;
            let line: Vec<f64> = (0..profile.coefficients()).map(|j| slope * (-3.0 + step * (j as f64 - 1.0))).collect();
            let [y, dy] = profile.at(at, &line);
            prop_assert!((y - slope * at).abs() < 1e-9 && (dy - slope).abs() < 1e-9);
            // The foot of a point on the line's normal.
            let foot = profile.foot(at - 0.3 * slope, slope * at + 0.3, &line);
            prop_assert!((foot - at).abs() < 1e-9);
        }
    }
}
