//! The camera's promises: pixel and ray are inverse, a zoom holds its point, a fit contains.

use super::*;

const SIZE: ViewSize = ViewSize { width_px: 1280.0, height_px: 800.0 };
const BOTH: [Projection; 2] = [Projection::Perspective, Projection::Parallel];

fn cameras() -> Vec<Camera> {
    let bounds = Bounds { min: Point3::new(-20.0, 5.0, 0.0), max: Point3::new(60.0, 45.0, 30.0) };
    let mut all = Vec::new();
    for projection in BOTH {
        for view in StandardView::ALL {
            let mut camera = Camera { projection, ..Camera::fitted(bounds, SIZE) };
            camera.look(view);
            camera.fit(&bounds, SIZE);
            all.push(camera);
            camera.orbit(37.0, -12.0);
            camera.pan(55.0, -20.0, SIZE);
            all.push(camera);
        }
    }
    all
}

#[test]
fn ray_passes_through_the_point_seen_at_its_pixel() {
    for camera in cameras() {
        for point in camera.scene_bounds.corners() {
            let (x_px, y_px, _) = camera.project(&point, SIZE).expect("in front of the eye");
            let (origin, dir) = camera.ray_through(Point2::new(x_px, y_px), SIZE);
            let offset = point - origin;
            assert!(offset.dot(&dir) > 0.0, "the point lies before the start of the ray");
            assert!(offset.cross(&dir).norm() < 1e-9, "{camera:?} misses {point}");
        }
    }
}

#[test]
fn projection_matrix_agrees_with_project() {
    for camera in cameras() {
        let clip = camera.clip_from_eye(SIZE) * camera.eye_from_scene();
        for point in camera.scene_bounds.corners() {
            let (x_px, y_px, _) = camera.project(&point, SIZE).expect("in front of the eye");
            let seen = clip * point.to_homogeneous();
            let ndc = seen.xyz() / seen.w;
            assert!(((ndc.x + 1.0) * 640.0 - x_px).abs() < 1e-6);
            assert!(((1.0 - ndc.y) * 400.0 - y_px).abs() < 1e-6);
            assert!(ndc.z.abs() < 1.0, "a corner is clipped: {camera:?}");
        }
    }
}

#[test]
fn zoom_keeps_the_point_under_the_cursor() {
    for camera in cameras() {
        let cursor = Point2::new(900.0, 130.0);
        let mut zoomed = camera;
        zoomed.zoom_at(cursor, 1.7, SIZE);
        assert!((zoomed.distance_mm * 1.7 - camera.distance_mm).abs() < 1e-9);
        // The point on the plane of the target that was under the cursor, seen again.
        let (origin, dir) = camera.ray_through(cursor, SIZE);
        let toward_eye = camera.axes().column(2).into_owned();
        let depth = (camera.target - origin).dot(&toward_eye) / dir.dot(&toward_eye);
        let (x_px, y_px, _) = zoomed.project(&(origin + dir * depth), SIZE).expect("seen");
        assert!(libm::hypot(x_px - cursor.x, y_px - cursor.y) < 1e-6);

        let corner = camera.scene_bounds.max;
        let before = camera.project(&corner, SIZE).expect("seen");
        let mut zoomed = camera;
        zoomed.zoom_about(corner, 0.4);
        let after = zoomed.project(&corner, SIZE).expect("seen");
        assert!(libm::hypot(before.0 - after.0, before.1 - after.1) < 1e-6);
    }
}

#[test]
fn zoom_stops_at_its_limits_and_survives_nonsense() {
    for factor in [1e9, 1e-9, 0.0, f64::NAN, f64::INFINITY, -3.0] {
        let mut camera = cameras()[0];
        for _ in 0..5 {
            camera.zoom_at(Point2::new(3.0, 4.0), factor, SIZE);
        }
        let radius = camera.scene_bounds.radius_mm();
        assert!(camera.distance_mm >= radius * 0.999e-3 && camera.distance_mm <= radius * 60.1);
        assert!(camera.target.coords.iter().all(|value| value.is_finite()));
        let (near_mm, far_mm) = camera.near_far_mm();
        assert!(near_mm > 0.0 && far_mm > near_mm);
    }
}

#[test]
fn fit_contains_the_box_and_fills_the_view() {
    let flat = Bounds { min: Point3::new(0.0, 0.0, 0.0), max: Point3::new(900.0, 10.0, 1.0) };
    let cube = Bounds::default();
    let tall = ViewSize::new(300.0, 900.0);
    for (bounds, size) in [(flat, SIZE), (cube, SIZE), (flat, tall), (cube, tall)] {
        for projection in BOTH {
            for view in StandardView::ALL {
                let mut camera = Camera { projection, scene_bounds: bounds, ..Camera::default() };
                camera.look(view);
                camera.fit(&bounds, size);
                let mut reach = 0.0_f64;
                for corner in bounds.corners() {
                    let (x_px, y_px, _) = camera.project(&corner, size).expect("seen");
                    let off_x = (x_px / size.width_px - 0.5).abs();
                    let off_y = (y_px / size.height_px - 0.5).abs();
                    reach = reach.max(off_x).max(off_y);
                }
                assert!(reach < 0.4301, "{view:?} {projection:?}: reaches {reach}");
                assert!(reach > 0.25, "{view:?} {projection:?}: too small, {reach}");
            }
        }
    }
}

#[test]
fn fit_of_a_single_point_is_finite() {
    let point = Bounds { min: Point3::new(1.0, 2.0, 3.0), max: Point3::new(1.0, 2.0, 3.0) };
    let camera = Camera::fitted(point, SIZE);
    assert!(camera.distance_mm > 0.0 && camera.distance_mm.is_finite());
}

#[test]
fn standard_views_look_where_they_say() {
    let looks = [
        (StandardView::Front, Vector3::y(), Vector3::z()),
        (StandardView::Back, -Vector3::y(), Vector3::z()),
        (StandardView::Left, Vector3::x(), Vector3::z()),
        (StandardView::Right, -Vector3::x(), Vector3::z()),
        (StandardView::Top, -Vector3::z(), Vector3::y()),
        (StandardView::Bottom, Vector3::z(), -Vector3::y()),
    ];
    for (view, forward, up) in looks {
        let mut camera = Camera::default();
        camera.look(view);
        let axes = camera.axes();
        assert!((axes.column(2) + forward).norm() < 1e-12, "{view:?}");
        assert!((axes.column(1) - up).norm() < 1e-12, "{view:?}");
        assert!((axes.determinant() - 1.0).abs() < 1e-12);
    }
    let mut camera = Camera::default();
    camera.look(StandardView::Iso);
    let eye = camera.eye();
    assert!(eye.x > 0.0 && eye.y < 0.0 && eye.z > 0.0, "front, right, above");
}

#[test]
fn blend_goes_the_short_way_round() {
    let (mut from, mut to) = (Camera::default(), Camera::default());
    from.yaw_rad = 3.0;
    to.yaw_rad = -3.0;
    from.distance_mm = 10.0;
    to.distance_mm = 1000.0;
    assert_eq!(Camera::blend(&from, &to, 0.0), from);
    assert_eq!(Camera::blend(&from, &to, 1.0), to);
    let half = Camera::blend(&from, &to, 0.5);
    assert!(half.yaw_rad.abs() > 3.0, "through the back, not through the front");
    assert!((half.distance_mm - 100.0).abs() < 1e-9, "equal ratios");
}

#[test]
fn orbit_stops_exactly_above() {
    let mut camera = Camera::default();
    camera.orbit(0.0, 1e6);
    assert_eq!(camera.pitch_rad, FRAC_PI_2);
    camera.orbit(1e7, -2e6);
    assert_eq!(camera.pitch_rad, -FRAC_PI_2);
    assert!(camera.yaw_rad.abs() <= std::f64::consts::PI);
}
