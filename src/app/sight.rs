//! From where a place on the part is seen: findings lie on all its sides.

use crate::part::Bvh;
use crate::view::Camera;
use nalgebra::{Isometry3, Point3, Vector3};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// Pitches that are looked from where the place is hidden, radians.
const PITCHES_RAD: [f64; 7] = [0.5, 0.0, 1.0, -0.5, -1.0, FRAC_PI_2, -FRAC_PI_2];

/// A camera that sees a place of the part: the same one where it does, else turned by the least that is needed, by eighths
/// of a turn. Where nothing sees it, as it is. `at`: in the part.
pub(super) fn seeing(camera: &Camera, bvh: &Bvh, at: &Point3<f64>, scene_from_part: &Isometry3<f64>) -> Camera {
    let toward_eye = |camera: &Camera| scene_from_part.rotation.inverse() * camera.axes().column(2).into_owned();
    let now = toward_eye(camera);
    if is_seen(bvh, at, &now) {
        return *camera;
    }
    let turned = |pitch_rad: f64, eighths: u8| {
        let yaw_rad = (camera.yaw_rad + f64::from(eighths) * FRAC_PI_4).rem_euclid(TAU);
        Camera { yaw_rad, pitch_rad, ..*camera }
    };
    let pitches = std::iter::once(camera.pitch_rad).chain(PITCHES_RAD);
    let all = pitches.flat_map(|pitch| (0..8).map(move |eighths| turned(pitch, eighths)));
    let mut all: Vec<(f64, Camera)> = all.map(|c| (toward_eye(&c).dot(&now), c)).collect();
    // The least turn first; of equal ones the first.
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.into_iter().map(|(_, c)| c).find(|c| is_seen(bvh, at, &toward_eye(c))).unwrap_or(*camera)
}

/// Whether nothing of the part is between a place on it and an eye far away in a direction, nor the place seen from its
/// back or all but edgewise.
fn is_seen(bvh: &Bvh, at: &Point3<f64>, toward_eye: &Vector3<f64>) -> bool {
    let reach_mm = 2.0 * bvh.diagonal_mm().max(1.0);
    // From the eye's side: the first facet that is met is that of the place.
    let from = at + toward_eye * reach_mm;
    let within_mm = 1e-3 * reach_mm;
    bvh.nearest_hit(&from, &-toward_eye, 0.0, 2.0 * reach_mm).is_none_or(|hit| hit.t_mm >= reach_mm - within_mm)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Mesh;
    use crate::sample::solids;
    use crate::view::{Bounds, ViewSize};

    fn cube() -> Bvh {
        let corners = solids::cube(10.0);
        let raw: Vec<[[f32; 3]; 3]> = corners.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        Bvh::new(&Mesh::weld(&raw, 1.0))
    }

    #[test]
    fn every_side_of_a_part_is_turned_into_sight() {
        let (bvh, place) = (cube(), Isometry3::rotation(Vector3::new(0.3, -0.2, 0.9)));
        let (middle, radius) = bvh.sphere_of_box().expect("facets");
        let bounds = Bounds { min: middle - Vector3::repeat(radius), max: middle + Vector3::repeat(radius) };
        let camera = Camera::fitted(bounds, ViewSize::new(800.0, 600.0));
        let mut kept = 0;
        for axis in 0..3 {
            for side in [-1.0, 1.0] {
                let outward = Vector3::ith(axis, side);
                let at = middle + outward * 5.0;
                let found = seeing(&camera, &bvh, &at, &place);
                let faces = (place.rotation * outward).dot(&found.axes().column(2));
                assert!(faces > 0.0, "axis {axis}, side {side}: {faces}");
                kept += u32::from(found == camera);
            }
        }
        assert_eq!(kept, 3, "three sides are seen as it is, and stay");
    }

    #[test]
    fn what_nothing_sees_turns_nothing() {
        let bvh = cube();
        let (middle, _) = bvh.sphere_of_box().expect("facets");
        let camera = Camera::default();
        assert_eq!(seeing(&camera, &bvh, &middle, &Isometry3::identity()), camera);
    }
}
