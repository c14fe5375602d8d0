//! Where a fit starts from: frames by the points and their normals, in closed form.
//!
//! A cylinder's or an extrusion's direction is the one in which normals have least of their length. The axis of what is
//! revolved is met by all its normals: the rotation whose paths they cross most nearly at right angles (Pottmann and
//! Wallner, "Computational Line Geometry", 2001: the linear complex nearest to the normals).

use super::profile::Profile;
use super::surface::{Form, Surface, monomial_count};
use crate::part::angle::{any_square_to, unit};
use crate::part::circle::fitted_circle;
use crate::scan::normals::plane_through;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, SymmetricEigen, Translation3, UnitQuaternion, Vector3};

/// Points with normals that a start is made of, and all places that the surface has to reach.
pub(super) struct Given<'a> {
    pub points: &'a [Point3<f64>],
    pub normals: &'a [Vector3<f64>],
    pub reached: &'a [Point3<f64>],
    pub size_mm: f64,
}

/// Cosine between a normal and the direction in which a curve is a height: with less (75°) it is hardly one.
const STEEPEST: f64 = 0.26;
/// Share of the normals that may be steeper: noise, and rims.
const STEEPER: f64 = 0.05;
/// Added to both ends of a curve, as a share of its length: the frame turns a little while it is fitted.
const BEYOND: f64 = 0.01;

impl Given<'_> {
    fn middle(&self) -> Point3<f64> {
        let from = self.points.first().copied().unwrap_or_default();
        let sum: Vector3<f64> = self.points.iter().map(|p| p - from).sum();
        from + sum / self.points.len().max(1) as f64
    }

    fn mean_normal(&self) -> Vector3<f64> {
        self.normals.iter().sum()
    }

    /// A height over the plane of the points.
    pub fn height(&self, degree: usize) -> Option<Surface> {
        let plane = plane_through(self.points.iter().copied())?;
        let up = if plane.normal.dot(&self.mean_normal()) < 0.0 { -plane.normal } else { plane.normal };
        let frame = frame(plane.middle, any_square_to(&up), up);
        let flat = self.reached.iter().map(|p| frame.inverse_transform_point(p));
        let size_mm = flat.fold(0.0, |m: f64, q| m.max(q.x.abs()).max(q.y.abs())) * (1.0 + BEYOND);
        let coefficients = vec![0.0; monomial_count(degree)];
        Some(Surface { frame, form: Form::Height { degree, size_mm }, coefficients, outward: 1.0 })
    }

    /// A curve drawn along a direction. `None` where it is no height over its plane.
    pub fn extruded(&self, intervals: usize) -> Option<Surface> {
        let along = self.least_normal_direction();
        let mean = self.mean_normal();
        let up = unit(mean - along * mean.dot(&along))?;
        if self.steeper(|_| up) > STEEPER {
            return None;
        }
        let frame = frame(self.middle(), along.cross(&up), up);
        let profile = self.profile(intervals, &frame, |q| q.x)?;
        let coefficients = vec![0.0; profile.coefficients()];
        Some(Surface { frame, form: Form::Extruded(profile), coefficients, outward: 1.0 })
    }

    /// A cylinder.
    pub fn cylinder(&self) -> Option<Surface> {
        let axis = self.least_normal_direction();
        let (middle, u) = (self.middle(), any_square_to(&axis));
        let v = axis.cross(&u);
        let across = self.points.iter().map(|p| p - middle).map(|d| [d.dot(&u), d.dot(&v)]);
        let ([x, y], _) = fitted_circle(across)?;
        self.about(&frame(middle + u * x + v * y, u, axis), 0)
    }

    /// A curve turned about an axis. `None` where its radius is no height along the axis.
    pub fn revolved(&self, intervals: usize) -> Option<Surface> {
        let middle = self.middle();
        let (mut turns, mut mixed, mut shifts) = (Matrix3::zeros(), Matrix3::zeros(), Matrix3::zeros());
        for (p, n) in self.points.iter().zip(self.normals) {
            let moment = ((p - middle) / self.size_mm).cross(n);
            turns += moment * moment.transpose();
            mixed += moment * n.transpose();
            shifts += n * n.transpose();
        }
        // A shift that no normal has any part in is none that a rotation needs.
        shifts += Matrix3::from_diagonal_element(1e-6 * shifts.trace());
        let best = shifts.try_inverse()? * mixed.transpose();
        let eigen = SymmetricEigen::new(turns - mixed * best);
        let axis = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
        // The rotation shifts the middle by −best·axis: so far off the axis it stands.
        let through = middle + axis.cross(&(-(best * axis))) * self.size_mm;
        self.about(&frame(through, any_square_to(&axis), axis), intervals)
    }

    fn about(&self, frame: &Isometry3<f64>, intervals: usize) -> Option<Surface> {
        let axis = frame * Vector3::z();
        let radial = |p: &Point3<f64>| {
            let d = p - Point3::from(frame.translation.vector);
            unit(d - axis * d.dot(&axis)).unwrap_or_default()
        };
        let facing: f64 = self.points.iter().zip(self.normals).map(|(p, n)| radial(p).dot(n)).sum();
        let outward = if facing < 0.0 { -1.0 } else { 1.0 };
        if self.steeper(|p| radial(p) * outward) > STEEPER {
            return None;
        }
        let profile = self.profile(intervals, frame, |q| q.z)?;
        let radii = self.points.iter().map(|p| (p - Point3::from(frame.translation.vector)).cross(&axis).norm());
        let radius = radii.sum::<f64>() / self.points.len().max(1) as f64;
        let coefficients = vec![radius; profile.coefficients()];
        Some(Surface { frame: *frame, form: Form::Revolved(profile), coefficients, outward })
    }

    /// The direction in which the normals have least of their length.
    fn least_normal_direction(&self) -> Vector3<f64> {
        let spread = self.normals.iter().fold(Matrix3::zeros(), |s, n| s + n * n.transpose());
        let eigen = SymmetricEigen::new(spread);
        eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned()
    }

    /// Share of the normals that lie too far from a direction.
    fn steeper(&self, up: impl Fn(&Point3<f64>) -> Vector3<f64>) -> f64 {
        let is_steep = |(p, n): &(&Point3<f64>, &Vector3<f64>)| n.dot(&up(p)) < STEEPEST;
        self.points.iter().zip(self.normals).filter(is_steep).count() as f64 / self.points.len().max(1) as f64
    }

    fn profile(&self, intervals: usize, frame: &Isometry3<f64>, of: impl Fn(Point3<f64>) -> f64) -> Option<Profile> {
        let along = || self.reached.iter().map(|p| of(frame.inverse_transform_point(p)));
        let (lo, hi) = along().fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
        let beyond = BEYOND * (hi - lo);
        let is_long = hi - lo > 1e-9 * self.size_mm;
        is_long.then_some(Profile { start_mm: lo - beyond, end_mm: hi + beyond, intervals })
    }
}

/// The frame with w along `up` and u along `across`, which is square to it.
fn frame(origin: Point3<f64>, across: Vector3<f64>, up: Vector3<f64>) -> Isometry3<f64> {
    let axes = Matrix3::from_columns(&[across, up.cross(&across), up]);
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    Isometry3::from_parts(Translation3::from(origin.coords), turn)
}
