//! Distance over the surface from a border, at every vertex of a surface mesh.
//!
//! From facet to facet: the nearest way to a corner crosses the opposite edge. Along that edge the
//! distance is known at both ends with its slope, so between them by a cubic; the slope comes with the
//! direction of the nearest way, carried from plane to plane (jets, as in Potter and Cameron). So
//! fronts, straight or curved, stay what they are on coarse facets too. A way that is found always
//! exists, so a vertex that is reached in a better way later is simply taken up again; that replaces
//! the unfolding of obtuse facets.

use super::surface_mesh::SurfaceMesh;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Distances on a surface mesh.
pub(super) struct DistanceField {
    /// At the vertices, mm; infinite where no way leads from the border.
    pub mm: Vec<f64>,
    /// Unit direction of the way that arrives at a vertex, and the facet in whose plane it lies.
    arrives: Vec<(Vector3<f64>, u32)>,
    /// For each edge at a border vertex the slope of the distance along it, from its lower end and from
    /// its higher.
    border: Vec<[f64; 2]>,
    is_border: Vec<bool>,
    /// Whether a vertex was processed since its distance last changed. A slope that may still
    /// change would let the cubic sink below the truth, and what is too short is never made longer.
    is_settled: Vec<bool>,
}

/// A difference of slopes that tells a ridge from a curved front: 17°.
const RIDGE: f64 = 0.3;

/// How often a vertex is processed at most. Behind an obtuse corner once more is enough; without a limit two
/// corners of a sliver could improve each other for ever by the error of the cubic.
const MOST_TURNS: u8 = 4;

impl DistanceField {
    /// Distances from these edges of the surface mesh. Ways shorter by less than `grain_mm` are not followed.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(
        surface_mesh: &SurfaceMesh,
        from: &[u32],
        grain_mm: f64,
        progress: &Progress,
    ) -> Result<DistanceField, Cancelled> {
        let count = surface_mesh.mesh.vertices.len();
        let mut field = DistanceField {
            mm: vec![f64::INFINITY; count],
            arrives: vec![(Vector3::zeros(), 0); count],
            border: vec![[1.0; 2]; surface_mesh.mesh.edges.len()],
            is_border: vec![false; count],
            is_settled: vec![false; count],
        };
        let mut heap = BinaryHeap::new();
        for &e in from {
            for v in surface_mesh.mesh.edges[e as usize] {
                field.set_border_slopes(surface_mesh, e, v);
                field.is_border[v as usize] = true;
                field.mm[v as usize] = 0.0;
                heap.push(Reverse((0u64, v)));
            }
        }
        let mut turns = vec![0u8; count];
        // Distances are not negative: their bits sort as they do.
        while let Some(Reverse((bits, v))) = heap.pop() {
            progress.check()?;
            if f64::from_bits(bits) > field.mm[v as usize] {
                continue;
            }
            field.is_settled[v as usize] = true;
            turns[v as usize] = turns[v as usize].saturating_add(1);
            for &f in surface_mesh.mesh.vertex_facets(v) {
                let corners = surface_mesh.mesh.facets[f as usize];
                for k in (0..3).filter(|&k| corners[k] != v) {
                    // Over the edge from v to the third corner.
                    let across = (k + 1) % 3;
                    if let Some((mm, direction)) = field.nearest_way(surface_mesh, f, across)
                        && mm < field.mm[corners[k] as usize] - grain_mm
                        && turns[corners[k] as usize] < MOST_TURNS
                    {
                        let at = corners[k] as usize;
                        field.mm[at] = mm;
                        field.arrives[at] = (direction, f);
                        field.is_settled[at] = false;
                        heap.push(Reverse((mm.to_bits(), corners[k])));
                    }
                }
            }
        }
        Ok(field)
    }

    /// Slopes along the edges that leave a border vertex, by their angle to one border edge there.
    fn set_border_slopes(&mut self, surface_mesh: &SurfaceMesh, edge: u32, vertex: u32) {
        let end = |e: u32| usize::from(surface_mesh.mesh.edges[e as usize][1] == vertex);
        self.border[edge as usize][end(edge)] = 0.0;
        let (mut e, mut angle) = (edge, 0.0);
        let mut facet = surface_mesh.mesh.edge_facets(edge).first().copied();
        // No fan has more facets than the vertex.
        for _ in surface_mesh.mesh.vertex_facets(vertex) {
            let Some(f) = facet.map(|f| f as usize) else { return };
            let Some(k) = surface_mesh.mesh.facets[f].iter().position(|&v| v == vertex) else { return };
            let corners = surface_mesh.mesh.corners(f);
            let (u, v) = (corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
            angle += libm::atan2(u.cross(&v).norm(), u.dot(&v));
            if angle >= std::f64::consts::FRAC_PI_2 {
                return;
            }
            let edges = surface_mesh.mesh.facet_edges[f];
            e = if edges[k] == e { edges[(k + 2) % 3] } else { edges[k] };
            let slope = &mut self.border[e as usize][end(e)];
            *slope = slope.min(libm::sin(angle));
            facet = surface_mesh.mesh.two_facets(e).map(|[a, b]| if a as usize == f { b } else { a });
        }
    }

    /// Slope of the distance at a vertex along one of its edges, seen in a facet beside it.
    fn slope(&self, surface_mesh: &SurfaceMesh, facet: u32, edge: u32, vertex: u32, along: &Vector3<f64>) -> f64 {
        if self.is_border[vertex as usize] {
            return self.border[edge as usize][usize::from(surface_mesh.mesh.edges[edge as usize][1] == vertex)];
        }
        let (direction, from) = self.arrives[vertex as usize];
        let (n, m) = (surface_mesh.mesh.normals[from as usize], surface_mesh.mesh.normals[facet as usize]);
        // Turned with the facets' planes, about the line in which they meet.
        let turned = direction - (n + m) * (direction.dot(&m) / (1.0 + n.dot(&m)).max(0.1));
        turned.dot(along).clamp(-1.0, 1.0)
    }

    /// The distance along an edge from `from` to `to`, seen in a facet beside it.
    pub fn along(&self, surface_mesh: &SurfaceMesh, facet: u32, edge: u32, from: u32, to: u32) -> Along {
        let way = surface_mesh.mesh.vertices[to as usize] - surface_mesh.mesh.vertices[from as usize];
        let length = way.norm();
        let unit = way / length.max(1e-300);
        Along {
            length,
            ends: [self.mm[from as usize], self.mm[to as usize]],
            slopes: [
                self.slope(surface_mesh, facet, edge, from, &unit),
                -self.slope(surface_mesh, facet, edge, to, &-unit),
            ],
        }
    }

    /// The nearest way to the corner of a facet opposite to its edge `k`.
    fn nearest_way(&self, surface_mesh: &SurfaceMesh, facet: u32, k: usize) -> Option<(f64, Vector3<f64>)> {
        let f = facet as usize;
        let corners = surface_mesh.mesh.facets[f];
        let at = |i: usize| surface_mesh.mesh.vertices[corners[i % 3] as usize];
        let (a, c) = (at(k), at(k + 2));
        let known = |i: usize| self.is_settled[corners[i % 3] as usize];
        let direct = |i: usize| (self.mm[corners[i % 3] as usize] + (c - at(i)).norm(), c - at(i));
        let (mm, way) = match (known(k), known(k + 1)) {
            (true, true) => {
                let along = self.along(
                    surface_mesh,
                    facet,
                    surface_mesh.mesh.facet_edges[f][k],
                    corners[k],
                    corners[(k + 1) % 3],
                );
                let unit = (at(k + 1) - a) / along.length.max(1e-300);
                let x = (c - a).dot(&unit);
                let y = (c - a - unit * x).norm();
                let (foot, mm) = along.nearest(x, y);
                (mm, c - (a + unit * foot))
            }
            (true, false) => direct(k),
            (false, true) => direct(k + 1),
            (false, false) => return None,
        };
        let length = way.norm();
        (length > 0.0 && mm.is_finite()).then(|| (mm, way / length))
    }

    /// The distance inside a facet: the least over its three edges.
    pub fn inside(&self, surface_mesh: &SurfaceMesh, facet: u32, p: &Point3<f64>) -> f64 {
        let corners = surface_mesh.mesh.facets[facet as usize];
        (0..3)
            .map(|k| {
                let (from, to) = (corners[k], corners[(k + 1) % 3]);
                let along = self.along(surface_mesh, facet, surface_mesh.mesh.facet_edges[facet as usize][k], from, to);
                let a = surface_mesh.mesh.vertices[from as usize];
                let unit = (surface_mesh.mesh.vertices[to as usize] - a) / along.length.max(1e-300);
                let x = (p - a).dot(&unit);
                along.nearest(x, (p - a - unit * x).norm()).1
            })
            .fold(f64::INFINITY, f64::min)
    }
}

/// Distance from the border along one edge: at its ends, with slopes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Along {
    pub length: f64,
    pub ends: [f64; 2],
    pub slopes: [f64; 2],
}

impl Along {
    /// Where two fronts meet, from the first end on to the other at most; `None` where one front passes.
    fn kink(&self) -> Option<f64> {
        let bend = self.slopes[0] - self.slopes[1];
        let x = (self.ends[1] - self.slopes[1] * self.length - self.ends[0]) / bend;
        (bend > RIDGE).then(|| x.clamp(0.0, self.length))
    }

    /// Where two fronts meet between the ends, and the distance there.
    pub fn ridge(&self) -> Option<(f64, f64)> {
        let x = self.kink().filter(|&x| x > 1e-3 * self.length && x < (1.0 - 1e-3) * self.length)?;
        Some((x, self.ends[0] + self.slopes[0] * x))
    }

    /// The distance at `x` from the first end, where no ridge is.
    pub fn at(&self, x: f64) -> f64 {
        let (l, t) = (self.length, x / self.length.max(1e-300));
        let ([a, b], [s, r]) = (self.ends, self.slopes);
        let (u, v) = (1.0 - t, t);
        a * u * u * (1.0 + 2.0 * v) + b * v * v * (1.0 + 2.0 * u) + l * u * v * (s * u - r * v)
    }

    /// The place on the edge over which a point is nearest to the border, and how near. The point is at
    /// `px` along the edge and `py` off it.
    fn nearest(&self, px: f64, py: f64) -> (f64, f64) {
        let off = |x: f64| libm::sqrt((x - px) * (x - px) + py * py);
        let least = |a: (f64, f64), b: (f64, f64)| if b.1 < a.1 { b } else { a };
        let l = self.length;
        let ends = least((0.0, self.ends[0] + off(0.0)), (l, self.ends[1] + off(l)));
        // With one slope all along: in closed form.
        let straight = |s: f64| {
            if s.abs() < 1.0 { px - s * py / libm::sqrt(1.0 - s * s) } else { -s.signum() * f64::INFINITY }
        };
        if let Some(kink) = self.kink() {
            // One line of one slope each side; from an end where the fronts meet there.
            let peak = if let Some((_, peak)) = self.ridge() { peak } else { self.ends[usize::from(kink > 0.5 * l)] };
            let rise = (peak - self.ends[0]) / kink.max(1e-300);
            let fall = (self.ends[1] - peak) / (l - kink).max(1e-300);
            let (x, y) = (straight(rise).clamp(0.0, kink), straight(fall).clamp(kink, l));
            let one = (x, self.ends[0] + rise * x + off(x));
            let two = (y, self.ends[1] - fall * (l - y) + off(y));
            return least(least(one, two), ends);
        }
        let mut x = straight((self.ends[1] - self.ends[0]) / l.max(1e-300)).clamp(0.0, l);
        for _ in 0..4 {
            let d = off(x).max(1e-300);
            let (first, second) = self.slopes_at(x);
            let (rise, bend) = (first + (x - px) / d, second + py * py / (d * d * d));
            let to = (x - rise / bend).clamp(0.0, l);
            if bend <= 0.0 || !to.is_finite() || (to - x).abs() < 1e-9 * l {
                break;
            }
            x = to;
        }
        least((x, self.at(x) + off(x)), ends)
    }

    /// First and second derivative at `x`.
    fn slopes_at(&self, x: f64) -> (f64, f64) {
        let l = self.length.max(1e-300);
        let t = x / l;
        let ([a, b], [s, r]) = (self.ends, self.slopes);
        let rise = (b - a) / l;
        let first = s * (1.0 - t) * (1.0 - 3.0 * t) + r * t * (3.0 * t - 2.0) + 6.0 * rise * t * (1.0 - t);
        let second = (s * (6.0 * t - 4.0) + r * (6.0 * t - 2.0) + 6.0 * rise * (1.0 - 2.0 * t)) / l;
        (first, second)
    }

    /// Where the distance is `level`, between the ends' distances; not for a ridge between the ends.
    pub fn place(&self, level: f64) -> f64 {
        let up = self.ends[0] < self.ends[1];
        let (mut low, mut high) = (0.0, self.length);
        let mut x = self.length * ((level - self.ends[0]) / (self.ends[1] - self.ends[0])).clamp(0.0, 1.0);
        if self.kink().is_some() {
            return x;
        }
        // Newton, kept between ends that hold the place.
        for _ in 0..12 {
            let wrong = self.at(x) - level;
            if wrong.abs() < 1e-10 {
                break;
            }
            if (wrong < 0.0) == up {
                low = x
            } else {
                high = x
            }
            let to = x - wrong / self.slopes_at(x).0;
            x = if to > low && to < high { to } else { 0.5 * (low + high) };
        }
        x
    }
}
