//! A surface of few parameters: a height over a plane, a curve drawn along a direction, or a curve turned about an axis.
//! How far a point lies off it, how that changes with the parameters, and where its foot is.

use super::profile::Profile;
use nalgebra::{Isometry3, Matrix2, Point3, Translation3, UnitQuaternion, Vector2, Vector3};

/// What stands over the frame of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    /// w = polynomial of u and v up to this degree; both in units of `size_mm`, and 1 at most.
    Height { degree: usize, size_mm: f64 },
    /// w = curve over u, the same all along v.
    Extruded(Profile),
    /// √(u² + v²) = curve over w.
    Revolved(Profile),
}

/// A surface in space. The frame's axes are u, v, w.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Surface {
    pub frame: Isometry3<f64>,
    pub form: Form,
    pub coefficients: Vec<f64>,
    /// 1 where normals point up (w), or away from the axis; −1 for bores.
    pub outward: f64,
}

/// How far a point lies off a surface, and how much that changes with each parameter: those of the frame's motion
/// first, then the coefficients from `first` on.
pub(super) struct Row {
    pub off_mm: f64,
    pub motion: [f64; 4],
    pub first: usize,
    pub slopes: Slopes,
    /// How many of the slopes there are.
    pub count: usize,
}

/// Coefficients that a point's distance depends on at most: those of a polynomial of degree 4.
const MOST_COEFFICIENTS: usize = 15;

/// One number for each coefficient.
type Slopes = [f64; MOST_COEFFICIENTS];

impl Surface {
    /// Parameters of the frame's motion: turns about u and w of what is extruded; turns about u and v and shifts along
    /// them of what is revolved. All other motions are done by coefficients.
    pub fn motions(&self) -> usize {
        match self.form {
            Form::Height { .. } => 0,
            Form::Extruded(_) => 2,
            Form::Revolved(_) => 4,
        }
    }

    /// A point's distance to first order and its change. `None` on the axis, where there is no direction.
    pub fn row(&self, p: &Point3<f64>) -> Option<Row> {
        let q = self.frame.inverse_transform_point(p).coords;
        match self.form {
            Form::Height { degree, size_mm } => {
                let (value, du, dv) = monomials(q.x / size_mm, q.y / size_mm, degree);
                let sum = |of: &[f64]| of.iter().zip(&self.coefficients).map(|(m, c)| m * c).sum::<f64>();
                let (du, dv) = (sum(&du) / size_mm, sum(&dv) / size_mm);
                let steep = (1.0 + du * du + dv * dv).sqrt();
                let (slopes, count) = (value.map(|m| -m / steep), self.coefficients.len());
                Some(Row { off_mm: (q.z - sum(&value)) / steep, motion: [0.0; 4], first: 0, slopes, count })
            }
            Form::Extruded(profile) => {
                let (row, dy) = curve_row(&profile, q.x, q.z, &self.coefficients);
                let n = Vector3::new(-dy, 0.0, 1.0) / (1.0 + dy * dy).sqrt();
                let turned = -q.cross(&n);
                Some(Row { motion: [turned.x, turned.z, 0.0, 0.0], ..row })
            }
            Form::Revolved(profile) => {
                let radius = (q.x * q.x + q.y * q.y).sqrt();
                if radius < 1e-9 {
                    return None;
                }
                let (row, dy) = curve_row(&profile, q.z, radius, &self.coefficients);
                let n = Vector3::new(q.x / radius, q.y / radius, -dy) / (1.0 + dy * dy).sqrt();
                let turned = -q.cross(&n);
                Some(Row { motion: [turned.x, turned.y, -n.x, -n.y], ..row })
            }
        }
    }

    /// Moves the frame, as far as that is free, and adds to the coefficients.
    pub fn change(&mut self, by: &[f64]) {
        let motions = self.motions();
        let (turn, shift) = match self.form {
            Form::Height { .. } => (Vector3::zeros(), Vector3::zeros()),
            Form::Extruded(_) => (Vector3::new(by[0], 0.0, by[1]), Vector3::zeros()),
            Form::Revolved(_) => (Vector3::new(by[0], by[1], 0.0), Vector3::new(by[2], by[3], 0.0)),
        };
        let motion = Isometry3::from_parts(Translation3::from(shift), UnitQuaternion::from_scaled_axis(turn));
        self.frame *= motion;
        self.coefficients.iter_mut().zip(&by[motions..]).for_each(|(c, d)| *c += d);
    }

    /// The foot of a point and the outward unit normal there; `None` beyond the ends of a curve, beside the square
    /// of a height, on the axis, and so far off that no foot is found.
    pub fn closest(&self, p: &Point3<f64>) -> Option<(Point3<f64>, Vector3<f64>)> {
        let q = self.frame.inverse_transform_point(p).coords;
        let (foot, normal) = match self.form {
            Form::Height { degree, size_mm } => {
                let is_over = q.x.abs() <= size_mm && q.y.abs() <= size_mm;
                is_over.then(|| self.foot_of_height(&q, degree, size_mm))?
            }
            Form::Extruded(profile) => {
                if !profile.holds(q.x) {
                    return None;
                }
                let x = profile.foot(q.x, q.z, &self.coefficients);
                let [y, dy] = profile.at(x, &self.coefficients);
                (Vector3::new(x, q.y, y), Vector3::new(-dy, 0.0, 1.0))
            }
            Form::Revolved(profile) => {
                let radius = (q.x * q.x + q.y * q.y).sqrt();
                let along = Vector2::new(q.x, q.y).try_normalize(1e-9).filter(|_| profile.holds(q.z))?;
                let z = profile.foot(q.z, radius, &self.coefficients);
                let [y, dy] = profile.at(z, &self.coefficients);
                (Vector3::new(along.x * y, along.y * y, z), Vector3::new(along.x, along.y, -dy))
            }
        };
        let normal = normal.normalize();
        let is_foot = (q - foot).cross(&normal).norm() <= SQUARE * (1.0 + (q - foot).norm());
        is_foot.then(|| (self.frame * Point3::from(foot), self.frame * (normal * self.outward)))
    }

    fn foot_of_height(&self, q: &Vector3<f64>, degree: usize, size_mm: f64) -> (Vector3<f64>, Vector3<f64>) {
        let at = |u: f64, v: f64| {
            let (value, du, dv) = monomials(u / size_mm, v / size_mm, degree);
            let sum = |of: &[f64]| of.iter().zip(&self.coefficients).map(|(m, c)| m * c).sum::<f64>();
            (sum(&value), sum(&du) / size_mm, sum(&dv) / size_mm)
        };
        let (mut u, mut v) = (q.x, q.y);
        for _ in 0..12 {
            let (w, du, dv) = at(u, v);
            let right = Vector2::new(q.x - u + (q.z - w) * du, q.y - v + (q.z - w) * dv);
            let left = Matrix2::new(1.0 + du * du, du * dv, du * dv, 1.0 + dv * dv);
            let step = left.try_inverse().map_or_else(Vector2::zeros, |inverse| inverse * right);
            (u, v) = (u + step.x, v + step.y);
        }
        let (w, du, dv) = at(u, v);
        (Vector3::new(u, v, w), Vector3::new(-du, -dv, 1.0))
    }
}

/// The row of a curve's point (x, y), without motion, and the curve's slope there.
fn curve_row(profile: &Profile, x: f64, y: f64, coefficients: &[f64]) -> (Row, f64) {
    let [height, dy] = profile.at(x, coefficients);
    let steep = (1.0 + dy * dy).sqrt();
    let base = profile.base(x);
    let mut slopes = [0.0; MOST_COEFFICIENTS];
    slopes.iter_mut().zip(base.value).for_each(|(s, b)| *s = -b / steep);
    (Row { off_mm: (y - height) / steep, motion: [0.0; 4], first: base.first, slopes, count: base.count }, dy)
}

/// A foot's offset along the surface, mm, and as a share of its distance, up to which it is one.
const SQUARE: f64 = 1e-4;

/// Number of coefficients of a polynomial of two variables.
pub(super) fn monomial_count(degree: usize) -> usize {
    (degree + 1) * (degree + 2) / 2
}

/// The products uⁱ·vʲ with i + j up to the degree, 4 at most, and their slopes along u and v.
fn monomials(u: f64, v: f64, degree: usize) -> (Slopes, Slopes, Slopes) {
    let powers = |x: f64| [1.0, x, x * x, x * x * x, x * x * x * x];
    let slope = |of: &[f64; 5], k: usize| if k == 0 { 0.0 } else { k as f64 * of[k - 1] };
    let (pu, pv) = (powers(u), powers(v));
    let mut found = ([0.0; MOST_COEFFICIENTS], [0.0; MOST_COEFFICIENTS], [0.0; MOST_COEFFICIENTS]);
    let mut at = 0;
    for sum in 0..=degree {
        for j in 0..=sum {
            let i = sum - j;
            found.0[at] = pu[i] * pv[j];
            found.1[at] = slope(&pu, i) * pv[j];
            found.2[at] = pu[i] * slope(&pv, j);
            at += 1;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each entry of a row against the difference that a small change makes.
    #[test]
    fn rows_tell_how_the_distance_changes() {
        let frame = Isometry3::new(Vector3::new(1.0, -2.0, 3.0), Vector3::new(0.3, -0.7, 0.2));
        let profile = Profile { start_mm: -6.0, end_mm: 6.0, intervals: 3 };
        let curve = vec![9.0, 9.5, 10.4, 10.0, 9.7, 9.9];
        let height: Vec<f64> = (0..monomial_count(3)).map(|k| 0.03 * (k as f64 - 4.0)).collect();
        let forms = [
            (Form::Height { degree: 3, size_mm: 8.0 }, height),
            (Form::Extruded(profile), curve.clone()),
            (Form::Revolved(profile), curve),
        ];
        for (form, coefficients) in forms {
            let surface = Surface { frame, form, coefficients, outward: 1.0 };
            let height = if matches!(form, Form::Extruded(_)) { 9.5 } else { -0.2 };
            let from = frame * Point3::new(2.0, 6.0, height);
            let (foot, normal) = surface.closest(&from).expect("a foot");
            assert!((from - foot).cross(&normal).norm() < 1e-9, "{form:?}");
            // On the surface rows are exact.
            let row = surface.row(&foot).expect("a row");
            assert!(row.off_mm.abs() < 1e-9);
            for k in 0..surface.motions() + surface.coefficients.len() {
                let mut by = vec![0.0; surface.motions() + surface.coefficients.len()];
                by[k] = 1e-6;
                let mut changed = surface.clone();
                changed.change(&by);
                let found = changed.row(&foot).expect("a row").off_mm / 1e-6;
                let motions = surface.motions();
                let told = if k < motions {
                    row.motion[k]
                } else {
                    (k - motions).checked_sub(row.first).filter(|j| *j < row.count).map_or(0.0, |j| row.slopes[j])
                };
                assert!((found - told).abs() < 1e-4, "{form:?}, parameter {k}: {found}, not {told}");
            }
        }
    }
}
