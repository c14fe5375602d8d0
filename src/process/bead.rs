//! The section of a clad bead and of beads side by side (P3 4.1): a circular arc over its width.
//!
//! The distance of centres is that at which the metal of a bead fills its share of a layer as high as the bead:
//! area / height. P3's formula has an arcsine for the arc's angle, which is right up to a half circle only; here
//! it is `4·atan(2h/w)` all round. How power, speed and powder determine the size of a bead is not modelled here.

use std::f64::consts::PI;

/// A bead's section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bead {
    width_mm: f64,
    height_mm: f64,
}

/// Below this `2h/w` the area comes from a series: differences would lose digits.
const FLAT: f64 = 0.01;
/// Bounds between which `2h/w` is searched by bisection.
const STEEPNESS: (f64, f64) = (1e-6, 1e6);

impl Bead {
    /// A bead of this width at its foot and this height; `None` unless both are above 0 and finite.
    pub fn new(width_mm: f64, height_mm: f64) -> Option<Bead> {
        let is = |x: f64| x.is_finite() && x > 0.0;
        (is(width_mm) && is(height_mm)).then_some(Bead { width_mm, height_mm })
    }

    /// The bead of this width whose centres lie `spacing_mm` apart; `None` at two thirds of the width or less.
    pub fn of_width(width_mm: f64, spacing_mm: f64) -> Option<Bead> {
        let steepness = solved(spacing_mm / width_mm, spacing_share)?;
        Bead::new(width_mm, 0.5 * steepness * width_mm)
    }

    /// The bead of this height whose centres lie `spacing_mm` apart; `None` at π/4 of the height or less.
    pub fn of_height(height_mm: f64, spacing_mm: f64) -> Option<Bead> {
        // At one height a wider bead has more area: the distance falls with the steepness.
        let steepness = solved(-spacing_mm / height_mm, |s| -2.0 * spacing_share(s) / s)?;
        Bead::new(2.0 * height_mm / steepness, height_mm)
    }

    /// The bead of this width that overlaps by this share of it; `None` from a third on.
    pub fn of_width_overlapping(width_mm: f64, overlap: f64) -> Option<Bead> {
        Bead::of_width(width_mm, (1.0 - overlap) * width_mm)
    }

    /// The bead of this height that overlaps by this share of its width; `None` from a third on.
    pub fn of_height_overlapping(height_mm: f64, overlap: f64) -> Option<Bead> {
        Bead::new(2.0 * height_mm / solved(1.0 - overlap, spacing_share)?, height_mm)
    }

    /// Width at its foot, mm.
    pub fn width_mm(&self) -> f64 {
        self.width_mm
    }

    /// Height, mm.
    pub fn height_mm(&self) -> f64 {
        self.height_mm
    }

    /// Radius of its arc, mm.
    pub fn radius_mm(&self) -> f64 {
        let half = 0.5 * self.width_mm;
        (half * half + self.height_mm * self.height_mm) / (2.0 * self.height_mm)
    }

    /// Area of its section, mm².
    pub fn area_mm2(&self) -> f64 {
        self.spacing_mm() * self.height_mm
    }

    /// Distance of the centres of neighbouring beads, mm.
    pub fn spacing_mm(&self) -> f64 {
        self.width_mm * spacing_share(2.0 * self.height_mm / self.width_mm)
    }

    /// Share of its width by which it overlaps the next: a third for flat ones, less for higher ones; below 0
    /// for those so high that they stand apart at the foot.
    pub fn overlap(&self) -> f64 {
        1.0 - self.spacing_mm() / self.width_mm
    }

    /// Greatest less least height from one centre to the next, mm: what the outline of [`Bead::profile`] shows.
    pub fn ripple_mm(&self, spacing_mm: f64) -> f64 {
        let radius_mm = self.radius_mm();
        let valley = self.valley(spacing_mm).map(|angle| radius_mm * (1.0 - libm::cos(angle)));
        valley.unwrap_or(self.height_mm)
    }

    /// Outline (y, z) of `count` beads so far apart, mm: the ground at z = 0, the first centre at y = 0, each arc
    /// in `steps` chords.
    ///
    /// It is the outline of the arcs laid over each other. Metal is not conserved: where beads overlap it would
    /// also fill up the valleys, so the ripple told is the most there can be, and is 0 only for spacing 0.
    pub fn profile(&self, count: usize, spacing_mm: f64, steps: usize) -> Vec<(f64, f64)> {
        let radius_mm = self.radius_mm();
        let foot = 2.0 * libm::atan2(2.0 * self.height_mm, self.width_mm);
        let valley = self.valley(spacing_mm);
        let mut out = Vec::new();
        for bead in 0..count {
            let from = valley.filter(|_| bead > 0);
            let to = valley.filter(|_| bead + 1 < count).unwrap_or(foot);
            let steps = steps.max(1);
            // Neighbours share the point in the valley.
            for k in usize::from(from.is_some())..=steps {
                let first = -from.unwrap_or(foot);
                let angle = first + (to - first) * k as f64 / steps as f64;
                let y = bead as f64 * spacing_mm + radius_mm * libm::sin(angle);
                out.push((y, (self.height_mm - radius_mm * (1.0 - libm::cos(angle))).max(0.0)));
            }
        }
        out
    }

    /// Angle from the top of a bead to where it meets the next above the ground.
    fn valley(&self, spacing_mm: f64) -> Option<f64> {
        let (half, radius_mm) = (0.5 * spacing_mm.abs(), self.radius_mm());
        let foot = 2.0 * libm::atan2(2.0 * self.height_mm, self.width_mm);
        (half < radius_mm).then(|| libm::asin(half / radius_mm)).filter(|angle| *angle < foot)
    }
}

/// Distance of centres by width, for `s` = 2h/w: A / (h w). From 2/3 for flat beads it only grows.
fn spacing_share(s: f64) -> f64 {
    if s < FLAT {
        return 2.0 / 3.0 + s * s * (2.0 / 15.0 - s * s * 2.0 / 105.0);
    }
    // A = R²φ − (R − h) w/2 with R = (w/4)(1 + s²)/s and φ = 2·atan s, by w²/4.
    let area = (1.0 + s * s) * (1.0 + s * s) / (2.0 * s * s) * libm::atan(s) - (1.0 - s * s) / (2.0 * s);
    area / (2.0 * s)
}

/// The steepness at which a growing function has this value.
fn solved(value: f64, of: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut low, mut high) = STEEPNESS;
    if !(of(low) < value && value < of(high)) {
        return None;
    }
    // Halved by ratio, until the two are neighbours.
    for _ in 0..100 {
        let middle = (low * high).sqrt();
        if of(middle) < value { low = middle } else { high = middle }
    }
    Some((low * high).sqrt())
}

/// The least distance of centres that a bead of this height can have, mm: that of a full circle.
pub fn least_spacing_mm(height_mm: f64) -> f64 {
    0.25 * PI * height_mm
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bead(width_mm: f64, height_mm: f64) -> Bead {
        Bead::new(width_mm, height_mm).expect("a bead")
    }

    #[track_caller]
    fn near(found: f64, expected: f64) {
        assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} instead of {expected}");
    }

    #[test]
    fn flat_beads_overlap_by_a_third() {
        let flat = bead(3.0, 1e-5);
        near(flat.spacing_mm(), 2.0);
        near(flat.overlap(), 1.0 / 3.0);
        // A parabola's next term: c/w = 2/3 + (2/15)(2h/w)².
        let low = bead(2.0, 0.002);
        assert!((low.spacing_mm() / 2.0 - 2.0 / 3.0 - 2.0 / 15.0 * 4e-6).abs() < 1e-12);
        // Series and formula meet.
        assert!((spacing_share(FLAT) - spacing_share(FLAT * (1.0 - 1e-12))).abs() < 1e-11);
    }

    #[test]
    fn half_circles_and_more() {
        let half = bead(4.0, 2.0);
        near(half.radius_mm(), 2.0);
        near(half.area_mm2(), PI * 16.0 / 8.0);
        near(half.overlap(), 1.0 - PI / 4.0);
        // Three quarters of a circle of radius 1, cut at 45° below: area 3π/4 + 1/2.
        let root = 2f64.sqrt();
        let high = bead(root, 1.0 + 0.5 * root);
        near(high.radius_mm(), 1.0);
        near(high.area_mm2(), 0.75 * PI + 0.5);
        assert!(high.overlap() < 0.0, "they stand apart at the foot");
        // A flat one by the printed formula: a sixth of a circle of radius 1, cut along its chord.
        let sixth = bead(1.0, 1.0 - 0.75f64.sqrt());
        near(sixth.area_mm2(), PI / 6.0 - 3f64.sqrt() / 4.0);
    }

    #[test]
    fn what_no_bead_can_do_has_none() {
        for (width, height) in [(0.0, 1.0), (1.0, -1.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)] {
            assert_eq!(Bead::new(width, height), None);
        }
        assert_eq!(Bead::of_width(3.0, 2.0), None, "two thirds is no height at all");
        assert_eq!(Bead::of_width_overlapping(3.0, 0.34), None);
        assert_eq!(Bead::of_height(1.0, least_spacing_mm(1.0)), None);
        assert!(Bead::of_height(1.0, least_spacing_mm(1.0) * 1.001).is_some());
        assert_eq!(
            (Bead::of_width(f64::NAN, 1.0), Bead::of_height(0.0, 1.0), Bead::of_width(-1.0, 1.0)),
            (None, None, None)
        );
    }

    #[test]
    fn the_outline_meets_ground_top_and_valley() {
        let half = bead(4.0, 2.0);
        // Centres 2 mm apart on circles of radius 2: they meet at √3.
        let valley = 3f64.sqrt();
        near(half.ripple_mm(2.0), 2.0 - valley);
        let outline = half.profile(3, 2.0, 10);
        assert_eq!(outline.len(), 11 + 10 + 10);
        let (first, last) = (outline[0], outline[30]);
        assert!((first.0 + 2.0).abs() < 1e-12 && first.1 < 1e-12 && (last.0 - 6.0).abs() < 1e-12 && last.1 < 1e-12);
        assert!((outline[10].0 - 1.0).abs() < 1e-12 && (outline[10].1 - valley).abs() < 1e-12);
        let least = outline.iter().filter(|p| (0.0..=4.0).contains(&p.0)).map(|p| p.1).fold(2.0, f64::min);
        near(least, valley);
        assert!(outline.iter().all(|p| p.1 <= 2.0 + 1e-12));
        // Apart they stand on the ground; one above the other there is no valley.
        near(half.ripple_mm(4.5), 2.0);
        assert_eq!(half.profile(2, 4.5, 10).iter().filter(|p| p.1 < 1e-9).count(), 4);
        near(half.ripple_mm(0.0), 0.0);
        assert!(half.profile(0, 1.0, 10).is_empty());
    }

    proptest! {
        #[test]
        fn there_and_back(width in 0.1..20.0f64, steepness in 0.05..5.0f64) {
            let made = bead(width, 0.5 * steepness * width);
            let same = |other: Option<Bead>| {
                let other = other.expect("the one it was made of");
                (other.width_mm() - width).abs() < 1e-6 * width
                    && (other.height_mm() - made.height_mm()).abs() < 1e-6 * made.height_mm()
            };
            prop_assert!(same(Bead::of_width(width, made.spacing_mm())));
            prop_assert!(same(Bead::of_height(made.height_mm(), made.spacing_mm())));
            prop_assert!(same(Bead::of_width_overlapping(width, made.overlap())));
            prop_assert!(same(Bead::of_height_overlapping(made.height_mm(), made.overlap())));
        }

        /// The closed form beside the area of the drawn outline.
        #[test]
        fn the_outline_has_the_area(width in 0.1..20.0f64, steepness in 0.01..4.0f64) {
            let made = bead(width, 0.5 * steepness * width);
            let outline = made.profile(1, 1.0, 4000);
            let area: f64 = outline.windows(2).map(|w| (w[1].0 - w[0].0) * 0.5 * (w[0].1 + w[1].1)).sum();
            prop_assert!((area / made.area_mm2() - 1.0).abs() < 1e-5, "{area}");
        }

        /// Higher beads lie farther apart, and a layer of them has the height of a bead.
        #[test]
        fn a_layer_holds_the_metal(width in 0.1..20.0f64, low in 0.001..3.0f64, more in 1.001..2.0f64) {
            let (one, other) = (bead(width, low), bead(width, low * more));
            prop_assert!(one.spacing_mm() < other.spacing_mm());
            let phi = 2.0 * libm::atan2(2.0 * low, width);
            let r = one.radius_mm();
            let area = r * r * phi - (r - low) * width / 2.0;
            prop_assert!((one.spacing_mm() * low - area).abs() < 1e-9 * r * r);
        }
    }
}
