//! The scales of a diagram: the stretch of time in sight, the height of the curves, and the samples that are drawn.

use crate::program::{Clearance, CurveSample};

/// If more samples than this are in sight, only the least and the greatest of each group are drawn.
const MOST_POINTS: usize = 1200;
/// The shortest stretch that can be looked at, s.
pub(super) const SHORTEST_S: f64 = 0.05;

/// Something with a time: curves run over it.
pub(super) trait Timed {
    /// Time in the program, s.
    fn time_s(&self) -> f64;
}

impl Timed for CurveSample {
    fn time_s(&self) -> f64 {
        self.time_s
    }
}

impl Timed for Clearance {
    fn time_s(&self) -> f64 {
        self.time_s
    }
}

/// What is in sight of a program.
#[derive(Clone, Copy)]
pub(super) struct InSight {
    /// The stretch that is shown, s.
    pub span_s: [f64; 2],
    /// Where the simulation is, s.
    pub now_s: f64,
    /// The length of the program, s.
    pub total_s: f64,
}

/// A stretch scaled about a time, within the program; `None` for all of it.
pub(super) fn zoomed([from, to]: [f64; 2], about_s: f64, factor: f64, total_s: f64) -> Option<[f64; 2]> {
    let length = ((to - from) * factor).max(SHORTEST_S);
    if length >= total_s {
        return None;
    }
    let share = ((about_s - from) / (to - from)).clamp(0.0, 1.0);
    let from = (about_s - share * length).clamp(0.0, total_s - length);
    Some([from, from + length])
}

/// The scale of a diagram: its curves with some room, at least so high.
pub(super) fn range(lines: &[Vec<[f64; 2]>], least: f64) -> [f64; 2] {
    let values = || lines.iter().flatten().map(|p| p[1]);
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    if low > high {
        return [0.0, least];
    }
    let room = (0.08 * (high - low)).max(0.5 * (least - (high - low))).max(0.04 * least);
    [low - room, high + room]
}

/// The samples in sight, one beyond each end; of many, what stands out.
pub(super) fn thinned<T: Timed>(samples: &[T], [from, to]: [f64; 2], value: &dyn Fn(&T) -> f64) -> Vec<[f64; 2]> {
    let first = samples.partition_point(|s| s.time_s() < from).saturating_sub(1);
    let end = (samples.partition_point(|s| s.time_s() <= to) + 1).min(samples.len());
    let seen = samples.get(first..end).unwrap_or_default();
    let point = |s: &T| [s.time_s(), value(s)];
    if seen.len() <= MOST_POINTS {
        return seen.iter().map(point).collect();
    }
    let group = seen.len().div_ceil(MOST_POINTS / 2);
    let mut out = Vec::with_capacity(MOST_POINTS + 2);
    for chunk in seen.chunks(group) {
        let points = || chunk.iter().map(point);
        let (low, high) =
            (points().min_by(|a, b| a[1].total_cmp(&b[1])), points().max_by(|a, b| a[1].total_cmp(&b[1])));
        let mut pair: Vec<[f64; 2]> = low.into_iter().chain(high).collect();
        pair.sort_by(|a, b| a[0].total_cmp(&b[0]));
        out.extend(pair);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(time_s: f64, singularity: f64) -> CurveSample {
        CurveSample {
            time_s,
            joints_deg: [0.0; 6],
            speeds_deg_s: [0.0; 6],
            limit_margin_deg: 0.0,
            singularity,
            rz_ry_rx_deg: [0.0; 3],
        }
    }

    #[test]
    fn a_peak_of_one_sample_survives_thinning() {
        let samples: Vec<CurveSample> =
            (0..50_000).map(|i| sample(f64::from(i) * 0.01, if i == 33_333 { 1.0 } else { 0.5 })).collect();
        let all = thinned(&samples, [0.0, 500.0], &|s| s.singularity);
        assert!(all.len() <= MOST_POINTS + 2 && all.contains(&[333.33, 1.0]), "{} points", all.len());
        assert!(all.windows(2).all(|w| w[0][0] <= w[1][0]), "in the order of time");
        let near = thinned(&samples, [1.0, 2.0], &|s| s.singularity);
        assert!(near.first().is_some_and(|p| p[0] < 1.0) && near.last().is_some_and(|p| p[0] > 2.0));
        assert!(near.len() <= 104, "only what is in sight: {}", near.len());
    }

    #[test]
    fn zooming_keeps_the_time_under_the_pointer_and_stays_within() {
        let [from, to] = zoomed([0.0, 100.0], 25.0, 0.5, 100.0).expect("a part of it");
        assert!((from - 12.5).abs() < 1e-9 && (to - 62.5).abs() < 1e-9);
        assert_eq!(zoomed([10.0, 60.0], 30.0, 4.0, 100.0), None, "all of it");
        let [from, to] = zoomed([90.0, 100.0], 99.0, 1e-9, 100.0).expect("the shortest");
        assert!((to - from - SHORTEST_S).abs() < 1e-9 && to <= 100.0 && from >= 0.0);
    }
}
