//! The one place where nalgebra (f64, our API) turns into what three-d sends to the graphics
//! card (cgmath, f32).

use super::camera::Camera;
use super::lens::{Projection, ViewSize};
use nalgebra::{Isometry3, Matrix4, Vector3};
use three_d::{Mat4, Vec2, Vec3};

/// What every shader wants to know about the camera, and where the item stands that it draws.
#[derive(Debug, Clone, Copy)]
pub(super) struct CameraUniforms {
    eye_from_scene: Matrix4<f64>,
    /// The item's own coordinates to the eye's.
    pub eye_from_item: Mat4,
    /// The scene's z in the item's frame.
    pub up_in_item: Vec3,
    pub clip_from_eye: Mat4,
    /// Half the size of the view.
    pub half_view_px: Vec2,
    /// Millimetres across one pixel at the depth of the camera's target.
    pub mm_per_px: f64,
    /// Eye z of the near plane, where lines are cut; out of the way in parallel projection,
    /// where nothing lies behind the viewer.
    pub near_z: f32,
    /// Moves a point one pixel's size toward the viewer: as a share of its depth (perspective)
    /// and in mm (parallel). One of them is 0.
    pub nearer_by_one_px: Vec2,
}

impl CameraUniforms {
    pub fn new(camera: &Camera, size: ViewSize) -> Self {
        let mm_per_px = camera.mm_per_px(size);
        let (near_z, nearer_by_one_px) = match camera.projection {
            Projection::Perspective => {
                let share = (mm_per_px / camera.distance_mm) as f32;
                (-camera.near_far_mm().0 as f32, Vec2::new(share, 0.0))
            }
            Projection::Parallel => (1e30, Vec2::new(0.0, mm_per_px as f32)),
        };
        Self {
            eye_from_scene: camera.eye_from_scene(),
            eye_from_item: mat4(&camera.eye_from_scene()),
            up_in_item: Vec3::new(0.0, 0.0, 1.0),
            clip_from_eye: mat4(&camera.clip_from_eye(size)),
            half_view_px: Vec2::new(size.width_px as f32, size.height_px as f32) / 2.0,
            mm_per_px,
            near_z,
            nearer_by_one_px,
        }
    }

    /// For an item that stands there.
    pub fn of_item(&self, scene_from_item: &Isometry3<f64>) -> Self {
        let up = scene_from_item.rotation.inverse() * Vector3::z();
        Self {
            eye_from_item: mat4(&(self.eye_from_scene * scene_from_item.to_homogeneous())),
            up_in_item: Vec3::new(up.x as f32, up.y as f32, up.z as f32),
            ..*self
        }
    }
}

fn mat4(matrix: &Matrix4<f64>) -> Mat4 {
    let columns: [[f32; 4]; 4] = matrix.cast::<f32>().into();
    Mat4::from(columns)
}
