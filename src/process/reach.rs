//! Which facets a piece of the light comes near, and which of them nothing can shade.
//!
//! Most of a part is lit without anything in between, and a ray for each sample would cost more than
//! all the rest: a facet that no other facet near the beam can shade is told here, once for a piece.

use super::light::{Light, Piece};
use super::shade::Shade;
use crate::part::{Part, Surfaces, topology::Dead};
use nalgebra::{Point3, Vector3};

/// A plane may be missed by this much before a corner counts as beyond it, mm: the rounding of f32
/// coordinates on a metre, which is far less than any shadow is wide.
const PLANE_MM: f64 = 1e-4;
/// Length of the first stretch above and below the spot that is looked at by itself, mm; each further
/// one reaches three times as far.
const FIRST_STRETCH_MM: f64 = 2.0;

/// A piece that comes near a facet.
#[derive(Clone, Copy, Debug)]
pub struct Near {
    /// Its place in [`Light::pieces`].
    pub piece: u32,
    /// Nothing stands between.
    pub clear: bool,
}

/// A facet near a piece, seen along its middle axis.
struct Seen {
    facet: u32,
    corners: [Point3<f64>; 3],
    vertices: [u32; 3],
    /// Unit normal, turned to the light.
    up: Vector3<f64>,
    /// How steeply it rises to the light: sine.
    rise: f64,
    /// Whether its side to be worked on is lit.
    lit: bool,
    /// Least and greatest x, y and height.
    low: [f64; 3],
    high: [f64; 3],
}

/// The facets that get light from a piece (or would, without what stands in between).
pub fn lit_facets(part: &Part, surfaces: &Surfaces, shade: &Shade<'_>, light: &Light, index: u32) -> Vec<(u32, Near)> {
    let Some(piece) = light.pieces.get(index as usize) else { return Vec::new() };
    let seen = seen(part, surfaces, light, piece);
    let turn = libm::sin(0.5 * crate::part::angle::between_deg(&piece.from.a, &piece.to.a).to_radians());
    let slope = light.spot.greatest_slope() + turn;
    let mut out = Vec::new();
    for f in seen.iter().filter(|f| f.lit) {
        let is_clear = |g: &Seen| !may_shade(g, f, slope);
        // Edges of the box around the spot's way from here up: a clamp in it may shade.
        let clear = seen.iter().all(is_clear) && {
            let [x, y] = light.spot.reach_mm(0.0f64.max(light.spot.defocus_mm - f.low[2]));
            let lens_mm = light.spot.defocus_mm + light.spot.optics.lens_to_focus_mm;
            let wide = libm::hypot(x, y).max(0.5 * light.spot.optics.aperture_mm * 2.5);
            let reach_mm = wide + 0.5 * (piece.to.p - piece.from.p).norm() + turn * lens_mm.max(-f.low[2]);
            let (p, a) = (nalgebra::center(&piece.from.p, &piece.to.p), piece.axis(0.5));
            !shade.clamp_near(&(p + a * f.low[2]), &(p + a * lens_mm), reach_mm)
        };
        out.push((f.facet, Near { piece: index, clear }));
    }
    out
}

/// Whether some light to `f` may meet `g` first. `slope`: how far light may lean from the middle axis.
fn may_shade(g: &Seen, f: &Seen, slope: f64) -> bool {
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

/// All facets within the light's reach of a piece, in the order of their numbers.
fn seen(part: &Part, surfaces: &Surfaces, light: &Light, piece: &Piece) -> Vec<Seen> {
    let Some((centre, radius)) = part.bvh.sphere_of_box() else { return Vec::new() };
    let spot = &light.spot;
    let (p, a) = (nalgebra::center(&piece.from.p, &piece.to.p), piece.axis(0.5));
    let o = crate::pose::target::travel(&piece.from.o, &a);
    let n = o.cross(&a);
    let way = piece.to.p - piece.from.p;
    let (half, aside) = (0.5 * way.norm(), 0.5 * way.dot(&n).abs());
    let half_turn = libm::sin(0.5 * crate::part::angle::between_deg(&piece.from.a, &piece.to.a).to_radians());
    let middle = (centre - p).dot(&a);
    let lens_mm = spot.defocus_mm + spot.optics.lens_to_focus_mm;
    let (bottom, top) = (middle - radius, (middle + radius).min(lens_mm));
    // How far along and across the light reaches between two heights.
    let reach = |low: f64, high: f64| {
        let deepest = (spot.defocus_mm - low).abs().max((spot.defocus_mm - high).abs());
        let sway = half_turn * low.abs().max(high.abs());
        spot.reach_mm(deepest).map(|r| r + sway)
    };
    let mut found: Vec<u32> = Vec::new();
    let mut visit = |low: f64, high: f64| {
        let (low, high) = (low.max(bottom), high.min(top));
        if high < low {
            return;
        }
        let [x, y] = reach(low, high);
        part.bvh.visit_ray(&(p + a * low), &a, 0.0, high - low, libm::hypot(x + half, y + aside), |facet, _| {
            found.push(facet);
            high - low
        });
    };
    let mut far = FIRST_STRETCH_MM;
    visit(-far, far);
    while far < top.max(-bottom) {
        visit(far, 3.0 * far);
        visit(-3.0 * far, -far);
        far *= 3.0;
    }
    found.sort_unstable();
    found.dedup();
    let in_frame = |q: &Point3<f64>| {
        let d = q - p;
        [d.dot(&o), d.dot(&n), d.dot(&a)]
    };
    found
        .into_iter()
        .filter(|&f| part.mesh.dead[f as usize] == Dead::No)
        .filter_map(|facet| {
            let corners = part.mesh.corners(facet as usize);
            let places = corners.map(|c| in_frame(&c));
            let low: [f64; 3] = std::array::from_fn(|k| places.iter().map(|c| c[k]).fold(f64::INFINITY, f64::min));
            let high: [f64; 3] =
                std::array::from_fn(|k| places.iter().map(|c| c[k]).fold(f64::NEG_INFINITY, f64::max));
            let [x, y] = reach(low[2].max(bottom), high[2].min(top));
            let beside = |k: usize, r: f64| low[k] > r || high[k] < -r;
            if beside(0, x + half) || beside(1, y + aside) {
                return None;
            }
            let normal = surfaces.normals[facet as usize];
            let up = part.mesh.normals[facet as usize];
            let up = if up.dot(&a) < 0.0 { -up } else { up };
            let lit = normal.dot(&piece.from.a).max(normal.dot(&piece.to.a)) > 0.0;
            let vertices = part.mesh.facets[facet as usize];
            Some(Seen { facet, corners, vertices, rise: up.dot(&a), up, lit, low, high })
        })
        .collect()
}
