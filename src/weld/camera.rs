//! The camera as a pinhole with the distortion of Brown and Conrady, as OpenCV writes its figures: a pixel's ray, and the
//! pixel of a point (P4, Eq. 5, which has no distortion).
//!
//! With r² = x² + y² of a point (x, y, 1): x' = x·(1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2 (r² + 2 x²), y' likewise,
//! u = fx x' + cx, v = fy y' + cy. The way back has no closed form. A polynomial that bends back (barrel distortion of a
//! lens that was calibrated for less) has several rays for one pixel, or none; only the one that belongs to the image's
//! middle counts, and a pixel beyond where the polynomial turns has no ray.

use nalgebra::{Matrix2, Point3, Vector2, Vector3};
use thiserror::Error;

/// Newton's steps for a ray. Distortion of shipped lenses takes 3 to 5; near the turning point convergence is slower.
const MOST_STEPS: usize = 30;
/// A ray is found when its pixel is so near, in units of the focal length: 1e-9 pixels at 1000 pixels.
const FOUND: f64 = 1e-12;
/// The principal point of a camera lies so near to the image's middle, as a share of the image's sides. Lenses sit within a
/// few hundredths; that of a camera with half the resolution is a quarter off, with twice the resolution a half.
const MOST_OFF_MIDDLE: f64 = 0.2;
/// Focal lengths in widths of the image: 0.2 is a view of 136°, 20 one of 3°. Depth cameras have 0.5 to 3.
const FOCAL_IN_WIDTHS: [f64; 2] = [0.2, 20.0];

/// A camera's figures, as calibrations give them.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthCamera {
    /// Width of its images, pixels; `None` where the file does not say.
    pub width: Option<usize>,
    /// Height of its images, pixels.
    pub height: Option<usize>,
    /// Focal length along u, pixels.
    pub fx: f64,
    /// Focal length along v, pixels.
    pub fy: f64,
    /// u of the principal point, pixels.
    pub cx: f64,
    /// v of the principal point, pixels.
    pub cy: f64,
    /// Units of the depth image in a millimetre, s: z = d / s (P4, Eq. 5).
    pub units_per_mm: f64,
    /// Radial distortion, of r².
    pub k1: f64,
    /// Radial distortion, of r⁴.
    pub k2: f64,
    /// Tangential distortion.
    pub p1: f64,
    /// Tangential distortion.
    pub p2: f64,
    /// Radial distortion, of r⁶.
    pub k3: f64,
}

/// Why a camera's figures cannot be right.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum CameraFault {
    /// A figure that must be above 0 is not, or one is not finite.
    #[error("{key} = {value}")]
    Figure {
        /// Its key in the camera file.
        key: &'static str,
        /// What it is.
        value: f64,
    },
    /// It is for images of another size.
    #[error("camera of {camera:?}, image of {image:?}")]
    Size {
        /// Width and height in the camera file, pixels; 0 where it does not say.
        camera: [usize; 2],
        /// Those of the image.
        image: [usize; 2],
    },
    /// Its principal point lies far from the image's middle: intrinsics of another camera.
    #[error("principal point {principal_px:?}, image of {image:?}")]
    OffMiddle {
        /// The principal point.
        principal_px: [f64; 2],
        /// Width and height of the image.
        image: [usize; 2],
    },
    /// Its focal length is none of an image of this width: intrinsics of another camera.
    #[error("focal length {focal_px} px, image {width} px wide")]
    Focal {
        /// The focal length.
        focal_px: f64,
        /// Width of the image.
        width: usize,
    },
}

impl DepthCamera {
    /// A camera without distortion, of one unit to the millimetre.
    pub fn pinhole(fx: f64, fy: f64, cx: f64, cy: f64) -> DepthCamera {
        let (k1, k2, p1, p2, k3) = (0.0, 0.0, 0.0, 0.0, 0.0);
        DepthCamera { width: None, height: None, fx, fy, cx, cy, units_per_mm: 1.0, k1, k2, p1, p2, k3 }
    }

    /// Its figures with their keys in the camera file.
    pub fn figures(&self) -> [(&'static str, f64); 10] {
        let DepthCamera { fx, fy, cx, cy, units_per_mm, k1, k2, p1, p2, k3, .. } = *self;
        let lens = [("fx", fx), ("fy", fy), ("cx", cx), ("cy", cy), ("s", units_per_mm)];
        let distortion = [("k1", k1), ("k2", k2), ("p1", p1), ("p2", p2), ("k3", k3)];
        std::array::from_fn(|i| if i < 5 { lens[i] } else { distortion[i - 5] })
    }

    /// # Errors
    /// [`CameraFault::Figure`]: the figures are those of no camera.
    pub fn check(&self) -> Result<(), CameraFault> {
        let is_wrong = |key: &str, x: f64| !x.is_finite() || (matches!(key, "fx" | "fy" | "s") && x <= 0.0);
        let wrong = self.figures().into_iter().find(|(key, x)| is_wrong(key, *x));
        wrong.map_or(Ok(()), |(key, value)| Err(CameraFault::Figure { key, value }))
    }

    /// Whether an image of this size, in pixels, can be this camera's.
    ///
    /// # Errors
    /// It is not, or the figures are those of no camera.
    pub fn fits(&self, width: usize, height: usize) -> Result<(), CameraFault> {
        self.check()?;
        let image = [width, height];
        if self.width.is_some_and(|w| w != width) || self.height.is_some_and(|h| h != height) {
            let camera = [self.width.unwrap_or(0), self.height.unwrap_or(0)];
            return Err(CameraFault::Size { camera, image });
        }
        let off = |c: f64, side: usize| ((c + 0.5) / side as f64 - 0.5).abs() > MOST_OFF_MIDDLE;
        if off(self.cx, width) || off(self.cy, height) {
            return Err(CameraFault::OffMiddle { principal_px: [self.cx, self.cy], image });
        }
        let [least, most] = FOCAL_IN_WIDTHS.map(|f| f * width as f64);
        match [self.fx, self.fy].into_iter().find(|f| !(least..=most).contains(f)) {
            Some(focal_px) => Err(CameraFault::Focal { focal_px, width }),
            None => Ok(()),
        }
    }

    /// The ray of a place in the image, z = 1, camera frame. `None`: the distortion leads no ray there.
    pub fn ray(&self, u: f64, v: f64) -> Option<Vector3<f64>> {
        let seen = Vector2::new((u - self.cx) / self.fx, (v - self.cy) / self.fy);
        let mut at = seen;
        if self.has_distortion() {
            // Newton's steps are halved until they come nearer and stay where the polynomial still rises.
            let mut apart = (self.distorted(at) - seen).norm();
            if !self.rises_to(at) {
                (at, apart) = (Vector2::zeros(), (self.distorted(Vector2::zeros()) - seen).norm());
            }
            for _ in 0..MOST_STEPS {
                if apart <= FOUND {
                    break;
                }
                let step = self.jacobian(at).try_inverse()? * (seen - self.distorted(at));
                let tries = std::iter::successors(Some(1.0), |s| Some(0.5 * s)).take(20).map(|s| at + step * s);
                let nearer = |p: &Vector2<f64>| self.rises_to(*p) && (self.distorted(*p) - seen).norm() < apart;
                at = tries.into_iter().find(nearer)?;
                apart = (self.distorted(at) - seen).norm();
            }
            if apart > FOUND {
                return None;
            }
        }
        at.iter().all(|x| x.is_finite()).then(|| Vector3::new(at.x, at.y, 1.0))
    }

    /// The place in the image of a point in the camera frame, pixels; it may lie outside. `None`: the point is not in front
    /// of the camera, or so far aside that the distortion leads it back into the image.
    pub fn pixel_of(&self, point: &Point3<f64>) -> Option<[f64; 2]> {
        if point.z.is_nan() || point.z <= 0.0 {
            return None;
        }
        let at = Vector2::new(point.x / point.z, point.y / point.z);
        let seen = self.distorted(at);
        let pixel = [self.fx * seen.x + self.cx, self.fy * seen.y + self.cy];
        (pixel.iter().all(|x| x.is_finite()) && self.rises_to(at)).then_some(pixel)
    }

    /// The depth of a value of the depth image, mm; `None` where it has none.
    pub fn depth_mm(&self, units: f32) -> Option<f64> {
        Some(f64::from(units) / self.units_per_mm).filter(|z| z.is_finite() && *z > 0.0)
    }

    fn has_distortion(&self) -> bool {
        [self.k1, self.k2, self.p1, self.p2, self.k3].iter().any(|k| *k != 0.0)
    }

    fn distorted(&self, p: Vector2<f64>) -> Vector2<f64> {
        let (x, y, r2) = (p.x, p.y, p.norm_squared());
        let radial = 1.0 + r2 * (self.k1 + r2 * (self.k2 + r2 * self.k3));
        let (p1, p2) = (self.p1, self.p2);
        Vector2::new(
            x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
            y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y,
        )
    }

    fn jacobian(&self, p: Vector2<f64>) -> Matrix2<f64> {
        let (x, y, r2) = (p.x, p.y, p.norm_squared());
        let radial = 1.0 + r2 * (self.k1 + r2 * (self.k2 + r2 * self.k3));
        // Half of its derivative by x is x times this.
        let growth = self.k1 + r2 * (2.0 * self.k2 + r2 * 3.0 * self.k3);
        let cross = 2.0 * (x * y * growth + self.p1 * x + self.p2 * y);
        Matrix2::new(
            radial + 2.0 * x * x * growth + 2.0 * self.p1 * y + 6.0 * self.p2 * x,
            cross,
            cross,
            radial + 2.0 * y * y * growth + 6.0 * self.p1 * y + 2.0 * self.p2 * x,
        )
    }

    /// Whether the radial distortion r·(1 + k1 r² + …) rises from the middle up to here, and nothing is mirrored here: its
    /// slope, a cubic in r², is least at an end or where the slope of that is 0.
    fn rises_to(&self, p: Vector2<f64>) -> bool {
        let far = p.norm_squared();
        let [a, b, c] = [3.0 * self.k1, 5.0 * self.k2, 7.0 * self.k3];
        let slope = |s: f64| 1.0 + s * (a + s * (b + s * c));
        let root = (4.0 * b * b - 12.0 * a * c).max(0.0).sqrt();
        // Both forms of the quadratic's roots, so that one that is nearly linear loses no digits.
        let q = if b < 0.0 { 2.0 * b - root } else { 2.0 * b + root };
        let flat = [-q / (6.0 * c), -2.0 * a / q];
        let inside = flat.into_iter().filter(|s| *s > 0.0 && *s < far);
        inside.chain([far]).all(|s| slope(s) > 0.0) && self.jacobian(p).determinant() > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn lens() -> DepthCamera {
        DepthCamera {
            k1: -0.32,
            k2: 0.11,
            p1: 0.0007,
            p2: -0.0004,
            k3: -0.01,
            ..DepthCamera::pinhole(580.0, 583.0, 321.7, 236.2)
        }
    }

    #[test]
    fn a_pinhole_is_equation_5() {
        let camera = DepthCamera { units_per_mm: 10.0, ..DepthCamera::pinhole(500.0, 400.0, 320.0, 240.0) };
        assert_eq!(camera.ray(420.0, 200.0), Some(Vector3::new(0.2, -0.1, 1.0)));
        assert_eq!(camera.pixel_of(&Point3::new(20.0, -10.0, 100.0)), Some([420.0, 200.0]));
        assert_eq!(camera.pixel_of(&Point3::new(20.0, -10.0, -100.0)), None);
        assert_eq!([1000.0, 0.0, f32::NAN, f32::INFINITY].map(|d| camera.depth_mm(d)), [Some(100.0), None, None, None]);
    }

    /// Pixels as OpenCV's `projectPoints` (4.14) tells them for the same lens, and slopes by differences.
    #[test]
    fn distortion_is_that_of_opencv() {
        let camera = lens();
        let told = [
            ([30.0, -20.0, 100.0], [488.66060322, 124.35004730199996]),
            ([-52.0, 38.0, 100.0], [54.25804867977263, 432.7478286324508]),
            ([5.0, 41.0, 90.0], [351.8749991025017, 485.4035325179864]),
        ];
        for (point, [u, v]) in told {
            let pixel = camera.pixel_of(&Point3::from(point)).expect("in front");
            assert!((pixel[0] - u).abs() < 1e-9 && (pixel[1] - v).abs() < 1e-9, "{pixel:?} {u} {v}");
        }
        let [x, y] = [0.3, -0.2];
        let at = Vector2::new(x, y);
        for (k, step) in [Vector2::new(1e-6, 0.0), Vector2::new(0.0, 1e-6)].into_iter().enumerate() {
            let slope = (camera.distorted(at + step) - camera.distorted(at - step)) / 2e-6;
            assert!((slope - camera.jacobian(at).column(k)).norm() < 1e-9);
        }
    }

    proptest! {
        #[test]
        fn a_point_lies_on_its_pixels_ray(x in -0.55..0.55f64, y in -0.42..0.42f64, z in 100.0..2000.0f64) {
            let camera = lens();
            let [u, v] = camera.pixel_of(&Point3::new(x * z, y * z, z)).expect("in front");
            let ray = camera.ray(u, v).expect("a ray");
            prop_assert!((ray - Vector3::new(x, y, 1.0)).norm() < 1e-10, "{ray}");
        }

        #[test]
        fn a_ray_is_right_or_none(
            k in prop::array::uniform3(-2.0..2.0f64), p in prop::array::uniform2(-0.05..0.05f64),
            u in -100.0..740.0f64, v in -100.0..580.0f64,
        ) {
            let [k1, k2, k3] = k;
            let camera = DepthCamera { k1, k2, k3, p1: p[0], p2: p[1], ..DepthCamera::pinhole(400.0, 400.0, 320.0, 240.0) };
            if let Some(ray) = camera.ray(u, v) {
                let [a, b] = camera.pixel_of(&Point3::from(ray)).expect("it has a pixel");
                prop_assert!((a - u).abs() < 1e-8 && (b - v).abs() < 1e-8, "{a} {b}");
            }
        }
    }

    /// r (1 − r²) is greatest at r² = 1/3, where it is 0.385: no ray leads to 0.39, and 0.38 has that on the rising side.
    #[test]
    fn beyond_the_turning_point_there_is_no_ray() {
        let camera = DepthCamera { k1: -1.0, ..DepthCamera::pinhole(100.0, 100.0, 0.0, 0.0) };
        assert_eq!(camera.ray(39.0, 0.0), None);
        let x = camera.ray(38.0, 0.0).expect("a ray").x;
        assert!((x * (1.0 - x * x) - 0.38).abs() < 1e-11 && x < 0.5774, "{x}");
        assert_eq!(camera.pixel_of(&Point3::new(0.6, 0.0, 1.0)), None);
    }

    #[test]
    fn intrinsics_of_another_camera_are_told() {
        let camera = DepthCamera::pinhole(525.0, 525.0, 319.5, 239.5);
        assert_eq!(camera.fits(640, 480), Ok(()));
        assert!(matches!(camera.fits(1280, 960), Err(CameraFault::OffMiddle { .. })));
        assert!(matches!(DepthCamera { fx: 100.0, ..camera.clone() }.fits(640, 480), Err(CameraFault::Focal { .. })));
        let sized = DepthCamera { width: Some(640), height: Some(480), ..camera.clone() };
        assert_eq!(sized.fits(640, 400), Err(CameraFault::Size { camera: [640, 480], image: [640, 400] }));
        assert!(camera.fits(0, 0).is_err());
        let wrong = DepthCamera { units_per_mm: 0.0, ..camera };
        assert_eq!(wrong.check(), Err(CameraFault::Figure { key: "s", value: 0.0 }));
    }
}
