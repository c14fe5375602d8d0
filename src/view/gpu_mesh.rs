//! Facets on the graphics card: positions and normals once, colours whenever they change.

use super::error::{DriverObject, ViewError};
use super::scene::{MeshItem, Rgba};
use super::to_three_d::CameraUniforms;
use three_d::{Blend, Context, DepthTest, Program, RenderStates, Vec4, VertexBuffer, Viewport, WriteMask};

/// Positions and normals of one `geometry_key`.
pub(super) struct MeshGeometry {
    positions: VertexBuffer<[f32; 3]>,
    /// One 10-10-10-bit normal per corner: a quarter of the memory of three floats.
    normals: VertexBuffer<u32>,
    corner_count: u32,
}

/// Colours of one `colors_key` on that geometry.
pub(super) struct MeshColors {
    colors: VertexBuffer<Rgba>,
    has_opaque: bool,
    has_see_through: bool,
    /// One colour per corner.
    run_together: bool,
}

/// Which facets a pass draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum DrawPass {
    Opaque,
    SeeThrough,
}

impl MeshGeometry {
    pub fn upload(context: &Context, item: &MeshItem) -> Self {
        let corners = &item.positions[..item.facet_count() * 3];
        let normals: Vec<u32> =
            corners.chunks_exact(3).flat_map(|facet| [packed_normal(facet[0], facet[1], facet[2]); 3]).collect();
        Self {
            positions: VertexBuffer::new_with_data(context, corners),
            normals: VertexBuffer::new_with_data(context, &normals),
            corner_count: corners.len() as u32,
        }
    }
}

impl MeshColors {
    pub fn upload(context: &Context, item: &MeshItem) -> Self {
        // Facets without a colour are a mistake of the caller; they are shown in mid grey
        // rather than read beyond the end of the buffer.
        let (facets, given) = (item.facet_count(), &item.facet_colors);
        let run_together = given.len() == 3 * facets;
        let filled = given.iter().copied().chain(std::iter::repeat([128, 128, 128, 255]));
        let colors: Vec<Rgba> = match run_together {
            true => filled.take(3 * facets).collect(),
            false => filled.take(facets).flat_map(|color| [color; 3]).collect(),
        };
        Self {
            run_together,
            has_opaque: colors.iter().any(|color| color[3] == 255),
            has_see_through: colors.iter().any(|color| (1..255).contains(&color[3])),
            colors: VertexBuffer::new_with_data(context, &colors),
        }
    }
}

/// The programs that draw facets.
pub(super) struct MeshPrograms {
    per_facet: Program,
    per_corner: Program,
}

impl MeshPrograms {
    pub fn new(context: &Context) -> Result<Self, ViewError> {
        let [vertex, fragment] = [include_str!("shaders/mesh.vert"), include_str!("shaders/mesh.frag")];
        let program = |shaded: &str| {
            let [vertex, fragment] = [vertex, fragment].map(|source| format!("#define SHADED {shaded}\n{source}"));
            Program::from_source(context, &vertex, &fragment)
                .map_err(|error| ViewError::Driver { what: DriverObject::FacetShader, reason: error.to_string() })
        };
        Ok(Self { per_facet: program("flat")?, per_corner: program("smooth")? })
    }

    pub fn draw(
        &self,
        geometry: &MeshGeometry,
        colors: &MeshColors,
        (pass, cut_in_item): (DrawPass, [f32; 4]),
        camera: &CameraUniforms,
        viewport: Viewport,
    ) {
        let (wanted, states) = match pass {
            DrawPass::Opaque => {
                (colors.has_opaque, RenderStates { depth_test: DepthTest::LessOrEqual, ..RenderStates::default() })
            }
            DrawPass::SeeThrough => (
                colors.has_see_through,
                RenderStates {
                    depth_test: DepthTest::LessOrEqual,
                    write_mask: WriteMask::COLOR,
                    blend: Blend::TRANSPARENCY,
                    ..RenderStates::default()
                },
            ),
        };
        if !wanted || geometry.corner_count == 0 {
            return;
        }
        let program = if colors.run_together { &self.per_corner } else { &self.per_facet };
        program.use_uniform("eye_from_item", camera.eye_from_item);
        program.use_uniform("clip_from_eye", camera.clip_from_eye);
        program.use_uniform("up_in_item", camera.up_in_item);
        program.use_uniform("cut_in_item", Vec4::from(cut_in_item));
        program.use_uniform("see_through", i32::from(pass == DrawPass::SeeThrough));
        program.use_vertex_attribute("position", &geometry.positions);
        program.use_vertex_attribute("packed_normal", &geometry.normals);
        program.use_vertex_attribute("color", &colors.colors);
        program.draw_arrays(states, viewport, geometry.corner_count);
    }
}

/// The unit normal by the right-hand rule, each part as 10 bits around 511; of a facet without
/// area, a vector of length 0, which the shader lights like an edge-on facet.
fn packed_normal(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> u32 {
    let [a, b, c] = [a, b, c].map(|corner| nalgebra::Vector3::from(corner).cast::<f64>());
    let normal = (b - a).cross(&(c - a)).try_normalize(0.0).unwrap_or_default();
    let bits = |value: f64| ((value * 511.0).round() as i32 + 511).clamp(0, 1023) as u32;
    bits(normal.x) | bits(normal.y) << 10 | bits(normal.z) << 20
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unpacked(bits: u32) -> [i32; 3] {
        [bits, bits >> 10, bits >> 20].map(|part| (part & 1023) as i32 - 511)
    }

    #[test]
    fn normal_follows_the_right_hand_rule() {
        let [o, x, y] = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
        assert_eq!(unpacked(packed_normal(o, x, y)), [0, 0, 511]);
        assert_eq!(unpacked(packed_normal(o, y, x)), [0, 0, -511]);
    }

    #[test]
    fn facets_without_area_or_with_nan_have_no_normal() {
        let (o, bad) = ([0.0; 3], [f32::NAN, 0.0, 0.0]);
        assert_eq!(unpacked(packed_normal(o, o, [1.0, 0.0, 0.0])), [0, 0, 0]);
        let _ = packed_normal(o, bad, [1.0, 0.0, 0.0]);
    }
}
