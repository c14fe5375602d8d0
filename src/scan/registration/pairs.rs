//! A start from pairs of places, picked on scan and model.

use super::RegistrationError;
use crate::fit::{PlacedPair, rigid};
use nalgebra::{Isometry3, Matrix3, Point3, SymmetricEigen, Vector3};

/// Fewest pairs.
const FEWEST: usize = 3;
/// Pairs spread across their line by less than this share of their spread along it leave the turn about it open: on a
/// shaft of 150 mm places a millimetre off a line.
const LEAST_SPREAD: f64 = 0.01;

/// `model_from_scan` by pairs.
///
/// # Errors
/// [`RegistrationError::PairsTellNoMotion`].
pub(super) fn start_of(pairs: &[PlacedPair]) -> Result<Isometry3<f64>, RegistrationError> {
    let none = || RegistrationError::PairsTellNoMotion { pairs: pairs.len() };
    let tells = |of: fn(&PlacedPair) -> Point3<f64>| spread_across(&pairs.iter().map(of).collect::<Vec<_>>());
    let is_enough = pairs.len() >= FEWEST && tells(|p| p.from) > LEAST_SPREAD && tells(|p| p.onto) > LEAST_SPREAD;
    if is_enough { rigid(pairs).ok_or_else(none) } else { Err(none()) }
}

/// Spread of points across the line that they lie along most, as a share of that along it; 0 for what is no number.
fn spread_across(points: &[Point3<f64>]) -> f64 {
    let middle = points.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + p.coords) / points.len().max(1) as f64;
    let spread = points.iter().fold(Matrix3::zeros(), |s: Matrix3<f64>, p| {
        let d = p.coords - middle;
        s + d * d.transpose()
    });
    if !spread.iter().all(|x| x.is_finite()) {
        return 0.0;
    }
    let mut values: [f64; 3] = SymmetricEigen::new(spread).eigenvalues.into();
    values.sort_by(f64::total_cmp);
    if values[2] > 0.0 { (values[1].max(0.0) / values[2]).sqrt() } else { 0.0 }
}
