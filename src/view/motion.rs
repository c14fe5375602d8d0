//! Whether what is seen is on the move: while it is, less is drawn, and once it rests, one more picture shows the whole
//! scene.

use super::camera::Camera;

/// What has not moved for so long is at rest: longer than a hand pauses within a drag, or two notches of the wheel are
/// apart, and short enough not to be waited for.
const REST_S: f64 = 0.2;

/// What camera and scene did of late.
#[derive(Debug, Clone, Default)]
pub(super) struct Motion {
    shown: Option<(Camera, Vec<u64>)>,
    moved_at_s: Option<f64>,
}

impl Motion {
    /// The camera was put there at once; a cut is no motion.
    pub fn jump(&mut self) {
        *self = Self::default();
    }

    /// Where the camera is now, and the stamp of the scene: one that is played, or coloured otherwise while a number is
    /// dragged, moves as well. Gives the time until all is at rest, if it stays so; `None`: it is.
    pub fn follow(&mut self, camera: &Camera, stamp: Vec<u64>, now_s: f64) -> Option<f64> {
        let now = (*camera, stamp);
        let moved = self.shown.as_ref().is_some_and(|(shown, stamp)| {
            // The same scene may be given more room without being seen otherwise.
            Camera { scene_bounds: shown.scene_bounds, ..now.0 } != *shown || *stamp != now.1
        });
        self.shown = Some(now);
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
        assert_eq!(motion.follow(&camera, vec![], 1.0), None, "the first picture is whole");
        camera.orbit(3.0, 0.0);
        assert_eq!(motion.follow(&camera, vec![], 1.1), Some(REST_S));
        let left_s = motion.follow(&camera, vec![], 1.2).expect("a pause within a drag");
        assert!((left_s - (REST_S - 0.1)).abs() < 1e-9);
        assert_eq!(motion.follow(&camera, vec![], 1.1 + REST_S + 1e-9), None);
        assert_eq!(motion.follow(&camera, vec![], 9.0), None);
    }

    #[test]
    fn a_scene_that_changes_moves() {
        let camera = Camera::default();
        let mut motion = Motion::default();
        motion.follow(&camera, vec![7], 1.0);
        assert_eq!(motion.follow(&camera, vec![8], 1.1), Some(REST_S));
        assert_eq!(motion.follow(&camera, vec![8], 1.1 + REST_S + 1e-9), None);
    }

    #[test]
    fn neither_a_cut_nor_more_room_is_motion() {
        let mut camera = Camera::default();
        let mut motion = Motion::default();
        motion.follow(&camera, vec![], 0.0);
        camera.orbit(50.0, 0.0);
        motion.jump();
        assert_eq!(motion.follow(&camera, vec![], 0.1), None);
        camera.scene_bounds = Bounds { min: Point3::origin(), max: Point3::new(1.0, 2.0, 3.0) };
        assert_eq!(motion.follow(&camera, vec![], 0.2), None);
    }
}
