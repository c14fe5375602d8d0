//! Arc length from the centre of a spiral to every vertex of a surface mesh, along radial curves: the surface cut
//! by half-planes through the centre's axis (P4 5).
//!
//! A curve is walked inwards from facet to facet. Across a hole, or from island to island, it goes on
//! in a straight line to the next rim in its half-plane, so that turns keep their place behind it. It ends at
//! the centre, or at the innermost rim where the centre is a hole.

use super::surface_mesh::SurfaceMesh;
use nalgebra::{Point3, Vector2, Vector3};
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Where a spiral turns about.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpiralAxis {
    /// A point of it: the centre, where that is on the surface.
    pub at: Point3<f64>,
    /// Directions: the axis itself and two square to it.
    pub along: Vector3<f64>,
    pub u: Vector3<f64>,
    pub v: Vector3<f64>,
    /// The centre's vertex; `None`: it is a hole.
    pub vertex: Option<u32>,
}

impl SpiralAxis {
    /// Where a point stands across the axis, mm.
    pub fn across(&self, p: &Point3<f64>) -> Vector2<f64> {
        Vector2::new((p - self.at).dot(&self.u), (p - self.at).dot(&self.v))
    }

    /// Distance from the axis, mm, and angle about it, 0 to 2π.
    pub fn polar(&self, p: &Point3<f64>) -> (f64, f64) {
        let across = self.across(p);
        let angle = libm::atan2(across.y, across.x);
        (self.radius_mm(p), if angle < 0.0 { (angle + TAU).min(TAU * (1.0 - f64::EPSILON)) } else { angle })
    }

    /// Distance from the axis, mm.
    pub fn radius_mm(&self, p: &Point3<f64>) -> f64 {
        libm::sqrt(self.across(p).norm_squared())
    }
}

/// Sectors by which rims are looked up.
const SECTORS: usize = 1024;
/// Number of groups in which vertices are computed, from the axis outwards: a curve that meets an edge of the
/// groups before it has its length from there.
const GROUPS: usize = 16;

/// Lengths at the vertices less their distance from the axis, mm: on a plane 0. NaN where no radial curve
/// tells it: on the axis, but for the centre.
///
/// `polar`: distance from the axis and angle of every vertex.
pub(super) fn excess(surface_mesh: &SurfaceMesh, axis: &SpiralAxis, polar: &[(f64, f64)]) -> Vec<f64> {
    let walk = Walk { surface_mesh, axis, polar, rims: rims(surface_mesh, polar) };
    let count = polar.len();
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.par_sort_by(|&a, &b| polar[a as usize].0.total_cmp(&polar[b as usize].0).then(a.cmp(&b)));
    let mut excess = vec![f64::NAN; count];
    let mut known = vec![false; count];
    for group in order.chunks(count.div_ceil(GROUPS).max(1)) {
        let found: Vec<f64> = group.par_iter().map(|&v| walk.excess(v, &excess, &known)).collect();
        for (&v, found) in group.iter().zip(found) {
            excess[v as usize] = found;
            known[v as usize] = found.is_finite();
        }
    }
    excess
}

/// Rim edges by the sectors that they pass.
fn rims(surface_mesh: &SurfaceMesh, polar: &[(f64, f64)]) -> Vec<Vec<u32>> {
    let mut rims = vec![Vec::new(); SECTORS];
    let sector = |angle: f64| ((angle / TAU * SECTORS as f64).floor() as i64).rem_euclid(SECTORS as i64) as usize;
    for e in surface_mesh.rim() {
        let [a, b] = surface_mesh.mesh.edges[e as usize].map(|v| polar[v as usize].1);
        let turn = wrapped(b - a);
        let (from, width) = if turn < 0.0 { (b, -turn) } else { (a, turn) };
        let count = (width / TAU * SECTORS as f64).ceil() as usize + 1;
        for i in 0..count.min(SECTORS) {
            rims[(sector(from) + i) % SECTORS].push(e);
        }
    }
    rims
}

/// An angle between −π and π.
pub(super) fn wrapped(angle: f64) -> f64 {
    if angle > PI {
        angle - TAU
    } else if angle < -PI {
        angle + TAU
    } else {
        angle
    }
}

/// Where a curve comes in over a rim: facet, edge and place.
type RimEntry = (u32, u32, Point3<f64>);

struct Walk<'a> {
    surface_mesh: &'a SurfaceMesh,
    axis: &'a SpiralAxis,
    polar: &'a [(f64, f64)],
    rims: Vec<Vec<u32>>,
}

/// The half-plane of one radial curve, from the axis outwards.
struct HalfPlane<'a> {
    surface_mesh: &'a SurfaceMesh,
    axis: &'a SpiralAxis,
    /// The vertex that the curve begins at.
    start: u32,
    /// Its angle about the axis.
    angle: f64,
    /// Unit, square to the half-plane.
    side: Vector3<f64>,
}

impl HalfPlane<'_> {
    /// Signed distance of a vertex, mm. A vertex on the half-plane counts as before it; those that must lie on it
    /// do.
    fn height(&self, v: u32) -> f64 {
        let exact = v == self.start || self.axis.vertex == Some(v);
        if exact { 0.0 } else { (self.surface_mesh.mesh.vertices[v as usize] - self.axis.at).dot(&self.side) }
    }

    /// Where it crosses an edge, and at which share of the edge.
    fn crossing(&self, a: u32, b: u32) -> (Point3<f64>, f64) {
        let (ha, hb) = (self.height(a), self.height(b));
        let t = if ha == hb { 0.5 } else { (ha / (ha - hb)).clamp(0.0, 1.0) };
        let (p, q) = (self.surface_mesh.mesh.vertices[a as usize], self.surface_mesh.mesh.vertices[b as usize]);
        (p + (q - p) * t, t)
    }
}

impl Walk<'_> {
    fn half_plane(&self, start: u32, angle: f64) -> HalfPlane<'_> {
        let outward = self.axis.u * libm::cos(angle) + self.axis.v * libm::sin(angle);
        HalfPlane {
            surface_mesh: self.surface_mesh,
            axis: self.axis,
            start,
            angle,
            side: self.axis.along.cross(&outward),
        }
    }

    /// Length of the radial curve of a vertex less its distance from the axis, mm; NaN where there is none.
    fn excess(&self, vertex: u32, known_excess: &[f64], known: &[bool]) -> f64 {
        if self.axis.vertex == Some(vertex) {
            return 0.0;
        }
        let mesh = &self.surface_mesh.mesh;
        let (off, angle) = self.polar[vertex as usize];
        if off < 1e-9 {
            return f64::NAN;
        }
        let plane = self.half_plane(vertex, angle);
        let mut here = mesh.vertices[vertex as usize];
        let mut length = 0.0;
        let mut next = self.first_exit(&plane);
        // No curve passes a facet twice; one that does (on a Möbius strip) goes round for ever.
        let mut passed = u32::MAX;
        for step in 1..2 * mesh.facets.len() + 4 {
            let Some((facet, leaves)) = next else {
                // Past a rim: on to the next one inwards, if there is one.
                let Some((facet, entered, at)) = self.over_gap(&here, &plane) else {
                    return if self.axis.vertex.is_none() { length - off } else { f64::NAN };
                };
                length += (at - here).norm();
                here = at;
                next = self.exit(facet, entered, &plane).or_else(|| self.has_centre(facet).then_some((facet, 0)));
                if next.is_none() {
                    return f64::NAN;
                }
                continue;
            };
            if facet == passed {
                return f64::NAN;
            }
            if step.is_power_of_two() {
                passed = facet;
            }
            if self.has_centre(facet) {
                return length + (here - self.axis.at).norm() - off;
            }
            let corners = mesh.facets[facet as usize];
            let (a, b) = (corners[leaves], corners[(leaves + 1) % 3]);
            let (at, t) = plane.crossing(a, b);
            length += (at - here).norm();
            here = at;
            let (a, b) = (a as usize, b as usize);
            if known[a] && known[b] && a != vertex as usize && b != vertex as usize {
                let rest = self.axis.radius_mm(&at) + known_excess[a] + (known_excess[b] - known_excess[a]) * t;
                return length + rest - off;
            }
            let edge = mesh.facet_edges[facet as usize][leaves];
            let over = mesh.two_facets(edge).map(|[f, g]| if f == facet { g } else { f });
            next = over.and_then(|g| self.exit(g, edge, &plane));
        }
        f64::NAN
    }

    /// The facet that a curve enters from its first vertex, and the edge by which it leaves that facet.
    fn first_exit(&self, plane: &HalfPlane<'_>) -> Option<(u32, usize)> {
        let mesh = &self.surface_mesh.mesh;
        mesh.vertex_facets(plane.start).iter().find_map(|&f| {
            let k = mesh.facets[f as usize].iter().position(|&v| v == plane.start)?;
            let (p, q) = (mesh.facets[f as usize][(k + 1) % 3], mesh.facets[f as usize][(k + 2) % 3]);
            (plane.height(p) >= 0.0 && plane.height(q) < 0.0).then_some((f, (k + 1) % 3))
        })
    }

    /// Whether the centre of the spiral is a corner of a facet.
    fn has_centre(&self, facet: u32) -> bool {
        self.axis.vertex.is_some_and(|c| self.surface_mesh.mesh.facets[facet as usize].contains(&c))
    }

    /// The edge by which a curve leaves a facet that it has entered by another.
    fn exit(&self, facet: u32, entered: u32, plane: &HalfPlane<'_>) -> Option<(u32, usize)> {
        let corners = self.surface_mesh.mesh.facets[facet as usize];
        let before = corners.map(|v| plane.height(v) >= 0.0);
        (0..3)
            .find(|&k| {
                before[k] && !before[(k + 1) % 3] && self.surface_mesh.mesh.facet_edges[facet as usize][k] != entered
            })
            .map(|k| (facet, k))
    }

    /// The nearest rim further inwards in the half-plane: facet, edge and place.
    fn over_gap(&self, here: &Point3<f64>, plane: &HalfPlane<'_>) -> Option<RimEntry> {
        let mesh = &self.surface_mesh.mesh;
        let from = self.axis.radius_mm(here) * (1.0 - 1e-9);
        let sector = ((plane.angle / TAU * SECTORS as f64) as usize).min(SECTORS - 1);
        let mut best: Option<(f64, RimEntry)> = None;
        for &e in &self.rims[sector] {
            let Some(&f) = mesh.edge_facets(e).first() else { continue };
            let Some(k) = mesh.facet_edges[f as usize].iter().position(|&x| x == e) else { continue };
            let (a, b) = (mesh.facets[f as usize][k], mesh.facets[f as usize][(k + 1) % 3]);
            // Only where the curve comes in by this edge.
            if plane.height(a) < 0.0 && plane.height(b) >= 0.0 {
                let at = plane.crossing(a, b).0;
                let off = self.axis.radius_mm(&at);
                let same_side = wrapped(self.axis.polar(&at).1 - plane.angle).abs() < 1.0;
                if same_side && off < from && best.as_ref().is_none_or(|b| off > b.0) {
                    best = Some((off, (f, e, at)));
                }
            }
        }
        best.map(|b| b.1)
    }
}
