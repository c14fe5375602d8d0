//! The first steps from a turn: point to point in the field of nearest points (Besl and McKay 1992; weights of Geman and
//! McClure, whose width shrinks).

use super::field::Field;
use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};

/// Width of the weights at the first step, as a share of the model's diagonal, and by what it shrinks a step: after 20
/// steps it is D/200, less than a cell.
const FIRST_WIDTH: f64 = 1.0 / 8.0;
const SHRINK: f64 = 0.85;
/// Beyond this share of the diagonal a point's distance counts no more in the score.
const SCORE_CAP: f64 = 1.0 / 30.0;

/// A pose on its way: places of the scan from its middle, places of the model from the field's corner.
#[derive(Clone, Copy, Debug)]
pub(in crate::scan) struct Walk {
    pub(in crate::scan) turn: Matrix3<f64>,
    pub(in crate::scan) shift: Vector3<f64>,
    /// Mean of min(d, cap)², mm².
    pub(in crate::scan) score: f64,
}

impl Walk {
    /// Takes steps `from` to `to` with these points.
    pub(in crate::scan) fn walked(
        mut self,
        field: &Field,
        points: &[Vector3<f64>],
        steps: std::ops::Range<i32>,
        d: f64,
    ) -> Walk {
        let mut width = d * FIRST_WIDTH * (0..steps.start).fold(1.0, |w, _| w * SHRINK);
        for _ in steps {
            let per_width = 1.0 / (width * width);
            let (mut whole, mut from, mut onto, mut both) = (0.0, Vector3::zeros(), Vector3::zeros(), Matrix3::zeros());
            for x in points {
                let y = self.turn * x + self.shift;
                let foot = field.foot(&y);
                let share = 1.0 / (1.0 + (foot - y).norm_squared() * per_width);
                let weight = share * share;
                whole += weight;
                from += x * weight;
                onto += foot * weight;
                both += x * (foot * weight).transpose();
            }
            let (from, onto) = (from / whole, onto / whole);
            self.turn = nearest_turn(&(both / whole - from * onto.transpose()));
            self.shift = onto - self.turn * from;
            width *= SHRINK;
        }
        let cap = (d * SCORE_CAP) * (d * SCORE_CAP);
        let off = |x: &Vector3<f64>| {
            let y = self.turn * x + self.shift;
            (field.foot(&y) - y).norm_squared().min(cap)
        };
        self.score = points.iter().map(off).sum::<f64>() / points.len().max(1) as f64;
        self
    }

    /// The pose in the frames of part and scan.
    pub(in crate::scan) fn model_from_scan(&self, field: &Field, scan_middle: &Vector3<f64>) -> Isometry3<f64> {
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(self.turn));
        Isometry3::from_parts(Translation3::from(field.lo.coords + self.shift - turn * scan_middle), turn)
    }
}

/// The turn that brings points nearest to others whose products `from · ontoᵀ` are summed (Kabsch). Without weights in
/// three directions the rest is some turn.
fn nearest_turn(both: &Matrix3<f64>) -> Matrix3<f64> {
    let svd = both.svd(true, true);
    let (Some(u), Some(v_t)) = (svd.u, svd.v_t) else { return Matrix3::identity() };
    let mut v = v_t.transpose();
    if (v * u.transpose()).determinant() < 0.0 {
        // Singular values are sorted: the least turns, so that it is no mirror.
        v.column_mut(2).neg_mut();
    }
    v * u.transpose()
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::{field_of, off_mm, part_of, scan};
    use super::*;
    use crate::sample::scan_maker::ScanRecipe;
    use crate::sample::solids;
    use nalgebra::Point3;

    #[test]
    fn a_turn_is_found_again_and_never_a_mirror() {
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -1.2, 0.9)).to_rotation_matrix();
        let points = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.5], [-1.0, -1.0, 3.0], [0.2, 0.1, -1.0]].map(Vector3::from);
        let sum = |m: &Matrix3<f64>| points.iter().fold(Matrix3::zeros(), |s, p| s + p * (m * p).transpose());
        assert!((nearest_turn(&sum(turn.matrix())) - turn.matrix()).norm() < 1e-9);
        let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, -1.0));
        assert!((nearest_turn(&sum(&mirror)).determinant() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn from_a_few_degrees_off_it_walks_to_within_a_cell() {
        let part = part_of(&solids::plate(
            [60.0, 40.0, 8.0],
            &[solids::PlateFeature { centre: [15.0, 12.0], diameter: 16.0, sides: 48, height: 20.0 }],
        ));
        let recipe = ScanRecipe { missing_share: 0.0, outlier_share: 0.0, ..ScanRecipe::of(500, 3) };
        let (cloud, truth) = scan(&part, &recipe);
        let field = field_of(&part);
        let middle = cloud.points().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + p.coords) / 500.0;
        let points: Vec<Vector3<f64>> = cloud.points().map(|p| p.coords - middle).collect();
        let off = UnitQuaternion::from_scaled_axis(Vector3::new(0.1, -0.15, 0.1));
        let turn = (off * truth.rotation).to_rotation_matrix().into_inner();
        let shift = (truth * Point3::from(middle)) - field.lo + Vector3::new(2.0, -3.0, 1.0);
        let walk = Walk { turn, shift, score: 0.0 }.walked(&field, &points, 0..20, part.mesh.diagonal());
        let found = off_mm(&part, &walk.model_from_scan(&field, &middle), &truth);
        assert!(found < 1.5 && walk.score.sqrt() < 1.0, "{found} {}", walk.score.sqrt());
    }
}
