//! One spiral over a surface, its turns one spacing apart (P4 5).
//!
//! It passes the radial curve of angle φ at arc length `Ns (turn + φ/2π)`. So it is where
//! `ρ/Ns − φ/2π` is a whole number, and that is followed from edge to edge: every point lies on an edge and
//! every chord in a facet. Rims and holes cut it into pieces, in the order of the spiral.

use super::super::normals::VertexNormals;
use super::super::section::{SectionPoint, TransversalLine, chained, merged};
use super::net::Net;
use super::radial::{Axis, excess, wrapped};
use super::{Layout, SurfaceLines, mean_normal, spacing};
use crate::part::{Mesh, angle, surfaces::Surface};
use crate::path::planes::live;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A chord within a facet is at most so far from the spiral, mm.
const CHORD_MM: f64 = 0.004;

pub(super) fn lines(
    mesh: &Mesh,
    surface: &Surface,
    normals: &VertexNormals,
    rule: &Layout,
    merge_mm: f64,
) -> SurfaceLines {
    let (net, axis) = centred(mesh, surface, Net::new(mesh, surface, normals), rule);
    let finest = rule.spacing_mm / 24.0;
    let net = net.refined(false, |p| libm::sqrt(8.0 * CHORD_MM * axis.off(p)).max(finest));
    let winding = Winding::new(&net, &axis, rule.spacing_mm);
    let (mut lines, mut turns) = winding.lines(merge_mm);
    // Near the axis a spiral leads outwards more than around, and turns lie nearer.
    let around = |p: &Point3<f64>| axis.off(p) >= 2.5 * rule.spacing_mm;
    let achieved = spacing::measured(&lines, &turns, None, around, rule.spacing_mm);
    if rule.inward {
        lines.reverse();
        turns.reverse();
        lines.iter_mut().for_each(|l| l.points.reverse());
    }
    let missed: f64 = (0..net.mesh.facets.len()).filter(|&f| !winding.reaches(f)).map(|f| net.mesh.areas[f]).sum();
    let reason = if lines.is_empty() {
        Some(format!(
            "no turn of a spiral {} mm apart fits on surface {}: choose a smaller spacing or another strategy",
            rule.spacing_mm, surface.number
        ))
    } else if missed > rule.spacing_mm * rule.spacing_mm {
        Some(format!(
            "{missed:.1} mm² of surface {} are not reached by its spiral: choose another centre or another strategy",
            surface.number
        ))
    } else {
        None
    };
    SurfaceLines { lines, achieved, planes: Vec::new(), reason }
}

/// Where the spiral turns about, its centre a vertex of the net.
///
/// The middle is the centroid of the area, or the given point; its normal line meets the surface in the
/// centre. Where it meets nothing, the centre is a hole. A closed surface has no mean normal; then it is z.
fn centred(mesh: &Mesh, surface: &Surface, net: Net, rule: &Layout) -> (Net, Axis) {
    let (sum, area) = live(mesh, surface)
        .fold((Vector3::zeros(), 0.0), |(s, a), f| (s + mesh.centroid(f).coords * mesh.areas[f], a + mesh.areas[f]));
    let middle = rule.centre.unwrap_or(Point3::from(sum / f64::max(area, 1e-300)));
    let mean = mean_normal(mesh, surface);
    let along = mean.unwrap_or_else(Vector3::z);
    // On a closed surface the far end of the line; else the nearest place.
    let hits = (0..net.mesh.facets.len() as u32).filter_map(|f| {
        let (weights, height) = pierced(&net.mesh.corners(f as usize), &middle, &along)?;
        Some((if mean.is_some() || rule.centre.is_some() { height.abs() } else { -height }, f, weights))
    });
    let hit = hits.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let axis = |at: Point3<f64>, along: Vector3<f64>, vertex: Option<u32>| {
        let u = angle::any_square_to(&along);
        Axis { at, along, u, v: along.cross(&u), vertex }
    };
    let Some((_, facet, weights)) = hit else { return (net, axis(middle, along, None)) };
    let own = net.mesh.normals[facet as usize];
    let (net, vertex) = net.with_vertex(facet, weights);
    // Vertex normals look to the side that is worked on; the curves need that of the facets.
    let there = net.normals[vertex as usize];
    let there = if there.dot(&own) < 0.0 { -there } else { there };
    let at = net.mesh.vertices[vertex as usize];
    (net, axis(at, angle::unit(there).unwrap_or(own), Some(vertex)))
}

/// Where a line meets a facet: weights of its corners, and height along the line.
fn pierced(corners: &[Point3<f64>; 3], p: &Point3<f64>, along: &Vector3<f64>) -> Option<([f64; 3], f64)> {
    let [a, b, c] = corners.map(|q| q - p);
    let parts = [b.cross(&c).dot(along), c.cross(&a).dot(along), a.cross(&b).dot(along)];
    let whole: f64 = parts.iter().sum();
    let weights = parts.map(|x| x / whole);
    let height = (a * weights[0] + b * weights[1] + c * weights[2]).dot(along);
    (whole != 0.0 && height.is_finite() && weights.iter().all(|w| *w >= -1e-9)).then(|| {
        let kept = weights.map(|w| w.max(0.0));
        let sum: f64 = kept.iter().sum();
        (kept.map(|w| w / sum), height)
    })
}

/// The number of turns from the centre, less the angle, at the vertices of a net.
struct Winding<'a> {
    net: &'a Net,
    axis: &'a Axis,
    spacing_mm: f64,
    polar: Vec<(f64, f64)>,
    excess: Vec<f64>,
    /// `ρ/Ns − φ/2π`.
    value: Vec<f64>,
    /// Number of the first crossing of each edge; they count from its least value upwards.
    first: Vec<u32>,
}

/// In a facet the whole part of the value at a corner, the edge to the next corner (`None`: the centre
/// itself), and what is to be added to a value of that edge to be one of the facet.
type Corner = (i64, Option<u32>, i64);

impl Winding<'_> {
    fn new<'a>(net: &'a Net, axis: &'a Axis, spacing_mm: f64) -> Winding<'a> {
        let polar: Vec<(f64, f64)> = net.mesh.vertices.par_iter().map(|p| axis.polar(p)).collect();
        let excess = excess(net, axis);
        let value: Vec<f64> =
            (0..polar.len()).map(|v| (polar[v].0 + excess[v]) / spacing_mm - polar[v].1 / TAU).collect();
        let mut winding = Winding { net, axis, spacing_mm, polar, excess, value, first: Vec::new() };
        let mut first = Vec::with_capacity(net.mesh.edges.len() + 1);
        let mut count = 0u32;
        for e in 0..net.mesh.edges.len() as u32 {
            first.push(count);
            let [a, b] = winding.floors(e);
            count = count.saturating_add((a - b).unsigned_abs().min(u64::from(u32::MAX)) as u32);
        }
        first.push(count);
        winding.first = first;
        winding
    }

    fn is_centre(&self, v: u32) -> bool {
        self.axis.vertex == Some(v)
    }

    /// Whole turns between two vertices that lie on either side of φ = 0, so that `value(b)` and these
    /// continue `value(a)`.
    fn turns_between(&self, a: u32, b: u32) -> i64 {
        let (a, b) = (self.polar[a as usize].1, self.polar[b as usize].1);
        ((b - a - wrapped(b - a)) / TAU).round() as i64
    }

    /// Whole parts of the values at the lower and the higher end of an edge, in the count of its lower end
    /// (of the other where that is the centre); equal where the value is not known.
    fn floors(&self, edge: u32) -> [i64; 2] {
        let [a, b] = self.net.mesh.edges[edge as usize];
        let whole = |v: u32| self.value[v as usize].floor() as i64;
        if !self.value[a as usize].is_finite() || !self.value[b as usize].is_finite() {
            return [0, 0];
        }
        match (self.is_centre(a), self.is_centre(b)) {
            (true, _) => [self.at_centre(b), whole(b)],
            (_, true) => [whole(a), self.at_centre(a)],
            _ => [whole(a), whole(b) + self.turns_between(a, b)],
        }
    }

    /// Whole part of the value at the centre, seen from a vertex.
    fn at_centre(&self, from: u32) -> i64 {
        (-self.polar[from as usize].1 / TAU).floor() as i64
    }

    fn reaches(&self, facet: usize) -> bool {
        self.net.mesh.areas[facet] == 0.0 || self.corners(facet).is_some()
    }

    /// The corners of a facet in the count of its first; the centre twice, as it has two angles. `None`
    /// where the value is not known or the facet goes around the axis.
    fn corners(&self, facet: usize) -> Option<Vec<Corner>> {
        let (mut corners, mut edges) = (self.net.mesh.facets[facet], self.net.mesh.facet_edges[facet]);
        if corners.iter().any(|&v| !self.value[v as usize].is_finite()) {
            return None;
        }
        // The centre last.
        while corners[..2].iter().any(|&v| self.is_centre(v)) {
            corners.rotate_left(1);
            edges.rotate_left(1);
        }
        let [a, b, c] = corners;
        let added = |v: u32| if v == a { 0 } else { self.turns_between(a, v) };
        let whole = |v: u32| self.value[v as usize].floor() as i64 + added(v);
        let lower = |e: u32| self.net.mesh.edges[e as usize][0];
        if self.is_centre(c) {
            return Some(vec![
                (whole(a), Some(edges[0]), added(lower(edges[0]))),
                (whole(b), Some(edges[1]), added(b)),
                (self.at_centre(b) + added(b), None, 0),
                (self.at_centre(a), Some(edges[2]), 0),
            ]);
        }
        let around = self.turns_between(a, b) + self.turns_between(b, c) + self.turns_between(c, a);
        (around == 0).then(|| {
            let corner = |v: u32, e: u32| (whole(v), Some(e), added(lower(e)));
            vec![corner(a, edges[0]), corner(b, edges[1]), corner(c, edges[2])]
        })
    }

    /// The pieces in the order of the spiral, with the turns at their points.
    fn lines(&self, merge_mm: f64) -> (Vec<TransversalLine>, Vec<Vec<f64>>) {
        let places: Vec<(SectionPoint, f64)> = (0..self.net.mesh.edges.len() as u32)
            .into_par_iter()
            .flat_map_iter(|e| {
                let [a, b] = self.floors(e);
                (a.min(b) + 1..=a.max(b)).map(move |level| self.place(e, level))
            })
            .collect();
        // One more than the last crossing: the centre, where the spiral begins.
        let centre = places.len() as u32;
        let mut gates = Vec::new();
        for facet in 0..self.net.mesh.facets.len() {
            let Some(corners) = self.corners(facet) else { continue };
            let (low, high) = corners.iter().fold((i64::MAX, i64::MIN), |(l, h), c| (l.min(c.0), h.max(c.0)));
            for level in low + 1..=high {
                let crossed = |upwards: bool| {
                    (0..corners.len()).find_map(|k| {
                        let (from, edge, added) = corners[k];
                        let to = corners[(k + 1) % corners.len()].0;
                        let here = if upwards { from < level && to >= level } else { from >= level && to < level };
                        here.then(|| edge.map_or(centre, |e| self.crossing(e, level - added)))
                    })
                };
                gates.extend(crossed(true).zip(crossed(false)));
            }
        }
        let start = SectionPoint {
            p: self.axis.at,
            n: self.axis.vertex.map_or(self.axis.along, |v| self.net.normals[v as usize]),
        };
        let place = |id: u32| places.get(id as usize).copied().unwrap_or((start, 0.0));
        let mut found: Vec<(TransversalLine, Vec<f64>)> = chained(&gates)
            .into_iter()
            .filter_map(|(ids, closed)| {
                let all: Vec<(SectionPoint, f64)> = ids.into_iter().map(place).collect();
                let (points, closed) = merged(all.iter().map(|x| x.0).collect(), closed, merge_mm)?;
                // Merging leaves some of the points, in their order.
                let mut rest = all.iter();
                let turns = points.iter().filter_map(|q| rest.find(|x| x.0 == *q)).map(|x| x.1).collect();
                Some((TransversalLine { plane: 0, points, closed, dark: Vec::new() }, turns))
            })
            .collect();
        let begin = |turns: &[f64]| turns.first().copied().unwrap_or(0.0);
        found.sort_by(|a, b| begin(&a.1).total_cmp(&begin(&b.1)));
        found.into_iter().unzip()
    }

    /// Number of the crossing of an edge at a level, counted as in [`Winding::floors`].
    fn crossing(&self, edge: u32, level: i64) -> u32 {
        let [a, b] = self.floors(edge);
        self.first[edge as usize] + (level - a.min(b) - 1).clamp(0, i64::from(u32::MAX)) as u32
    }

    /// Where the spiral crosses an edge, and how many turns from the centre.
    fn place(&self, edge: u32, level: i64) -> (SectionPoint, f64) {
        let [a, b] = self.net.mesh.edges[edge as usize];
        let base = if self.is_centre(a) { b } else { a };
        let (from, to) = (self.excess[a as usize], self.excess[b as usize]);
        let angle = self.polar[base as usize].1;
        let at = |t: f64| {
            let p = self.net.on_edge(edge, t);
            let (off, there) = self.axis.polar(&p.p);
            let radial = self.is_centre(a) || self.is_centre(b);
            let turns = (off + from + (to - from) * t) / self.spacing_mm;
            let there = if radial { angle } else { angle + wrapped(there - angle) };
            (p, turns, turns - there / TAU - level as f64)
        };
        let (mut low, mut high) = ((0.0, at(0.0).2), (1.0, at(1.0).2));
        let mut found = at(0.5);
        // Regula falsi, Illinois.
        for _ in 0..20 {
            let t = ((low.0 * high.1 - high.0 * low.1) / (high.1 - low.1)).clamp(0.0, 1.0);
            if !t.is_finite() {
                break;
            }
            found = at(t);
            if found.2.abs() < 1e-9 {
                break;
            }
            if (found.2 < 0.0) == (low.1 < 0.0) {
                low = (t, found.2);
                high.1 *= 0.5;
            } else {
                high = (t, found.2);
                low.1 *= 0.5;
            }
        }
        (found.0, found.1)
    }
}
