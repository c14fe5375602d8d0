//! How close lines have to lie for enough to land between them: long parallel lines on a plate, which the spot
//! crosses at its defocus. Rims, bends and slopes are not modelled.

use super::spot::Spot;

/// Number of places sampled between two lines.
const PLACES: u32 = 32;
/// Ratio of one trial spacing to the one before.
const STEP: f64 = 0.99;
/// Least spacing worth advising, as a share of the spot; below it the power is too low, or the speed too high.
const CLOSEST_SHARE: f64 = 0.1;

impl Spot {
    /// Density that a long line leaves at a distance from it, 1/mm: times power over speed it is the energy per area.
    pub fn density_beside_line(&self, y_mm: f64) -> f64 {
        let [reach, _] = self.reach_mm(self.defocus_mm);
        let (from, to) = ([-reach, y_mm], [reach, y_mm]);
        let window = self.window(from, to, self.defocus_mm);
        window.map_or(0.0, |w| 2.0 * reach * self.density_integral(from, to, self.defocus_mm, w))
    }

    /// The least that lands anywhere between parallel lines `spacing_mm` apart, 1/mm; on the average it is one over
    /// the spacing.
    pub fn least_between(&self, spacing_mm: f64) -> f64 {
        let [_, reach] = self.reach_mm(self.defocus_mm);
        let lines = (reach / spacing_mm).ceil() as i64 + 1;
        let at = |y: f64| (-lines..=lines).map(|k| self.density_beside_line(y - spacing_mm * k as f64)).sum::<f64>();
        (0..=PLACES).map(|i| at(0.5 * spacing_mm * f64::from(i) / f64::from(PLACES))).fold(f64::INFINITY, f64::min)
    }

    /// The greatest spacing below `from_mm`, to a hundredth of it, at which what lands between lines is enough;
    /// `is_enough` gets a spacing and the least that lands at it. `None` if `from_mm` is close enough already, or if no
    /// practicable spacing is.
    pub fn sufficient_spacing_mm(&self, from_mm: f64, is_enough: &dyn Fn(f64, f64) -> bool) -> Option<f64> {
        let enough = |mm: f64| is_enough(mm, self.least_between(mm));
        let closest = CLOSEST_SHARE * self.spot_mm;
        if !(closest > 0.0 && from_mm.is_finite()) || enough(from_mm) {
            return None;
        }
        let closer = std::iter::successors(Some(STEP * from_mm), |mm| Some(STEP * mm));
        closer.take_while(|mm| *mm >= closest).find(|mm| enough(*mm))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beam::Optics;
    use crate::process::Profile;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn spot(profile: Profile, spot_mm: f64) -> Spot {
        Spot { profile, line_mm: 3.0, spot_mm, defocus_mm: 20.0, optics: Optics::default() }
    }

    /// Half of the mean: what a job without thresholds calls enough.
    fn half(mm: f64, least: f64) -> bool {
        least * mm >= 0.5
    }

    #[test]
    fn a_line_leaves_its_closed_form() {
        let (r, y) = (0.6, 0.25);
        let gauss = (2.0 / PI).sqrt() / r * libm::exp(-2.0 * y * y / (r * r));
        let chord = 2.0 * (r * r - y * y).sqrt() / (PI * r * r);
        for (profile, expected) in [(Profile::Gaussian, gauss), (Profile::TopHat, chord), (Profile::Line, 1.0 / 3.0)] {
            let found = spot(profile, 2.0 * r).density_beside_line(y);
            // A Gaussian spot ends at two and a half radii.
            assert!((found - expected).abs() < 1e-5 * expected, "{profile:?}: {found}, not {expected}");
        }
    }

    #[test]
    fn the_spacing_of_even_power_is_the_width_of_its_line() {
        let found = spot(Profile::Line, 1.0).sufficient_spacing_mm(5.0, &half).expect("a spacing");
        assert!(found <= 3.0 && found > 0.98 * 3.0, "{found}");
        assert_eq!(spot(Profile::Line, 1.0).sufficient_spacing_mm(2.9, &half), None, "close enough");
    }

    proptest! {
        /// Found, it is enough, and so is what is closer; a hundredth more is not. It grows with the spot.
        #[test]
        fn it_is_the_greatest(spot_mm in 0.2..4.0f64, wide in 1.5..6.0f64) {
            let s = spot(Profile::Gaussian, spot_mm);
            let found = s.sufficient_spacing_mm(wide * spot_mm, &half).expect("too wide");
            prop_assert!(half(found, s.least_between(found)));
            prop_assert!(half(0.5 * found, s.least_between(0.5 * found)));
            prop_assert!(!half(found / STEP, s.least_between(found / STEP)));
            let double = spot(Profile::Gaussian, 2.0 * spot_mm).sufficient_spacing_mm(2.0 * wide * spot_mm, &half);
            prop_assert!((double.expect("too wide") / found - 2.0).abs() < 1e-9);
        }

        /// No power is enough at any spacing that is worth the name.
        #[test]
        fn too_little_power_is_no_matter_of_spacing(spot_mm in 0.2..4.0f64) {
            let s = spot(Profile::Gaussian, spot_mm);
            prop_assert_eq!(s.sufficient_spacing_mm(2.0 * spot_mm, &|_, least| least > 100.0 / spot_mm), None);
        }
    }
}
