//! Whether the camera is on the move: while it is, less is drawn, and once it rests, one more picture shows the whole
//! scene.

use super::camera::Camera;

/// A camera that has not moved for so long is at rest: longer than a hand pauses within a drag, or two notches of the
/// wheel are apart, and short enough not to be waited for.
const REST_S: f64 = 0.2;

/// What the camera did of late.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Motion {
    shown: Option<Camera>,
    moved_at_s: Option<f64>,
}

impl Motion {
    /// The camera was put there at once; a cut is no motion.
    pub fn jump(&mut self, camera: &Camera) {
        *self = Self { shown: Some(*camera), moved_at_s: None };
    }

    /// Where the camera is now. Gives the time until it is at rest, if it stays there; `None`: it is.
    pub fn follow(&mut self, camera: &Camera, now_s: f64) -> Option<f64> {
        // A scene that grows moves no camera.
        let moved = self.shown.is_some_and(|shown| Camera { scene_bounds: shown.scene_bounds, ..*camera } != shown);
        self.shown = Some(*camera);
        if moved {
            self.moved_at_s = Some(now_s);
        }
        let left_s = REST_S - (now_s - self.moved_at_s?);
        if left_s <= 0.0 {
            self.moved_at_s = None;
        }
        self.moved_at_s.map(|_| left_s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Bounds;
    use nalgebra::Point3;

    #[test]
    fn moves_until_it_has_stood_still_for_a_while() {
        let mut camera = Camera::default();
        let mut motion = Motion::default();
        assert_eq!(motion.follow(&camera, 1.0), None, "the first picture is whole");
        camera.orbit(3.0, 0.0);
        assert_eq!(motion.follow(&camera, 1.1), Some(REST_S));
        let left_s = motion.follow(&camera, 1.2).expect("a pause within a drag");
        assert!((left_s - (REST_S - 0.1)).abs() < 1e-9);
        assert_eq!(motion.follow(&camera, 1.1 + REST_S + 1e-9), None);
        assert_eq!(motion.follow(&camera, 9.0), None);
    }

    #[test]
    fn neither_a_cut_nor_a_growing_scene_is_motion() {
        let mut camera = Camera::default();
        let mut motion = Motion::default();
        motion.follow(&camera, 0.0);
        camera.orbit(50.0, 0.0);
        motion.jump(&camera);
        assert_eq!(motion.follow(&camera, 0.1), None);
        camera.scene_bounds = Bounds { min: Point3::origin(), max: Point3::new(1.0, 2.0, 3.0) };
        assert_eq!(motion.follow(&camera, 0.2), None);
    }
}
