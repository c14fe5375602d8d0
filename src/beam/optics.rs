//! Optics: how wide the beam is at any distance from its focus, and where it must stand for a wanted
//! spot.
//!
//! `d(z) = d0·√(1 + (z/zR)²)` (ISO 11146-1); z from the focus, mm, to either side. Spots are diameters
//! at 1/e². Aberrations and pulses are not modelled.

use crate::number_fields::number_fields;
use serde::{Deserialize, Serialize};

/// The `[optics]` table of a job.
///
/// The defaults give P1's spot (Table 1): 1 mm at a defocus of 20 mm, with the same cone from the
/// lens (10 mm on 200 mm) as from the waist (d0/zR = 0.1/2).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Optics {
    /// From the focus to the lens or the protective glass, the last thing that the light leaves, mm.
    pub lens_to_focus_mm: f64,
    /// Diameter of the beam there, mm.
    pub aperture_mm: f64,
    /// Diameter of the spot at the focus (d0), mm.
    pub focus_spot_mm: f64,
    /// Distance from the focus at which the spot is √2 times as wide (zR), mm.
    pub rayleigh_mm: f64,
    /// Wavelength, nm; used only for M².
    pub wavelength_nm: f64,
}

impl Default for Optics {
    fn default() -> Self {
        Optics::DEFAULT
    }
}

crate::part::keyed!(Optics { lens_to_focus_mm, aperture_mm, focus_spot_mm, rayleigh_mm, wavelength_nm });
number_fields!(Optics { lens_to_focus_mm, aperture_mm, focus_spot_mm, rayleigh_mm, wavelength_nm });

/// Relative change of the spot that a stated tolerance of the defocus allows.
pub const SPOT_TOLERANCE: f64 = 0.1;

impl Optics {
    /// Those of a new job.
    pub const DEFAULT: Optics = Optics {
        lens_to_focus_mm: 200.0,
        aperture_mm: 10.0,
        focus_spot_mm: 0.1,
        rayleigh_mm: 2.0,
        wavelength_nm: 1064.0,
    };

    /// Diameter of the spot at `z_mm` from the focus, mm.
    pub fn spot_mm(&self, z_mm: f64) -> f64 {
        let x = z_mm / self.rayleigh_mm;
        self.focus_spot_mm * (1.0 + x * x).sqrt()
    }

    /// Distance from the focus, to either side, at which the spot has this diameter; `None`: narrower than
    /// at the focus.
    pub fn defocus_for(&self, spot_mm: f64) -> Option<f64> {
        let ratio = spot_mm / self.focus_spot_mm;
        (ratio >= 1.0).then(|| self.rayleigh_mm * (ratio * ratio - 1.0).sqrt())
    }

    /// Defocus distances, least and greatest, on the same side of the focus, at which the spot is
    /// within [`SPOT_TOLERANCE`] of that at `defocus_mm`.
    pub fn tolerance_mm(&self, defocus_mm: f64) -> (f64, f64) {
        let spot = self.spot_mm(defocus_mm);
        let far = self.defocus_for(spot * (1.0 + SPOT_TOLERANCE)).unwrap_or(0.0);
        match self.defocus_for(spot * (1.0 - SPOT_TOLERANCE)) {
            Some(near) if defocus_mm < 0.0 => (-far, -near),
            Some(near) => (near, far),
            // Near the focus the spot is never that much narrower, on either side.
            None => (-far, far),
        }
    }

    /// Beam quality: `π·d0² / (4·λ·zR)`; 1 for a perfect Gaussian beam.
    pub fn m_squared(&self) -> f64 {
        std::f64::consts::PI * self.focus_spot_mm * self.focus_spot_mm
            / (4.0 * self.wavelength_nm * 1e-6 * self.rayleigh_mm)
    }

    /// Rayleigh length of a beam of that quality with this waist, mm.
    pub fn rayleigh_for(&self, m_squared: f64) -> f64 {
        std::f64::consts::PI * self.focus_spot_mm * self.focus_spot_mm / (4.0 * self.wavelength_nm * 1e-6 * m_squared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_defaults_are_those_of_the_papers_first_table() {
        let o = Optics::default();
        assert!((o.spot_mm(20.0) - 1.0).abs() < 0.006, "{}", o.spot_mm(20.0));
        assert_eq!(o.spot_mm(0.0), 0.1);
        assert!((o.spot_mm(2.0) / o.spot_mm(0.0) - 2f64.sqrt()).abs() < 1e-12);
        assert!((o.rayleigh_for(o.m_squared()) - o.rayleigh_mm).abs() < 1e-12);
        let far = o.spot_mm(o.lens_to_focus_mm);
        assert!((far - o.aperture_mm).abs() < 0.01, "the waist's cone fills the aperture: {far}");
    }

    proptest! {
        #[test]
        fn a_wanted_spot_is_found_on_both_sides(d in 0.1..20.0f64) {
            let o = Optics::default();
            let z = o.defocus_for(d).expect("wider than the waist");
            prop_assert!((o.spot_mm(z) - d).abs() < 1e-9 && (o.spot_mm(-z) - d).abs() < 1e-9);
            prop_assert_eq!(o.defocus_for(0.0999), None);
        }

        #[test]
        fn within_the_tolerance_the_spot_is_as_wanted(z in -60.0..60.0f64, t in 0.0..1.0f64) {
            let o = Optics::default();
            let (low, high) = o.tolerance_mm(z);
            prop_assert!(low <= z && z <= high);
            let off = o.spot_mm(low + (high - low) * t) / o.spot_mm(z) - 1.0;
            prop_assert!(off <= SPOT_TOLERANCE + 1e-9 && (off >= -SPOT_TOLERANCE - 1e-9 || low < 0.0 && high > 0.0));
        }
    }
}
