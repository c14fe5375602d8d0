//! A welded panel before a depth camera (P4, Fig. 10 and 16): a warped skin with an S-shaped bead and, beside it, a ground
//! place of roundish outline; its grey image, its depth image, and the truth about both.
//!
//! Skin, bead and outline are formulas, the images are what rays through the pixels meet first. The bead is 8 to 15 mm
//! wide, 15 mm high at its greatest (the highest of P4), and 26 pixels wide where it is narrowest. The ground place is
//! bright and has no height: P4's case for the spiral. Light with a gradient, a gloss band, scratches and spatter, depth
//! with noise, holes and flying pixels follow from a seed.

mod files;
mod grey_image;
mod measured_depth;
mod panel;
mod seen;

pub use files::{DEPTH_UNITS_PER_MM, camera_toml, depth_png, grey_png, truth_json};
pub use panel::{BEAD_HEIGHT_MM, BEAD_WIDTH_MM, WeldPanel};

use super::FixedNumbers;
use nalgebra::{Isometry3, Point3, Vector3};
use seen::Seen;

/// Width of the images, pixels.
pub const WIDTH: usize = 640;
/// Height of the images, pixels.
pub const HEIGHT: usize = 480;
/// Focal length, pixels: a millimetre at 350 mm takes 3.4 pixels.
pub const FOCAL_PX: f64 = 1200.0;
/// Principal point, pixels; not quite the middle, as with any lens.
pub const PRINCIPAL_PX: [f64; 2] = [322.4, 236.8];
/// Noise of the shipped depth image, mm.
pub const NOISE_MM: f64 = 0.3;
/// Seed of the shipped images.
pub const SEED: u64 = 2012;

/// The panel, the camera before it, and what the camera sees.
#[derive(Clone, Debug)]
pub struct WeldScene {
    /// Skin, bead and ground place.
    pub panel: WeldPanel,
    /// Where the panel stands.
    pub camera_from_panel: Isometry3<f64>,
    /// What each pixel shows, row by row.
    seen: Vec<Seen>,
}

impl Default for WeldScene {
    fn default() -> WeldScene {
        WeldScene::new()
    }
}

impl WeldScene {
    /// The scene of the sample. A fraction of a second.
    pub fn new() -> WeldScene {
        let panel = WeldPanel;
        let camera_from_panel = panel::camera_from_panel();
        let seen = seen::seen(&panel, &camera_from_panel);
        WeldScene { panel, camera_from_panel, seen }
    }

    /// The scene, made once for all tests.
    #[cfg(test)]
    pub fn shared() -> &'static WeldScene {
        static SCENE: std::sync::LazyLock<WeldScene> = std::sync::LazyLock::new(WeldScene::new);
        &SCENE
    }

    /// The two images, row by row: levels from 0 to 255, and depths in tenths of a millimetre, 0 without one.
    /// `noise_mm`: standard deviation of the depth.
    pub fn images(&self, noise_mm: f64, seed: u64) -> (Vec<u8>, Vec<u16>) {
        (grey_image::levels(&self.seen, seed), measured_depth::depths(&self.seen, noise_mm, seed))
    }

    /// Which pixels show the bead, row by row.
    pub fn bead_mask(&self) -> Vec<bool> {
        self.seen.iter().map(|s| s.bead.is_some()).collect()
    }

    /// Which pixels show the ground place, row by row.
    pub fn ground_mask(&self) -> Vec<bool> {
        self.seen.iter().map(|s| s.ground > 0.5).collect()
    }

    /// Exact depth of each pixel, mm, row by row.
    pub fn depths_mm(&self) -> Vec<f64> {
        self.seen.iter().map(|s| s.depth_mm).collect()
    }

    /// How far a point lies above the skin, along its normal, mm; below 0 behind it. Camera frame.
    pub fn height_over_parent_mm(&self, point: &Point3<f64>) -> f64 {
        self.panel.foot(&(self.camera_from_panel.inverse() * point)).height_mm
    }

    /// The skin under a point, whether a bead covers it or not. Camera frame.
    pub fn parent_under(&self, point: &Point3<f64>) -> Point3<f64> {
        let [x, y] = self.panel.foot(&(self.camera_from_panel.inverse() * point)).at;
        self.camera_from_panel * Point3::new(x, y, self.panel.parent(x, y))
    }

    /// The bead's centre line on the skin, from tip to tip, in pieces of equal length along the panel's x; camera frame.
    pub fn centre_line(&self, points: usize) -> Vec<Point3<f64>> {
        let all = self.panel.centre_line(points);
        all.iter().map(|p| self.camera_from_panel * p).collect()
    }

    /// Greatest height of the bead, mm.
    pub fn max_height_mm(&self) -> f64 {
        BEAD_HEIGHT_MM[1]
    }

    /// Median of the bead's widths along its line, mm.
    pub fn width_mm(&self) -> f64 {
        self.panel.median_width_mm()
    }

    /// Length of the bead's centre line on the skin, from tip to tip, mm.
    pub fn length_mm(&self) -> f64 {
        // Chords of 0.1 mm on a line of 50 mm radius: short by 1e-7 of the length.
        let line = self.panel.centre_line(1501);
        line.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }

    /// The way of the light at a pixel, z = 1, camera frame.
    pub fn ray(u: usize, v: usize) -> Vector3<f64> {
        Vector3::new((u as f64 - PRINCIPAL_PX[0]) / FOCAL_PX, (v as f64 - PRINCIPAL_PX[1]) / FOCAL_PX, 1.0)
    }
}

/// Normally distributed numbers of mean 0 and deviation 1.
fn normals(numbers: &mut FixedNumbers, count: usize) -> Vec<f64> {
    let mut all = Vec::with_capacity(count + 2);
    while all.len() < count {
        all.extend(numbers.normal_vector().iter());
    }
    all.truncate(count);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pixel_lies_on_what_it_shows() {
        let scene = WeldScene::shared();
        for (i, seen) in scene.seen.iter().enumerate().step_by(7) {
            let point = Point3::from(WeldScene::ray(i % WIDTH, i / WIDTH) * seen.depth_mm);
            let in_panel = scene.camera_from_panel.inverse() * point;
            let foot = scene.panel.foot(&in_panel);
            let exact = scene.panel.bead_height(foot.at[0], foot.at[1]);
            assert!((scene.height_over_parent_mm(&point) - exact).abs() < 1e-6, "{i}");
            assert_eq!(exact > 0.0, seen.bead.is_some(), "{i} {exact}");
            assert!((scene.parent_under(&point) - point).norm() - exact.abs() < 1e-6);
        }
    }

    #[test]
    fn bead_and_ground_place_lie_apart_inside_of_the_image() {
        let scene = WeldScene::shared();
        let (bead, ground) = (scene.bead_mask(), scene.ground_mask());
        for (i, (b, g)) in bead.iter().zip(&ground).enumerate() {
            let (u, v) = (i % WIDTH, i / WIDTH);
            let at_border = u.min(v).min(WIDTH - 1 - u).min(HEIGHT - 1 - v) < 15;
            assert!(!(*b && *g) && !((*b || *g) && at_border), "{u} {v}");
        }
        let count = |m: &[bool]| m.iter().filter(|x| **x).count();
        assert!(count(&bead) > 15_000 && count(&ground) > 12_000, "{} {}", count(&bead), count(&ground));
        // The bead at its narrowest: across the line, between the rims.
        let narrowest = scene.panel.narrowest_x();
        let across = scene.panel.rims(narrowest).map(|rim| scene.camera_from_panel * rim);
        let pixel = |p: Point3<f64>| [p.x / p.z * FOCAL_PX, p.y / p.z * FOCAL_PX];
        let [a, b] = across.map(pixel);
        let width_px = libm::hypot(a[0] - b[0], a[1] - b[1]);
        assert!(width_px > 25.0, "{width_px}");
    }

    #[test]
    fn the_bead_is_as_wide_and_as_high_as_told() {
        let scene = WeldScene::shared();
        let line = scene.panel.centre_line(4001);
        let inner = line.iter().filter(|p| p.x.abs() < 55.0);
        let widths: Vec<f64> = inner.map(|p| scene.panel.width_mm(p.x)).collect();
        let [least, most] = [f64::min, f64::max].map(|f| widths.iter().copied().fold(widths[0], f));
        assert!((least - BEAD_WIDTH_MM[0]).abs() < 1e-4 && (most - BEAD_WIDTH_MM[1]).abs() < 1e-4, "{least} {most}");
        let heights: Vec<f64> = line.iter().map(|p| scene.panel.bead_height(p.x, p.y)).collect();
        let highest = heights.iter().copied().fold(0.0, f64::max);
        assert!((highest - BEAD_HEIGHT_MM[1]).abs() < 1e-5, "{highest}");
        assert!(heights[0].abs() < 1e-9 && heights[4000].abs() < 1e-9 && heights[100] > 2.0, "{heights:?}");
        // A sine's length in the plane is its chord times 1 + g²/4 − 3g⁴/64, g its steepest slope; the skin adds 0.1 mm.
        let steepest: f64 = 9.0 * std::f64::consts::PI / 70.0;
        let flat_mm = 140.0 * (1.0 + steepest.powi(2) / 4.0 - 3.0 * steepest.powi(4) / 64.0);
        assert!((scene.length_mm() - flat_mm - 0.1).abs() < 0.1, "{} {flat_mm}", scene.length_mm());
    }

    #[test]
    fn images_follow_from_their_seed() {
        let scene = WeldScene::shared();
        let first = scene.images(NOISE_MM, 1);
        assert!(first == scene.images(NOISE_MM, 1));
        assert!(first.0 != scene.images(NOISE_MM, 2).0 && first.1 != scene.images(NOISE_MM, 2).1);
        let holes = first.1.iter().filter(|d| **d == 0).count() as f64 / first.1.len() as f64;
        assert!((holes - 0.03).abs() < 0.002, "{holes}");
        let off =
            first.1.iter().zip(&scene.seen).filter(|(d, _)| **d > 0).map(|(d, s)| f64::from(*d) / 10.0 - s.depth_mm);
        let mut off: Vec<f64> = off.map(f64::abs).collect();
        off.sort_by(f64::total_cmp);
        // The median of the distances of normal numbers is 0.6745 deviations; rounding adds 0.03 mm.
        let sigma = off[off.len() / 2] / 0.6745;
        assert!((sigma - NOISE_MM).abs() < 0.01, "{sigma}");
        assert!(off[off.len() - 20] > 5.0, "there are flying pixels");
    }

    #[test]
    fn the_files_are_small_and_say_what_they_hold() {
        let scene = WeldScene::shared();
        let (grey, depth) = scene.images(NOISE_MM, SEED);
        let sizes = [grey_png(&grey).len(), depth_png(&depth).len()];
        assert!(sizes.iter().sum::<usize>() < 900_000, "{sizes:?}");
        let truth: serde_json::Value = serde_json::from_str(&truth_json(scene)).expect("JSON");
        let number = |key: &str| truth[key].as_f64().expect("a number");
        assert_eq!((number("max_height_mm"), number("least_width_mm"), number("most_width_mm")), (15.0, 8.0, 15.0));
        let widths = (0..=200).map(|k| scene.panel.width_mm(-70.0 + 0.7 * f64::from(k)));
        let below = widths.filter(|w| *w < number("width_mm")).count();
        assert!((98..=103).contains(&below), "half of the widths lie below the median: {below} of 201");
    }
}
