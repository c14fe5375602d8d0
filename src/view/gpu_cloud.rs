//! Clouds on the graphics card: places once, colours whenever they change, in an order whose first points stand for all.

use super::cloud::CloudItem;
use super::detail::{Budget, Detail};
use super::error::{DriverObject, ViewError};
use super::gpu_strokes::bias_px;
use super::scene::Rgba;
use super::thinning::Order;
use super::to_three_d::CameraUniforms;
use three_d::context::{self as gl, HasContext as _};
use three_d::{Context, DepthTest, Program, RenderStates, Vec2, Vec3, Vec4, VertexBuffer, Viewport};

/// How much a dot grows at most by zooming in: more would be tiles.
const LARGEST_GROWTH: f64 = 4.0;
/// How much it grows at most to close the gaps between fewer points.
const LARGEST_FILLING: f64 = 1.5;
/// What the farthest point of a cloud that fades loses of its brightness.
const FADING: f32 = 0.65;

/// Places of one `geometry_key`.
pub(super) struct CloudPlaces {
    places: VertexBuffer<[f32; 3]>,
    order: Order,
    count: u32,
    /// Middle of their box, and the distance from there to its corner, mm.
    middle: [f64; 3],
    radius_mm: f64,
}

impl CloudPlaces {
    pub fn upload(context: &Context, item: &CloudItem) -> Self {
        let (all, count) = (item.places.places(), item.count());
        let order = Order::of(count);
        let gathered: Vec<_> = order.indices().map(|index| all[index as usize]).collect();
        let (mut lo, mut hi) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for place in all {
            for axis in 0..3 {
                // Both pass over what is not a number.
                (lo[axis], hi[axis]) = (lo[axis].min(place[axis]), hi[axis].max(place[axis]));
            }
        }
        let half = [0, 1, 2].map(|axis| (f64::from(hi[axis]) - f64::from(lo[axis])) / 2.0);
        Self {
            places: VertexBuffer::new_with_data(context, &gathered),
            order,
            count,
            middle: [0, 1, 2].map(|axis| f64::from(lo[axis]) + half[axis]),
            radius_mm: half.iter().map(|side| side * side).sum::<f64>().sqrt(),
        }
    }

    /// Uniform `fade` of the shader.
    fn fade(&self, camera: &CameraUniforms) -> Vec3 {
        let [x, y, z] = self.middle.map(|at| at as f32);
        let middle_z = (camera.eye_from_item * Vec4::new(x, y, z, 1.0)).z;
        let radius_mm = (self.radius_mm as f32).max(f32::MIN_POSITIVE);
        Vec3::new(middle_z + radius_mm, 0.5 / radius_mm, FADING)
    }

    /// How many points are drawn when a whole scene of clouds may draw so many.
    fn drawn(&self, moving: Option<(u32, u64)>) -> u32 {
        match moving {
            Some((at_most, all)) if all > u64::from(at_most) => {
                self.order.prefix((u64::from(at_most) * u64::from(self.count) / all) as u32)
            }
            _ => self.count,
        }
    }
}

/// Colours of one `colors_key` on those places.
pub(super) struct CloudColors(VertexBuffer<Rgba>);

impl CloudColors {
    pub fn upload(context: &Context, item: &CloudItem) -> Self {
        // As for facets: a colour that is missing is the caller's mistake, and mid grey.
        let color = |index| item.colors.get(index as usize).copied().unwrap_or([128, 128, 128, 255]);
        let gathered: Vec<_> = Order::of(item.count()).indices().map(color).collect();
        Self(VertexBuffer::new_with_data(context, &gathered))
    }
}

/// The program that draws clouds.
pub(super) struct CloudProgram {
    context: Context,
    program: Program,
}

impl CloudProgram {
    pub fn new(context: &Context) -> Result<Self, ViewError> {
        let [vertex, fragment] = [include_str!("shaders/cloud.vert"), include_str!("shaders/cloud.frag")];
        let program = Program::from_source(context, vertex, fragment)
            .map_err(|error| ViewError::Driver { what: DriverObject::CloudShader, reason: error.to_string() })?;
        Ok(Self { context: context.clone(), program })
    }

    /// Draws one cloud of a scene with `all` points.
    pub fn draw(
        &self,
        item: &CloudItem,
        places: &CloudPlaces,
        colors: &CloudColors,
        (detail, budget, all): (Detail, Budget, u64),
        camera: &CameraUniforms,
        viewport: Viewport,
    ) {
        let drawn = places.drawn(detail.thinned.then_some((budget.points, all)));
        if drawn == 0 {
            return;
        }
        let filling = (f64::from(places.count) / f64::from(drawn)).sqrt().min(LARGEST_FILLING);
        let views_high = 2.0 * places.radius_mm / (camera.mm_per_px * 2.0 * f64::from(camera.half_view_px.y));
        let growth = views_high.sqrt().clamp(1.0, LARGEST_GROWTH) * filling;
        let side_px = (item.size_points * detail.px_per_point * growth as f32).max(1.0);
        let program = &self.program;
        program.use_uniform("eye_from_item", camera.eye_from_item);
        program.use_uniform("clip_from_eye", camera.clip_from_eye);
        program.use_uniform("side_px", side_px);
        let toward_viewer = camera.nearer_by_one_px * bias_px(side_px / 2.0) + Vec2::new(0.0, item.lift_mm);
        program.use_uniform("toward_viewer", toward_viewer);
        let none = Vec3::new(0.0, 0.0, 0.0);
        program.use_uniform("fade", if item.fades { places.fade(camera) } else { none });
        program.use_vertex_attribute("place", &places.places);
        program.use_vertex_attribute("color", &colors.0);
        let states = RenderStates { depth_test: DepthTest::LessOrEqual, ..RenderStates::default() };
        let gl = &self.context;
        // OpenGL ES always asks the shader, and has no switch for it.
        let has_switch = !gl.version().is_embedded;
        program.draw_with(states, viewport, || {
            // SAFETY: both buffers hold at least `drawn` vertices, and the switch is put back.
            unsafe {
                let was_on = has_switch && gl.is_enabled(gl::PROGRAM_POINT_SIZE);
                if has_switch {
                    gl.enable(gl::PROGRAM_POINT_SIZE);
                }
                gl.draw_arrays(gl::POINTS, 0, drawn as i32);
                if has_switch && !was_on {
                    gl.disable(gl::PROGRAM_POINT_SIZE);
                }
            }
        });
    }
}
