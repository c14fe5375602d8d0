//! Points of a fitted curve: no two further apart than the step, and closer where it bends, so that no chord is further off
//! than allowed.

use super::band::PlaneFrame;
use super::banded::Columns;
use super::curve_fit::CurveFit;
use super::oriented::OrderedPoints;
use super::rules::SliceRules;
use super::slice::SlicePoint;
use nalgebra::{Vector2, Vector3};

/// Looks at the curve between two spacings of its points.
const LOOKS: f64 = 4.0;
/// Most points of a curve; beyond it all steps become longer.
const MOST_POINTS: f64 = 1e5;
/// Nearest points of the scan that tell the noise at a place.
const NOISE_POINTS: usize = 24;

/// Points along a curve; two at the least, three of a closed one.
pub(super) fn sampled(
    fit: &CurveFit,
    points: &OrderedPoints,
    rules: &SliceRules,
    frame: &PlaneFrame,
) -> Vec<SlicePoint> {
    let noise = Noise::of(fit);
    let ways = ways_mm(fit, points, rules);
    ways.into_iter().filter_map(|way_mm| sample(&fit.spline.at(way_mm), noise.at(way_mm), frame)).collect()
}

fn sample([at, slope, _]: &[Columns; 3], noise_mm: f64, frame: &PlaneFrame) -> Option<SlicePoint> {
    let tangent = frame.direction(&Vector3::new(slope[0], slope[1], 0.0)).try_normalize(0.0)?;
    let normal = frame.direction(&Vector3::new(at[2], at[3], at[4]));
    let outward = (normal - tangent * normal.dot(&tangent)).try_normalize(0.0)?;
    Some(SlicePoint { place: frame.place(&Vector2::new(at[0], at[1])), tangent, outward, noise_mm })
}

/// Where points stand: the count to each place is summed up, and whole counts are looked for in it.
fn ways_mm(fit: &CurveFit, points: &OrderedPoints, rules: &SliceRules) -> Vec<f64> {
    let breaks = &fit.spline.knots.breaks;
    let mut looks = vec![(breaks[0], 0.0)];
    let mut before: Option<f64> = None;
    for pair in breaks.windows(2) {
        let count = (LOOKS * (pair[1] - pair[0]) / points.scale_mm).clamp(LOOKS, MOST_POINTS).ceil();
        let step = (pair[1] - pair[0]) / count;
        for k in 1..=count as usize {
            let way_mm = pair[0] + step * k as f64;
            let begin = before.unwrap_or_else(|| per_mm(fit, points, rules, breaks[0]));
            let end = per_mm(fit, points, rules, way_mm);
            // The denser of both ends: between them it may be as dense.
            let sum = looks.last().map_or(0.0, |l| l.1) + step * begin.max(end);
            looks.push((way_mm, sum));
            before = Some(end);
        }
    }
    let whole = looks.last().map_or(0.0, |l| l.1);
    let is_round = fit.spline.knots.is_round;
    let steps = whole.clamp(if is_round { 3.0 } else { 1.0 }, MOST_POINTS).ceil();
    let count = if is_round { steps as usize } else { steps as usize + 1 };
    let mut look = 0;
    (0..count)
        .map(|k| {
            let due = whole * k as f64 / steps;
            while look + 2 < looks.len() && looks[look + 1].1 < due {
                look += 1;
            }
            let (a, b) = (looks[look], looks[look + 1]);
            let share = if b.1 > a.1 { ((due - a.1) / (b.1 - a.1)).clamp(0.0, 1.0) } else { 0.0 };
            a.0 + (b.0 - a.0) * share
        })
        .collect()
}

/// Points wanted a millimetre of the way. What bends more sharply than a circle of the points' spacing is a corner as
/// the scan saw it, and counts as that circle.
fn per_mm(fit: &CurveFit, points: &OrderedPoints, rules: &SliceRules, way_mm: f64) -> f64 {
    let [_, slope, bend] = fit.spline.at(way_mm);
    let speed = libm::hypot(slope[0], slope[1]);
    let turned = (slope[0] * bend[1] - slope[1] * bend[0]).abs() / (speed * speed * speed);
    let curvature = turned.min(1.0 / points.scale_mm);
    // A chord of length s is s²/8 times the curvature off.
    let wanted = (1.0 / rules.step_mm).max((curvature / (8.0 * rules.chord_mm)).sqrt());
    if wanted.is_finite() { speed * wanted.max(0.0) } else { speed / points.scale_mm }
}

/// What points scatter by along a curve.
struct Noise {
    ways_mm: Vec<f64>,
    /// Sums of the squares of the points before each.
    sums: Vec<f64>,
}

impl Noise {
    fn of(fit: &CurveFit) -> Noise {
        let mut sums = vec![0.0];
        for (_, off) in &fit.residuals {
            sums.push(sums[sums.len() - 1] + off * off);
        }
        Noise { ways_mm: fit.residuals.iter().map(|r| r.0).collect(), sums }
    }

    fn at(&self, way_mm: f64) -> f64 {
        let count = self.ways_mm.len();
        let middle = self.ways_mm.partition_point(|w| *w < way_mm);
        let from = middle.saturating_sub(NOISE_POINTS / 2).min(count.saturating_sub(NOISE_POINTS));
        let to = (from + NOISE_POINTS).min(count);
        ((self.sums[to] - self.sums[from]).max(0.0) / (to - from).max(1) as f64).sqrt()
    }
}
