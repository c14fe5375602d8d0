//! The point of a cloud under the cursor. A click is rare: all points are looked at.

use super::camera::Camera;
use super::cloud::CloudItem;
use super::lens::{Projection, ViewSize};
use nalgebra::{Point2, Point3};

/// What lies so many times the reach behind the foremost point under the cursor belongs to another side of the part.
const SAME_SIDE: f64 = 4.0;

/// A point of a cloud that was picked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CloudPick {
    /// Its index in the item.
    pub index: u32,
    /// How far along the ray through the pixel it lies, mm.
    pub along_mm: f64,
}

/// The point of a cloud under a pixel: of those within `reach_px` the one nearest to the ray, on the side that faces
/// the viewer. Points that are not shown are not picked.
pub fn cloud_point_at(
    item: &CloudItem,
    camera: &Camera,
    px: Point2<f64>,
    size: ViewSize,
    reach_px: f64,
) -> Option<CloudPick> {
    let (origin, dir) = camera.ray_through(px, size);
    let item_from_scene = item.scene_from_item.inverse();
    let (from, along) = (item_from_scene * origin, item_from_scene * dir);
    let at_target_mm = reach_px / camera.px_per_mm(&camera.target, size);
    // In perspective what is reached widens with the way from the eye.
    let steepness = -dir.dot(&camera.axes().column(2));
    let reach_mm = |along_mm: f64| match camera.projection {
        Projection::Parallel => at_target_mm,
        Projection::Perspective => at_target_mm * along_mm * steepness / camera.distance_mm,
    };
    let colors = &item.colors;
    let near = item.places.places().iter().zip(0u32..).filter_map(|(place, index)| {
        let way = Point3::from(place.map(f64::from)) - from;
        let along_mm = way.dot(&along);
        let off_mm = (way - along * along_mm).norm();
        let is_shown = colors.get(index as usize).is_some_and(|c| c[3] > 0);
        (is_shown && along_mm > 0.0 && off_mm <= reach_mm(along_mm)).then_some((off_mm, CloudPick { index, along_mm }))
    });
    let near: Vec<(f64, CloudPick)> = near.collect();
    let first_mm = near.iter().map(|(_, pick)| pick.along_mm).fold(f64::INFINITY, f64::min);
    let last_mm = first_mm + SAME_SIDE * reach_mm(first_mm);
    let in_front = near.into_iter().filter(|(_, pick)| pick.along_mm <= last_mm);
    in_front.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, pick)| pick)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Isometry3, Vector3};
    use std::sync::Arc;

    #[test]
    fn the_foremost_point_under_the_pixel_is_picked_wherever_the_cloud_stands() {
        let size = ViewSize::new(800.0, 600.0);
        let place = Isometry3::new(Vector3::new(3.0, 2.0, -1.0), Vector3::new(0.1, 0.7, -0.3));
        for projection in [Projection::Perspective, Projection::Parallel] {
            let camera = Camera { projection, ..Camera::default() };
            let toward_eye = camera.axes().column(2).into_owned();
            let side = camera.axes().column(0).into_owned();
            let scene = [
                camera.target + toward_eye * 5.0,
                camera.target - toward_eye * 5.0,
                camera.target + side * 10.0,
                camera.target + toward_eye * 9.0,
            ];
            let places: Vec<[f32; 3]> =
                scene.iter().map(|p| (place.inverse() * p).coords.map(|x| x as f32).into()).collect();
            let colors = vec![[255, 255, 255, 255], [255; 4], [255; 4], [0; 4]];
            let item = CloudItem {
                geometry_key: 1,
                places: Arc::new(places),
                colors_key: 1,
                colors: Arc::new(colors),
                size_points: 2.0,
                lift_mm: 0.0,
                fades: false,
                scene_from_item: place,
            };
            let at = |p: &Point3<f64>| {
                let (x, y, _) = camera.project(p, size).expect("in front");
                cloud_point_at(&item, &camera, Point2::new(x + 1.0, y), size, 6.0).map(|pick| pick.index)
            };
            assert_eq!((at(&scene[0]), at(&scene[2])), (Some(0), Some(2)), "{projection:?}");
            assert_eq!(at(&(camera.target + side * 4.0)), None);
        }
    }
}
