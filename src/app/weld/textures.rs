//! The images of a weld on the graphics card: each is made when it is first shown, and kept while it stays.

use super::images::MaskStep;
use crate::picture::weld_image::{DepthScale, areas_pixels, depth_pixels, gray_pixels, mask_pixels};
use crate::planning::welded::ReadWeld;
use crate::weld::masking::MaskedImage;
use crate::weld::raster::Raster;
use eframe::egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
use std::sync::Arc;

/// Images that are shown side by side.
pub(in super::super) struct ImageTextures {
    of: Arc<ReadWeld>,
    /// The grey image.
    pub gray: TextureHandle,
    /// Depths in false colours.
    pub depth: TextureHandle,
    /// Those colours.
    pub scale: DepthScale,
    step: Option<StepTexture>,
}

/// A step of the mask.
struct StepTexture {
    of: Arc<MaskedImage>,
    step: MaskStep,
    texture: TextureHandle,
    is_gray: bool,
}

impl ImageTextures {
    /// The textures of images; those that are known are kept.
    pub fn synced(
        known: Option<ImageTextures>,
        read: &Arc<ReadWeld>,
        masked: Option<&Arc<MaskedImage>>,
        step: MaskStep,
        ctx: &Context,
    ) -> ImageTextures {
        let mut textures = known.filter(|t| Arc::ptr_eq(&t.of, read)).unwrap_or_else(|| {
            let scale = DepthScale::of(&read.depth, read.camera.units_per_mm);
            ImageTextures {
                of: read.clone(),
                gray: upload(ctx, "gray", &gray_pixels(&read.grey)),
                depth: upload(ctx, "depth", &depth_pixels(&read.depth, &scale)),
                scale,
                step: None,
            }
        });
        let Some(masked) = masked else { return textures };
        let is_known = |s: &StepTexture| s.step == step && Arc::ptr_eq(&s.of, masked);
        if textures.step.as_ref().is_some_and(is_known) {
            return textures;
        }
        let (pixels, is_gray) = match step {
            MaskStep::Gray => {
                textures.step = None;
                return textures;
            }
            MaskStep::Evened => (gray_pixels(&masked.evened), true),
            MaskStep::Smoothed => (gray_pixels(&masked.smoothed), true),
            MaskStep::Above => (mask_pixels(&masked.above_threshold), false),
            MaskStep::Opened => (mask_pixels(&masked.opened), false),
            MaskStep::Closed => (mask_pixels(&masked.closed), false),
            MaskStep::Painted => (mask_pixels(&masked.painted), false),
            MaskStep::Areas => (areas_pixels(&masked.areas), false),
            MaskStep::Edges => (mask_pixels(&masked.edges), false),
        };
        let texture = upload(ctx, "step", &pixels);
        textures.step = Some(StepTexture { of: masked.clone(), step, texture, is_gray });
        textures
    }

    /// What lies under the mask on the left: the grey image, or a step of it.
    pub fn left(&self) -> &TextureHandle {
        self.step.as_ref().filter(|s| s.is_gray).map_or(&self.gray, |s| &s.texture)
    }

    /// What is drawn over both.
    pub fn mask(&self) -> Option<&TextureHandle> {
        self.step.as_ref().filter(|s| !s.is_gray).map(|s| &s.texture)
    }
}

/// Images that are larger than the card takes are shown coarser.
fn upload(ctx: &Context, name: &str, pixels: &Raster<[u8; 4]>) -> TextureHandle {
    let most = ctx.input(|i| i.max_texture_side).max(1);
    let step = pixels.width.max(pixels.height).div_ceil(most).max(1);
    let size = [pixels.width.div_ceil(step), pixels.height.div_ceil(step)];
    let at = |i: usize| pixels.at(i % size[0].max(1) * step, i / size[0].max(1) * step).copied().unwrap_or_default();
    let color = |[r, g, b, a]: [u8; 4]| Color32::from_rgba_unmultiplied(r, g, b, a);
    let image = ColorImage::new(size, (0..size[0] * size[1]).map(|i| color(at(i))).collect());
    ctx.load_texture(format!("weld {name}"), image, TextureOptions::NEAREST)
}
