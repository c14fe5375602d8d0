//! The spline through a curve's points: as few knots as keep it within the tolerance of their middle, or as the noise
//! lets be told.
//!
//! Each span is looked at in parts: the median distance of a part's points from the curve is what the spline misses
//! there. A single point's distance is noise, so it adds no knot, and beyond Tukey's width it counts for nothing.

use super::banded::Columns;
use super::oriented::OrderedPoints;
use super::scale::median;
use super::spline::{FEWEST_ROUND, Knots, Spline};
use crate::scan::SIGMA_OF_MEDIAN;
use crate::scan::TUKEY;

/// Points of a span to begin with: 20 spacings long.
const FIRST_POINTS: usize = 64;
/// Fewest points of a span: with fewer it follows the noise.
const FEWEST_POINTS: usize = 6;
/// Parts of a span that are looked at, and fewest points of one.
const PARTS: usize = 4;
const FEWEST_OF_PART: usize = 4;
/// A median further off than so many of its standard errors is none of the noise.
const STANDARD_ERRORS: f64 = 3.0;
/// Standard error of a median, in standard deviations over the root of the count.
const ERROR_OF_MEDIAN: f64 = 1.2533;
const LEAST_WIDTH_MM: f64 = 1e-3;
/// Greatest mean cosine between curve and normals: of normals that point anywhere it is 2/π = 0.64, on a smooth surface as
/// good as nought.
const MOST_COSINE: f64 = 0.4;
/// Rounds of fitting and halving: 64 points a span are halved to six in four.
const ROUNDS: usize = 8;

/// A fitted curve.
#[derive(Clone, Debug)]
pub(super) struct CurveFit {
    pub(super) spline: Spline,
    /// Way and distance in the plane of the points that count, in order, mm.
    pub(super) residuals: Vec<(f64, f64)>,
}

/// Fits a spline to ordered points; `None` where their normals do not stand square to it: stray points make no surface.
pub(super) fn fitted(points: &OrderedPoints, tolerance_mm: f64) -> Option<CurveFit> {
    let mut knots = first_knots(points);
    let mut weights = vec![1.0; points.ways_mm.len()];
    let mut round = 0;
    loop {
        let spline = Spline::fitted(&knots, &points.ways_mm, &points.values, &weights);
        let offs: Vec<f64> = points.ways_mm.iter().zip(&points.values).map(|(w, v)| off_mm(&spline, *w, v)).collect();
        let noise_mm = noise_mm(&offs);
        let scatter_mm = SIGMA_OF_MEDIAN * median(offs.iter().map(|r| r.abs()));
        let width_mm = (TUKEY * scatter_mm.max(noise_mm)).max(LEAST_WIDTH_MM);
        let halved = halved(&knots, points, &offs, [tolerance_mm, noise_mm]);
        if round > 0 && halved == knots || round == ROUNDS {
            let all = points.ways_mm.iter().zip(&offs).zip(&weights);
            let residuals = all.filter(|(_, w)| **w > 0.0).map(|((way, off), _)| (*way, *off)).collect();
            return (mean_cosine(&spline, points) <= MOST_COSINE).then_some(CurveFit { spline, residuals });
        }
        knots = halved;
        weights = offs.iter().map(|off| tukey(off / width_mm)).collect();
        round += 1;
    }
}

/// Mean of the cosines, without their signs, between the curve and the points' normals in the plane.
fn mean_cosine(spline: &Spline, points: &OrderedPoints) -> f64 {
    let of = |(way_mm, value): (&f64, &Columns)| {
        let [_, slope, _] = spline.at(*way_mm);
        let length = libm::hypot(slope[0], slope[1]) * libm::hypot(value[2], value[3]);
        if length > 0.0 { (slope[0] * value[2] + slope[1] * value[3]).abs() / length } else { 0.0 }
    };
    points.ways_mm.iter().zip(&points.values).map(of).sum::<f64>() / points.values.len().max(1) as f64
}

fn tukey(share: f64) -> f64 {
    let rest = (1.0 - share * share).max(0.0);
    rest * rest
}

fn first_knots(points: &OrderedPoints) -> Knots {
    let is_round = points.round_mm.is_some();
    let spans = (points.ways_mm.len() / FIRST_POINTS).max(if is_round { FEWEST_ROUND } else { 1 });
    let first = if is_round { 0.0 } else { points.ways_mm.first().copied().unwrap_or(0.0) };
    let last = points.round_mm.or(points.ways_mm.last().copied()).unwrap_or(0.0);
    Knots { breaks: (0..=spans).map(|k| first + (last - first) * k as f64 / spans as f64).collect(), is_round }
}

/// How far a point is from the spline, to the left of its way.
fn off_mm(spline: &Spline, way_mm: f64, value: &Columns) -> f64 {
    let [at, slope, _] = spline.at(way_mm);
    let speed = libm::hypot(slope[0], slope[1]);
    let cross = slope[0] * (value[1] - at[1]) - slope[1] * (value[0] - at[0]);
    if speed > 0.0 { cross / speed } else { 0.0 }
}

/// Standard deviation of noise by the differences of neighbours: what the spline misses is the same for both.
fn noise_mm(offs: &[f64]) -> f64 {
    SIGMA_OF_MEDIAN / std::f64::consts::SQRT_2 * median(offs.windows(2).map(|w| (w[1] - w[0]).abs()))
}

/// The knots with one more in the middle of each span that misses its points by more than the tolerance and the noise.
fn halved(knots: &Knots, points: &OrderedPoints, offs: &[f64], [tolerance_mm, noise_mm]: [f64; 2]) -> Knots {
    let mut breaks = vec![knots.breaks[0]];
    let mut from = 0;
    for span in 0..knots.spans() {
        let (start, end) = (knots.breaks[span], knots.breaks[span + 1]);
        let to = if span + 1 == knots.spans() { offs.len() } else { points.ways_mm.partition_point(|w| *w < end) };
        let middle = 0.5 * (start + end);
        let first_half = points.ways_mm.partition_point(|w| *w < middle);
        let is_enough = first_half >= from + FEWEST_POINTS && to >= first_half + FEWEST_POINTS;
        if is_enough && end - start >= 2.0 * points.scale_mm && is_missed(&offs[from..to], tolerance_mm, noise_mm) {
            breaks.push(middle);
        }
        breaks.push(end);
        from = to;
    }
    Knots { breaks, is_round: knots.is_round }
}

fn is_missed(offs: &[f64], tolerance_mm: f64, noise_mm: f64) -> bool {
    let parts = (offs.len() / FEWEST_OF_PART).clamp(1, PARTS);
    (0..parts).any(|k| {
        let part = &offs[k * offs.len() / parts..(k + 1) * offs.len() / parts];
        let error_mm = ERROR_OF_MEDIAN * noise_mm / (part.len().max(1) as f64).sqrt();
        median(part.iter().copied()).abs() > tolerance_mm.max(STANDARD_ERRORS * error_mm)
    })
}
