//! What an export has of a weld beside its program: the mask as a picture, and the points of the beads with their heights.

use crate::planning::welded::{MeasuredWeld, WeldOnPart};
use crate::scan::{Cloud, ply_file};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder as _};
use nalgebra::Point3;

/// Level of a bead's pixels in the mask, and of other areas'.
const BEAD: u8 = 255;
const DEFECT: u8 = 128;

/// The areas as a grey picture of the images' size: white beads, grey areas without height, all else black. Empty where
/// nothing was measured.
pub(super) fn mask_png(measured: &MeasuredWeld) -> Vec<u8> {
    let mut png = Vec::new();
    let Some(first) = measured.areas.first() else { return png };
    let (width, height) = (first.outline.width, first.outline.height);
    let mut levels = vec![0; width * height];
    for area in &measured.areas {
        let level = if area.bead.is_some() { BEAD } else { DEFECT };
        for (into, _) in levels.iter_mut().zip(&area.outline.values).filter(|(_, on)| **on) {
            *into = level;
        }
    }
    let encoder = PngEncoder::new_with_quality(&mut png, CompressionType::Default, FilterType::Adaptive);
    // Memory takes every write, and there are as many levels as pixels.
    let _written = encoder.write_image(&levels, width as u32, height as u32, ExtendedColorType::L8);
    png
}

/// The points of all beads in the part frame, with their heights above the surface that they stand on.
pub(super) fn bead_ply(weld: &WeldOnPart) -> Vec<u8> {
    let points = || weld.measured.areas.iter().filter_map(|area| area.bead.as_ref()).flat_map(|bead| &bead.points);
    let places: Vec<Point3<f64>> = points().map(|p| weld.on.part_from_camera * p.point).collect();
    let heights_mm: Vec<f32> = points().map(|p| p.height_mm as f32).collect();
    ply_file::bytes(&Cloud::of_points(&places), &[("height_mm", &heights_mm)])
}
