//! The turns of a spiral on a surface mesh: where they cross edges, and the chords in facets chained to lines.
//!
//! Every edge and every facet is looked at by itself; only the chaining goes along the spiral.

use super::super::section::{SectionPoint, TransversalLine, chained, merged};
use super::radial::{SpiralAxis, excess, wrapped};
use super::surface_mesh::SurfaceMesh;
use crate::progress::{Cancelled, Progress};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// The number of turns from the centre, less the angle, at the vertices of a surface mesh.
pub(super) struct Winding<'a> {
    surface_mesh: &'a SurfaceMesh,
    axis: &'a SpiralAxis,
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
    pub fn new<'a>(surface_mesh: &'a SurfaceMesh, axis: &'a SpiralAxis, spacing_mm: f64) -> Winding<'a> {
        let polar: Vec<(f64, f64)> = surface_mesh.mesh.vertices.par_iter().map(|p| axis.polar(p)).collect();
        let excess = excess(surface_mesh, axis, &polar);
        let value: Vec<f64> =
            (0..polar.len()).map(|v| (polar[v].0 + excess[v]) / spacing_mm - polar[v].1 / TAU).collect();
        let mut winding = Winding { surface_mesh, axis, spacing_mm, polar, excess, value, first: Vec::new() };
        let crossings = |e: u32| {
            let [a, b] = winding.floors(e);
            (a - b).unsigned_abs().min(u64::from(u32::MAX)) as u32
        };
        let mut first: Vec<u32> = (0..surface_mesh.mesh.edges.len() as u32).into_par_iter().map(crossings).collect();
        let mut before = 0u32;
        for count in &mut first {
            before = before.saturating_add(std::mem::replace(count, before));
        }
        first.push(before);
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
        let [a, b] = self.surface_mesh.mesh.edges[edge as usize];
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

    /// Whether turns are known in a facet, as far as it has any.
    pub fn reaches(&self, facet: usize) -> bool {
        self.surface_mesh.mesh.areas[facet] == 0.0 || self.corners(facet).is_some()
    }

    /// The corners of a facet in the count of its first; the centre twice, as it has two angles. `None`
    /// where the value is not known or the facet goes around the axis.
    fn corners(&self, facet: usize) -> Option<Vec<Corner>> {
        let (mut corners, mut edges) =
            (self.surface_mesh.mesh.facets[facet], self.surface_mesh.mesh.facet_edges[facet]);
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
        let lower = |e: u32| self.surface_mesh.mesh.edges[e as usize][0];
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
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn lines(
        &self,
        merge_mm: f64,
        progress: &Progress,
    ) -> Result<(Vec<TransversalLine>, Vec<Vec<f64>>), Cancelled> {
        let places: Vec<(SectionPoint, f64)> = (0..self.surface_mesh.mesh.edges.len() as u32)
            .into_par_iter()
            .flat_map_iter(|e| {
                let [a, b] = self.floors(e);
                (a.min(b) + 1..=a.max(b)).map(move |level| self.place(e, level))
            })
            .collect();
        progress.check()?;
        // One more than the last crossing: the centre, where the spiral begins.
        let centre = places.len() as u32;
        let gates: Vec<(u32, u32)> =
            (0..self.surface_mesh.mesh.facets.len()).into_par_iter().flat_map_iter(|f| self.gates(f, centre)).collect();
        progress.check()?;
        let start = SectionPoint {
            p: self.axis.at,
            n: self.axis.vertex.map_or(self.axis.along, |v| self.surface_mesh.normals[v as usize]),
        };
        let place = |id: &u32| places.get(*id as usize).copied().unwrap_or((start, 0.0));
        let mut found: Vec<(TransversalLine, Vec<f64>)> = chained(&gates)
            .into_iter()
            .filter_map(|(ids, closed)| {
                let (points, closed) = merged(ids.iter().map(|id| place(id).0).collect(), closed, merge_mm)?;
                // Merging leaves some of the points, in their order.
                let mut rest = ids.iter().map(place);
                let turns = points.iter().filter_map(|q| rest.find(|x| x.0 == *q)).map(|x| x.1).collect();
                Some((TransversalLine { plane: 0, points, closed, dark: Vec::new() }, turns))
            })
            .collect();
        progress.check()?;
        let begin = |turns: &[f64]| turns.first().copied().unwrap_or(0.0);
        found.sort_by(|a, b| begin(&a.1).total_cmp(&begin(&b.1)));
        Ok(found.into_iter().unzip())
    }

    /// Where the spiral comes into a facet and leaves it, on all its turns there.
    fn gates(&self, facet: usize, centre: u32) -> Vec<(u32, u32)> {
        let Some(corners) = self.corners(facet) else { return Vec::new() };
        let (low, high) = corners.iter().fold((i64::MAX, i64::MIN), |(l, h), c| (l.min(c.0), h.max(c.0)));
        let crossed = |level: i64, upwards: bool| {
            (0..corners.len()).find_map(|k| {
                let (from, edge, added) = corners[k];
                let to = corners[(k + 1) % corners.len()].0;
                let here = if upwards { from < level && to >= level } else { from >= level && to < level };
                here.then(|| edge.map_or(centre, |e| self.crossing(e, level - added)))
            })
        };
        (low + 1..=high).filter_map(|level| crossed(level, true).zip(crossed(level, false))).collect()
    }

    /// Number of the crossing of an edge at a level, counted as in [`Winding::floors`].
    fn crossing(&self, edge: u32, level: i64) -> u32 {
        let [a, b] = self.floors(edge);
        self.first[edge as usize] + (level - a.min(b) - 1).clamp(0, i64::from(u32::MAX)) as u32
    }

    /// Where the spiral crosses an edge, and how many turns from the centre.
    fn place(&self, edge: u32, level: i64) -> (SectionPoint, f64) {
        let [a, b] = self.surface_mesh.mesh.edges[edge as usize];
        let (from, to) = (self.excess[a as usize], self.excess[b as usize]);
        let ((near, angle), (far, other)) = (self.polar[a as usize], self.polar[b as usize]);
        let mm = |t: f64, off: f64| off + from + (to - from) * t;
        let level = level as f64;
        if self.is_centre(a) || self.is_centre(b) {
            // Straight outwards, where the angle does not change.
            let whole = level + if self.is_centre(a) { other } else { angle } / TAU;
            let t = (whole * self.spacing_mm - near - from) / (far + to - near - from);
            return (self.surface_mesh.on_edge(edge, t.clamp(0.0, 1.0)), whole);
        }
        let [p, q] = [a, b].map(|v| self.axis.across(&self.surface_mesh.mesh.vertices[v as usize]));
        let way = q - p;
        // Value less level at a share of the way, its rise there, and the turns.
        let at = |t: f64| {
            let r = p + way * t;
            let off = libm::sqrt(r.norm_squared());
            let turns = mm(t, off) / self.spacing_mm;
            let turned = libm::atan2(p.perp(&r), p.dot(&r));
            let rise = (r.dot(&way) / off + to - from) / self.spacing_mm - r.perp(&way) / (off * off * TAU);
            (turns - (angle + turned) / TAU - level, rise, turns)
        };
        let ends =
            [self.value[a as usize], self.value[b as usize] + self.turns_between(a, b) as f64].map(|v| v - level);
        let (mut low, mut high) = (0.0, 1.0);
        let mut t = (ends[0] / (ends[0] - ends[1])).clamp(0.0, 1.0);
        let mut turns = mm(t, near + (far - near) * t) / self.spacing_mm;
        // Newton, kept between ends that hold the place.
        for _ in 0..20 {
            let (wrong, rise, here) = at(t);
            turns = here;
            if wrong.abs() < 1e-9 {
                break;
            }
            if (wrong < 0.0) == (ends[0] < 0.0) {
                low = t
            } else {
                high = t
            }
            let to = t - wrong / rise;
            t = if to > low && to < high { to } else { 0.5 * (low + high) };
        }
        (self.surface_mesh.on_edge(edge, t), turns)
    }
}
