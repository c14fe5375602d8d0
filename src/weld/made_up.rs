//! A warped panel with a bead on it, as a depth camera sees it: for tests, all by formula.
//!
//! The panel is a cylinder of 1500 mm radius, warped by 1.5 mm; the bead's centre line is 12 sin(x / 60), its section a cap
//! 12 mm wide, its height 4 to 15 mm. Noise, 3 % holes in blobs, 5 % flying pixels at the edge.

use super::camera::DepthCamera;
use super::parent::ParentSurface;
use super::points::PixelPoint;
use super::raster::{Mask, Raster};
use crate::scan::made_up::Sequence;
use nalgebra::{Point3, Vector3};

const WIDTH: usize = 640;
const HEIGHT: usize = 480;
const FAR_MM: f64 = 500.0;
pub const BEAD_MM: f64 = 12.0;
pub const LENGTH_MM: f64 = 260.0;

/// What the camera would see without noise. Panel frame: x right, y down, heights towards the camera, which is 500 mm off.
pub struct Scene {
    pub camera: DepthCamera,
    pub mask: Mask,
    depths: Vec<f64>,
    /// Moves the bead along the panel, mm.
    shift_mm: f64,
    /// What stands higher was ground off, mm; below 0: into the panel.
    level_mm: f64,
}

pub struct Noise {
    pub seed: u64,
    pub depth_mm: f64,
}

pub fn line_y(x: f64) -> f64 {
    12.0 * libm::sin(x / 60.0)
}

pub fn parent(x: f64, y: f64) -> f64 {
    -x * x / 3000.0 + 1.5 * libm::sin(x / 90.0 + 0.4) * libm::cos(y / 110.0)
}

/// Height of the bead over its centre line; `t` is x there.
pub fn profile(t: f64) -> f64 {
    let arch = libm::sin(std::f64::consts::PI * (t + LENGTH_MM / 2.0) / LENGTH_MM).clamp(0.0, 1.0);
    4.0 + 11.0 * libm::pow(arch, 1.5) + 0.25 * libm::sin(t / 1.9)
}

/// Height of the bead over the panel; `None` beside it.
fn bead(x: f64, y: f64) -> Option<f64> {
    if (y - line_y(x)).abs() > BEAD_MM || x.abs() > LENGTH_MM / 2.0 + BEAD_MM {
        return None;
    }
    let mut t = x;
    for _ in 0..4 {
        let (f, g) = (line_y(t), 0.2 * libm::cos(t / 60.0));
        t -= ((t - x) + (f - y) * g) / (1.0 + g * g);
    }
    let share = 2.0 * libm::hypot(x - t, y - line_y(t)) / BEAD_MM;
    (t.abs() < LENGTH_MM / 2.0 && share < 1.0).then(|| profile(t) * (1.0 - share * share))
}

impl Scene {
    /// 0.83 mm a pixel.
    pub fn coarse() -> Scene {
        Scene::of_size(600.0, 0.0, [WIDTH, HEIGHT], f64::INFINITY)
    }

    /// The bead leaves the image on the right.
    pub fn leaving() -> Scene {
        Scene::of_size(1200.0, 30.0, [WIDTH, HEIGHT], f64::INFINITY)
    }

    /// 0.42 mm a pixel, all of the bead.
    pub fn fine() -> Scene {
        Scene::ground(f64::INFINITY)
    }

    /// The fine one, ground down to a level above the panel.
    pub fn ground(level_mm: f64) -> Scene {
        Scene::of_size(1200.0, 0.0, [1000, 480], level_mm)
    }

    fn of_size(focal: f64, shift_mm: f64, [width, height]: [usize; 2], level_mm: f64) -> Scene {
        let middle = [width, height].map(|side| side as f64 / 2.0 - 0.5);
        let camera = DepthCamera { units_per_mm: 10.0, ..DepthCamera::pinhole(focal, focal, middle[0], middle[1]) };
        let mut scene = Scene {
            camera,
            mask: Raster { width, height, values: Vec::new() },
            depths: Vec::new(),
            shift_mm,
            level_mm,
        };
        for i in 0..width * height {
            let ray = scene.ray(i % width, i / width);
            let (z, on_bead) = scene.hit(ray.x, ray.y);
            scene.depths.push(z);
            scene.mask.values.push(on_bead);
        }
        scene
    }

    fn ray(&self, u: usize, v: usize) -> Vector3<f64> {
        self.camera.ray(u as f64, v as f64).expect("a pinhole has all rays")
    }

    fn hit(&self, a: f64, b: f64) -> (f64, bool) {
        let depth = |z: f64| {
            let (x, y) = (a * z, b * z);
            let over = bead(x - self.shift_mm, y).map(|h| h.min(self.level_mm));
            (FAR_MM - parent(x, y) - over.unwrap_or(0.0), over.is_some())
        };
        let mut z = FAR_MM;
        for _ in 0..6 {
            z = FAR_MM - parent(a * z, b * z);
        }
        if (b * z - line_y(a * z - self.shift_mm)).abs() > BEAD_MM + 6.0 {
            return (z, false);
        }
        let (mut near, mut far) = (z - 17.0, z - 17.0);
        while far < depth(far).0 {
            (near, far) = (far, far + 0.5);
        }
        for _ in 0..20 {
            let middle = 0.5 * (near + far);
            if middle < depth(middle).0 { near = middle } else { far = middle }
        }
        (far, depth(far).1)
    }

    pub fn points(&self, noise: &Noise) -> Vec<PixelPoint> {
        let Raster { width, height, .. } = self.mask;
        let mut random = Sequence::new(noise.seed);
        let blobs: Vec<[f64; 2]> = (0..(width * height) / 1000)
            .map(|_| [random.uniform() * width as f64, random.uniform() * height as f64])
            .collect();
        let mut holes = vec![false; width * height];
        for [u, v] in blobs {
            for i in 0..100 {
                let (du, dv) = ((i % 10) as f64 - 4.5, (i / 10) as f64 - 4.5);
                if du * du + dv * dv < 9.6
                    && (0.0..width as f64).contains(&(u + du))
                    && (0.0..height as f64).contains(&(v + dv))
                {
                    holes[(v + dv) as usize * width + (u + du) as usize] = true;
                }
            }
        }
        let mut points = Vec::new();
        for (i, &z) in self.depths.iter().enumerate() {
            let (u, v) = (i % width, i / width);
            let beside = |du: isize, dv: isize| {
                let (u, v) = (u.saturating_add_signed(du).min(width - 1), v.saturating_add_signed(dv).min(height - 1));
                self.mask.values[v * width + u] != self.mask.values[i]
            };
            let is_edge = (-1..=1).any(|du| (-1..=1).any(|dv| beside(du, dv)));
            let mut z = z + noise.depth_mm * random.normal();
            if is_edge && random.uniform() < 0.05 {
                z += random.uniform() * 20.0 - 15.0;
            }
            let z = (z * self.camera.units_per_mm).round() / self.camera.units_per_mm;
            if !holes[i] {
                points.push(PixelPoint { pixel: [u as u32, v as u32], point: Point3::from(self.ray(u, v) * z) });
            }
        }
        points
    }

    /// The camera's view of a place of the panel.
    pub fn in_camera(&self, x: f64, y: f64, height: f64) -> Point3<f64> {
        Point3::new(x, y, FAR_MM - parent(x, y) - height)
    }

    pub fn rms_under_bead_mm(&self, surface: &ParentSurface) -> f64 {
        let mut squares = Vec::new();
        for i in -125..=125 {
            for j in -5..=5 {
                let x = f64::from(i) + self.shift_mm;
                let foot = surface.foot(&self.in_camera(x, line_y(f64::from(i)) + f64::from(j), 0.0));
                squares.push(foot.height_mm * foot.height_mm);
            }
        }
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    }
}
