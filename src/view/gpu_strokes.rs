//! Lines and dots on the graphics card: one quad each, widened to pixels by the vertex shader.
//!
//! Quads with explicit corners instead of instances: software OpenGL starts anew for every
//! instance, which is slow when each has four vertices only.

use super::error::{DriverObject, ViewError};
use super::scene::{Depth, LineSegment, Rgba};
use super::to_three_d::CameraUniforms;
use three_d::{Blend, Context, DepthTest, ElementBuffer, Program, RenderStates, VertexBuffer, Viewport, WriteMask};

/// Corner numbers of quads, six per quad; the same for every line and dot, so shared by all.
pub(super) struct QuadIndices {
    buffer: ElementBuffer<u32>,
    quad_count: u32,
}

impl QuadIndices {
    pub fn new(context: &Context) -> Self {
        Self { buffer: ElementBuffer::new(context), quad_count: 0 }
    }

    /// Makes room for at least so many quads; grows by doubling.
    fn reserve(&mut self, quad_count: u32) {
        if quad_count <= self.quad_count {
            return;
        }
        self.quad_count = quad_count.next_power_of_two().max(1024);
        let corners: Vec<u32> =
            (0..self.quad_count).flat_map(|quad| [0, 1, 2, 2, 1, 3].map(|corner| quad * 4 + corner)).collect();
        self.buffer.fill(&corners);
    }
}

/// The segments of one line item, or the crease lines of a mesh.
pub(super) struct Lines {
    ends_a: VertexBuffer<[f32; 3]>,
    ends_b: VertexBuffer<[f32; 3]>,
    colors: VertexBuffer<Rgba>,
    count: u32,
}

impl Lines {
    pub fn upload(
        context: &Context,
        segments: impl Iterator<Item = LineSegment> + Clone,
        indices: &mut QuadIndices,
    ) -> Self {
        let ends_a: Vec<_> = segments.clone().flat_map(|segment| [segment.a; 4]).collect();
        let ends_b: Vec<_> = segments.clone().flat_map(|segment| [segment.b; 4]).collect();
        let colors: Vec<_> = segments.flat_map(|segment| [segment.color; 4]).collect();
        let count = (colors.len() / 4) as u32;
        indices.reserve(count);
        Self {
            ends_a: VertexBuffer::new_with_data(context, &ends_a),
            ends_b: VertexBuffer::new_with_data(context, &ends_b),
            colors: VertexBuffer::new_with_data(context, &colors),
            count,
        }
    }
}

/// The dots of one point item.
pub(super) struct Dots {
    centers: VertexBuffer<[f32; 3]>,
    colors: VertexBuffer<Rgba>,
    count: u32,
}

impl Dots {
    pub fn upload(context: &Context, points: &[([f32; 3], Rgba)], indices: &mut QuadIndices) -> Self {
        let centers: Vec<_> = points.iter().flat_map(|(center, _)| [*center; 4]).collect();
        let colors: Vec<_> = points.iter().flat_map(|(_, color)| [*color; 4]).collect();
        indices.reserve(points.len() as u32);
        Self {
            centers: VertexBuffer::new_with_data(context, &centers),
            colors: VertexBuffer::new_with_data(context, &colors),
            count: points.len() as u32,
        }
    }
}

/// The programs that draw lines and dots.
pub(super) struct StrokePrograms {
    line: Program,
    point: Program,
}

impl StrokePrograms {
    pub fn new(context: &Context) -> Result<Self, ViewError> {
        let program = |what, vertex, fragment| {
            Program::from_source(context, vertex, fragment)
                .map_err(|error| ViewError::Driver { what, reason: error.to_string() })
        };
        Ok(Self {
            line: program(
                DriverObject::LineShader,
                include_str!("shaders/line.vert"),
                include_str!("shaders/line.frag"),
            )?,
            point: program(
                DriverObject::DotShader,
                include_str!("shaders/point.vert"),
                include_str!("shaders/point.frag"),
            )?,
        })
    }

    pub fn draw_lines(
        &self,
        lines: &Lines,
        width_px: f32,
        depth: Depth,
        camera: &CameraUniforms,
        viewport: Viewport,
        indices: &QuadIndices,
    ) {
        if lines.count == 0 {
            return;
        }
        let half_width_px = width_px.max(1.0) / 2.0;
        let program = &self.line;
        program.use_uniform("eye_from_item", camera.eye_from_item);
        program.use_uniform("clip_from_eye", camera.clip_from_eye);
        program.use_uniform("half_view_px", camera.half_view_px);
        program.use_uniform("half_width_px", half_width_px);
        program.use_uniform("near_z", camera.near_z);
        program.use_uniform("toward_viewer", camera.nearer_by_one_px * bias_px(half_width_px));
        program.use_vertex_attribute("end_a", &lines.ends_a);
        program.use_vertex_attribute("end_b", &lines.ends_b);
        program.use_vertex_attribute("color", &lines.colors);
        let states = states(depth, WriteMask::COLOR_AND_DEPTH);
        program.draw_subset_of_elements(states, viewport, &indices.buffer, 0, lines.count * 6);
    }

    pub fn draw_dots(
        &self,
        dots: &Dots,
        size_px: f32,
        depth: Depth,
        camera: &CameraUniforms,
        viewport: Viewport,
        indices: &QuadIndices,
    ) {
        if dots.count == 0 {
            return;
        }
        let radius_px = size_px.max(1.0) / 2.0;
        let program = &self.point;
        program.use_uniform("eye_from_item", camera.eye_from_item);
        program.use_uniform("clip_from_eye", camera.clip_from_eye);
        program.use_uniform("half_view_px", camera.half_view_px);
        program.use_uniform("radius_px", radius_px);
        // One step before the lines that end in the dot.
        let bias_px = bias_px(radius_px) + 1.0;
        program.use_uniform("toward_viewer", camera.nearer_by_one_px * bias_px);
        program.use_vertex_attribute("center", &dots.centers);
        program.use_vertex_attribute("color", &dots.colors);
        // The soft rim must not hide what is drawn later.
        let states = states(depth, WriteMask::COLOR);
        program.draw_subset_of_elements(states, viewport, &indices.buffer, 0, dots.count * 6);
    }
}

/// How far a stroke is moved toward the viewer, in sizes of a pixel. The half that lies on the
/// far side of its axis is buried by half the width times the slope of the surface: three half
/// widths show it whole up to a slope of 3 (72°). More would shine through thin walls.
pub(super) fn bias_px(half_width_px: f32) -> f32 {
    1.0 + 3.0 * half_width_px
}

fn states(depth: Depth, tested_mask: WriteMask) -> RenderStates {
    let (depth_test, write_mask) = match depth {
        Depth::Tested => (DepthTest::LessOrEqual, tested_mask),
        Depth::OnTop => (DepthTest::Always, WriteMask::COLOR),
    };
    RenderStates { depth_test, write_mask, blend: Blend::TRANSPARENCY, ..RenderStates::default() }
}
