//! Draws a scene as a camera sees it into a picture of its own, only when something changed,
//! and copies that picture to the window or into memory.
//!
//! The OpenGL context belongs to somebody else (eframe, [`super::HeadlessGl`]) and must be
//! current on the calling thread; every call leaves its state as it was. Drop the renderer
//! while the context still lives (eframe: in `App::on_exit`).

use super::camera::Camera;
use super::detail::{Budget, Detail};
use super::error::{DriverObject, ViewError};
use super::gl_state::SavedState;
use super::gpu_cache::{GpuCache, cloud_color_key, color_key};
use super::gpu_cloud::CloudProgram;
use super::gpu_mesh::{DrawPass, MeshPrograms};
use super::gpu_strokes::StrokePrograms;
use super::lens::ViewSize;
use super::scene::{Depth, Scene};
use super::target::{RenderTarget, Smoothing};
use super::to_three_d::CameraUniforms;
use std::sync::Arc;
use three_d::context::{self as gl, HasContext as _};
use three_d::{Context, DepthTest, Program, RenderStates, Vec3, VertexBuffer, Viewport, WriteMask};

/// Width of crease lines.
const EDGE_WIDTH_PX: f32 = 1.25;

/// Draws a scene, and keeps the picture until something changes.
pub struct Renderer {
    context: Context,
    background: Program,
    /// One triangle that covers the view.
    background_corners: VertexBuffer<[f32; 2]>,
    meshes: MeshPrograms,
    strokes: StrokePrograms,
    clouds: CloudProgram,
    /// What a moving camera may see.
    budget: Budget,
    cache: GpuCache,
    largest_side_px: u32,
    target: Option<RenderTarget>,
    /// What the picture in `target` shows.
    drawn: Option<(Vec<u64>, Camera, Detail)>,
}

impl std::fmt::Debug for Renderer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let size_px = self.target.as_ref().map(RenderTarget::size_px);
        f.debug_struct("Renderer").field("size_px", &size_px).finish_non_exhaustive()
    }
}

impl Renderer {
    /// Compiles the shaders.
    ///
    /// # Errors
    /// When the context is older than OpenGL 3.3 (ES 3.0), or its driver refuses the shaders.
    pub fn new(gl: Arc<gl::Context>) -> Result<Self, ViewError> {
        check_version(&gl)?;
        let _restored_on_return = SavedState::save(&gl);
        let refuse = |what| move |error: three_d::CoreError| ViewError::Driver { what, reason: error.to_string() };
        let context = Context::from_gl_context(gl).map_err(refuse(DriverObject::VertexArray))?;
        let [vertex, fragment] = [include_str!("shaders/background.vert"), include_str!("shaders/background.frag")];
        let background =
            Program::from_source(&context, vertex, fragment).map_err(refuse(DriverObject::BackgroundShader))?;
        let covering = [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]];
        // SAFETY: queries only.
        let largest_side_px = unsafe {
            let renderbuffer = context.get_parameter_i32(gl::MAX_RENDERBUFFER_SIZE);
            renderbuffer.max(1) as u32
        };
        Ok(Self {
            background_corners: VertexBuffer::new_with_data(&context, &covering),
            background,
            meshes: MeshPrograms::new(&context)?,
            strokes: StrokePrograms::new(&context)?,
            clouds: CloudProgram::new(&context)?,
            budget: Budget::of(&context),
            cache: GpuCache::new(&context),
            largest_side_px,
            target: None,
            drawn: None,
            context,
        })
    }

    /// Draws, if scene, camera or size differ from the last time; says whether it did. A size
    /// of 0 draws nothing; one beyond the driver's limit is drawn at the limit.
    ///
    /// # Errors
    /// When the driver has no memory for a picture of this size.
    pub fn draw(&mut self, scene: &Scene, camera: &Camera, size_px: [u32; 2]) -> Result<bool, ViewError> {
        self.draw_in_detail(scene, camera, size_px, Detail::default())
    }

    /// Whether a moving camera sees less of the scene than one at rest.
    pub fn thins(&self, scene: &Scene) -> bool {
        self.budget.thins(scene)
    }

    /// Draws as [`Self::draw`] does, as much as is wanted this time.
    ///
    /// # Errors
    /// As [`Self::draw`].
    pub fn draw_in_detail(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        size_px: [u32; 2],
        detail: Detail,
    ) -> Result<bool, ViewError> {
        if size_px.contains(&0) {
            return Ok(false);
        }
        let size_px = size_px.map(|px| px.min(self.largest_side_px));
        // Where nothing shows it, detail makes no other picture.
        let thinned = detail.thinned && self.thins(scene);
        let px_per_point = if scene.clouds.is_empty() { 1.0 } else { detail.px_per_point };
        let detail = Detail { px_per_point, thinned };
        let smoothing = if detail.thinned { Smoothing::One } else { Smoothing::Four };
        let fits = self.target.as_ref().is_some_and(|target| target.is(size_px, smoothing));
        let wanted = (scene.stamp(), *camera, detail);
        if fits && self.drawn.as_ref() == Some(&wanted) {
            return Ok(false);
        }
        let _restored_on_return = SavedState::save(&self.context);
        self.drawn = None;
        let kept = self.target.take().filter(|_| fits);
        let target = match kept {
            Some(target) => target,
            None => RenderTarget::new(&self.context, size_px, smoothing)?,
        };
        self.cache.follow(scene, self.budget.facets);
        target.begin();
        self.draw_layers(scene, camera, size_px, detail);
        target.resolve();
        self.target = Some(target);
        self.drawn = Some(wanted);
        Ok(true)
    }

    /// Copies the picture into the framebuffer that is bound, to a rectangle in pixels from its
    /// bottom-left corner, clipped to the scissor that is set. Nothing without a picture.
    pub fn blit(&self, x_px: i32, y_px: i32, width_px: i32, height_px: i32) {
        if let Some(target) = &self.target {
            let state = SavedState::save(&self.context);
            target.blit_to(state.draw_framebuffer(), [x_px, y_px, width_px, height_px]);
        }
    }

    /// The picture as an image, top row first; 0 × 0 before the first drawing.
    pub fn read_rgba(&self) -> image::RgbaImage {
        let Some(target) = &self.target else {
            return image::RgbaImage::default();
        };
        let _restored_on_return = SavedState::save(&self.context);
        let [width_px, height_px] = target.size_px();
        let bytes = target.read();
        let mut picture = image::RgbaImage::from_raw(width_px, height_px, bytes).unwrap_or_default();
        image::imageops::flip_vertical_in_place(&mut picture);
        picture
    }

    /// Buffers uploaded so far: a measure of how well keys are reused.
    pub fn upload_count(&self) -> u64 {
        self.cache.uploads
    }

    fn draw_layers(&self, scene: &Scene, camera: &Camera, [width_px, height_px]: [u32; 2], detail: Detail) {
        let size = ViewSize::new(f64::from(width_px), f64::from(height_px));
        let uniforms = CameraUniforms::new(camera, size);
        let viewport = Viewport::new_at_origo(width_px, height_px);
        self.draw_background(scene, viewport);
        self.draw_meshes(scene, (DrawPass::Opaque, detail), &uniforms, viewport);
        self.draw_clouds(scene, detail, &uniforms, viewport);
        if !detail.thinned || self.budget.shows_creases(scene) {
            self.draw_edges(scene, &uniforms, viewport);
        }
        self.draw_strokes(scene, Depth::Tested, &uniforms, viewport);
        // After all that can be seen through it.
        self.draw_meshes(scene, (DrawPass::SeeThrough, detail), &uniforms, viewport);
        self.draw_strokes(scene, Depth::OnTop, &uniforms, viewport);
    }

    fn draw_background(&self, scene: &Scene, viewport: Viewport) {
        let color = |[r, g, b]: [u8; 3]| Vec3::new(f32::from(r), f32::from(g), f32::from(b)) / 255.0;
        let states =
            RenderStates { depth_test: DepthTest::Always, write_mask: WriteMask::COLOR, ..RenderStates::default() };
        self.background.use_uniform("top_color", color(scene.background_top));
        self.background.use_uniform("bottom_color", color(scene.background_bottom));
        self.background.use_vertex_attribute("corner", &self.background_corners);
        self.background.draw_arrays(states, viewport, 3);
    }

    fn draw_meshes(&self, scene: &Scene, how: (DrawPass, Detail), camera: &CameraUniforms, viewport: Viewport) {
        for item in &scene.meshes {
            let geometry = self.cache.geometry.get(&item.geometry_key);
            let colors = self.cache.colors.get(&color_key(item));
            if let (Some(geometry), Some(colors)) = (geometry, colors) {
                let cut = scene.cut.filter(|cut| cut.geometry_key == item.geometry_key);
                // A plane that everything is above of.
                let cut = cut.map_or([0.0, 0.0, 0.0, 1.0], |cut| cut.plane);
                self.meshes.draw(geometry, colors, (how, cut), &camera.of_item(&item.scene_from_item), viewport);
            }
        }
    }

    fn draw_clouds(&self, scene: &Scene, detail: Detail, camera: &CameraUniforms, viewport: Viewport) {
        let all = scene.cloud_points();
        for item in &scene.clouds {
            let places = self.cache.cloud_places.get(&item.geometry_key);
            let colors = self.cache.cloud_colors.get(&cloud_color_key(item));
            if let (Some(places), Some(colors)) = (places, colors) {
                let camera = camera.of_item(&item.scene_from_item);
                self.clouds.draw(item, places, colors, (detail, self.budget, all), &camera, viewport);
            }
        }
    }

    fn draw_edges(&self, scene: &Scene, camera: &CameraUniforms, viewport: Viewport) {
        let indices = &self.cache.indices;
        for item in &scene.meshes {
            let edges = item.edges.as_ref();
            if let Some(lines) = edges.and_then(|edges| self.cache.edges.get(&edges.key)) {
                let (tested, camera) = (Depth::Tested, camera.of_item(&item.scene_from_item));
                self.strokes.draw_lines(lines, EDGE_WIDTH_PX, tested, &camera, viewport, indices);
            }
        }
    }

    fn draw_strokes(&self, scene: &Scene, depth: Depth, camera: &CameraUniforms, viewport: Viewport) {
        let indices = &self.cache.indices;
        for item in scene.lines.iter().filter(|item| item.depth == depth) {
            if let Some(lines) = self.cache.lines.get(&item.key) {
                let camera = camera.of_item(&item.scene_from_item);
                self.strokes.draw_lines(lines, item.width_px, depth, &camera, viewport, indices);
            }
        }
        for item in scene.points.iter().filter(|item| item.depth == depth) {
            if let Some(dots) = self.cache.dots.get(&item.key) {
                let camera = camera.of_item(&item.scene_from_item);
                self.strokes.draw_dots(dots, item.size_px, depth, &camera, viewport, indices);
            }
        }
    }
}

fn check_version(gl: &gl::Context) -> Result<(), ViewError> {
    let version = gl.version();
    let needed = if version.is_embedded { (3, 0) } else { (3, 3) };
    if (version.major, version.minor) >= needed {
        return Ok(());
    }
    // SAFETY: queries only.
    let [version, renderer] = [gl::VERSION, gl::RENDERER].map(|name| unsafe { gl.get_parameter_string(name) });
    Err(ViewError::TooOld { version, renderer })
}
