//! The eye: a turntable camera (z stays up) that orbits a target, in perspective or parallel.
//!
//! All in f64 and free of OpenGL. Here is how it moves; how it projects is in `projecting`,
//! gliding in [`super::flight`], gestures in [`super::widget`].

use super::bounds::Bounds;
use super::lens::{Projection, ViewSize};
use super::standard_view::StandardView;
use nalgebra::{Matrix3, Point2, Point3, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Vertical opening of the view. 30° keeps a part in proportion; 60° bulges it.
pub(super) const FOV_Y_RAD: f64 = std::f64::consts::PI / 6.0;
/// A fitted box leaves this share of the view free on each side.
const FIT_MARGIN: f64 = 0.08;
/// Nearest and farthest eye, as multiples of the radius of the scene: from a weld pore filling
/// the window on a car door, to a door of the size of a pea.
const DISTANCE_RANGE: [f64; 2] = [1e-3, 60.0];
/// Turn per point of a drag, 0.4°: half a turn takes half a laptop screen.
const ORBIT_RAD_PER_STEP: f64 = 0.4 * std::f64::consts::PI / 180.0;

/// Where the eye is and what it can see.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// The point in the middle of the view, mm.
    pub target: Point3<f64>,
    /// From the eye to the target; in parallel projection it only sets the scale.
    pub distance_mm: f64,
    /// Turn of the eye around z: 0 looks along +y, a quarter turn along -x.
    pub yaw_rad: f64,
    /// Height of the eye: a quarter turn is straight above.
    pub pitch_rad: f64,
    /// How depth looks.
    pub projection: Projection,
    /// Everything there is to see: the clip planes are laid around it and it limits the zoom.
    pub scene_bounds: Bounds,
}

impl Camera {
    /// An iso view of the box.
    pub fn fitted(bounds: Bounds, size: ViewSize) -> Self {
        let mut camera = Self { scene_bounds: bounds, ..Self::default() };
        camera.fit(&bounds, size);
        camera
    }

    /// Turns by a drag of so many points; right turns the part to the right, down tips its top
    /// towards the viewer. Stops exactly above and below.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        self.yaw_rad = wrap_turn(self.yaw_rad - dx * ORBIT_RAD_PER_STEP);
        self.pitch_rad = (self.pitch_rad + dy * ORBIT_RAD_PER_STEP).clamp(-FRAC_PI_2, FRAC_PI_2);
    }

    /// Shifts the view so that what is at the target's depth follows the cursor.
    pub fn pan(&mut self, dx_px: f64, dy_px: f64, size: ViewSize) {
        let mm_per_px = 1.0 / self.px_per_mm(&self.target, size);
        let axes = self.axes();
        self.target += (axes.column(1) * dy_px - axes.column(0) * dx_px) * mm_per_px;
    }

    /// Zooms in (factor > 1) or out at the cursor, taking what is there to lie at the target's
    /// depth. Use [`Self::zoom_about`] when the point under the cursor is known.
    pub fn zoom_at(&mut self, cursor_px: Point2<f64>, factor: f64, size: ViewSize) {
        let (origin, dir) = self.ray_through(cursor_px, size);
        let toward_eye = self.axes().column(2).into_owned();
        let depth = (self.target - origin).dot(&toward_eye) / dir.dot(&toward_eye);
        self.zoom_about(origin + dir * depth, factor);
    }

    /// Zooms in (factor > 1) or out; the point keeps its place in the picture.
    pub fn zoom_about(&mut self, fixed: Point3<f64>, factor: f64) {
        let [nearest, farthest] = DISTANCE_RANGE.map(|multiple| multiple * self.scene_radius_mm());
        let wanted = self.distance_mm / factor;
        let distance = if wanted.is_finite() { wanted } else { self.distance_mm };
        let distance = distance.clamp(nearest, farthest);
        // Shrinking the whole eye-and-target frame about the point leaves every ray to it.
        self.target = fixed + (self.target - fixed) * (distance / self.distance_mm);
        self.distance_mm = distance;
    }

    /// Keeps the direction and moves so that the whole box is seen.
    pub fn fit(&mut self, bounds: &Bounds, size: ViewSize) {
        let axes = self.axes();
        let tan_y = libm::tan(FOV_Y_RAD / 2.0) * (1.0 - 2.0 * FIT_MARGIN);
        let tan_x = tan_y * size.aspect();
        self.target = bounds.center();
        let needed_mm = bounds
            .corners()
            .iter()
            .map(|corner| {
                let offset = axes.tr_mul(&(corner - self.target));
                let toward_eye = match self.projection {
                    Projection::Perspective => offset.z,
                    Projection::Parallel => 0.0,
                };
                toward_eye + (offset.x.abs() / tan_x).max(offset.y.abs() / tan_y)
            })
            .fold(0.0, f64::max);
        let [nearest, farthest] = DISTANCE_RANGE.map(|multiple| multiple * self.scene_radius_mm());
        self.distance_mm = needed_mm.clamp(nearest, farthest.max(needed_mm));
    }

    /// Turns to a standard view; target and distance stay.
    pub fn look(&mut self, view: StandardView) {
        (self.yaw_rad, self.pitch_rad) = view.angles_rad();
    }

    /// Between two cameras: `t` = 0 is `from`, 1 is `to`. Turns the short way round and scales
    /// by equal ratios, so that a long zoom does not rush at one end.
    pub fn blend(from: &Self, to: &Self, t: f64) -> Self {
        if t <= 0.0 {
            return *from;
        }
        if t >= 1.0 {
            return *to;
        }
        let mix = |a: f64, b: f64| a + (b - a) * t;
        Self {
            target: from.target + (to.target - from.target) * t,
            distance_mm: libm::exp(mix(libm::log(from.distance_mm), libm::log(to.distance_mm))),
            yaw_rad: wrap_turn(from.yaw_rad + wrap_turn(to.yaw_rad - from.yaw_rad) * t),
            pitch_rad: mix(from.pitch_rad, to.pitch_rad),
            ..*to
        }
    }

    /// Place of the eye.
    pub fn eye(&self) -> Point3<f64> {
        self.target + self.axes().column(2) * self.distance_mm
    }

    /// Columns: right, up and toward the eye, in the scene's frame.
    pub fn axes(&self) -> Matrix3<f64> {
        let (sin_yaw, cos_yaw) = libm::sincos(self.yaw_rad);
        let (sin_pitch, cos_pitch) = libm::sincos(self.pitch_rad);
        Matrix3::from_columns(&[
            Vector3::new(cos_yaw, sin_yaw, 0.0),
            Vector3::new(-sin_yaw * sin_pitch, cos_yaw * sin_pitch, cos_pitch),
            Vector3::new(sin_yaw * cos_pitch, -cos_yaw * cos_pitch, sin_pitch),
        ])
    }

    pub(super) fn half_height_at_target_mm(&self) -> f64 {
        self.distance_mm * libm::tan(FOV_Y_RAD / 2.0)
    }

    pub(super) fn scene_radius_mm(&self) -> f64 {
        self.scene_bounds.radius_mm().max(1e-3)
    }
}

impl Default for Camera {
    /// An iso view of an empty scene, as large as a hand.
    fn default() -> Self {
        let (yaw_rad, pitch_rad) = StandardView::Iso.angles_rad();
        Self {
            target: Point3::origin(),
            distance_mm: 400.0,
            yaw_rad,
            pitch_rad,
            projection: Projection::default(),
            scene_bounds: Bounds::default(),
        }
    }
}

/// The angle of the same direction that is within half a turn of zero.
fn wrap_turn(angle_rad: f64) -> f64 {
    angle_rad - TAU * (angle_rad / TAU).round()
}

#[cfg(test)]
#[path = "camera_tests.rs"]
mod tests;
