//! Leaves OpenGL as it was found. three-d and our drawing change state that egui's painter sets
//! once per frame or not at all; whoever draws holds a [`SavedState`] meanwhile.

use std::sync::Arc;
use three_d::context::{self as gl, HasContext as _};

/// The state at the time of [`SavedState::save`], put back on drop.
pub(super) struct SavedState {
    gl: Arc<gl::Context>,
    draw_framebuffer: Option<gl::Framebuffer>,
    read_framebuffer: Option<gl::Framebuffer>,
    renderbuffer: Option<gl::Renderbuffer>,
    program: Option<gl::Program>,
    array_buffer: Option<gl::Buffer>,
    vertex_array: Option<gl::VertexArray>,
    scissor_px: [i32; 4],
    viewport_px: [i32; 4],
    depth_mask: bool,
    color_mask: [bool; 4],
    clear_color: [f32; 4],
    depth_func: u32,
    blend: [u32; 6],
    capabilities: [(u32, bool); 5],
}

/// Switches that our drawing turns.
const CAPABILITIES: [u32; 5] = [gl::SCISSOR_TEST, gl::DEPTH_TEST, gl::CULL_FACE, gl::BLEND, gl::FRAMEBUFFER_SRGB];
const BLEND: [u32; 6] = [
    gl::BLEND_SRC_RGB,
    gl::BLEND_DST_RGB,
    gl::BLEND_SRC_ALPHA,
    gl::BLEND_DST_ALPHA,
    gl::BLEND_EQUATION_RGB,
    gl::BLEND_EQUATION_ALPHA,
];

impl SavedState {
    /// Asks OpenGL for all that our drawing changes. Dozens of queries, microseconds: the driver
    /// keeps these on our side of the bus.
    pub fn save(gl: &Arc<gl::Context>) -> Self {
        // SAFETY: queries only; the caller holds a current context, as for any drawing.
        unsafe {
            let mut scissor_px = [0; 4];
            gl.get_parameter_i32_slice(gl::SCISSOR_BOX, &mut scissor_px);
            let mut viewport_px = [0; 4];
            gl.get_parameter_i32_slice(gl::VIEWPORT, &mut viewport_px);
            let mut clear_color = [0.0; 4];
            gl.get_parameter_f32_slice(gl::COLOR_CLEAR_VALUE, &mut clear_color);
            Self {
                draw_framebuffer: gl.get_parameter_framebuffer(gl::DRAW_FRAMEBUFFER_BINDING),
                read_framebuffer: gl.get_parameter_framebuffer(gl::READ_FRAMEBUFFER_BINDING),
                renderbuffer: gl.get_parameter_renderbuffer(gl::RENDERBUFFER_BINDING),
                program: gl.get_parameter_program(gl::CURRENT_PROGRAM),
                array_buffer: gl.get_parameter_buffer(gl::ARRAY_BUFFER_BINDING),
                vertex_array: gl.get_parameter_vertex_array(gl::VERTEX_ARRAY_BINDING),
                scissor_px,
                viewport_px,
                depth_mask: gl.get_parameter_bool(gl::DEPTH_WRITEMASK),
                color_mask: gl.get_parameter_bool_array(gl::COLOR_WRITEMASK),
                clear_color,
                depth_func: gl.get_parameter_i32(gl::DEPTH_FUNC) as u32,
                blend: BLEND.map(|name| gl.get_parameter_i32(name) as u32),
                capabilities: CAPABILITIES.map(|name| (name, gl.is_enabled(name))),
                gl: Arc::clone(gl),
            }
        }
    }

    /// The framebuffer into which the caller was drawing.
    pub fn draw_framebuffer(&self) -> Option<gl::Framebuffer> {
        self.draw_framebuffer
    }
}

impl Drop for SavedState {
    fn drop(&mut self) {
        let gl = &self.gl;
        // SAFETY: every value was read from this context; nothing saved is deleted in between.
        unsafe {
            gl.bind_framebuffer(gl::DRAW_FRAMEBUFFER, self.draw_framebuffer);
            gl.bind_framebuffer(gl::READ_FRAMEBUFFER, self.read_framebuffer);
            gl.bind_renderbuffer(gl::RENDERBUFFER, self.renderbuffer);
            gl.use_program(self.program);
            gl.bind_vertex_array(self.vertex_array);
            gl.bind_buffer(gl::ARRAY_BUFFER, self.array_buffer);
            let [x, y, width, height] = self.scissor_px;
            gl.scissor(x, y, width, height);
            let [x, y, width, height] = self.viewport_px;
            gl.viewport(x, y, width, height);
            gl.depth_mask(self.depth_mask);
            let [red, green, blue, alpha] = self.color_mask;
            gl.color_mask(red, green, blue, alpha);
            let [red, green, blue, alpha] = self.clear_color;
            gl.clear_color(red, green, blue, alpha);
            gl.depth_func(self.depth_func);
            let [src_rgb, dst_rgb, src_alpha, dst_alpha, rgb, alpha] = self.blend;
            gl.blend_func_separate(src_rgb, dst_rgb, src_alpha, dst_alpha);
            gl.blend_equation_separate(rgb, alpha);
            for (name, enabled) in self.capabilities {
                if enabled { gl.enable(name) } else { gl.disable(name) }
            }
        }
    }
}
