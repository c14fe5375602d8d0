//! A chain's points made ready for their curve: normals on the outward side, places carried along the surface as the curve
//! goes on it, and the sense of the way.

use super::band::{BandPoint, PlaneFrame};
use super::banded::Columns;
use super::chain::Chain;
use super::rules::OutwardSide;
use nalgebra::{Vector2, Vector3};

/// Normals are averaged over so many spacings of the way to both sides.
const AVERAGED: f64 = 1.5;

/// Points of one curve in order.
#[derive(Clone, Debug)]
pub(super) struct OrderedPoints {
    /// Way along the curve, mm, ascending from about 0.
    pub(super) ways_mm: Vec<f64>,
    /// Place in the plane, and outward normal in its frame.
    pub(super) values: Vec<Columns>,
    /// The length of a closed curve, mm.
    pub(super) round_mm: Option<f64>,
    /// Mean unit length, mm.
    pub(super) scale_mm: f64,
}

/// The points of a chain.
pub(super) fn ordered(band: &[BandPoint], chain: &Chain, side: &OutwardSide, frame: &PlaneFrame) -> OrderedPoints {
    let points: Vec<&BandPoint> = chain.points.iter().map(|p| &band[p.1 as usize]).collect();
    let mut ways_mm: Vec<f64> = chain.points.iter().map(|p| p.0).collect();
    let mut normals: Vec<Vector3<f64>> = points.iter().map(|p| p.normal).collect();
    if let OutwardSide::Towards(side) = side {
        turn_alike(&mut normals);
        let towards: f64 = normals.iter().map(|n| frame.direction(n).dot(side)).sum();
        if towards < 0.0 {
            normals.iter_mut().for_each(|n| *n = -*n);
        }
    }
    let scale_mm = points.iter().map(|p| p.scale_mm).sum::<f64>() / points.len().max(1) as f64;
    let smooth = averaged(&ways_mm, &normals, AVERAGED * scale_mm);
    let carried = |((p, n), s): ((&&BandPoint, &Vector3<f64>), &Vector3<f64>)| {
        let sign = if p.normal.dot(n) < 0.0 { -1.0 } else { 1.0 };
        let at = p.carried(&(p.normal + s * sign)).unwrap_or(p.at);
        Columns::new(at.x, at.y, n.x, n.y, n.z)
    };
    let mut values: Vec<Columns> = points.iter().zip(&normals).zip(&smooth).map(carried).collect();
    if runs_backward(&values) {
        let whole_mm = chain.round_mm.unwrap_or_else(|| ways_mm.last().copied().unwrap_or(0.0));
        values.reverse();
        ways_mm.reverse();
        ways_mm.iter_mut().for_each(|w| *w = whole_mm - *w);
    }
    OrderedPoints { ways_mm, values, round_mm: chain.round_mm, scale_mm }
}

/// Turns each normal to the side of the mean of those before it.
fn turn_alike(normals: &mut [Vector3<f64>]) {
    let mut before = normals.first().copied().unwrap_or_default();
    for n in normals {
        if n.dot(&before) < 0.0 {
            *n = -*n;
        }
        before = before * 0.8 + *n * 0.2;
    }
}

/// Mean unit normals over a stretch of the way to both sides of each point.
fn averaged(ways_mm: &[f64], normals: &[Vector3<f64>], reach_mm: f64) -> Vec<Vector3<f64>> {
    let (mut from, mut to, mut sum) = (0, 0, Vector3::zeros());
    let of = |(&way_mm, n): (&f64, &Vector3<f64>)| {
        while to < normals.len() && ways_mm[to] <= way_mm + reach_mm {
            sum += normals[to];
            to += 1;
        }
        while ways_mm[from] < way_mm - reach_mm {
            sum -= normals[from];
            from += 1;
        }
        sum.try_normalize(1e-9).unwrap_or(*n)
    };
    ways_mm.iter().zip(normals).map(of).collect()
}

/// Whether points go against (outward normal) × (plane's normal).
fn runs_backward(values: &[Columns]) -> bool {
    let way = |w: &[Columns]| {
        let step = Vector2::new(w[1][0] - w[0][0], w[1][1] - w[0][1]);
        step.x * w[0][3] - step.y * w[0][2]
    };
    values.windows(2).map(way).sum::<f64>() < 0.0
}
