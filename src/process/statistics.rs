//! Statistics of a dose: shares of the chosen area, what lands where it should not, a histogram.

use super::dose_map::DoseMap;
use super::samples::DoseSample;
use crate::part::Surfaces;
use std::collections::BTreeMap;

/// How the dose on a sample of a chosen surface is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum DoseVerdict {
    /// Enough and not too much.
    Within,
    /// Too little.
    Under,
    /// Too much.
    Over,
    /// Too little, because something shades it.
    Shaded,
}

/// Shares of the chosen area; they sum to 1, or are all 0 where nothing is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// Enough and not too much.
    pub within: f64,
    /// Too little.
    pub under: f64,
    /// Too much.
    pub over: f64,
    /// Too little, because something shades it.
    pub shaded: f64,
}

/// A surface that was not chosen and gets more than is allowed there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collateral {
    /// Its number.
    pub surface: u32,
    /// Area above the threshold, mm².
    pub area_mm2: f64,
    /// The greatest dose on it, J/cm².
    pub greatest_j_cm2: f64,
}

impl DoseMap {
    /// How the dose on a sample is judged, if its surface is chosen.
    pub fn verdict(&self, sample: &DoseSample) -> DoseVerdict {
        let t = self.own.get(&sample.facet).unwrap_or(&self.thresholds);
        let (dose, unshaded) = (f64::from(sample.fluence_j_cm2), f64::from(sample.unshaded_j_cm2));
        if dose > t.high_j_cm2 {
            DoseVerdict::Over
        } else if dose >= t.low_j_cm2 {
            DoseVerdict::Within
        } else if unshaded >= t.low_j_cm2 {
            DoseVerdict::Shaded
        } else {
            DoseVerdict::Under
        }
    }

    /// The samples of the chosen surfaces, by their places in [`DoseMap::samples`], with their surface.
    pub fn chosen_samples(&self, surfaces: &Surfaces) -> impl Iterator<Item = (usize, &DoseSample, u32)> {
        let chosen = flags(&self.chosen, surfaces);
        let of_facet = surfaces.of_facet.clone();
        self.samples.iter().enumerate().filter_map(move |(i, s)| {
            let n = *of_facet.get(s.facet as usize)?;
            chosen.get(n as usize).is_some_and(|c| *c).then_some((i, s, n))
        })
    }

    /// Shares of the chosen area.
    pub fn shares(&self, surfaces: &Surfaces) -> Shares {
        let mut areas = [0.0f64; 4];
        for (_, s, _) in self.chosen_samples(surfaces) {
            areas[self.verdict(s) as usize] += f64::from(s.area_mm2);
        }
        let whole: f64 = areas.iter().sum();
        let share = |v: DoseVerdict| if whole > 0.0 { areas[v as usize] / whole } else { 0.0 };
        Shares {
            within: share(DoseVerdict::Within),
            under: share(DoseVerdict::Under),
            over: share(DoseVerdict::Over),
            shaded: share(DoseVerdict::Shaded),
        }
    }

    /// Surfaces that were not chosen and get more than the threshold somewhere, by their numbers.
    pub fn collateral(&self, surfaces: &Surfaces) -> Vec<Collateral> {
        let chosen = flags(&self.chosen, surfaces);
        let mut found: BTreeMap<u32, Collateral> = BTreeMap::new();
        for s in self.samples.iter().filter(|s| f64::from(s.fluence_j_cm2) > self.thresholds.collateral_j_cm2) {
            let Some(&surface) = surfaces.of_facet.get(s.facet as usize) else { continue };
            if chosen.get(surface as usize).is_some_and(|c| *c) {
                continue;
            }
            let c = found.entry(surface).or_insert(Collateral { surface, area_mm2: 0.0, greatest_j_cm2: 0.0 });
            c.area_mm2 += f64::from(s.area_mm2);
            c.greatest_j_cm2 = c.greatest_j_cm2.max(f64::from(s.fluence_j_cm2));
        }
        found.into_values().collect()
    }

    /// Area of the chosen surfaces by dose, mm²: `bins` classes of equal width from 0 to `to_j_cm2`;
    /// the last one holds what is above, too.
    pub fn histogram(&self, surfaces: &Surfaces, bins: usize, to_j_cm2: f64) -> Vec<f64> {
        let mut areas = vec![0.0; bins];
        for (_, s, _) in self.chosen_samples(surfaces) {
            let class = (f64::from(s.fluence_j_cm2) / to_j_cm2 * bins as f64) as usize;
            if let Some(a) = areas.get_mut(class.min(bins.saturating_sub(1))) {
                *a += f64::from(s.area_mm2);
            }
        }
        areas
    }

    /// The greatest dose anywhere, J/cm².
    pub fn greatest_j_cm2(&self) -> f64 {
        self.samples.iter().map(|s| f64::from(s.fluence_j_cm2)).fold(0.0, f64::max)
    }
}

/// Whether a surface is chosen, by its number.
fn flags(chosen: &[u32], surfaces: &Surfaces) -> Vec<bool> {
    let last = surfaces.list.last().map_or(0, |s| s.number);
    let mut flags = vec![false; last as usize + 1];
    for &n in chosen {
        if let Some(f) = flags.get_mut(n as usize) {
            *f = true;
        }
    }
    flags
}
