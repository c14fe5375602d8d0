//! Names the shape of a feature surface where one fits: plane, cylinder, cone or sphere; else
//! freeform. Vertices of an exported surface lie on the true shape to f32 accuracy, so the fit may
//! be strict; facets only give the axis.

use super::surfaces::Surface;
use super::topology::{FacetDefect, Mesh};
use nalgebra::{Matrix3, Matrix4, Point3, SymmetricEigen, Vector3, Vector4};

/// A shape with its size, mm and degrees, part frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A plane with its unit normal.
    Plane {
        /// Unit normal.
        normal: Vector3<f64>,
    },
    /// A circular cylinder or a piece of one.
    Cylinder {
        /// Diameter, mm.
        diameter_mm: f64,
        /// A point on the axis.
        centre: Point3<f64>,
        /// Unit axis.
        axis: Vector3<f64>,
    },
    /// A circular cone or a piece of one.
    Cone {
        /// Angle between axis and side, degrees.
        half_angle_deg: f64,
        /// Its tip.
        apex: Point3<f64>,
        /// Unit axis, from the tip into the cone.
        axis: Vector3<f64>,
    },
    /// A sphere or a piece of one.
    Sphere {
        /// Diameter, mm.
        diameter_mm: f64,
        /// Its centre.
        centre: Point3<f64>,
    },
    /// Any other shape.
    Freeform,
}

impl Shape {
    /// Its word in `inspect --json`.
    pub fn word(&self) -> &'static str {
        match self {
            Shape::Plane { .. } => "plane",
            Shape::Cylinder { .. } => "cylinder",
            Shape::Cone { .. } => "cone",
            Shape::Sphere { .. } => "sphere",
            Shape::Freeform => "freeform",
        }
    }

    /// Whether another shape is of this kind and size: diameters to 0.01 mm, angles to 0.1°.
    pub fn is_like(&self, other: &Shape) -> bool {
        match (self, other) {
            (Shape::Plane { .. }, Shape::Plane { .. }) | (Shape::Freeform, Shape::Freeform) => true,
            (Shape::Cylinder { diameter_mm: one, .. }, Shape::Cylinder { diameter_mm: two, .. })
            | (Shape::Sphere { diameter_mm: one, .. }, Shape::Sphere { diameter_mm: two, .. }) => {
                (one - two).abs() < 0.01
            }
            (Shape::Cone { half_angle_deg: one, .. }, Shape::Cone { half_angle_deg: two, .. }) => {
                (one - two).abs() < 0.1
            }
            _ => false,
        }
    }

    /// Fits the simplest shape that every vertex of the surface lies on.
    pub fn of(mesh: &Mesh, surface: &Surface) -> Shape {
        let samples = Samples::new(mesh, surface);
        // 1e-4 of the surface's size: a hundred times the grain of f32, a tenth of what an
        // operator would call out of round.
        let tolerance = 1e-4 * samples.size;
        samples
            .plane(tolerance)
            .or_else(|| samples.cylinder(tolerance))
            // Before the sphere: the two rings of a cone's side lie on one as well.
            .or_else(|| samples.cone(tolerance))
            .or_else(|| samples.sphere(tolerance))
            .map_or(Shape::Freeform, |shape| shape.scaled(samples.unit_mm))
    }

    /// The shape, so many times larger.
    pub(super) fn scaled(self, by: f64) -> Shape {
        match self {
            Shape::Cylinder { diameter_mm, centre, axis } => {
                Shape::Cylinder { diameter_mm: diameter_mm * by, centre: centre * by, axis }
            }
            Shape::Cone { half_angle_deg, apex, axis } => Shape::Cone { half_angle_deg, apex: apex * by, axis },
            Shape::Sphere { diameter_mm, centre } => {
                Shape::Sphere { diameter_mm: diameter_mm * by, centre: centre * by }
            }
            Shape::Plane { .. } | Shape::Freeform => self,
        }
    }
}

/// Unique vertices and facet normals of a surface, in a unit of its size, so that a fit is the same at every scale.
struct Samples {
    /// A power of two, so that nothing is rounded.
    unit_mm: f64,
    points: Vec<Point3<f64>>,
    normals: Vec<(Vector3<f64>, f64)>,
    planes: Vec<(Vector3<f64>, Point3<f64>, f64)>,
    centre: Point3<f64>,
    size: f64,
}

impl Samples {
    fn new(mesh: &Mesh, surface: &Surface) -> Samples {
        let live: Vec<usize> =
            surface.facets.iter().map(|&f| f as usize).filter(|&f| mesh.defects[f] == FacetDefect::None).collect();
        let mut vertices: Vec<u32> = live.iter().flat_map(|&f| mesh.facets[f]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let at = |v: u32| mesh.vertices[v as usize];
        let (lo, hi) = super::topology::bounds_of(vertices.iter().map(|&v| at(v)));
        let size_mm = (hi - lo).norm();
        let unit_mm = if size_mm > 0.0 { libm::ldexp(1.0, libm::ilogb(size_mm)) } else { 1.0 };
        let area = |f: usize| mesh.areas[f] / unit_mm / unit_mm;
        let facet = |&f: &usize| (mesh.normals[f], mesh.corners(f)[0] / unit_mm, area(f));
        Samples {
            unit_mm,
            points: vertices.iter().map(|&v| at(v) / unit_mm).collect(),
            normals: live.iter().map(|&f| (mesh.normals[f], area(f))).collect(),
            planes: live.iter().map(facet).collect(),
            centre: (lo + (hi - lo) * 0.5) / unit_mm,
            size: size_mm / unit_mm,
        }
    }

    fn fits(&self, tolerance: f64, off: impl Fn(&Point3<f64>) -> f64) -> bool {
        self.points.iter().all(|p| off(p).abs() <= tolerance)
    }

    fn plane(&self, tolerance: f64) -> Option<Shape> {
        let sum: Vector3<f64> = self.normals.iter().map(|(n, a)| n * *a).sum();
        let normal = sum.try_normalize(1e-12)?;
        let through = self.points.first()?;
        self.fits(tolerance, |p| (p - through).dot(&normal)).then_some(Shape::Plane { normal })
    }

    /// Direction in which the normals vary least, about their mean or about zero.
    fn least_normal_axis(&self, about_mean: bool) -> Vector3<f64> {
        let weight: f64 = self.normals.iter().map(|(_, a)| a).sum();
        let mean: Vector3<f64> = self.normals.iter().map(|(n, a)| n * *a).sum::<Vector3<f64>>() / weight.max(1e-300);
        let mean = if about_mean { mean } else { Vector3::zeros() };
        let spread: Matrix3<f64> = self.normals.iter().map(|(n, a)| (n - mean) * (n - mean).transpose() * *a).sum();
        let eigen = SymmetricEigen::new(spread);
        eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned()
    }

    fn cylinder(&self, tolerance: f64) -> Option<Shape> {
        let axis = self.least_normal_axis(false);
        if self.normals.iter().any(|(n, _)| n.dot(&axis).abs() > 0.01) {
            return None;
        }
        let u = super::angle::any_square_to(&axis);
        let v = axis.cross(&u);
        let across = self.points.iter().map(|p| p - self.centre).map(|d| [d.dot(&u), d.dot(&v)]);
        let ([x, y], radius) = super::circle::fitted_circle(across)?;
        let centre = self.centre + u * x + v * y;
        // A nearly flat strip fits a huge circle; nobody calls that a cylinder.
        if radius > 50.0 * self.size {
            return None;
        }
        self.fits(tolerance.max(1e-4 * radius), |p| (p - centre).cross(&axis).norm() - radius)
            .then_some(Shape::Cylinder { diameter_mm: 2.0 * radius, centre, axis })
    }

    fn sphere(&self, tolerance: f64) -> Option<Shape> {
        if self.points.len() < 6 {
            return None;
        }
        let (mut m, mut r) = (Matrix4::zeros(), Vector4::zeros());
        for p in &self.points {
            let d = p - self.centre;
            let row = Vector4::new(2.0 * d.x, 2.0 * d.y, 2.0 * d.z, 1.0);
            m += row * row.transpose();
            r += row * d.norm_squared();
        }
        let c = m.lu().solve(&r)?;
        let offset = Vector3::new(c[0], c[1], c[2]);
        let radius = (c[3] + offset.norm_squared()).sqrt();
        let centre = self.centre + offset;
        if !radius.is_finite() || radius > 50.0 * self.size {
            return None;
        }
        self.fits(tolerance.max(1e-4 * radius), |p| (p - centre).norm() - radius)
            .then_some(Shape::Sphere { diameter_mm: 2.0 * radius, centre })
    }

    fn cone(&self, tolerance: f64) -> Option<Shape> {
        let axis = self.least_normal_axis(true);
        // The tip lies in the plane of every facet.
        let (mut m, mut r) = (Matrix3::zeros(), Vector3::zeros());
        for (n, p, area) in &self.planes {
            m += n * n.transpose() * *area;
            r += n * n.dot(&(p - self.centre)) * *area;
        }
        let apex = self.centre + m.lu().solve(&r)?;
        let mean: Vector3<f64> = self.points.iter().map(|p| p - apex).sum();
        let axis = if mean.dot(&axis) < 0.0 { -axis } else { axis };
        let along = |p: &Point3<f64>| ((p - apex).dot(&axis), (p - apex).cross(&axis).norm());
        let (height, radius) = self.points.iter().map(along).fold((0.0, 0.0), |s, q| (s.0 + q.0, s.1 + q.1));
        let half = libm::atan2(radius, height);
        let half_angle_deg = half.to_degrees();
        if !(1.0..89.0).contains(&half_angle_deg) || height > 50.0 * self.size * self.points.len() as f64 {
            return None;
        }
        let (s, c) = (libm::sin(half), libm::cos(half));
        let off = |p: &Point3<f64>| {
            let (h, r) = along(p);
            r * c - h * s
        };
        self.fits(2.0 * tolerance, off).then_some(Shape::Cone { half_angle_deg, apex, axis })
    }
}
