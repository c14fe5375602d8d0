//! Facets on the graphics card: positions and normals once, colours whenever they change; and fewer of them for a
//! camera that moves.

use super::coarse::CoarseMesh;
use super::detail::Detail;
use super::error::{DriverObject, ViewError};
use super::scene::{MeshItem, Rgba};
use super::to_three_d::CameraUniforms;
use rayon::prelude::*;
use three_d::{Blend, Context, DepthTest, Program, RenderStates, Vec4, VertexBuffer, Viewport, WriteMask};

/// Positions and normals of one `geometry_key`.
pub(super) struct MeshGeometry {
    whole: Corners,
    /// What a moving camera sees of it, where that is less, and which facets these are.
    coarse: Option<(Corners, Vec<u32>)>,
}

struct Corners {
    positions: VertexBuffer<[f32; 3]>,
    /// One 10-10-10-bit normal per corner: a quarter of the memory of three floats.
    normals: VertexBuffer<u32>,
    count: u32,
}

/// Colours of one `colors_key` on that geometry.
pub(super) struct MeshColors {
    whole: VertexBuffer<Rgba>,
    coarse: Option<VertexBuffer<Rgba>>,
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
    /// Uploads a mesh, and where it has more facets than a moving camera may see, a coarser one.
    pub fn upload(context: &Context, item: &MeshItem, moving_facets: usize) -> Self {
        let corners = &item.positions[..item.facet_count() * 3];
        let coarse = (item.facet_count() > moving_facets).then(|| CoarseMesh::of(corners, moving_facets));
        Self {
            whole: Corners::upload(context, corners),
            coarse: coarse.map(|coarse| (Corners::upload(context, &coarse.positions), coarse.facets)),
        }
    }
}

impl Corners {
    fn upload(context: &Context, corners: &[[f32; 3]]) -> Self {
        let normals: Vec<u32> = corners
            .par_chunks_exact(3)
            .flat_map_iter(|facet| [packed_normal(facet[0], facet[1], facet[2]); 3])
            .collect();
        Self {
            positions: VertexBuffer::new_with_data(context, corners),
            normals: VertexBuffer::new_with_data(context, &normals),
            count: corners.len() as u32,
        }
    }
}

impl MeshColors {
    pub fn upload(context: &Context, item: &MeshItem, geometry: &MeshGeometry) -> Self {
        // Facets without a colour are a mistake of the caller; they are shown in mid grey
        // rather than read beyond the end of the buffer.
        let (facets, given) = (item.facet_count(), &item.facet_colors);
        let run_together = given.len() == 3 * facets;
        let color = |at: usize| given.get(at).copied().unwrap_or([128, 128, 128, 255]);
        let of_facet = |facet: usize| [0, 1, 2].map(|k| color(if run_together { 3 * facet + k } else { facet }));
        let whole: Vec<Rgba> = (0..facets).into_par_iter().flat_map_iter(of_facet).collect();
        let coarse = geometry.coarse.as_ref().map(|(_, kept)| {
            let colors: Vec<Rgba> = kept.iter().flat_map(|&facet| of_facet(facet as usize)).collect();
            VertexBuffer::new_with_data(context, &colors)
        });
        Self {
            run_together,
            has_opaque: whole.iter().any(|color| color[3] == 255),
            has_see_through: whole.iter().any(|color| (1..255).contains(&color[3])),
            whole: VertexBuffer::new_with_data(context, &whole),
            coarse,
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
        ((pass, detail), cut_in_item): ((DrawPass, Detail), [f32; 4]),
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
        let coarse = geometry.coarse.as_ref().zip(colors.coarse.as_ref()).filter(|_| detail.thinned);
        let (corners, color) =
            coarse.map_or((&geometry.whole, &colors.whole), |((corners, _), color)| (corners, color));
        if !wanted || corners.count == 0 {
            return;
        }
        let program = if colors.run_together { &self.per_corner } else { &self.per_facet };
        program.use_uniform("eye_from_item", camera.eye_from_item);
        program.use_uniform("clip_from_eye", camera.clip_from_eye);
        program.use_uniform("up_in_item", camera.up_in_item);
        program.use_uniform("cut_in_item", Vec4::from(cut_in_item));
        program.use_uniform("see_through", i32::from(pass == DrawPass::SeeThrough));
        program.use_vertex_attribute("position", &corners.positions);
        program.use_vertex_attribute("packed_normal", &corners.normals);
        program.use_vertex_attribute("color", color);
        program.draw_arrays(states, viewport, corners.count);
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
