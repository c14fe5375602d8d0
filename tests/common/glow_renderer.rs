//! Renders an egui_kittest harness with OpenGL and without a screen, 3D view included:
//! `Harness::builder().renderer(GlowTestRenderer::new()).build_eframe(|cc| App::new(cc))`.
//!
//! All harnesses of one thread share one context: an app that is dropped while another
//! harness is alive then deletes its own objects, not its neighbour's of the same number.

use clearbeam::view::HeadlessGl;
use eframe::egui;
use egui_glow::glow::{self, HasContext as _};
use std::cell::RefCell;
use std::rc::{Rc, Weak};
use std::sync::Arc;

thread_local! {
    static CONTEXT: RefCell<Weak<HeadlessGl>> = const { RefCell::new(Weak::new()) };
}

/// The context of this thread, made on first use and dropped with its last user.
pub fn thread_gl() -> Rc<HeadlessGl> {
    CONTEXT.with_borrow_mut(|shared| {
        shared.upgrade().unwrap_or_else(|| {
            let made = Rc::new(HeadlessGl::new().unwrap_or_else(|error| panic!("{error}")));
            *shared = Rc::downgrade(&made);
            made
        })
    })
}

/// egui's own OpenGL painter, drawing into a framebuffer object.
pub struct GlowTestRenderer {
    painter: egui_glow::Painter,
    // Last: fields drop in order, and the painter needs the context.
    context: Rc<HeadlessGl>,
}

impl GlowTestRenderer {
    pub fn new() -> Self {
        let context = thread_gl();
        let painter = egui_glow::Painter::new(context.gl(), "", None, false).unwrap_or_else(|error| panic!("{error}"));
        Self { painter, context }
    }

    fn gl(&self) -> Arc<glow::Context> {
        self.context.gl()
    }
}

impl Drop for GlowTestRenderer {
    fn drop(&mut self) {
        self.painter.destroy();
    }
}

impl egui_kittest::TestRenderer for GlowTestRenderer {
    fn setup_eframe(&self, cc: &mut eframe::CreationContext<'_>, _frame: &mut eframe::Frame) {
        cc.gl = Some(self.gl());
    }

    fn handle_delta(&mut self, delta: &mut egui::TexturesDelta) {
        for (id, images) in delta.set.drain() {
            for image in images {
                self.painter.set_texture(id, &image);
            }
        }
        for id in delta.free.drain() {
            self.painter.free_texture(id);
        }
    }

    fn render(&mut self, ctx: &egui::Context, output: &egui::FullOutput) -> Result<image::RgbaImage, String> {
        let pixels_per_point = ctx.pixels_per_point();
        let size = ctx.content_rect().size() * pixels_per_point;
        let size_px = [size.x.round() as u32, size.y.round() as u32];
        let primitives = ctx.tessellate(output.shapes.clone(), pixels_per_point);
        let screen = Screen::bind(self.gl(), size_px)?;
        self.painter.clear(size_px, [0.0, 0.0, 0.0, 1.0]);
        self.painter.paint_primitives(size_px, pixels_per_point, &primitives);
        screen.read()
    }
}

/// Stands in for the window: the framebuffer that is bound while egui paints.
struct Screen {
    gl: Arc<glow::Context>,
    framebuffer: glow::Framebuffer,
    color: glow::Renderbuffer,
    size_px: [u32; 2],
}

impl Screen {
    fn bind(gl: Arc<glow::Context>, size_px: [u32; 2]) -> Result<Self, String> {
        // SAFETY: fresh objects of the context that is current on this thread.
        unsafe {
            let framebuffer = gl.create_framebuffer()?;
            let color = gl.create_renderbuffer()?;
            gl.bind_renderbuffer(glow::RENDERBUFFER, Some(color));
            let [width_px, height_px] = size_px.map(|px| px as i32);
            gl.renderbuffer_storage(glow::RENDERBUFFER, glow::RGBA8, width_px, height_px);
            gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
            gl.framebuffer_renderbuffer(glow::FRAMEBUFFER, glow::COLOR_ATTACHMENT0, glow::RENDERBUFFER, Some(color));
            let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
            let screen = Self { gl, framebuffer, color, size_px };
            if status == glow::FRAMEBUFFER_COMPLETE {
                Ok(screen)
            } else {
                Err(format!("no framebuffer of {size_px:?} pixels: status 0x{status:04x}"))
            }
        }
    }

    /// Fails when the app left another framebuffer bound or an OpenGL error behind.
    fn read(&self) -> Result<image::RgbaImage, String> {
        let [width_px, height_px] = self.size_px;
        let mut bytes = vec![0; width_px as usize * height_px as usize * 4];
        // SAFETY: the slice has room for all rows, and no pixel buffer is bound.
        unsafe {
            for binding in [glow::DRAW_FRAMEBUFFER_BINDING, glow::READ_FRAMEBUFFER_BINDING] {
                if self.gl.get_parameter_framebuffer(binding) != Some(self.framebuffer) {
                    return Err("a paint callback left another framebuffer bound".to_owned());
                }
            }
            self.gl.read_pixels(
                0,
                0,
                width_px as i32,
                height_px as i32,
                glow::RGBA,
                glow::UNSIGNED_BYTE,
                glow::PixelPackData::Slice(Some(&mut bytes)),
            );
            let error = self.gl.get_error();
            if error != glow::NO_ERROR {
                return Err(format!("OpenGL error 0x{error:04x} while painting"));
            }
        }
        let mut picture =
            image::RgbaImage::from_raw(width_px, height_px, bytes).ok_or("picture and bytes differ in size")?;
        image::imageops::flip_vertical_in_place(&mut picture);
        Ok(picture)
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // SAFETY: our own objects, deleted once.
        unsafe {
            self.gl.bind_framebuffer(glow::FRAMEBUFFER, None);
            self.gl.delete_framebuffer(self.framebuffer);
            self.gl.delete_renderbuffer(self.color);
        }
    }
}
