//! What was measured of an area at places on the part: heights above the skin, or how far within the outline. Between the
//! samples a quadric tells the value, fitted around the place to those that agree with each other.

use crate::part::angle;
use crate::progress::{Cancelled, Progress};
use crate::scan::neighbours::{Neighbour, Neighbours};
use crate::scan::{Cloud, SIGMA_OF_MEDIAN, TUKEY, upper_median};
use nalgebra::{Matrix6, Point3, Vector3, Vector6};

/// Samples so far around a place count, mm: a bead of 12 mm width and 15 mm height bends by 0.1 mm in the third order over
/// it, and at 0.8 mm between pixels it holds 28 of them.
const RADIUS_MM: f64 = 2.5;
/// Fewer tell no quadric that noise does not bend.
const LEAST: usize = 12;
const ROUNDS: usize = 3;

/// Values at places in the part frame, mm.
#[derive(Clone, Debug, Default)]
pub struct AreaSamples {
    tree: Neighbours,
    places: Vec<Point3<f64>>,
    values_mm: Vec<f64>,
}

impl AreaSamples {
    /// Keeps samples: places in the part frame and their values.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(samples: &[(Point3<f64>, f64)], progress: &Progress) -> Result<AreaSamples, Cancelled> {
        let places: Vec<Point3<f64>> = samples.iter().map(|s| s.0).collect();
        let tree = Neighbours::new(&Cloud::of_points(&places), progress)?;
        Ok(AreaSamples { tree, places, values_mm: samples.iter().map(|s| s.1).collect() })
    }

    /// The places.
    pub fn places(&self) -> &[Point3<f64>] {
        &self.places
    }

    /// Whether anything was measured so near a place, mm.
    pub fn is_near(&self, place: &Point3<f64>, within_mm: f64) -> bool {
        self.tree.nearest_one(place, within_mm).is_some()
    }

    /// The value at a place of the part with this normal, mm; `None`: too little was measured there.
    pub fn value_mm(&self, place: &Point3<f64>, normal: &Vector3<f64>, room: &mut Vec<Neighbour>) -> Option<f64> {
        room.clear();
        self.tree.within(place, RADIUS_MM, room);
        if room.len() < LEAST {
            return None;
        }
        let x = angle::any_square_to(normal);
        let y = normal.cross(&x);
        let rows: Vec<(Vector6<f64>, f64)> = room
            .iter()
            .map(|n| {
                let off = (self.places[n.index as usize] - place) / RADIUS_MM;
                let (u, v) = (off.dot(&x), off.dot(&y));
                (Vector6::new(1.0, u, v, u * u, u * v, v * v), self.values_mm[n.index as usize])
            })
            .collect();
        let mut weights: Vec<f64> = vec![1.0; rows.len()];
        let mut level = None;
        for _ in 0..ROUNDS {
            let (mut normal_matrix, mut right) = (Matrix6::from_diagonal_element(RIDGE), Vector6::zeros());
            for ((row, value), weight) in rows.iter().zip(&weights) {
                normal_matrix += row * row.transpose() * *weight;
                right += row * (*value * weight);
            }
            let quadric = normal_matrix.cholesky()?.solve(&right);
            level = Some(quadric[0]);
            let off: Vec<f64> = rows.iter().map(|(row, value)| (value - quadric.dot(row)).abs()).collect();
            let width = TUKEY * SIGMA_OF_MEDIAN * upper_median(&mut off.clone())?;
            if width <= 0.0 {
                break;
            }
            for (weight, off) in weights.iter_mut().zip(off) {
                let share = (off / width).min(1.0);
                *weight = (1.0 - share * share) * (1.0 - share * share);
            }
        }
        level
    }
}

/// Keeps places on one line from having no quadric; a ten-thousandth of one sample.
const RIDGE: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cap_is_told_between_its_samples_and_a_stray_one_is_not() {
        let cap = |p: &Point3<f64>| 15.0 * (1.0 - (p.y / 6.0) * (p.y / 6.0));
        let mut samples: Vec<(Point3<f64>, f64)> = Vec::new();
        for i in -20..=20 {
            for k in -7..=7 {
                let p = Point3::new(f64::from(i) * 0.8, f64::from(k) * 0.8, 300.0);
                samples.push((p, cap(&p)));
            }
        }
        let hole = samples.iter().position(|s| (s.0 - Point3::new(0.8, 0.8, 300.0)).norm() < 1e-9).expect("a sample");
        samples[hole].1 = 40.0;
        let of = AreaSamples::new(&samples, &Progress::default()).expect("samples");
        let mut room = Vec::new();
        for at in [[0.1, 0.3], [3.7, -2.2], [-8.0, 2.9]] {
            let p = Point3::new(at[0], at[1], 300.0);
            let found = of.value_mm(&p, &-Vector3::z(), &mut room).expect("samples around");
            assert!((found - cap(&p)).abs() < 0.01, "{found} for {}", cap(&p));
        }
        assert_eq!(of.value_mm(&Point3::new(0.0, 30.0, 300.0), &Vector3::z(), &mut room), None);
        assert!(of.is_near(&Point3::new(0.0, 6.0, 300.0), 1.0) && !of.is_near(&Point3::new(0.0, 9.0, 300.0), 1.0));
    }
}
