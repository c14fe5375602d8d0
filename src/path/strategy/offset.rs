//! Lines at equal distance from the border, measured over the surface.
//!
//! The first lies half a spacing from the border, the others one spacing apart. Where fronts from two
//! sides meet, the surface mesh is cut along their ridge, so that lines turn there as sharply as they do.
//! What is left around a greatest distance, and is wider than half a spacing from the last line, gets
//! one more at two thirds of the way: two of them facing each other lie as far apart as from the last. But no
//! more than half a spacing on: where a ridge slopes, lines on either side of what it leaves out below stand no
//! farther apart than one spacing.

use super::super::normals::VertexNormals;
use super::super::section::{SectionPoint, TransversalLine, chained, merged};
use super::geodesic_distance::{Along, DistanceField};
use super::surface_mesh::SurfaceMesh;
use super::{Layout, LinesFinding, SurfaceLines, none, spacing};
use crate::part::union_find::UnionFind;
use crate::part::{Mesh, surfaces::Surface};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;

/// One loop of a surface's outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Border {
    /// Its length, mm.
    pub length_mm: f64,
    /// Its edges, in no order.
    pub edges: Vec<[Point3<f64>; 2]>,
}

/// The loops of a surface's outline, the longest first: what [`Layout::border`] chooses from. Loops
/// that touch are one.
pub fn borders(mesh: &Mesh, surface: &Surface) -> Vec<Border> {
    // Nobody else holds this progress, so it is not cancelled.
    let made = SurfaceMesh::new(mesh, surface, &VertexNormals::default(), &Progress::default());
    let Ok(surface_mesh) = made else { return Vec::new() };
    let edge = |e: &u32| surface_mesh.mesh.edges[*e as usize].map(|v| surface_mesh.mesh.vertices[v as usize]);
    let border = |(length_mm, edges): (f64, Vec<u32>)| Border { length_mm, edges: edges.iter().map(edge).collect() };
    surface_mesh.loops().into_iter().map(border).collect()
}

/// A facet is cut to pieces no longer than this share of a spacing, while there are not too many.
const PIECE: f64 = 0.5;

pub(super) fn lines(
    mesh: &Mesh,
    surface: &Surface,
    normals: &VertexNormals,
    rule: &Layout,
    merge_mm: f64,
    progress: &Progress,
) -> Result<SurfaceLines, Cancelled> {
    let surface_mesh = SurfaceMesh::new(mesh, surface, normals, progress)?;
    let count = surface_mesh.loops().len();
    if count == 0 {
        return Ok(none(LinesFinding::NoBorder { surface: surface.number }));
    }
    if let Some(border) = rule.border.filter(|&b| b >= count) {
        return Ok(none(LinesFinding::NoSuchBorder { surface: surface.number, border, borders: count }));
    }
    let size_mm = (PIECE * rule.spacing_mm).min(0.15 * surface.area_mm2.sqrt());
    let surface_mesh = surface_mesh.refined(true, |_| size_mm, progress)?;
    let from = match rule.border {
        Some(chosen) => surface_mesh.loops().into_iter().nth(chosen).map(|l| l.1).unwrap_or_default(),
        None => surface_mesh.rim(),
    };
    let field = DistanceField::new(&surface_mesh, &from, 1e-6 * rule.spacing_mm, progress)?;
    let levels = Levels::new(&surface_mesh, &field, progress)?;
    let lines = levels.lines(rule.spacing_mm, merge_mm, progress)?;
    let unreached: f64 = (0..surface_mesh.mesh.facets.len())
        .filter(|&f| surface_mesh.mesh.facets[f].iter().any(|&v| !field.mm[v as usize].is_finite()))
        .map(|f| surface_mesh.mesh.areas[f])
        .sum();
    let finding = if lines.is_empty() {
        Some(LinesFinding::NoLineFits { surface: surface.number })
    } else if unreached > 1e-9 * surface.area_mm2 {
        Some(LinesFinding::ApartFromBorder { surface: surface.number, area_mm2: unreached })
    } else {
        None
    };
    progress.check()?;
    let achieved = spacing::achieved(&lines, None, rule.spacing_mm);
    Ok(SurfaceLines { achieved, lines, planes: Vec::new(), finding })
}

/// Rank, distance and facets of one level.
type LevelJob = (usize, f64, Vec<u32>);

/// A surface mesh that follows the ridges, with the distance at its vertices.
struct Levels {
    surface_mesh: SurfaceMesh,
    mm: Vec<f64>,
    /// For edges that no ridge has touched the distance along them, from the lower vertex.
    along: Vec<Option<Along>>,
}

impl Levels {
    fn new(surface_mesh: &SurfaceMesh, field: &DistanceField, progress: &Progress) -> Result<Levels, Cancelled> {
        let along: Vec<Option<Along>> = (0..surface_mesh.mesh.edges.len() as u32)
            .into_par_iter()
            .map(|e| {
                let [a, b] = surface_mesh.mesh.edges[e as usize];
                let known = field.mm[a as usize].is_finite() && field.mm[b as usize].is_finite();
                let facet = *surface_mesh.mesh.edge_facets(e).first()?;
                known.then(|| field.along(surface_mesh, facet, e, a, b))
            })
            .collect();
        progress.check()?;
        let mut mm = field.mm.clone();
        let mut cuts = Vec::new();
        for (e, along) in along.iter().enumerate() {
            if let Some((along, (x, peak))) = along.as_ref().and_then(|a| Some((a, a.ridge()?))) {
                cuts.push((e as u32, x / along.length));
                mm.push(peak);
            }
        }
        let (mut cut, first) = surface_mesh.cut(&cuts, progress)?;
        summits(surface_mesh, field, &mut cut, first, &mut mm, progress)?;
        // Both lists of edges are sorted by their vertices, and old vertices keep their numbers.
        let mut old = surface_mesh.mesh.edges.iter().zip(along).peekable();
        let along = cut
            .mesh
            .edges
            .iter()
            .map(|edge| {
                while old.next_if(|(o, _)| *o < edge).is_some() {}
                old.next_if(|(o, _)| *o == edge).and_then(|(_, along)| along)
            })
            .collect();
        Ok(Levels { surface_mesh: cut, mm, along })
    }

    fn lines(&self, spacing_mm: f64, merge_mm: f64, progress: &Progress) -> Result<Vec<TransversalLine>, Cancelled> {
        let facets = &self.surface_mesh.mesh.facets;
        let band = |mm: f64| (mm / spacing_mm - 0.5).floor();
        let most = self.mm.iter().copied().filter(|d| d.is_finite()).fold(0.0, f64::max);
        let mut jobs: Vec<LevelJob> = (0..=band(most).max(-1.0) as i64)
            .map(|k| (k as usize, (k as f64 + 0.5) * spacing_mm, Vec::new()))
            .collect();
        if band(most) < 0.0 {
            jobs.clear();
        }
        for (f, corners) in facets.iter().enumerate() {
            progress.check_at(f)?;
            let d = corners.map(|v| self.mm[v as usize]);
            let (low, high) = (d[0].min(d[1]).min(d[2]), d[0].max(d[1]).max(d[2]));
            if high.is_finite() {
                // Crossed where low < level <= high.
                for k in (band(low) + 1.0).max(0.0) as usize..(band(high) + 1.0).max(0.0) as usize {
                    jobs.get_mut(k).into_iter().for_each(|j| j.2.push(f as u32));
                }
            }
        }
        jobs.extend(self.leftovers(spacing_mm, band));
        progress.check()?;
        jobs.sort_by_key(|j| j.0);
        let lines = jobs
            .par_iter()
            .take_any_while(|_| progress.goes_on())
            .flat_map_iter(|(rank, level, facets)| {
                let gates: Vec<(u32, u32)> = facets.iter().filter_map(|&f| self.gates(f, *level)).collect();
                chained(&gates).into_iter().filter_map(move |(edges, closed)| {
                    let points = edges.iter().map(|&e| self.point(e, *level)).collect();
                    let (points, closed) = merged(points, closed, merge_mm)?;
                    Some(TransversalLine { plane: *rank, points, closed, dark: Vec::new() })
                })
            })
            .collect();
        // What is missing after a cancel is not handed out.
        progress.check().map(|()| lines)
    }

    /// Rank, distance and facets of the lines around greatest distances that would be left too wide.
    fn leftovers(&self, spacing_mm: f64, band: impl Fn(f64) -> f64) -> Vec<LevelJob> {
        let bands: Vec<f64> = self.mm.iter().map(|&d| band(d)).collect();
        let mut sets = UnionFind::new(bands.len());
        let equal = |[a, b]: [u32; 2]| bands[a as usize] == bands[b as usize];
        self.surface_mesh.mesh.edges.iter().filter(|e| equal(**e)).for_each(|e| sets.join(e[0], e[1]));
        let roots: Vec<u32> = (0..bands.len() as u32).map(|v| sets.root(v)).collect();
        let mut most = vec![0.0f64; bands.len()];
        let mut is_top = vec![true; bands.len()];
        for (v, &root) in roots.iter().enumerate() {
            most[root as usize] = most[root as usize].max(self.mm[v]);
        }
        for &[a, b] in &self.surface_mesh.mesh.edges {
            let lower = if bands[a as usize] < bands[b as usize] { a } else { b };
            if !equal([a, b]) {
                is_top[roots[lower as usize] as usize] = false;
            }
        }
        let mut found: Vec<(u32, LevelJob)> = Vec::new();
        for root in (0..bands.len()).filter(|&v| roots[v] as usize == v && is_top[v] && most[v].is_finite()) {
            // From the last line, or from the border where there is none.
            let last = ((bands[root] + 0.5) * spacing_mm).max(0.0);
            let wide = most[root] - last;
            if wide > 0.51 * spacing_mm || (bands[root] < 0.0 && wide > 0.0) {
                let level = last + (wide * 2.0 / 3.0).min(0.5 * spacing_mm);
                found.push((root as u32, ((bands[root] + 1.0) as usize, level, Vec::new())));
            }
        }
        for (f, corners) in self.surface_mesh.mesh.facets.iter().enumerate() {
            let highest = corners.iter().copied().max_by(|&a, &b| self.mm[a as usize].total_cmp(&self.mm[b as usize]));
            let root = highest.map_or(0, |v| roots[v as usize]);
            if let Ok(i) = found.binary_search_by_key(&root, |x| x.0) {
                found[i].1.2.push(f as u32);
            }
        }
        found.into_iter().map(|x| x.1).collect()
    }

    fn gates(&self, facet: u32, level: f64) -> Option<(u32, u32)> {
        let above = self.surface_mesh.mesh.facets[facet as usize].map(|v| self.mm[v as usize] >= level);
        let edge = |from: bool| {
            (0..3)
                .find(|&k| above[k] == from && above[(k + 1) % 3] != from)
                .map(|k| self.surface_mesh.mesh.facet_edges[facet as usize][k])
        };
        Some((edge(false)?, edge(true)?))
    }

    fn point(&self, edge: u32, level: f64) -> SectionPoint {
        let [a, b] = self.surface_mesh.mesh.edges[edge as usize].map(|v| self.mm[v as usize]);
        let share = match self.along[edge as usize] {
            Some(along) => along.place(level) / along.length,
            None => (level - a) / (b - a),
        };
        self.surface_mesh.on_edge(edge, share.clamp(0.0, 1.0))
    }
}

/// Facets in which three fronts meet are left with a piece between three ridges: the place of its
/// greatest distance becomes a vertex.
fn summits(
    surface_mesh: &SurfaceMesh,
    field: &DistanceField,
    cut: &mut SurfaceMesh,
    first: u32,
    mm: &mut Vec<f64>,
    progress: &Progress,
) -> Result<(), Cancelled> {
    let between: Vec<usize> =
        (0..cut.mesh.facets.len()).filter(|&f| cut.mesh.facets[f].iter().all(|&v| v >= first)).collect();
    if between.is_empty() {
        return Ok(());
    }
    // The facets that were cut at all three edges, in the same order.
    let ridge = |e: u32, f: usize| {
        let [a, b] = surface_mesh.mesh.edges[e as usize];
        let known = field.mm[a as usize].is_finite() && field.mm[b as usize].is_finite();
        let seen_in = surface_mesh.mesh.edge_facets(e).first().copied().unwrap_or(f as u32);
        known && field.along(surface_mesh, seen_in, e, a, b).ridge().is_some()
    };
    let parents =
        (0..surface_mesh.mesh.facets.len()).filter(|&f| surface_mesh.mesh.facet_edges[f].iter().all(|&e| ridge(e, f)));
    let mut facets = cut.mesh.facets.clone();
    let mut vertices = cut.mesh.vertices.clone();
    for (f, parent) in between.into_iter().zip(parents) {
        progress.check()?;
        let [a, b, c] = cut.mesh.corners(f);
        // Uphill from the middle of the three, in steps that halve.
        let mut at = (1.0 / 3.0, 1.0 / 3.0);
        let place = |(u, v): (f64, f64)| a + (b - a) * u + (c - a) * v;
        let mut best = field.inside(surface_mesh, parent as u32, &place(at));
        let mut step = 0.25;
        for _ in 0..24 {
            let tries = [(step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step), (step, -step), (-step, step)];
            let higher = tries
                .iter()
                .map(|t| (at.0 + t.0, at.1 + t.1))
                .filter(|t| t.0 > 0.0 && t.1 > 0.0 && t.0 + t.1 < 1.0)
                .map(|t| (field.inside(surface_mesh, parent as u32, &place(t)), t))
                .max_by(|x, y| x.0.total_cmp(&y.0))
                .filter(|x| x.0 > best);
            match higher {
                Some((value, to)) => (best, at) = (value, to),
                None => step *= 0.5,
            }
        }
        let [p, q, r] = facets[f];
        let centre = vertices.len() as u32;
        vertices.push(place(at));
        let normals = [p, q, r].map(|v| cut.normals[v as usize]);
        cut.normals.push(crate::part::angle::unit(normals[0] + normals[1] + normals[2]).unwrap_or(normals[0]));
        mm.push(best);
        facets[f] = [p, q, centre];
        facets.extend([[q, r, centre], [r, p, centre]]);
    }
    cut.mesh = Mesh::from_indexed_under(progress, vertices, facets)?;
    Ok(())
}
