//! What all distances say together: mean, spread, percentiles, shares, histogram. Of the points on the model alone; how
//! many are not is told beside it.

use super::{Deviation, Footing};
use crate::scan::SIGMA_OF_MEDIAN;
use rayon::prelude::*;

/// Figures of the signed distances, mm. Without points on the model the figures are 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeviationStatistics {
    /// Points without model: their foot lies on a rim.
    pub no_model: usize,
    /// Points farther off than what counts.
    pub far: usize,
    /// Mean distance, mm.
    pub mean_mm: f64,
    /// Root of the mean square, mm.
    pub rms_mm: f64,
    /// Standard deviation of the undisturbed points, mm: 1.4826 × the median of the distances from the median. Up to
    /// half of the points may be worn or stray.
    pub sigma_mm: f64,
    sorted_mm: Vec<f32>,
}

/// How many distances fall into each of equally wide bins.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Left side of the first bin, mm.
    pub from_mm: f64,
    /// Right side of the last one, mm; its points count.
    pub to_mm: f64,
    /// Points in each; a bin holds its left side.
    pub counts: Vec<usize>,
    /// Points left of the first.
    pub below: usize,
    /// Points right of the last.
    pub above: usize,
}

impl DeviationStatistics {
    /// Sums up a deviation: 4 bytes for each of its points.
    pub fn of(deviation: &Deviation) -> DeviationStatistics {
        let mut sorted_mm: Vec<f32> = deviation.on_model().map(|i| deviation.signed_mm[i as usize]).collect();
        sorted_mm.par_sort_unstable_by(f32::total_cmp);
        let count = |footing: Footing| deviation.footing.iter().filter(|f| **f == footing).count();
        let (no_model, far) = (count(Footing::NoModel), count(Footing::Far));
        let mut statistics = DeviationStatistics { no_model, far, sorted_mm, ..DeviationStatistics::default() };
        if statistics.sorted_mm.is_empty() {
            return statistics;
        }
        let all = || statistics.sorted_mm.iter().map(|d| f64::from(*d));
        let share = 1.0 / statistics.sorted_mm.len() as f64;
        let (mean_mm, rms_mm) = (all().sum::<f64>() * share, (all().map(|d| d * d).sum::<f64>() * share).sqrt());
        let median = statistics.percentile_mm(50.0);
        let mut off: Vec<f64> = all().map(|d| (d - median).abs()).collect();
        let middle = off.len() / 2;
        let sigma_mm = SIGMA_OF_MEDIAN * *off.select_nth_unstable_by(middle, f64::total_cmp).1;
        (statistics.mean_mm, statistics.rms_mm, statistics.sigma_mm) = (mean_mm, rms_mm, sigma_mm);
        statistics
    }

    /// Points on the model.
    pub fn count(&self) -> usize {
        self.sorted_mm.len()
    }

    /// The least and the greatest distance, mm.
    pub fn extremes_mm(&self) -> (f64, f64) {
        (self.percentile_mm(0.0), self.percentile_mm(100.0))
    }

    /// The distance that `percent` of the points are not above, mm, linear between two points.
    pub fn percentile_mm(&self, percent: f64) -> f64 {
        let Some(last) = self.sorted_mm.len().checked_sub(1) else { return 0.0 };
        let at = (percent / 100.0).clamp(0.0, 1.0) * last as f64;
        let (low, share) = (at as usize, at.fract());
        let [a, b] = [low, (low + 1).min(last)].map(|i| f64::from(self.sorted_mm[i]));
        a + (b - a) * share
    }

    /// Share of the points within a tolerance band, its limits included, 0 to 1.
    pub fn share_within(&self, low_mm: f64, high_mm: f64) -> f64 {
        let inside = self.up_to(high_mm, true).saturating_sub(self.up_to(low_mm, false));
        inside as f64 / self.sorted_mm.len().max(1) as f64
    }

    /// Counts into bins between two distances, the first below the second.
    pub fn histogram(&self, from_mm: f64, to_mm: f64, bins: usize) -> Histogram {
        let side = |k: usize| {
            let at = from_mm + (to_mm - from_mm) * (k as f64 / bins.max(1) as f64);
            if k < bins { self.up_to(at, false) } else { self.up_to(to_mm, true) }
        };
        let counts = (0..bins).map(|k| side(k + 1).saturating_sub(side(k))).collect();
        let (below, above) = (self.up_to(from_mm, false), self.count() - self.up_to(to_mm, true));
        Histogram { from_mm, to_mm, counts, below, above }
    }

    /// How many are below a distance, or equal to it too.
    fn up_to(&self, mm: f64, equal: bool) -> usize {
        self.sorted_mm.partition_point(|d| f64::from(*d) < mm || equal && f64::from(*d) == mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(signed_mm: &[f32]) -> DeviationStatistics {
        let footing = signed_mm.iter().map(|d| if d.is_nan() { Footing::NoModel } else { Footing::OnModel }).collect();
        let facet = vec![0; signed_mm.len()];
        DeviationStatistics::of(&Deviation { signed_mm: signed_mm.to_vec(), facet, footing })
    }

    #[test]
    fn figures_of_known_numbers() {
        let s = of(&[3.0, -1.0, f32::NAN, 0.0, 1.0, 2.0, -2.0, -3.0, 40.0]);
        assert_eq!((s.count(), s.no_model, s.far), (8, 1, 0));
        assert_eq!(s.extremes_mm(), (-3.0, 40.0));
        assert!((s.mean_mm - 5.0).abs() < 1e-12);
        assert!((s.rms_mm - (1628.0f64 / 8.0).sqrt()).abs() < 1e-12);
        assert!((s.percentile_mm(50.0) - 0.5).abs() < 1e-12);
        // Amounts off 0.5: 0.5 0.5 1.5 1.5 2.5 2.5 3.5 39.5.
        assert!((s.sigma_mm - 1.4826 * 2.5).abs() < 1e-9);
        assert!((s.share_within(-1.0, 2.0) - 0.5).abs() < 1e-12);
        let h = s.histogram(-2.0, 2.0, 4);
        assert_eq!((h.below, h.counts, h.above), (1, vec![1, 1, 1, 2], 2));
    }

    #[test]
    fn nothing_measured_says_nothing() {
        let s = of(&[]);
        assert_eq!((s.count(), s.percentile_mm(50.0), s.share_within(-1.0, 1.0)), (0, 0.0, 0.0));
        assert_eq!(s.histogram(0.0, 1.0, 2).counts, [0, 0]);
    }
}
