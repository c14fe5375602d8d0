//! Axis-aligned boxes, for fitting the camera and its clip planes.

use nalgebra::{Point3, Vector3};

/// An axis-aligned box in the scene's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Smallest corner.
    pub min: Point3<f64>,
    /// Largest corner.
    pub max: Point3<f64>,
}

impl Bounds {
    /// The box around the points; `None` without any finite point.
    pub fn around(points: impl IntoIterator<Item = Point3<f64>>) -> Option<Self> {
        points.into_iter().filter(|point| point.coords.iter().all(|value| value.is_finite())).fold(
            None,
            |so_far: Option<Self>, point| {
                let single = Self { min: point, max: point };
                Some(so_far.map_or(single, |bounds| bounds.union(&single)))
            },
        )
    }

    /// The box around both.
    pub fn union(&self, other: &Self) -> Self {
        Self { min: self.min.inf(&other.min), max: self.max.sup(&other.max) }
    }

    /// The middle.
    pub fn center(&self) -> Point3<f64> {
        nalgebra::center(&self.min, &self.max)
    }

    /// Radius of the sphere through the corners.
    pub fn radius_mm(&self) -> f64 {
        self.half_size().norm()
    }

    /// Half the edge lengths.
    pub fn half_size(&self) -> Vector3<f64> {
        (self.max - self.min) / 2.0
    }

    /// The eight corners.
    pub fn corners(&self) -> [Point3<f64>; 8] {
        std::array::from_fn(|corner| {
            Point3::from(Vector3::from_fn(
                |axis, _| {
                    if corner >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] }
                },
            ))
        })
    }
}

impl Default for Bounds {
    /// A hand-sized cube around the origin, for an empty scene.
    fn default() -> Self {
        Self { min: Point3::new(-50.0, -50.0, -50.0), max: Point3::new(50.0, 50.0, 50.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn around_ignores_what_is_not_a_number() {
        let points = [[0.0, 1.0, 2.0], [f64::NAN, 0.0, 0.0], [-1.0, 3.0, 2.0]];
        let bounds = Bounds::around(points.map(Point3::from)).expect("two finite points");
        assert_eq!(bounds.min, Point3::new(-1.0, 1.0, 2.0));
        assert_eq!(bounds.max, Point3::new(0.0, 3.0, 2.0));
        assert_eq!(Bounds::around([]), None);
    }
}
