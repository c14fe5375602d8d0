//! How a camera projects: rays through pixels, pixels of points, matrices and clip planes.
//!
//! Pixels are physical, from the top-left corner of the view.

use super::camera::{Camera, FOV_Y_RAD};
use super::lens::{Projection, ViewSize};
use nalgebra::{Matrix4, Orthographic3, Perspective3, Point2, Point3, Vector3};

impl Camera {
    /// The ray through a pixel: a point on it (the eye, or in parallel projection a point
    /// before everything that is shown) and its direction, of length 1.
    pub fn ray_through(&self, px: Point2<f64>, size: ViewSize) -> (Point3<f64>, Vector3<f64>) {
        let axes = self.axes();
        let half_height_mm = self.half_height_at_target_mm();
        let right_mm = (2.0 * px.x / size.width_px - 1.0) * half_height_mm * size.aspect();
        let up_mm = (1.0 - 2.0 * px.y / size.height_px) * half_height_mm;
        let across = axes.column(0) * right_mm + axes.column(1) * up_mm;
        let toward_eye = axes.column(2).into_owned();
        match self.projection {
            Projection::Perspective => {
                let dir = across - toward_eye * self.distance_mm;
                (self.eye(), dir.normalize())
            }
            Projection::Parallel => {
                let start_mm = -self.near_far_mm().0;
                (self.eye() + across + toward_eye * start_mm.max(0.0), -toward_eye)
            }
        }
    }

    /// Where a point is seen: pixel x, y, and depth from the eye in mm along the view. `None`
    /// behind the eye.
    pub fn project(&self, point: &Point3<f64>, size: ViewSize) -> Option<(f64, f64, f64)> {
        let offset = self.axes().tr_mul(&(point - self.target));
        let depth_mm = self.distance_mm - offset.z;
        let scale = match self.projection {
            Projection::Perspective if depth_mm <= 0.0 => return None,
            _ => self.px_per_mm(point, size),
        };
        let x_px = size.width_px / 2.0 + offset.x * scale;
        let y_px = size.height_px / 2.0 - offset.y * scale;
        Some((x_px, y_px, depth_mm))
    }

    /// Scale of the picture at the depth of a point; infinite at the eye and behind it.
    pub fn px_per_mm(&self, point: &Point3<f64>, size: ViewSize) -> f64 {
        let at_target = size.height_px / (2.0 * self.half_height_at_target_mm());
        match self.projection {
            Projection::Parallel => at_target,
            Projection::Perspective => {
                let offset_mm = (point - self.target).dot(&self.axes().column(2));
                let depth_mm = self.distance_mm - offset_mm;
                if depth_mm > 0.0 { at_target * self.distance_mm / depth_mm } else { f64::INFINITY }
            }
        }
    }

    /// From the scene to the eye's frame (x right, y up, z toward the viewer).
    pub fn eye_from_scene(&self) -> Matrix4<f64> {
        let rotation = self.axes().transpose();
        rotation.to_homogeneous().prepend_translation(&-self.eye().coords)
    }

    /// From the eye's frame to OpenGL's clip space.
    pub fn clip_from_eye(&self, size: ViewSize) -> Matrix4<f64> {
        let (near_mm, far_mm) = self.near_far_mm();
        match self.projection {
            Projection::Perspective => *Perspective3::new(size.aspect(), FOV_Y_RAD, near_mm, far_mm).as_matrix(),
            Projection::Parallel => {
                let up = self.half_height_at_target_mm();
                let right = up * size.aspect();
                *Orthographic3::new(-right, right, -up, up, near_mm, far_mm).as_matrix()
            }
        }
    }

    /// Clip planes just around the scene, as distances from the eye. The near one may lie
    /// behind the eye in parallel projection.
    pub fn near_far_mm(&self) -> (f64, f64) {
        let radius_mm = self.scene_radius_mm() * 1.02;
        let center_mm = (self.eye() - self.scene_bounds.center()).dot(&self.axes().column(2));
        let far_mm = center_mm + radius_mm;
        let near_mm = center_mm - radius_mm;
        match self.projection {
            Projection::Parallel => (near_mm, far_mm),
            Projection::Perspective => {
                // From inside the scene: near enough to see what is zoomed at, and a ratio that
                // a 24-bit depth buffer still resolves.
                let floor_mm = (self.distance_mm * 0.02).max(far_mm * 2e-5);
                let near_mm = near_mm.max(floor_mm).max(f64::MIN_POSITIVE);
                (near_mm, far_mm.max(near_mm * 2.0))
            }
        }
    }

    /// Millimetres across one pixel at the depth of the target.
    pub fn mm_per_px(&self, size: ViewSize) -> f64 {
        2.0 * self.half_height_at_target_mm() / size.height_px
    }
}
