//! The dose and the angle of incidence on the part, as coloured samples with their legend. The window
//! and `render` share it.

use super::colormap::viridis;
use super::legend::{Legend, LegendEntry, Quantity};
use super::palette::{Rgb, mixed, state};
use crate::part::{Hasher, Surfaces};
use crate::process::{DoseMap, DoseSample, DoseVerdict};
use crate::view::MeshItem;
use nalgebra::Isometry3;
use std::sync::Arc;

/// What is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DoseLook {
    /// Energy per area.
    Dose,
    /// Angle between light and normal.
    Incidence,
}

/// Where nothing lands.
pub const UNLIT: Rgb = [120, 122, 126];
/// More than the window allows.
pub const OVER: Rgb = [226, 58, 38];
/// A chosen surface that gets too little because too little light comes.
pub const UNDER: Rgb = [30, 32, 36];
/// A chosen surface that gets too little because something shades it.
pub const SHADED: Rgb = state::MISSED;

/// The legend of a look.
pub fn legend(map: &DoseMap, look: DoseLook) -> Legend {
    let t = &map.thresholds;
    let no_light = (LegendEntry::NoLight, UNLIT);
    match look {
        DoseLook::Dose => Legend {
            marks: vec![0.0, t.low_j_cm2, t.high_j_cm2],
            entries: vec![
                (LegendEntry::Over, OVER),
                (LegendEntry::Under, UNDER),
                (LegendEntry::Shaded, SHADED),
                no_light,
            ],
            ..Legend::new(Quantity::Dose, [0.0, t.high_j_cm2], |dose| viridis(share(map, dose)))
        },
        // Bright is upright.
        DoseLook::Incidence => Legend {
            marks: vec![0.0, 30.0, 60.0, 90.0],
            entries: vec![no_light],
            ..Legend::new(Quantity::Incidence, [0.0, 90.0], |deg| viridis(1.0 - deg / 90.0))
        },
    }
}

/// Share of the colour map for a dose: 1 at the greatest dose that is allowed.
fn share(map: &DoseMap, dose: f64) -> f64 {
    dose / map.thresholds.high_j_cm2
}

/// All samples in the colours of a look.
pub fn dose_item(map: &DoseMap, surfaces: &Surfaces, look: DoseLook) -> MeshItem {
    let mut chosen = vec![false; map.samples.len()];
    for (i, ..) in map.chosen_samples(surfaces) {
        chosen[i] = true;
    }
    let (mut colors, mut positions) = (Vec::new(), Vec::new());
    for (s, chosen) in map.samples.iter().zip(&chosen) {
        let [r, g, b] = color(map, s, *chosen, look);
        let corners = map.corners_of(s);
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            positions.extend([corners[0], pair[0], pair[1]]);
            colors.push([r, g, b, 255]);
        }
    }
    let bits: Vec<u32> = positions.iter().flatten().map(|x: &f32| x.to_bits()).collect();
    let flat: Vec<u32> = colors.iter().map(|c: &[u8; 4]| u32::from_le_bytes(*c)).collect();
    MeshItem {
        geometry_key: Hasher::default().u32s(&bits).finish().0 as u64,
        positions: Arc::new(positions),
        colors_key: Hasher::default().u32s(&flat).finish().0 as u64,
        facet_colors: Arc::new(colors),
        edges: None,
        scene_from_item: Isometry3::identity(),
    }
}

fn color(map: &DoseMap, s: &DoseSample, chosen: bool, look: DoseLook) -> Rgb {
    let dose = f64::from(s.fluence_j_cm2);
    match look {
        DoseLook::Incidence if s.incidence_deg < 0.0 => UNLIT,
        DoseLook::Incidence => viridis(1.0 - f64::from(s.incidence_deg) / 90.0),
        DoseLook::Dose => match map.verdict(s) {
            DoseVerdict::Over => OVER,
            DoseVerdict::Shaded if chosen => SHADED,
            DoseVerdict::Under if chosen => {
                // The nearer to the window, the more of the scale shows through.
                mixed(UNDER, viridis(share(map, dose)), (dose / map.thresholds.low_j_cm2) as f32 * 0.5)
            }
            _ if dose < 0.02 * map.thresholds.low_j_cm2 => UNLIT,
            _ => viridis(share(map, dose)),
        },
    }
}
