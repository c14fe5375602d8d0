//! A scan brought into the common frame by markers that are seen in both: the rigid motion of least squares over them.

use crate::fit::{PlacedPair, rigid};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};
use std::cmp::Ordering;

/// Markers are on a line where their spread across it is a smaller share of that along it. At 0.05 a row of markers
/// 300 mm long is about 15 mm wide, and an error of 0.05 mm turns the scan about the row by 0.2°, which is 0.3 mm at
/// 100 mm from it: more than is looked for.
const LEAST_WIDTH: f64 = 0.05;

/// A marker in two scans, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Where it is in the scan that is moved.
    pub in_scan: Point3<f64>,
    /// Where it is in the frame that scans are brought into.
    pub in_common: Point3<f64>,
}

/// How a scan is brought into the common frame.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkerFit {
    /// The motion.
    pub common_from_scan: Isometry3<f64>,
    /// How far each marker is from where it ought to be, mm. Three markers fit better than they are: only what is
    /// wrong in the lengths between them shows.
    pub residuals_mm: Vec<f64>,
    /// Root of their mean square, mm.
    pub rms_mm: f64,
}

/// Why markers tell no motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MarkerError {
    /// Fewer than three.
    #[error("{count} markers, 3 are needed")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// They are on a line, or in one place: the turn about it is open.
    #[error("the markers are on a line")]
    OnALine,
    /// A place is no number.
    #[error("marker {marker} has a place that is no number")]
    NoNumber {
        /// Which one, from 0.
        marker: usize,
    },
}

/// The motion that brings a scan's markers nearest to where they are in the common frame.
///
/// # Errors
/// [`MarkerError`] where the markers tell no motion.
pub fn by_markers(markers: &[Marker]) -> Result<MarkerFit, MarkerError> {
    if markers.len() < 3 {
        return Err(MarkerError::TooFew { count: markers.len() });
    }
    let is_number = |p: &Point3<f64>| p.coords.norm_squared().is_finite();
    if let Some(marker) = markers.iter().position(|m| !(is_number(&m.in_scan) && is_number(&m.in_common))) {
        return Err(MarkerError::NoNumber { marker });
    }
    if is_line(markers, |m| m.in_scan) || is_line(markers, |m| m.in_common) {
        return Err(MarkerError::OnALine);
    }
    let pair = |m: &Marker| PlacedPair { from: m.in_scan, onto: m.in_common, weight: 1.0 };
    let pairs: Vec<PlacedPair> = markers.iter().map(pair).collect();
    let common_from_scan = rigid(&pairs).ok_or(MarkerError::OnALine)?;
    let residuals_mm: Vec<f64> = pairs.iter().map(|p| (common_from_scan * p.from - p.onto).norm()).collect();
    let squares: f64 = residuals_mm.iter().map(|r| r * r).sum();
    let rms_mm = (squares / markers.len() as f64).sqrt();
    Ok(MarkerFit { common_from_scan, residuals_mm, rms_mm })
}

fn is_line(markers: &[Marker], of: impl Fn(&Marker) -> Point3<f64>) -> bool {
    let share = 1.0 / markers.len() as f64;
    let middle = markers.iter().fold(Vector3::zeros(), |s, m| s + of(m).coords * share);
    let scatter = markers.iter().fold(Matrix3::zeros(), |s, m| {
        let d = of(m).coords - middle;
        s + d * d.transpose()
    });
    let mut spread: [f64; 3] = scatter.symmetric_eigenvalues().into();
    spread.sort_by(f64::total_cmp);
    // Also where all are in one place, and both are nought.
    spread[1].partial_cmp(&(LEAST_WIDTH * LEAST_WIDTH * spread[2])) != Some(Ordering::Greater)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn markers(places: &[[f64; 3]], motion: &Isometry3<f64>) -> Vec<Marker> {
        let marker = |p: &[f64; 3]| Marker { in_scan: Point3::from(*p), in_common: motion * Point3::from(*p) };
        places.iter().map(marker).collect()
    }

    const PLACES: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 80.0, 0.0], [40.0, 30.0, 60.0]];

    proptest! {
        #[test]
        fn scans_of_one_part_come_together(turn in prop::array::uniform3(-3.0..3.0f64),
                                           shift in prop::array::uniform3(-500.0..500.0f64), count in 3..=4usize) {
            let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
            let fit = by_markers(&markers(&PLACES[..count], &motion)).expect("they tell a motion");
            prop_assert!(fit.rms_mm < 1e-9);
            for p in PLACES.map(Point3::from) {
                prop_assert!((fit.common_from_scan * p - motion * p).norm() < 1e-6);
            }
        }
    }

    /// Corners of a square of side 2a, one pair of opposite ones too far out by e each: the fit cannot help it. The
    /// turn and the shift stay nought by symmetry, and the residuals are e there and nought at the others.
    #[test]
    fn residuals_tell_which_markers_do_not_fit() {
        let square = [[10.0, 10.0, 0.0], [-10.0, 10.0, 0.0], [-10.0, -10.0, 0.0], [10.0, -10.0, 0.0]];
        let mut pairs = markers(&square, &Isometry3::identity());
        for i in [0, 2] {
            let out = pairs[i].in_scan.coords.normalize();
            pairs[i].in_common += out * 0.3;
        }
        let fit = by_markers(&pairs).expect("they tell a motion");
        for (found, expected) in fit.residuals_mm.iter().zip([0.3, 0.0, 0.3, 0.0]) {
            assert!((found - expected).abs() < 1e-9, "{fit:?}");
        }
        assert!((fit.rms_mm - 0.3 * 0.5f64.sqrt()).abs() < 1e-9);
    }

    #[test]
    fn markers_that_tell_no_motion_are_refused() {
        let still = Isometry3::identity();
        assert_eq!(by_markers(&markers(&PLACES[..2], &still)), Err(MarkerError::TooFew { count: 2 }));
        let line = |off: f64| markers(&[[0.0; 3], [100.0, 100.0, 0.0], [200.0, 200.0, off]], &still);
        assert_eq!(by_markers(&line(0.0)), Err(MarkerError::OnALine));
        assert_eq!(by_markers(&line(5.0)), Err(MarkerError::OnALine));
        assert!(by_markers(&line(40.0)).is_ok());
        assert_eq!(by_markers(&markers(&[[1.0; 3]; 3], &still)), Err(MarkerError::OnALine));
        let mut nan = markers(&PLACES, &still);
        nan[2].in_common.y = f64::NAN;
        assert_eq!(by_markers(&nan), Err(MarkerError::NoNumber { marker: 2 }));
    }
}
