//! What the window of the images shows, and what the hand does in it. Nothing here knows of the window itself.

use crate::weld::masking::BrushStroke;

/// Radius of a new brush, px: about that of a narrow bead.
const BRUSH_PX: f64 = 12.0;
/// Middles of a stroke lie at least this share of the brush's radius apart: a capsule joins them without a gap.
const STROKE_SHARE: f64 = 0.25;
/// How far the images can be enlarged, as a multiple of what shows all of them.
const ZOOMS: [f64; 2] = [1.0, 40.0];

/// A step on the way from the grey image to the areas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MaskStep {
    /// The grey image as it was read.
    Gray,
    /// Its light evened out.
    Evened,
    /// The evened image without noise.
    Smoothed,
    /// Pixels above the threshold.
    Above,
    /// Those without specks and scratches.
    Opened,
    /// With small holes filled.
    Closed,
    /// With the strokes of the brush.
    Painted,
    /// The areas that are large enough.
    #[default]
    Areas,
    /// Edges in and around them.
    Edges,
}

impl MaskStep {
    /// All of them, in the order in which they are made.
    pub const ALL: [MaskStep; 9] = [
        MaskStep::Gray,
        MaskStep::Evened,
        MaskStep::Smoothed,
        MaskStep::Above,
        MaskStep::Opened,
        MaskStep::Closed,
        MaskStep::Painted,
        MaskStep::Areas,
        MaskStep::Edges,
    ];
}

/// What a drag with the left button does on the images; the right one does the opposite of a brush.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImageHand {
    /// Shifts them.
    #[default]
    Pan,
    /// Adds to the mask.
    Add,
    /// Takes from it.
    Erase,
}

/// The window of the images.
#[derive(Clone, Debug, PartialEq)]
pub struct ImagesView {
    /// The step that is shown.
    pub step: MaskStep,
    /// What the hand does.
    pub hand: ImageHand,
    /// Radius of the brush, px.
    pub radius_px: f64,
    /// How much larger than whole the images are.
    pub zoom: f64,
    /// The pixel in the middle; `None`: that of the image.
    pub centre_px: Option<[f64; 2]>,
    /// The stroke that is being painted.
    pub stroke: Option<BrushStroke>,
}

impl Default for ImagesView {
    fn default() -> ImagesView {
        ImagesView {
            step: MaskStep::default(),
            hand: ImageHand::default(),
            radius_px: BRUSH_PX,
            zoom: ZOOMS[0],
            centre_px: None,
            stroke: None,
        }
    }
}

impl ImagesView {
    /// Enlarges by a factor; the pixel `at` stays where it is. `size`: of the image, px.
    pub fn zoom_at(&mut self, at: [f64; 2], factor: f64, size: [usize; 2]) {
        let zoom = (self.zoom * factor).clamp(ZOOMS[0], ZOOMS[1]);
        let (shrinks, centre) = (self.zoom / zoom, self.middle(size));
        self.centre_px = (zoom > ZOOMS[0]).then(|| [0, 1].map(|k| at[k] + (centre[k] - at[k]) * shrinks));
        self.zoom = zoom;
    }

    /// Shifts by so many pixels; the image stays in sight.
    pub fn shift(&mut self, by_px: [f64; 2], size: [usize; 2]) {
        let centre = self.middle(size);
        self.centre_px = Some([0, 1].map(|k| (centre[k] - by_px[k]).clamp(0.0, size[k] as f64)));
    }

    /// The pixel in the middle.
    pub fn middle(&self, size: [usize; 2]) -> [f64; 2] {
        self.centre_px.unwrap_or(size.map(|n| 0.5 * (n as f64 - 1.0)))
    }

    /// The brush goes to a pixel; `adds`: what a stroke that begins there does.
    pub fn brush_to(&mut self, at: [f64; 2], adds: bool) {
        let radius_px = self.radius_px;
        let stroke = self.stroke.get_or_insert_with(|| BrushStroke { way_px: Vec::new(), radius_px, adds });
        let far = |last: &[f64; 2]| {
            let [x, y] = [at[0] - last[0], at[1] - last[1]];
            let least = (STROKE_SHARE * radius_px).max(1.0);
            x * x + y * y >= least * least
        };
        if stroke.way_px.last().is_none_or(far) {
            stroke.way_px.push(at.map(|x| (x * 10.0).round() * 0.1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pixel_under_the_cursor_stays_and_whole_images_stand_in_the_middle() {
        let (mut view, size) = (ImagesView::default(), [640, 480]);
        view.zoom_at([100.0, 50.0], 4.0, size);
        let [u, v] = view.middle(size);
        // A quarter as far from the middle as before.
        assert!((u - (100.0 + 219.5 / 4.0)).abs() < 1e-9 && (v - (50.0 + 189.5 / 4.0)).abs() < 1e-9);
        view.zoom_at([3.0, 3.0], 1e-3, size);
        assert_eq!((view.zoom, view.middle(size)), (1.0, [319.5, 239.5]));
    }

    #[test]
    fn a_stroke_keeps_its_sense_and_is_no_denser_than_it_need_be() {
        let mut view = ImagesView::default();
        for k in 0..100 {
            view.brush_to([f64::from(k) * 0.5, 7.0], k == 0);
        }
        let stroke = view.stroke.expect("begun");
        assert!(stroke.adds && stroke.way_px.len() < 20 && stroke.way_px.len() > 12, "{stroke:?}");
    }
}
