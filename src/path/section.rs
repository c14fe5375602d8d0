//! Transversal lines: a surface cut by a plane, walked along the topology (P2 4.2.1, Algorithm 1).
//!
//! A vertex on the plane counts as above it, everywhere; then every crossed facet has one edge that
//! the winding takes upwards and one downwards. Entering by the first and leaving by the second, the
//! points come out in order, and every line runs in the sense of (facet normal × plane normal).

use super::key_index::KeyIndex;
use super::normals::{VertexNormals, between};
use crate::part::{Mesh, surfaces::Surface, topology::FacetDefect};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// A point of a transversal line with the surface normal there (unit).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPoint {
    /// On the part, mm.
    pub p: Point3<f64>,
    /// Unit normal of the surface.
    pub n: Vector3<f64>,
}

/// One line of one surface in one plane.
#[derive(Clone, Debug, PartialEq)]
pub struct TransversalLine {
    /// Rank of the line on its surface, from 0: the index of its plane or of its distance from the
    /// border; 0 for all pieces of a spiral; the second raster of a cross counts on from the first.
    pub plane: usize,
    /// Points in order. A closed line does not repeat its first.
    pub points: Vec<SectionPoint>,
    /// Whether the last point joins the first.
    pub closed: bool,
    /// Indices of the points that are reached with the laser off, ascending and above 0: pieces of one line
    /// with a hole between them that the spot passes over. Closed lines have none.
    pub dark: Vec<usize>,
}

impl TransversalLine {
    /// This line, run the other way.
    pub fn reversed(mut self) -> TransversalLine {
        self.points.reverse();
        let count = self.points.len();
        self.dark = self.dark.iter().rev().map(|&i| count.saturating_sub(i)).collect();
        self
    }

    /// Its lit pieces in order; a closed line is one, without its first point again.
    pub fn pieces(&self) -> impl Iterator<Item = &[SectionPoint]> {
        let last = self.points.len();
        let from = std::iter::once(0).chain(self.dark.iter().copied());
        let to = self.dark.iter().copied().chain([last]);
        from.zip(to).filter_map(|(from, to)| self.points.get(from..to))
    }

    /// The sides of its lit pieces, the closing one with them.
    pub fn sides(&self) -> impl Iterator<Item = (SectionPoint, SectionPoint)> {
        let closing = self.points.last().zip(self.points.first()).filter(|_| self.closed);
        let along = self.pieces().flat_map(|piece| piece.windows(2).map(|w| (w[0], w[1])));
        along.chain(closing.map(|(last, first)| (*last, *first)))
    }

    /// Its lit length, mm.
    pub fn length_mm(&self) -> f64 {
        self.sides().map(|(a, b)| (b.p - a.p).norm()).fold(0.0, |a, b| a + b)
    }

    /// Goes on over the points of `way` to another open line.
    pub(super) fn append(&mut self, way: Vec<SectionPoint>, next: TransversalLine) {
        self.points.extend(way);
        let shift = self.points.len();
        self.dark.extend(next.dark.iter().map(|at| at + shift));
        self.points.extend(next.points);
    }
}

/// Joins open lines, in the order in which they are run, wherever `way` leads from the end of one to the beginning of the
/// next: the points between them. A joined line has the rank of its first.
pub(super) fn linked(
    lines: Vec<TransversalLine>,
    way: impl Fn(&SectionPoint, &SectionPoint) -> Option<Vec<SectionPoint>>,
) -> Vec<TransversalLine> {
    let mut out: Vec<TransversalLine> = Vec::with_capacity(lines.len());
    for line in lines {
        let before = out.last().filter(|before| !before.closed && !line.closed);
        let between = before.and_then(|before| way(before.points.last()?, line.points.first()?));
        match (out.last_mut(), between) {
            (Some(before), Some(between)) => before.append(between, line),
            _ => out.push(line),
        }
    }
    out
}

/// Cuts a surface by planes `normal · p = height` (heights ascending): all lines, plane by plane.
///
/// Points closer than `merge_mm` are merged; lines shorter than that are dropped. A surface that is no higher than that
/// lies in a plane of the family: what would cut it is the rounding of its corners, so it has no line.
pub fn sections(
    mesh: &Mesh,
    surface: &Surface,
    vertex_normals: &VertexNormals,
    normal: &Vector3<f64>,
    heights_mm: &[f64],
    merge_mm: f64,
) -> Vec<TransversalLine> {
    // Nobody else holds this progress, so it is not cancelled.
    let progress = Progress::default();
    sections_under(&progress, (mesh, surface, vertex_normals), normal, heights_mm, merge_mm).unwrap_or_default()
}

/// All lines of a surface as [`sections`] cuts it, as long as nobody wants the work to end. The first argument behind
/// `progress` is the surface with its mesh and normals.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn sections_under(
    progress: &Progress,
    (mesh, surface, vertex_normals): (&Mesh, &Surface, &VertexNormals),
    normal: &Vector3<f64>,
    heights_mm: &[f64],
    merge_mm: f64,
) -> Result<Vec<TransversalLine>, Cancelled> {
    let height = |v: u32| mesh.vertices[v as usize].coords.dot(normal);
    let mut crossed: Vec<CrossedFacet> = Vec::new();
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    let live = surface.facets.iter().filter(|&&f| mesh.defects[f as usize] == FacetDefect::None);
    for (number, &facet) in live.enumerate() {
        progress.check_at(number)?;
        let h = mesh.facets[facet as usize].map(height);
        let (lo, hi) = (h[0].min(h[1]).min(h[2]), h[0].max(h[1]).max(h[2]));
        (lowest, highest) = (lowest.min(lo), highest.max(hi));
        // Crossed where lo < height <= hi.
        let from = heights_mm.partition_point(|&c| c <= lo);
        let to = from + heights_mm[from..].iter().take_while(|c| **c <= hi).count();
        if from < to {
            crossed.push(CrossedFacet { facet, heights_mm: h, planes: [from as u32, to as u32] });
        }
    }
    if highest - lowest < merge_mm {
        return Ok(Vec::new());
    }
    let per_plane = PerPlane::new(&crossed, heights_mm.len());
    let cut = PlaneCut { mesh, vertex_normals, normal };
    let lines = (0..heights_mm.len())
        .into_par_iter()
        .take_any_while(|_| progress.goes_on())
        .flat_map_iter(|plane| {
            let lines = cut.lines(per_plane.of(plane).iter().map(|&at| &crossed[at as usize]), heights_mm[plane]);
            lines.into_iter().filter_map(move |(points, closed)| {
                let (points, closed) = merged(points, closed, merge_mm)?;
                Some(TransversalLine { plane, points, closed, dark: Vec::new() })
            })
        })
        .collect();
    // What is missing after a cancel is not handed out.
    progress.check().map(|()| lines)
}

/// A facet that planes cross.
struct CrossedFacet {
    facet: u32,
    /// Heights of its corners along the planes' normal.
    heights_mm: [f64; 3],
    /// The first plane that crosses it, and the one behind the last.
    planes: [u32; 2],
}

/// For each plane the places of the facets that it crosses, in their order.
struct PerPlane {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl PerPlane {
    fn new(crossed: &[CrossedFacet], planes: usize) -> PerPlane {
        let of = |c: &CrossedFacet| c.planes[0] as usize..c.planes[1] as usize;
        let mut start = vec![0u32; planes + 1];
        crossed.iter().flat_map(of).for_each(|plane| start[plane + 1] += 1);
        for plane in 0..planes {
            start[plane + 1] += start[plane];
        }
        let mut list = vec![0u32; start[planes] as usize];
        let mut fill = start.clone();
        for (at, plane) in crossed.iter().enumerate().flat_map(|(at, c)| of(c).map(move |plane| (at, plane))) {
            list[fill[plane] as usize] = at as u32;
            fill[plane] += 1;
        }
        PerPlane { start, list }
    }

    fn of(&self, plane: usize) -> &[u32] {
        &self.list[self.start[plane] as usize..self.start[plane + 1] as usize]
    }
}

struct PlaneCut<'a> {
    mesh: &'a Mesh,
    vertex_normals: &'a VertexNormals,
    normal: &'a Vector3<f64>,
}

impl PlaneCut<'_> {
    /// Lines of the crossed facets of one plane.
    fn lines<'f>(&self, facets: impl Iterator<Item = &'f CrossedFacet>, height: f64) -> Vec<(Vec<SectionPoint>, bool)> {
        let gates: Vec<(u32, u32)> = facets.filter_map(|f| self.gates(f, height)).collect();
        let line = |(edges, closed): (Vec<u32>, bool)| (edges.iter().map(|&e| self.point(e, height)).collect(), closed);
        chained(&gates).into_iter().map(line).collect()
    }

    fn gates(&self, of: &CrossedFacet, height: f64) -> Option<(u32, u32)> {
        let above = of.heights_mm.map(|h| h >= height);
        let edge = |from: bool| {
            (0..3)
                .find(|&k| above[k] == from && above[(k + 1) % 3] != from)
                .map(|k| self.mesh.facet_edges[of.facet as usize][k])
        };
        Some((edge(false)?, edge(true)?))
    }

    /// Where an edge crosses the plane, with the normal between its ends (P2 4.2.3).
    fn point(&self, edge: u32, height: f64) -> SectionPoint {
        let [mut a, mut b] = self.mesh.edges[edge as usize];
        let at = |v: u32| self.mesh.vertices[v as usize];
        // From the lower end, whatever the numbering: the same bits for the same edge.
        let (ha, hb) = (at(a).coords.dot(self.normal), at(b).coords.dot(self.normal));
        let (low, high) = if ha <= hb { (ha, hb) } else { (hb, ha) };
        if ha > hb {
            std::mem::swap(&mut a, &mut b);
        }
        let t = ((height - low) / (high - low)).clamp(0.0, 1.0);
        SectionPoint {
            p: at(a) + (at(b) - at(a)) * t,
            n: between(&self.vertex_normals.at(a), &self.vertex_normals.at(b), t),
        }
    }
}

/// Lines through facets, each entered by one edge (upwards) and left by another (downwards): the edges
/// in order, and whether they close.
pub(super) fn chained(gates: &[(u32, u32)]) -> Vec<(Vec<u32>, bool)> {
    let crossings = Crossings::of(gates);
    let successor: Vec<Option<usize>> = (0..gates.len()).map(|slot| crossings.next(slot)).collect();
    let mut has_predecessor = vec![false; gates.len()];
    for s in successor.iter().flatten() {
        has_predecessor[*s] = true;
    }
    let mut visited = vec![false; gates.len()];
    let mut lines = Vec::new();
    let starts = (0..gates.len()).filter(|&s| !has_predecessor[s]).chain(0..gates.len());
    for start in starts {
        if visited[start] {
            continue;
        }
        let mut edges = Vec::new();
        if !has_predecessor[start] {
            edges.push(gates[start].0);
        }
        let mut slot = Some(start);
        while let Some(s) = slot.filter(|&s| !visited[s]) {
            visited[s] = true;
            edges.push(gates[s].1);
            slot = successor[s];
        }
        lines.push((edges, has_predecessor[start]));
    }
    lines
}

/// How lines cross edges.
struct Crossings {
    /// The gate that is entered by each edge, or [`NOBODY`] or [`SEVERAL`].
    entered: Vec<u32>,
    /// Whether more than one is left by it.
    is_left_twice: Vec<bool>,
    /// Which of these edges each gate is left by.
    exits: Vec<u32>,
}

const NOBODY: u32 = u32::MAX;
const SEVERAL: u32 = u32::MAX - 1;

impl Crossings {
    fn of(gates: &[(u32, u32)]) -> Crossings {
        let mut edges = KeyIndex::for_keys(gates.len() + 1);
        let (mut entered, mut leavers) = (Vec::with_capacity(gates.len() + 1), Vec::with_capacity(gates.len() + 1));
        let mut exits = Vec::with_capacity(gates.len());
        for (slot, (entry, exit)) in gates.iter().enumerate() {
            let [entry, exit] = [entry, exit].map(|e| edges.number(*e));
            entered.resize(edges.len(), NOBODY);
            leavers.resize(edges.len(), 0u8);
            entered[entry] = if entered[entry] == NOBODY { slot as u32 } else { SEVERAL };
            leavers[exit] = leavers[exit].saturating_add(1);
            exits.push(exit as u32);
        }
        Crossings { entered, is_left_twice: leavers.into_iter().map(|n| n > 1).collect(), exits }
    }

    /// The gate behind one. Over an edge with more than two facets of the surface no line is led.
    fn next(&self, slot: usize) -> Option<usize> {
        let edge = self.exits[slot] as usize;
        let next = self.entered[edge];
        (next < SEVERAL && !self.is_left_twice[edge]).then_some(next as usize)
    }
}

/// Drops points closer than `merge_mm` to the one before; `None` if no line is left.
pub(super) fn merged(points: Vec<SectionPoint>, closed: bool, merge_mm: f64) -> Option<(Vec<SectionPoint>, bool)> {
    let end = points.last().copied();
    let mut kept = points;
    kept.dedup_by(|q, before| (before.p - q.p).norm() < merge_mm);
    if closed {
        while kept.len() > 1 && (kept[0].p - kept[kept.len() - 1].p).norm() < merge_mm {
            kept.pop();
        }
    } else if let (Some(last), Some(end)) = (kept.last_mut(), end) {
        // The rim itself stays the end of an open line.
        *last = end;
    }
    let length: f64 = kept.windows(2).map(|w| (w[1].p - w[0].p).norm()).sum();
    if closed && kept.len() == 2 {
        return (length >= merge_mm).then_some((kept, false));
    }
    (kept.len() >= 2 && length >= merge_mm).then_some((kept, closed))
}
