//! Distances and angles between two places that were picked on the part, and what shapes they lie on.

use super::context::Context;
use super::shown::Picked;
use crate::part::{Shape, angle};
use crate::text::{fixed, id, say};
use nalgebra::{Point3, Unit, Vector3};

/// Directions this near are parallel, degrees: facets of a plane or cylinder are parallel to f32 accuracy.
const PARALLEL_DEG: f64 = 0.05;

/// What a surface is measured by.
enum Measure {
    Plane(Vector3<f64>),
    Axis { through: Point3<f64>, along: Vector3<f64> },
}

impl Context<'_> {
    /// What is told of the picked places, in lines.
    pub fn measured(self) -> Vec<String> {
        let picked = &self.session.measured;
        let mut lines: Vec<String> = picked.iter().map(|at| self.place_line(at)).collect();
        if let [one, other] = picked[..] {
            let apart = other.1 - one.1;
            let [x, y, z] = <[f64; 3]>::from(apart).map(|c| fixed(c, 3));
            lines.push(say!(measure_distance, mm = fixed(apart.norm(), 3), x, y, z));
            lines.extend(self.between(&one, &other));
        }
        lines
    }

    fn place_line(self, (facet, at): &Picked) -> String {
        let surface = self.surface_of(*facet).unwrap_or_default();
        let label = self.derived.label(self.document.job(), surface);
        let [x, y, z] = [at.x, at.y, at.z].map(|c| fixed(c, 3));
        say!(measure_place, surface = id(surface), label, x, y, z)
    }

    /// Angle and distance of two planes, two axes, or one of each.
    fn between(self, one: &Picked, other: &Picked) -> Option<String> {
        use Measure::{Axis, Plane};
        let measures = (self.measure_of(one)?, self.measure_of(other)?);
        let (a, b) = (direction(&measures.0), direction(&measures.1));
        // Planes by their normals, axes by their lines: neither has a sign that anybody sees.
        let deg = angle::between_deg(&a, &b);
        let deg = deg.min(180.0 - deg);
        let (angle_deg, apart_mm) = match measures {
            (Plane(normal), Plane(_)) => (deg, Some((other.1 - one.1).dot(&normal).abs())),
            (Axis { through: p, along }, Axis { through: q, .. }) => {
                let along = Unit::new_normalize(along);
                let off = q - p;
                (deg, Some((off - along.into_inner() * off.dot(&along)).norm()))
            }
            (Plane(normal), Axis { through, .. }) => (90.0 - deg, Some((through - one.1).dot(&normal).abs())),
            (Axis { through, .. }, Plane(normal)) => (90.0 - deg, Some((through - other.1).dot(&normal).abs())),
        };
        Some(match apart_mm.filter(|_| angle_deg < PARALLEL_DEG) {
            Some(mm) => say!(measure_parallel, mm = fixed(mm, 3)),
            None => say!(measure_angle, angle = fixed(angle_deg, 2)),
        })
    }

    fn measure_of(self, (facet, _): &Picked) -> Option<Measure> {
        match self.derived.shape(self.surface_of(*facet)?)? {
            Shape::Plane { normal } => Some(Measure::Plane(*normal)),
            Shape::Cylinder { centre, axis, .. } => Some(Measure::Axis { through: *centre, along: *axis }),
            Shape::Cone { apex, axis, .. } => Some(Measure::Axis { through: *apex, along: *axis }),
            Shape::Sphere { .. } | Shape::Freeform => None,
        }
    }
}

fn direction(measure: &Measure) -> Vector3<f64> {
    match measure {
        Measure::Plane(normal) => *normal,
        Measure::Axis { along, .. } => *along,
    }
}
