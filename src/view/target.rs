//! Where a picture is drawn: a framebuffer, multisampled unless it is in a hurry, and the plain one it is resolved into.
//!
//! Plain glow instead of three-d's render targets: those make and delete a framebuffer object
//! at every use and hide the one that the window must copy from.

use super::error::{DriverObject, ViewError};
use std::sync::Arc;
use three_d::context::{self as gl, HasContext as _};

/// Samples per pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Smoothing {
    /// Four make edges and thin lines calm; more cost software OpenGL dearly.
    Four,
    /// One: in a third of the time, for pictures that are gone in a moment.
    One,
}

/// One size of picture.
pub(super) struct RenderTarget {
    gl: Arc<gl::Context>,
    size_px: [u32; 2],
    smoothing: Smoothing,
    drawn: gl::Framebuffer,
    resolved: gl::Framebuffer,
    renderbuffers: [gl::Renderbuffer; 3],
}

impl RenderTarget {
    /// Allocates; the size must be at least 1 × 1 and within the driver's limit.
    pub fn new(gl: &Arc<gl::Context>, size_px: [u32; 2], smoothing: Smoothing) -> Result<Self, ViewError> {
        let refuse = |reason: String| ViewError::Driver { what: DriverObject::Framebuffer, reason };
        // SAFETY: fresh objects of a current context; the caller holds a SavedState, which
        // undoes the bindings. Objects leak on the error path, which ends the 3D view anyway.
        unsafe {
            let samples = match smoothing {
                Smoothing::Four => gl.get_parameter_i32(gl::MAX_SAMPLES).min(4),
                Smoothing::One => 0,
            };
            let drawn = gl.create_framebuffer().map_err(refuse)?;
            let resolved = gl.create_framebuffer().map_err(refuse)?;
            let [color, depth, plain] = [
                gl.create_renderbuffer().map_err(refuse)?,
                gl.create_renderbuffer().map_err(refuse)?,
                gl.create_renderbuffer().map_err(refuse)?,
            ];
            let uses = [
                (drawn, color, samples, gl::RGBA8, gl::COLOR_ATTACHMENT0),
                (drawn, depth, samples, gl::DEPTH_COMPONENT24, gl::DEPTH_ATTACHMENT),
                (resolved, plain, 0, gl::RGBA8, gl::COLOR_ATTACHMENT0),
            ];
            let [width_px, height_px] = size_px.map(|px| px as i32);
            for (framebuffer, buffer, samples, format, attachment) in uses {
                gl.bind_renderbuffer(gl::RENDERBUFFER, Some(buffer));
                gl.renderbuffer_storage_multisample(gl::RENDERBUFFER, samples, format, width_px, height_px);
                gl.bind_framebuffer(gl::FRAMEBUFFER, Some(framebuffer));
                gl.framebuffer_renderbuffer(gl::FRAMEBUFFER, attachment, gl::RENDERBUFFER, Some(buffer));
            }
            let renderbuffers = [color, depth, plain];
            let target = Self { gl: Arc::clone(gl), size_px, smoothing, drawn, resolved, renderbuffers };
            for framebuffer in [drawn, resolved] {
                gl.bind_framebuffer(gl::FRAMEBUFFER, Some(framebuffer));
                let status = gl.check_framebuffer_status(gl::FRAMEBUFFER);
                if status != gl::FRAMEBUFFER_COMPLETE {
                    return Err(ViewError::Framebuffer { status, size_px });
                }
            }
            Ok(target)
        }
    }

    pub fn size_px(&self) -> [u32; 2] {
        self.size_px
    }

    pub fn is(&self, size_px: [u32; 2], smoothing: Smoothing) -> bool {
        (self.size_px, self.smoothing) == (size_px, smoothing)
    }

    /// Makes the multisampled framebuffer the one that is drawn into, with depth cleared. The
    /// background covers all colours, so those are not cleared.
    pub fn begin(&self) {
        let gl = &self.gl;
        let [width_px, height_px] = self.size_px.map(|px| px as i32);
        // SAFETY: our own framebuffer; the caller's SavedState puts back what is bound here.
        unsafe {
            gl.bind_framebuffer(gl::FRAMEBUFFER, Some(self.drawn));
            gl.disable(gl::SCISSOR_TEST);
            gl.disable(gl::FRAMEBUFFER_SRGB);
            gl.viewport(0, 0, width_px, height_px);
            gl.depth_mask(true);
            gl.clear(gl::DEPTH_BUFFER_BIT);
        }
    }

    /// Averages the samples into the plain framebuffer.
    pub fn resolve(&self) {
        let whole = [0, 0, self.size_px[0] as i32, self.size_px[1] as i32];
        // SAFETY: our own framebuffers, of equal size and format.
        unsafe {
            self.gl.disable(gl::SCISSOR_TEST);
            self.copy(self.drawn, Some(self.resolved), whole);
        }
    }

    /// Copies the resolved picture to a rectangle (from the bottom-left, as OpenGL counts) of a
    /// framebuffer, within the scissor that is set.
    pub fn blit_to(&self, framebuffer: Option<gl::Framebuffer>, rect_px: [i32; 4]) {
        // SAFETY: `framebuffer` was bound by our caller, so it exists.
        unsafe { self.copy(self.resolved, framebuffer, rect_px) }
    }

    /// The resolved picture, 4 bytes per pixel, bottom row first.
    pub fn read(&self) -> Vec<u8> {
        let [width_px, height_px] = self.size_px;
        let mut bytes = vec![0; width_px as usize * height_px as usize * 4];
        // SAFETY: the slice has room for the whole picture at a row alignment of 1 (rows of
        // RGBA8 are multiples of 4 anyway) and no pixel buffer is bound.
        unsafe {
            self.gl.bind_framebuffer(gl::READ_FRAMEBUFFER, Some(self.resolved));
            self.gl.read_pixels(
                0,
                0,
                width_px as i32,
                height_px as i32,
                gl::RGBA,
                gl::UNSIGNED_BYTE,
                gl::PixelPackData::Slice(Some(&mut bytes)),
            );
        }
        bytes
    }

    /// # Safety
    /// Both framebuffers must exist in the current context.
    unsafe fn copy(&self, from: gl::Framebuffer, to: Option<gl::Framebuffer>, to_px: [i32; 4]) {
        let [x, y, width, height] = to_px;
        let [from_width, from_height] = self.size_px.map(|px| px as i32);
        // SAFETY: passed on to the caller.
        unsafe {
            self.gl.bind_framebuffer(gl::READ_FRAMEBUFFER, Some(from));
            self.gl.bind_framebuffer(gl::DRAW_FRAMEBUFFER, to);
            self.gl.blit_framebuffer(
                0,
                0,
                from_width,
                from_height,
                x,
                y,
                x + width,
                y + height,
                gl::COLOR_BUFFER_BIT,
                gl::NEAREST,
            );
        }
    }
}

impl Drop for RenderTarget {
    fn drop(&mut self) {
        // SAFETY: our own objects, deleted once.
        unsafe {
            self.gl.delete_framebuffer(self.drawn);
            self.gl.delete_framebuffer(self.resolved);
            for buffer in self.renderbuffers {
                self.gl.delete_renderbuffer(buffer);
            }
        }
    }
}
