//! The outline of a cam by its lift: base circle, flanks and nose of one formula, and the way along it.
//!
//! With h(φ) = base + lift·(1 − (φ/half)²)² for |φ| < half, else base, a plane follower stands at h when the cam has
//! turned by φ, so the outline is the envelope p(φ) = h·n + h'·t with n = (cos φ, sin φ) and t = (−sin φ, cos φ): n is
//! the outline's normal there, h + h'' its radius of curvature, ∫h dφ + h' the way from the nose. Convex where
//! base + lift > 4·lift/half²; an outline that is not is the caller's error. Its axis is the origin, its nose at φ = 0.

use super::outline::Flat;
use std::f64::consts::{PI, TAU};

/// A cam of which the follower rises and falls alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CamLobe {
    /// Radius of the base circle, mm.
    pub base_mm: f64,
    /// How far the follower rises, mm.
    pub lift_mm: f64,
    /// The turn from the nose to where the base circle begins, radians.
    pub half_rad: f64,
}

impl CamLobe {
    /// h, h' and h'' at φ in −π to π, mm.
    fn support(&self, angle: f64) -> [f64; 3] {
        let u = angle / self.half_rad;
        if u.abs() >= 1.0 {
            return [self.base_mm, 0.0, 0.0];
        }
        let (rest, step) = (1.0 - u * u, 4.0 * self.lift_mm / self.half_rad);
        let second = -step * (1.0 - 3.0 * u * u) / self.half_rad;
        [self.base_mm + self.lift_mm * rest * rest, -step * u * rest, second]
    }

    /// Length of the whole outline, mm.
    pub(super) fn length_mm(&self) -> f64 {
        TAU * self.base_mm + self.lift_mm * self.half_rad * 16.0 / 15.0
    }

    /// The way along the outline from the nose to φ, mm; below 0 on the other flank.
    pub(super) fn way_mm(&self, angle: f64) -> f64 {
        let u = (angle / self.half_rad).clamp(-1.0, 1.0);
        let rise = self.lift_mm * self.half_rad * u * (1.0 - u * u * (2.0 / 3.0 - u * u / 5.0));
        self.base_mm * angle + rise + self.support(angle)[1]
    }

    /// The angles of the corners of a polygon, from −π counter-clockwise: neighbours are as far apart in way and turn
    /// taken together, so that neither the nose gets a corner nor a flank a long chord.
    pub(super) fn angles(&self, corners: usize) -> Vec<f64> {
        let share = |angle: f64| self.way_mm(angle) / self.length_mm() + angle / TAU;
        (0..corners)
            .map(|i| {
                let wanted = 2.0 * i as f64 / corners as f64 - 1.0;
                // The share rises with the angle, so halving finds it: 60 times, to the last bit.
                let (mut low, mut high) = (-PI, PI);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if share(middle) < wanted { low = middle } else { high = middle }
                }
                0.5 * (low + high)
            })
            .collect()
    }

    /// The outline at those angles, offset inwards by less than the nose's radius, and turned by `phase_rad`.
    pub(super) fn points(&self, angles: &[f64], inset_mm: f64, phase_rad: f64) -> Vec<Flat> {
        let at = |&angle: &f64| {
            let [h, first, _] = self.support(angle);
            let (c, s) = (libm::cos(angle + phase_rad), libm::sin(angle + phase_rad));
            [(h - inset_mm) * c - first * s, (h - inset_mm) * s + first * c]
        };
        angles.iter().map(at).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOBE: CamLobe = CamLobe { base_mm: 15.0, lift_mm: 8.0, half_rad: 1.3 };

    fn chord(p: Flat, q: Flat) -> f64 {
        libm::hypot(q[0] - p[0], q[1] - p[1])
    }

    /// The way and the length are sums of many short chords; the ends of the lift meet the base circle.
    #[test]
    fn way_and_length_are_those_of_the_outline() {
        let fine: Vec<f64> = (0..=200_000).map(|i| -PI + TAU * f64::from(i) / 200_000.0).collect();
        let points = LOBE.points(&fine, 0.0, 0.4);
        let mut way = LOBE.way_mm(-PI);
        for (i, pair) in points.windows(2).enumerate() {
            way += chord(pair[0], pair[1]);
            if i % 5_000 == 0 {
                assert!((way - LOBE.way_mm(fine[i + 1])).abs() < 1e-6, "{} {way}", fine[i + 1]);
            }
        }
        assert!((way - LOBE.way_mm(-PI) - LOBE.length_mm()).abs() < 1e-6);
        let nose = LOBE.points(&[0.0, PI], 0.0, 0.0);
        assert!((nose[0][0] - 23.0).abs() < 1e-12 && (nose[1][0] + 15.0).abs() < 1e-12);
    }

    #[test]
    fn the_polygon_is_convex_close_to_the_outline_and_offset_by_its_inset() {
        let angles = LOBE.angles(256);
        let points = LOBE.points(&angles, 0.0, 0.0);
        let inner = LOBE.points(&angles, 0.5, 0.0);
        assert!((angles[128]).abs() < 1e-12, "a corner on the nose");
        for i in 0..256 {
            let (p, q, r) = (points[i], points[(i + 1) % 256], points[(i + 2) % 256]);
            let turn = (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]);
            assert!(turn > 0.0, "{q:?}");
            let end = if i == 255 { PI } else { angles[i + 1] };
            let middle = LOBE.points(&[0.5 * (angles[i] + end)], 0.0, 0.0)[0];
            let sagitta = ((q[0] - p[0]) * (middle[1] - p[1]) - (q[1] - p[1]) * (middle[0] - p[0])).abs() / chord(p, q);
            assert!(sagitta < 0.002, "{sagitta} at {p:?}");
            assert!((chord(p, inner[i]) - 0.5).abs() < 1e-12);
        }
        // Least radius of curvature: that of the nose.
        let [h, _, second] = LOBE.support(0.0);
        assert!((h + second - (23.0 - 32.0 / 1.69)).abs() < 1e-12);
    }
}
