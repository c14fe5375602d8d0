//! How the grey image is masked: sizes in pixels, levels from 0 to 255.

use super::painted::BrushStroke;

/// How a grey image is masked.
#[derive(Clone, Debug, PartialEq)]
pub struct MaskRules {
    /// Side of the window whose median is the background, pixels; 0: the light is taken as it is. What fills half of a
    /// window counts as background.
    pub even_light_px: u32,
    /// Standard deviation of the smoothing, pixels.
    pub smoothing_px: f64,
    /// How many standard deviations above the main mode the threshold lies.
    pub sigmas: f64,
    /// The threshold by hand, a level of the evened image; `None`: from the histogram.
    pub threshold: Option<f64>,
    /// Diameter of the disc for opening, pixels.
    pub opening_px: u32,
    /// Diameter of the disc for closing, pixels.
    pub closing_px: u32,
    /// Areas of fewer pixels are passed over.
    pub least_area_px: u32,
    /// Strokes of the brush, in their order.
    pub painted: Vec<BrushStroke>,
}

crate::part::keyed!(MaskRules {
    even_light_px,
    smoothing_px,
    sigmas,
    threshold,
    opening_px,
    closing_px,
    least_area_px,
    painted
});

impl Default for MaskRules {
    /// For images of 640 × 480 with beads of 25 to 60 pixels. The window is wide enough that a ground area of 160 pixels
    /// is not taken for background (at 168 it is) and follows a gloss band 100 pixels wide. At 2.5 deviations shading
    /// comes in, at 6 the rims go. Scratches are 1 to 3 pixels wide: a disc of 5 takes them out.
    fn default() -> MaskRules {
        MaskRules {
            even_light_px: 248,
            smoothing_px: 1.2,
            sigmas: 4.0,
            threshold: None,
            opening_px: 5,
            closing_px: 9,
            least_area_px: 200,
            painted: Vec::new(),
        }
    }
}
