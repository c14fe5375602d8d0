//! The files of the sample: both images as PNG, the camera, and the truth.

use super::{BEAD_HEIGHT_MM, BEAD_WIDTH_MM, FOCAL_PX, HEIGHT, NOISE_MM, PRINCIPAL_PX, WIDTH, WeldScene};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

/// Units of the depth image in a millimetre.
pub const DEPTH_UNITS_PER_MM: f64 = 10.0;

/// The grey image as PNG.
pub fn grey_png(levels: &[u8]) -> Vec<u8> {
    png(levels, ExtendedColorType::L8)
}

/// The depth image as PNG of 16 bits.
pub fn depth_png(depths: &[u16]) -> Vec<u8> {
    let bytes: Vec<u8> = depths.iter().flat_map(|d| d.to_ne_bytes()).collect();
    png(&bytes, ExtendedColorType::L16)
}

/// Empty where the samples are not those of an image of this size.
fn png(samples: &[u8], kind: ExtendedColorType) -> Vec<u8> {
    let mut bytes = Vec::new();
    let expected = WIDTH * HEIGHT * usize::from(kind.bits_per_pixel()) / 8;
    if samples.len() == expected {
        // Memory takes every write, and the size is right.
        let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::Adaptive);
        let _written = encoder.write_image(samples, WIDTH as u32, HEIGHT as u32, kind);
    }
    bytes
}

/// The camera as TOML.
pub fn camera_toml() -> String {
    let [cx, cy] = PRINCIPAL_PX;
    format!(
        "# The camera of gray.png and depth.png: pixels, and s units of the depth image to a millimetre.\n\
         width = {WIDTH}\nheight = {HEIGHT}\nfx = {FOCAL_PX:.1}\nfy = {FOCAL_PX:.1}\ncx = {cx}\ncy = {cy}\n\
         s = {DEPTH_UNITS_PER_MM:.1}\n"
    )
}

/// The truth as JSON: greatest height, median, least and greatest width, length along the centre line, the noise of the depth,
/// the ground place's area in the panel's plane, all of mm or mm²; and `camera_from_panel`, 16 numbers row by row.
pub fn truth_json(scene: &WeldScene) -> String {
    let rows: Vec<f64> = scene.camera_from_panel.to_homogeneous().transpose().iter().copied().collect();
    let line: Vec<[f64; 3]> = scene.centre_line(71).iter().map(|p| [p.x, p.y, p.z]).collect();
    let truth = serde_json::json!({
        "max_height_mm": BEAD_HEIGHT_MM[1],
        "width_mm": scene.width_mm(),
        "least_width_mm": BEAD_WIDTH_MM[0],
        "most_width_mm": BEAD_WIDTH_MM[1],
        "length_mm": scene.length_mm(),
        "noise_mm": NOISE_MM,
        "ground_area_mm2": scene.panel.ground_area_mm2(),
        "centre_line_mm": line,
        "camera_from_panel": rows,
    });
    format!("{truth}\n")
}
