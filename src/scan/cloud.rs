//! Points as they were measured: a cloud in the scan's frame, with what the scanner told of each.
//!
//! 31 bytes a point at most: places are f32 offsets from an f64 origin, so that a cloud in survey coordinates
//! (millions of millimetres from nought) keeps what its file resolves.

use crate::part::{Digest, Hasher};
use nalgebra::{Isometry3, Point3, Vector3};

/// Points in the frame of their scan. What is there of normals, colours and intensities is there for each point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cloud {
    /// What the offsets count from; mm once the cloud is scaled, file units before.
    pub origin: Point3<f64>,
    /// Each point's place from the origin.
    pub offsets: Vec<[f32; 3]>,
    /// Unit normals, outward as far as the scanner knew.
    pub normals: Option<Vec<[f32; 3]>>,
    /// Red, green, blue.
    pub colours: Option<Vec<[u8; 3]>>,
    /// How bright the point came back, in the file's own measure.
    pub intensities: Option<Vec<f32>>,
}

impl Cloud {
    /// A cloud of places alone; the middle of their box becomes the origin.
    pub fn of_points(points: &[Point3<f64>]) -> Cloud {
        let Some((lo, hi)) = bounds(points.iter().copied()) else { return Cloud::default() };
        let origin = lo + (hi - lo) * 0.5;
        Cloud { origin, offsets: points.iter().map(|p| offset(&origin, p)).collect(), ..Cloud::default() }
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.offsets.len()
    }

    /// Whether there is no point.
    pub fn is_empty(&self) -> bool {
        self.offsets.is_empty()
    }

    /// A point's place, in the scan's frame.
    pub fn point(&self, index: usize) -> Point3<f64> {
        let [x, y, z] = self.offsets[index];
        self.origin + Vector3::new(f64::from(x), f64::from(y), f64::from(z))
    }

    /// All places, in the scan's frame.
    pub fn points(&self) -> impl ExactSizeIterator<Item = Point3<f64>> + '_ {
        (0..self.len()).map(|i| self.point(i))
    }

    /// A point's normal, where the cloud has them.
    pub fn normal(&self, index: usize) -> Option<Vector3<f64>> {
        self.normals.as_ref().map(|n| Vector3::from(n[index].map(f64::from)))
    }

    /// The corners of the box around all points; `None` without points.
    pub fn bounds(&self) -> Option<(Point3<f64>, Point3<f64>)> {
        bounds(self.points())
    }

    /// Diagonal of that box, 0 without points.
    pub fn diagonal(&self) -> f64 {
        self.bounds().map_or(0.0, |(lo, hi)| (hi - lo).norm())
    }

    /// Only these points, in the order given.
    #[must_use]
    pub fn picked(&self, indices: &[u32]) -> Cloud {
        fn of<T: Copy>(all: &[T], indices: &[u32]) -> Vec<T> {
            indices.iter().map(|&i| all[i as usize]).collect()
        }
        Cloud {
            origin: self.origin,
            offsets: of(&self.offsets, indices),
            normals: self.normals.as_deref().map(|n| of(n, indices)),
            colours: self.colours.as_deref().map(|c| of(c, indices)),
            intensities: self.intensities.as_deref().map(|i| of(i, indices)),
        }
    }

    /// The cloud in another unit.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Cloud {
        self.origin *= factor;
        for o in &mut self.offsets {
            *o = o.map(|c| (f64::from(c) * factor) as f32);
        }
        self
    }

    /// The cloud in another frame.
    #[must_use]
    pub fn moved(mut self, other_from_self: &Isometry3<f64>) -> Cloud {
        let turned = |v: &[f32; 3]| {
            let t = other_from_self.rotation * Vector3::from(v.map(f64::from));
            [t.x as f32, t.y as f32, t.z as f32]
        };
        self.origin = other_from_self * self.origin;
        for v in self.offsets.iter_mut().chain(self.normals.iter_mut().flatten()) {
            *v = turned(v);
        }
        self
    }

    /// Changes with every place, normal, colour and intensity.
    pub fn digest(&self) -> Digest {
        let mut into = Hasher::default().f64s(self.origin.coords.as_slice());
        let floats = |all: &[[f32; 3]]| all.iter().flatten().flat_map(|c| c.to_le_bytes()).collect::<Vec<u8>>();
        into = into.bytes(&floats(&self.offsets));
        into = into.bytes(&self.normals.as_deref().map(floats).unwrap_or_default());
        into = into.bytes(self.colours.as_deref().map(<[_]>::as_flattened).unwrap_or_default());
        let bright = self.intensities.iter().flatten().flat_map(|i| i.to_le_bytes());
        into.bytes(&bright.collect::<Vec<u8>>()).finish()
    }
}

fn offset(origin: &Point3<f64>, p: &Point3<f64>) -> [f32; 3] {
    let d = p - origin;
    [d.x as f32, d.y as f32, d.z as f32]
}

fn bounds(points: impl Iterator<Item = Point3<f64>>) -> Option<(Point3<f64>, Point3<f64>)> {
    points.fold(None, |found, p| {
        let (lo, hi) = found.unwrap_or((p, p));
        Some((lo.inf(&p), hi.sup(&p)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cloud_far_from_nought_keeps_its_places() {
        let points = [Point3::new(4.3e9, 2.0, -1.0), Point3::new(4.3e9 + 10.25, 2.5, 7.0)];
        let cloud = Cloud::of_points(&points);
        for (found, p) in cloud.points().zip(points) {
            assert!((found - p).norm() < 1e-6, "{found}");
        }
        let scaled = cloud.picked(&[1]).scaled(0.5);
        assert!((scaled.point(0) - points[1] * 0.5).norm() < 1e-6);
    }

    #[test]
    fn a_moved_cloud_turns_about_nought_and_not_about_its_origin() {
        let cloud = Cloud { normals: Some(vec![[1.0, 0.0, 0.0]]), ..Cloud::of_points(&[Point3::new(100.0, 3.0, 2.0)]) };
        let quarter = Isometry3::new(Vector3::new(0.0, 0.0, 1.0), Vector3::z() * std::f64::consts::FRAC_PI_2);
        let moved = cloud.clone().moved(&quarter);
        assert!((moved.point(0) - Point3::new(-3.0, 100.0, 3.0)).norm() < 1e-5);
        assert!((moved.normal(0).expect("it has one") - Vector3::y()).norm() < 1e-6);
        assert_ne!(moved.digest(), cloud.digest());
    }
}
