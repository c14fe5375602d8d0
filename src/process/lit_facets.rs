//! Which facets a run of the light comes near, and which of them nothing can shade.
//!
//! Most of a part is lit without anything in between, and a ray for each sample would cost more than
//! all the rest: so facets that no other facet near the beam can shade are found here, once for a run.

use super::light_piece::LightPiece;
use super::occluder_height::{in_frame, occluder_height_mm};
use super::shade::Shade;
use super::spot::Spot;
use crate::part::{Part, Surfaces, angle, topology::FacetDefect};
use crate::pose::target;
use nalgebra::{Point3, Vector3};

/// Tolerance before a corner counts as beyond a plane, mm: the rounding of f32
/// coordinates on a metre, which is far less than any shadow is wide.
const PLANE_MM: f64 = 1e-4;
/// Length of the first stretch above and below the spot that is looked at by itself, mm; each further
/// one reaches three times as far.
const FIRST_STRETCH_MM: f64 = 2.0;

/// A piece that comes near a facet.
#[derive(Clone, Copy, Debug)]
pub struct NearPiece {
    /// Its place in [`super::light::Light::pieces`].
    pub piece: u32,
    /// Nothing can shade it.
    pub clear: bool,
}

/// A facet near a run, seen along its middle axis.
struct SeenFacet {
    facet: u32,
    corners: [Point3<f64>; 3],
    vertices: [u32; 3],
    /// Unit normal, turned to the light.
    up: Vector3<f64>,
    /// How steeply it rises to the light: sine.
    rise: f64,
    /// Whether the light comes to the side that is worked on.
    lit: bool,
    /// Least and greatest x, y and height.
    low: [f64; 3],
    high: [f64; 3],
}

/// The facets that light of a run comes to, and whether nothing can shade them. What lies beneath the spot
/// and beneath others that stop all light is not among them: no light was meant for it.
pub fn lit_facets(
    part: &Part,
    surfaces: &Surfaces,
    shade: &Shade<'_>,
    spot: &Spot,
    run: &[LightPiece],
) -> Vec<(u32, bool)> {
    let Some(frame) = RunFrame::of(run) else { return Vec::new() };
    let (seen, occluder_mm) = seen(part, surfaces, spot, run, &frame);
    let slope = spot.greatest_slope() + frame.turn;
    let lit = seen.iter().filter(|f| f.lit && f.high[2] >= occluder_mm - PLANE_MM);
    // What shaded the last facet is likely to shade the next one too.
    let mut last: Option<&SeenFacet> = None;
    lit.map(|f| {
        last = last.filter(|g| may_shade(g, f, slope)).or_else(|| seen.iter().find(|g| may_shade(g, f, slope)));
        (f.facet, last.is_none() && !clamp_near(shade, spot, &frame, f.low[2]))
    })
    .collect()
}

/// Whether a clamp comes near the light above a height.
fn clamp_near(shade: &Shade<'_>, spot: &Spot, frame: &RunFrame, from_mm: f64) -> bool {
    let lens_mm = spot.defocus_mm + spot.optics.lens_to_focus_mm;
    let [x, y] = frame.reach(spot, from_mm, lens_mm);
    let at = |h: f64| frame.p + frame.axes[2] * h;
    shade.clamp_near(&at(from_mm), &at(lens_mm), libm::hypot(x, y))
}

/// Whether some light to `f` may meet `g` first. `slope`: how far light may lean from the middle axis.
fn may_shade(g: &SeenFacet, f: &SeenFacet, slope: f64) -> bool {
    if g.facet == f.facet || g.high[2] <= f.low[2] + PLANE_MM {
        return false;
    }
    let lean = slope * (g.high[2] - f.low[2]);
    if (0..2).any(|k| g.low[k] > f.high[k] + lean || g.high[k] < f.low[k] - lean) {
        return false;
    }
    // Facets around a vertex that all rise to the light lie beside one another, seen from it.
    let both_rise = g.rise.min(f.rise) > slope;
    if both_rise && g.lit && g.vertices.iter().any(|v| f.vertices.contains(v)) {
        return false;
    }
    // Light leaves f upwards and never comes to what lies beneath its plane; nor through a plane that
    // it is above of.
    let under = f.rise > slope && g.corners.iter().all(|v| f.up.dot(&(v - f.corners[0])) <= PLANE_MM);
    let above = g.rise > slope && f.corners.iter().all(|v| g.up.dot(&(v - g.corners[0])) >= -PLANE_MM);
    !(under || above)
}

/// The frame of a run: its middle, and its axes along travel, across, and to the laser.
struct RunFrame {
    p: Point3<f64>,
    axes: [Vector3<f64>; 3],
    /// How far the spot goes from the middle along the axes, mm.
    half: [f64; 3],
    /// The greatest turn from the middle axis: sine.
    turn: f64,
}

impl RunFrame {
    fn of(run: &[LightPiece]) -> Option<RunFrame> {
        let (first, last) = (&run.first()?.from, &run.last()?.to);
        let a = angle::slerp(&first.a, &last.a, 0.5);
        let o = target::travel(&first.o, &a);
        let (p, axes) = (nalgebra::center(&first.p, &last.p), [o, o.cross(&a), a]);
        let mut frame = RunFrame { p, axes, half: [0.0; 3], turn: 0.0 };
        for at in run.iter().map(|piece| &piece.to).chain([first]) {
            let place = in_frame(&at.p, &frame.p, &frame.axes);
            frame.half = [0, 1, 2].map(|k| frame.half[k].max(place[k].abs()));
            frame.turn = frame.turn.max(at.a.cross(&a).norm());
        }
        Some(frame)
    }

    /// How far along and across the light reaches between two heights, mm.
    fn reach(&self, spot: &Spot, low: f64, high: f64) -> [f64; 2] {
        let deepest = (spot.defocus_mm - low).abs().max((spot.defocus_mm - high).abs()) + self.half[2];
        let sway = self.turn * (low.abs().max(high.abs()) + self.half[2]);
        let reach = spot.reach_mm(deepest);
        [0, 1].map(|k| self.half[k] + reach[k] + sway)
    }
}

/// All facets within the light's reach of a run, in the order of their numbers, and the height below
/// which no light comes.
fn seen(part: &Part, surfaces: &Surfaces, spot: &Spot, run: &[LightPiece], frame: &RunFrame) -> (Vec<SeenFacet>, f64) {
    let Some((centre, radius)) = part.bvh.sphere_of_box() else { return (Vec::new(), 0.0) };
    let (p, a) = (&frame.p, &frame.axes[2]);
    let middle = (centre - p).dot(a);
    let lens_mm = spot.defocus_mm + spot.optics.lens_to_focus_mm;
    let (bottom, top) = (middle - radius, (middle + radius).min(lens_mm));
    let mut found: Vec<(u32, [[f64; 3]; 3])> = Vec::new();
    let visit = |low: f64, high: f64, found: &mut Vec<(u32, [[f64; 3]; 3])>| {
        let (low, high) = (low.max(bottom), high.min(top));
        if high < low {
            return;
        }
        let [x, y] = frame.reach(spot, low, high);
        part.bvh.visit_ray(&(p + a * low), a, 0.0, high - low, libm::hypot(x, y), |facet, corners| {
            if part.mesh.defects[facet as usize] == FacetDefect::None {
                found.push((facet, corners.map(|c| in_frame(&c, p, &frame.axes))));
            }
            high - low
        });
    };
    let mut far = FIRST_STRETCH_MM;
    visit(-far, far, &mut found);
    while far < top {
        visit(far, 3.0 * far, &mut found);
        far *= 3.0;
    }
    far = FIRST_STRETCH_MM;
    let mut occluder_mm = f64::NEG_INFINITY;
    while far < -bottom {
        // Searched as wide as the light is at the end of the stretch.
        let half = frame.reach(spot, -far, far);
        occluder_mm = occluder_height_mm(half, found.iter().map(|f| &f.1)).filter(|f| *f > -far).unwrap_or(occluder_mm);
        if occluder_mm > -far {
            break;
        }
        visit(-3.0 * far, -far, &mut found);
        far *= 3.0;
    }
    found.sort_unstable_by_key(|f| f.0);
    found.dedup_by_key(|f| f.0);
    let seen = found.into_iter().filter_map(|(facet, places)| {
        let bound = |k: usize, from: f64, of: fn(f64, f64) -> f64| places.iter().map(|c| c[k]).fold(from, of);
        let low: [f64; 3] = std::array::from_fn(|k| bound(k, f64::INFINITY, f64::min));
        let high: [f64; 3] = std::array::from_fn(|k| bound(k, f64::NEG_INFINITY, f64::max));
        let reach = frame.reach(spot, low[2].max(bottom), high[2].min(top));
        if (0..2).any(|k| low[k] > reach[k] || high[k] < -reach[k]) {
            return None;
        }
        let normal = surfaces.normals[facet as usize];
        let up = part.mesh.normals[facet as usize];
        let up = if up.dot(a) < 0.0 { -up } else { up };
        let lit = run.iter().any(|piece| normal.dot(&piece.from.a) > 0.0 || normal.dot(&piece.to.a) > 0.0);
        let corners = part.mesh.corners(facet as usize);
        let vertices = part.mesh.facets[facet as usize];
        Some(SeenFacet { facet, corners, vertices, rise: up.dot(a), up, lit, low, high })
    });
    // Light is meant for the spot, whatever stands above it: that is shade.
    (seen.collect(), occluder_mm.min(-frame.half[2] - spot.spot_mm))
}
