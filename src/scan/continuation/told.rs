//! Whether the sound points tell the surface at all, and how surely.

use super::ContinuationError;
use super::robust::Fit;
use super::surface::Form;
use nalgebra::Point3;
use std::f64::consts::TAU;

/// Distances in standard deviations of the noise beyond which a surface is none of the kind. The right one has 1; a
/// wrong one that has 3 is seen with the eye.
const OFF: f64 = 3.0;
/// Least share of the sound points that lie on the surface: with half of them a wedge would be a plane.
const ON: f64 = 2.0 / 3.0;
/// Least rise of an arc over its chord, in standard deviations of the noise. More points do not help here: what a
/// scanner bends by itself is of the size of its noise. At 0.03 mm and a radius of 20 mm: 15°.
const RISE: f64 = 6.0;
/// How well an axis has to be told, degrees.
const AXIS_DEG: f64 = 0.5;
/// How well the surface has to be told across the damage, in standard deviations of the noise.
const SPREAD: f64 = 1.0;

/// Standard deviation of the surface at the worst of the damaged points, mm.
///
/// # Errors
/// The points do not tell the surface.
pub(super) fn told(
    fit: &Fit,
    points: &[Point3<f64>],
    damaged: &[Point3<f64>],
    noise_mm: f64,
) -> Result<f64, ContinuationError> {
    if fit.rms_mm > OFF * noise_mm || fit.share < ON {
        return Err(ContinuationError::OtherKind { rms_mm: Some(fit.rms_mm) });
    }
    if let Form::Revolved(_) = fit.surface.form {
        let rise_mm = rise_mm(fit, points);
        if rise_mm < RISE * noise_mm {
            return Err(ContinuationError::ArcTooShort { rise_mm });
        }
    }
    let noise_mm = noise_mm.max(fit.rms_mm);
    let spread_deg = (fit.turn_spread() * noise_mm).to_degrees();
    if spread_deg.is_nan() || spread_deg > AXIS_DEG {
        return Err(ContinuationError::AxisOpen { spread_deg });
    }
    let foot = |p: &Point3<f64>| fit.surface.closest(p).map(|found| found.0);
    let spreads = damaged.iter().map(|p| foot(p).map_or(f64::INFINITY, |foot| fit.spread_at(&foot)));
    let spread_mm = spreads.fold(0.0, f64::max) * noise_mm;
    if spread_mm > SPREAD * noise_mm { Err(ContinuationError::GapTooWide { spread_mm }) } else { Ok(spread_mm) }
}

/// How far the arc of the points about the axis rises over its chord, mm; twice the radius of a whole circle.
fn rise_mm(fit: &Fit, points: &[Point3<f64>]) -> f64 {
    let say = points.iter().zip(&fit.has_say).filter(|(_, has_say)| **has_say);
    let seen = say.map(|(p, _)| fit.surface.frame.inverse_transform_point(p));
    let (mut turns, mut widest) = (Vec::new(), 0.0f64);
    for q in seen {
        turns.push(libm::atan2(q.y, q.x));
        widest = widest.max((q.x * q.x + q.y * q.y).sqrt());
    }
    turns.sort_unstable_by(f64::total_cmp);
    let Some((first, last)) = turns.first().zip(turns.last()) else { return 0.0 };
    let gaps = turns.windows(2).map(|w| w[1] - w[0]);
    let gap = gaps.fold(first + TAU - last, f64::max);
    widest * (1.0 - libm::cos(0.5 * (TAU - gap)))
}
