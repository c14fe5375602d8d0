//! The shape of the panel by formula: skin, bead and the outline of the ground place. Panel frame: x along the bead, y
//! across, z out of the skin towards the camera, mm. Heights are along the skin's normal; a place of the skin is told by
//! its x and y.

use nalgebra::{Isometry3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};

/// Least and greatest height of the bead along its middle, mm; the tips run out.
pub const BEAD_HEIGHT_MM: [f64; 2] = [4.5, 15.0];
/// Least and greatest width of the bead, mm; the tips are rounded.
pub const BEAD_WIDTH_MM: [f64; 2] = [8.0, 15.0];
/// Radius of the skin, mm.
const SKIN_RADIUS_MM: f64 = 1500.0;
/// Height of its warp, mm.
const WARP_MM: f64 = 1.5;
/// The bead reaches so far to both sides of x = 0, mm.
const HALF_LENGTH_MM: f64 = 70.0;
/// Swing of the S to both sides, mm, and where its middle lies: with the ground place's rim some 40 mm away, so that a
/// disc of 60 mm fits between.
const SWING_MM: f64 = 9.0;
const LINE_Y_MM: f64 = -34.0;
/// Middle of the ground place, its half axes (44 × 40 mm), mm, and their turn.
const GROUND_AT_MM: [f64; 2] = [10.0, 42.0];
const GROUND_AXES_MM: [f64; 2] = [22.0, 20.0];
const GROUND_TURN: f64 = 0.5;
/// Where the camera stands: distance to the panel's middle, mm, and turns about its x, y and z.
const DISTANCE_MM: f64 = 350.0;
const TURNS: [f64; 3] = [0.06, -0.045, 0.03];
/// Steps of the projection onto the skin. Its radius is 80 times the height of anything here, so each takes two digits.
const STEPS: usize = 7;

/// The panel of the sample.
#[derive(Clone, Copy, Debug)]
pub struct WeldPanel;

/// The nearest place of the skin.
#[derive(Clone, Copy, Debug)]
pub struct SkinFoot {
    /// Its x and y, mm.
    pub at: [f64; 2],
    /// How far off it the point is, mm; below 0 inside of the panel.
    pub height_mm: f64,
}

/// A place by its bead.
#[derive(Clone, Copy, Debug)]
pub struct OnBead {
    /// x of the nearest place of the centre line, mm.
    pub x: f64,
    /// Distance from the centre line, above 0 towards y, mm.
    pub across_mm: f64,
    /// 0 on the centre line, 1 on the rim.
    pub share: f64,
    /// How high the bead stands there, mm.
    pub height_mm: f64,
}

/// Where the sample's panel stands before the camera: z of the panel looks back to it.
pub(super) fn camera_from_panel() -> Isometry3<f64> {
    let [x, y, z] = TURNS;
    let facing = Rotation3::from_matrix_unchecked(nalgebra::Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0)));
    let turn = UnitQuaternion::from_euler_angles(x, y, z) * UnitQuaternion::from_rotation_matrix(&facing);
    Isometry3::from_parts(Translation3::new(0.0, 0.0, DISTANCE_MM), turn)
}

impl WeldPanel {
    /// Height of the skin over the panel's plane, mm: a cylinder with a warp on it.
    pub fn parent(&self, x: f64, y: f64) -> f64 {
        self.skin(x, y).0
    }

    /// Height of the skin, and its slopes along x and y.
    pub(super) fn skin(&self, x: f64, y: f64) -> (f64, [f64; 2]) {
        let ((sin_x, cos_x), (sin_y, cos_y)) = (libm::sincos(x / 90.0 + 0.4), libm::sincos(y / 110.0));
        let z = -x * x / (2.0 * SKIN_RADIUS_MM) + WARP_MM * sin_x * cos_y;
        (z, [-x / SKIN_RADIUS_MM + WARP_MM / 90.0 * cos_x * cos_y, -WARP_MM / 110.0 * sin_x * sin_y])
    }

    /// The place of the skin whose normal leads to a point.
    pub fn foot(&self, point: &Point3<f64>) -> SkinFoot {
        self.foot_after(point, STEPS)
    }

    /// The place that so many steps of the projection lead to.
    pub(super) fn foot_after(&self, point: &Point3<f64>, steps: usize) -> SkinFoot {
        let [mut x, mut y] = [point.x, point.y];
        for _ in 0..steps {
            // The point is put onto the plane that touches the skin, and its place there is the next one.
            let (z, [a, b]) = self.skin(x, y);
            let off = (point.z - z - a * (point.x - x) - b * (point.y - y)) / (1.0 + a * a + b * b);
            (x, y) = (point.x + a * off, point.y + b * off);
        }
        let off = Vector3::new(point.x - x, point.y - y, point.z - self.parent(x, y));
        SkinFoot { at: [x, y], height_mm: off.norm().copysign(off.z) }
    }

    /// y of the centre line: one period of a sine.
    pub fn line_y(&self, x: f64) -> f64 {
        LINE_Y_MM + SWING_MM * libm::sin(PI * x / HALF_LENGTH_MM)
    }

    fn line_slope(&self, x: f64) -> f64 {
        SWING_MM * PI / HALF_LENGTH_MM * libm::cos(PI * x / HALF_LENGTH_MM)
    }

    /// Points of the centre line on the skin, from tip to tip, evenly along x.
    pub fn centre_line(&self, points: usize) -> Vec<Point3<f64>> {
        let last = points.saturating_sub(1).max(1) as f64;
        let at = |k: usize| HALF_LENGTH_MM * (2.0 * k as f64 / last - 1.0);
        (0..points).map(at).map(|x| (x, self.line_y(x))).map(|(x, y)| Point3::new(x, y, self.parent(x, y))).collect()
    }

    /// Median of the widths along the line, mm.
    pub fn median_width_mm(&self) -> f64 {
        let at = |k: i32| self.width_mm(HALF_LENGTH_MM * (f64::from(k) / 500.0 - 1.0));
        let mut all: Vec<f64> = (0..=1000).map(at).collect();
        all.sort_by(f64::total_cmp);
        all[500]
    }

    /// Width of the bead where its centre line has this x, mm, between its rims; the tips' rounding left aside.
    pub fn width_mm(&self, x: f64) -> f64 {
        let [least, most] = BEAD_WIDTH_MM;
        let share = 0.5 * (1.0 + x / HALF_LENGTH_MM);
        0.5 * (least + most) + 0.5 * (most - least) * libm::sin(1.25 * TAU * share - 0.9)
    }

    /// x at which the bead is narrowest, mm.
    pub fn narrowest_x(&self) -> f64 {
        let share = (1.5 * PI + 0.9) / (1.25 * TAU);
        HALF_LENGTH_MM * (2.0 * share - 1.0)
    }

    /// Both rims of the bead where its centre line has this x.
    pub fn rims(&self, x: f64) -> [Point3<f64>; 2] {
        let (slope, half) = (self.line_slope(x), 0.5 * self.width_mm(x));
        let across = 1.0 / (1.0 + slope * slope).sqrt();
        [-half, half].map(|d| {
            let (x, y) = (x - d * slope * across, self.line_y(x) + d * across);
            Point3::new(x, y, self.parent(x, y))
        })
    }

    /// Height of the bead along its middle, mm.
    fn height_mm(&self, x: f64) -> f64 {
        let [least, most] = BEAD_HEIGHT_MM;
        let off = (0.5 * (1.0 + x / HALF_LENGTH_MM) - 0.36) / 0.5;
        let hump = (1.0 - off * off).max(0.0);
        least + (most - least) * hump * hump
    }

    /// A place of the skin by the bead; `None` off it.
    pub fn on_bead(&self, x: f64, y: f64) -> Option<OnBead> {
        if x.abs() > HALF_LENGTH_MM + 1.0 || (y - LINE_Y_MM).abs() > SWING_MM + BEAD_WIDTH_MM[1] {
            return None;
        }
        // The line's radius is 55 mm or more, the bead 7.5 mm to either side: the steps lead to the nearest place.
        let mut t = x;
        for _ in 0..6 {
            let (off, slope) = (self.line_y(t) - y, self.line_slope(t));
            t -= (t - x + off * slope) / (1.0 + slope * slope);
        }
        let t = t.clamp(-HALF_LENGTH_MM, HALF_LENGTH_MM);
        let slope = self.line_slope(t);
        let stretch = (1.0 + slope * slope).sqrt();
        let across_mm = ((y - self.line_y(t)) - (x - t) * slope) / stretch;
        let along_mm = ((x - t) + (y - self.line_y(t)) * slope) / stretch;
        let half = 0.5 * self.width_mm(t);
        // Tips are half ellipses: from half a width before the end on, the way along counts as well.
        let to_end = (HALF_LENGTH_MM - t.abs()) * stretch;
        let tip = 0.5 * self.width_mm(HALF_LENGTH_MM.copysign(t));
        let beyond = (tip - to_end).max(0.0) + along_mm.abs();
        let squared = (across_mm / half) * (across_mm / half) + (beyond / tip) * (beyond / tip);
        let height_mm = self.height_mm(t) * (1.0 - squared);
        (height_mm > 0.0).then(|| OnBead { x: t, across_mm, share: squared.sqrt(), height_mm })
    }

    /// Height of the bead over a place of the skin, mm; 0 off it.
    pub fn bead_height(&self, x: f64, y: f64) -> f64 {
        self.on_bead(x, y).map_or(0.0, |on| on.height_mm)
    }

    /// How far inside of the ground place a place of the skin is, mm; below 0 outside.
    pub fn inside_ground_mm(&self, x: f64, y: f64) -> f64 {
        let [dx, dy] = [x - GROUND_AT_MM[0], y - GROUND_AT_MM[1]];
        let (s, c) = (libm::sin(GROUND_TURN), libm::cos(GROUND_TURN));
        let [a, b] = [(c * dx + s * dy) / GROUND_AXES_MM[0], (c * dy - s * dx) / GROUND_AXES_MM[1]];
        let (radius, angle) = (libm::hypot(a, b), libm::atan2(b, a));
        let rim = 1.0 + 0.05 * libm::sin(3.0 * angle + 1.0) + 0.025 * libm::sin(5.0 * angle + 2.0);
        (rim - radius) * GROUND_AXES_MM[1]
    }

    /// Area of the ground place in the panel's plane, mm²: π a b (1 + (0.05² + 0.025²) / 2).
    pub fn ground_area_mm2(&self) -> f64 {
        PI * GROUND_AXES_MM[0] * GROUND_AXES_MM[1] * (1.0 + 0.5 * (0.05 * 0.05 + 0.025 * 0.025))
    }

    /// Middle of the ground place on the skin.
    pub fn ground_middle(&self) -> Point3<f64> {
        let [x, y] = GROUND_AT_MM;
        Point3::new(x, y, self.parent(x, y))
    }
}
