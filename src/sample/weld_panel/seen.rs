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
/// Halvings of such a step: to 1e-9 mm.
const HALVINGS: usize = 30;
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
        let gap = |depth: f64| {
            let foot = panel.foot(&(camera + ray * depth));
            foot.height_mm - panel.bead_height(foot.at[0], foot.at[1])
        };
        let count = (HIGHEST_MM / (ray.z.abs() * STEP_MM)).ceil() as usize;
        let met = (0..count).rev().map(|k| depth_mm - k as f64 * STEP_MM).find(|d| gap(*d) < -1e-9);
        if let Some(inside) = met {
            let (mut above, mut below) = (inside - STEP_MM, inside);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (above + below);
                *(if gap(middle) < 0.0 { &mut below } else { &mut above }) = middle;
            }
            depth_mm = below;
        }
    }
    let at = panel.foot(&(camera + ray * depth_mm)).at;
    let bead = panel.on_bead(at[0], at[1]);
    let ground = (0.5 + panel.inside_ground_mm(at[0], at[1]) / FADE_MM).clamp(0.0, 1.0);
    Seen { depth_mm, at, bead, ground }
}

fn is_near_bead(panel: &WeldPanel, skin: &Point3<f64>) -> bool {
    let near = |dy: f64, dx: f64| panel.on_bead(skin.x + dx, skin.y + dy).is_some();
    let steps = [-ASIDE_MM, -0.5 * ASIDE_MM, 0.0, 0.5 * ASIDE_MM, ASIDE_MM];
    steps.iter().any(|dy| steps.iter().any(|dx| near(*dy, *dx)))
}
