//! Points of a band in order, and where a chain of them is cut: at gaps, since nothing is bridged where nothing was
//! scanned.

use super::band::BandPoint;

/// Gap in spacings that ends a curve. Points at random, three a spacing, leave one as wide once in three million.
pub(super) const GAP: f64 = 5.0;
/// Fewest points of a curve, and its least length in spacings: stray points make none.
const FEWEST: usize = 8;
const SHORTEST: f64 = 3.0;

/// Points in order.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Way along the chain, mm, ascending, and which point of the band.
    pub(super) points: Vec<(f64, u32)>,
    /// The length of a closed chain, mm; `None` of an open one. Ways are below it.
    pub(super) round_mm: Option<f64>,
}

/// By their way, then by number.
pub(super) fn sorted(mut points: Vec<(f64, u32)>) -> Vec<(f64, u32)> {
    points.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    points
}

impl Chain {
    /// Its pieces between gaps, without those that are too short to be a curve.
    pub(super) fn cut_at_gaps(mut self, band: &[BandPoint]) -> Vec<Chain> {
        let count = self.points.len();
        if count < FEWEST {
            return Vec::new();
        }
        let scale = |k: usize| band[self.points[k % count].1 as usize].scale_mm;
        let is_gap = |k: usize| {
            let round_mm = self.round_mm.filter(|_| k + 1 == count).unwrap_or(0.0);
            let way_mm = self.points[(k + 1) % count].0 + round_mm - self.points[k].0;
            way_mm > 0.5 * GAP * (scale(k) + scale(k + 1))
        };
        let pairs = if self.round_mm.is_some() { count } else { count - 1 };
        let gaps: Vec<usize> = (0..pairs).filter(|&k| is_gap(k)).map(|k| k + 1).collect();
        if let Some((round_mm, &first)) = self.round_mm.zip(gaps.first()) {
            // Open, and begun behind the first gap.
            let first = first % count;
            self.points.iter_mut().take(first).for_each(|p| p.0 += round_mm);
            self.points.rotate_left(first);
            let gaps: Vec<usize> = gaps[1..].iter().map(|g| g - first).collect();
            return pieces(self.points, &gaps, band);
        }
        if self.round_mm.is_some() { vec![self] } else { pieces(self.points, &gaps, band) }
    }
}

fn pieces(points: Vec<(f64, u32)>, gaps: &[usize], band: &[BandPoint]) -> Vec<Chain> {
    let ends = gaps.iter().copied().chain([points.len()]);
    let starts = std::iter::once(0).chain(gaps.iter().copied());
    let is_long =
        |p: &[(f64, u32)]| p.len() >= FEWEST && p[p.len() - 1].0 - p[0].0 >= SHORTEST * band[p[0].1 as usize].scale_mm;
    let of = |(from, to): (usize, usize)| &points[from..to];
    let long = starts.zip(ends).map(of).filter(|p| is_long(p));
    long.map(|p| Chain { points: p.to_vec(), round_mm: None }).collect()
}
