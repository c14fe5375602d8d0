//! What each pixel of the camera shows: the first place that its ray meets.

use super::panel::{OnBead, WeldPanel};
use super::{HEIGHT, WIDTH, WeldScene};
use nalgebra::{Isometry3, Point3, Vector3};
use rayon::prelude::*;

/// Nothing stands higher over the skin, mm.
const HIGHEST_MM: f64 = 15.5;
/// Steps along the ray in which the bead is looked for, mm of depth: a ray that grazes the bead over less is taken not to
/// meet it.
const STEP_MM: f64 = 0.5;
/// Two steps of the projection are right to this, mm.
const ROUGH_MM: f64 = 1e-3;
/// A place on the bead is right to this, mm.
const FOUND_MM: f64 = 1e-11;
/// A ray whose place on the skin is so far off the bead's box meets no bead: over 15 mm it moves 5 mm aside at most.
const ASIDE_MM: f64 = 8.0;
/// Over this width the ground place's rim fades in, mm.
const FADE_MM: f64 = 0.3;

/// What a pixel shows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) depth_mm: f64,
    /// Place on the skin, panel frame, mm.
    pub(super) at: [f64; 2],
    pub(super) bead: Option<OnBead>,
    /// Share of the pixel that is ground, 0 to 1.
    pub(super) ground: f64,
}

pub(super) fn seen(panel: &WeldPanel, camera_from_panel: &Isometry3<f64>) -> Vec<Seen> {
    let to_panel = camera_from_panel.inverse();
    let camera = to_panel * Point3::origin();
    let of = |i: usize| first_met(panel, &camera, &(to_panel * WeldScene::ray(i % WIDTH, i / WIDTH)));
    (0..WIDTH * HEIGHT).into_par_iter().map(of).collect()
}

/// The first place of a ray, whose length is 1 along the camera's axis.
fn first_met(panel: &WeldPanel, camera: &Point3<f64>, ray: &Vector3<f64>) -> Seen {
    let mut depth_mm = -camera.z / ray.z;
    for _ in 0..8 {
        let p = camera + ray * depth_mm;
        let (z, [a, b]) = panel.skin(p.x, p.y);
        depth_mm -= (p.z - z) / (ray.z - a * ray.x - b * ray.y);
    }
    let skin = camera + ray * depth_mm;
    if is_near_bead(panel, &skin) {
        // Above the bead the gap is positive.
        let gap = |depth: f64, steps: usize| {
            let foot = panel.foot_after(&(camera + ray * depth), steps);
            foot.height_mm - panel.bead_height(foot.at[0], foot.at[1])
        };
        let count = (HIGHEST_MM / (ray.z.abs() * STEP_MM)).ceil() as usize;
        let met = (1..count).rev().map(|k| depth_mm - k as f64 * STEP_MM).find(|d| gap(*d, 2) < -ROUGH_MM);
        // Where the skin itself is under the bead, however thin it is there, the bead is met before.
        let met = met.or((gap(depth_mm, 7) < 0.0).then_some(depth_mm));
        if let Some(inside) = met {
            // The step before may have been inside by less than was looked for.
            depth_mm = zero([inside - 1.1 * STEP_MM, inside], |d| gap(d, 7));
        }
    }
    let at = panel.foot(&(camera + ray * depth_mm)).at;
    let bead = panel.on_bead(at[0], at[1]);
    let ground = (0.5 + panel.inside_ground_mm(at[0], at[1]) / FADE_MM).clamp(0.0, 1.0);
    Seen { depth_mm, at, bead, ground }
}

/// Where a falling function is 0: by secants, of which none stays at one end (Dowell and Jarratt 1971, "Illinois").
fn zero([mut a, mut b]: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    let (mut at_a, mut at_b) = (value(a), value(b));
    for _ in 0..60 {
        if at_a <= 0.0 || at_b >= 0.0 {
            break;
        }
        let c = b - at_b * (b - a) / (at_b - at_a);
        let at_c = value(c);
        if at_c.abs() < FOUND_MM {
            return c;
        }
        if at_c > 0.0 {
            (a, at_a, at_b) = (c, at_c, 0.5 * at_b);
        } else {
            (b, at_b, at_a) = (c, at_c, 0.5 * at_a);
        }
    }
    if at_a <= 0.0 { a } else { b }
}

fn is_near_bead(panel: &WeldPanel, skin: &Point3<f64>) -> bool {
    let near = |dy: f64, dx: f64| panel.on_bead(skin.x + dx, skin.y + dy).is_some();
    let steps = [-ASIDE_MM, -0.5 * ASIDE_MM, 0.0, 0.5 * ASIDE_MM, ASIDE_MM];
    steps.iter().any(|dy| steps.iter().any(|dx| near(*dy, *dx)))
}
