//! Glides from one view to another, so that the viewer keeps the orientation.

use super::camera::Camera;

/// How long a change of view takes: long enough to follow, short enough not to wait for.
const DURATION_S: f64 = 0.35;

/// A camera on its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    from: Camera,
    to: Camera,
    started_s: f64,
}

impl Flight {
    /// A glide that begins now.
    pub fn new(from: Camera, to: Camera, now_s: f64) -> Self {
        Self { from, to, started_s: now_s }
    }

    /// The camera at its end.
    pub fn destination(&self) -> &Camera {
        &self.to
    }

    /// This glide, ending at another camera.
    pub fn redirected(&self, to: Camera) -> Self {
        Self { to, ..*self }
    }

    /// The camera at a time, and whether the glide has ended.
    pub fn at(&self, now_s: f64) -> (Camera, bool) {
        let t = ((now_s - self.started_s) / DURATION_S).clamp(0.0, 1.0);
        // Starts and stops gently.
        let eased = t * t * (3.0 - 2.0 * t);
        (Camera::blend(&self.from, &self.to, eased), t >= 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::StandardView;

    #[test]
    fn starts_here_and_lands_there() {
        let from = Camera::default();
        let mut to = from;
        to.look(StandardView::Top);
        let flight = Flight::new(from, to, 10.0);
        assert_eq!(flight.at(10.0), (from, false));
        assert!(!flight.at(10.2).1);
        assert_eq!(flight.at(11.0), (to, true));
    }
}
