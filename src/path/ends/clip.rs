//! Lines cut at a distance from the rim: within the surface, or beyond it.

use super::extended_surface::ExtendedSurface;
use super::rim::rim;
use super::tree::Tree;
use crate::part::distance::point_triangle;
use crate::part::{Bvh, Mesh, surfaces::Surface};
use crate::path::normals::between;
use crate::path::section::{SectionPoint, TransversalLine};
use nalgebra::Point3;
use rayon::prelude::*;

/// Tolerance by which a line at exactly the distance asked for stays, mm.
const HAIR_MM: f64 = 1e-9;
/// Length below which a piece is dropped, mm: it only touches the distance asked for.
const NOTHING_MM: f64 = 1e-6;

/// A stretch of a line: number of a side plus the share of it, from and to.
type Stretch = (f64, f64);

/// The parts of lines that are at least `inset_mm` from the rim of their surface. Holes smaller than a circle of the
/// diameter `ignore_holes_mm` do not count as rim.
///
/// A closed line that is cut becomes open pieces, and a dark gap ends a line.
pub fn inset(
    mesh: &Mesh,
    surface: &Surface,
    lines: Vec<TransversalLine>,
    inset_mm: f64,
    ignore_holes_mm: f64,
) -> Vec<TransversalLine> {
    let tree = Tree::new(rim(mesh, surface).segments(ignore_holes_mm));
    clipped(lines, |line| stretches_within(line, &tree, inset_mm - HAIR_MM))
}

/// The parts of lines, cut on the extended surface, that lie on the surface itself or within the reach beyond its
/// rim; and how many of their ends stop short of that reach, at a sharp edge or at the end of the part.
pub fn run_over(
    mesh: &Mesh,
    surface: &Surface,
    extended: &ExtendedSurface,
    lines: Vec<TransversalLine>,
) -> (Vec<TransversalLine>, usize) {
    let tree = Tree::new(rim(mesh, surface).segments(0.0));
    let beyond =
        Mesh::from_indexed(mesh.vertices.clone(), extended.beyond.iter().map(|&f| mesh.facets[f as usize]).collect());
    let (bvh, on_mm) = (Bvh::new(&beyond), (1e-5 * mesh.diagonal()).min(0.1 * extended.over_mm));
    let lines = clipped(lines, |line| {
        let sides: Vec<_> = line.sides().collect();
        let far = rest(&stretches_within(line, &tree, extended.over_mm + HAIR_MM), sides.len() as f64);
        // A stretch so far from the rim does not cross it: one place tells on which side all of it is.
        let is_beyond = |stretch: &Stretch| {
            let Some(q) = at(&sides, 0.5 * (stretch.0 + stretch.1)) else { return false };
            let mut is = false;
            bvh.visit_near(&q.p, on_mm, |_, corners| is = is || point_triangle(&q.p, corners) <= on_mm);
            is
        };
        far.into_iter().filter(is_beyond).collect()
    });
    let stops = Tree::new(extended.stops.iter().copied());
    let reach_mm = 2e-6 * mesh.diagonal();
    let ends = lines.iter().filter(|l| !l.closed).flat_map(|l| [l.points.first(), l.points.last()]).flatten();
    let stopped = ends.filter(|q| stops.has_within(&q.p, reach_mm)).count();
    (lines, stopped)
}

/// Cuts `gone` out of every line.
fn clipped(
    lines: Vec<TransversalLine>,
    gone: impl Fn(&TransversalLine) -> Vec<Stretch> + Sync,
) -> Vec<TransversalLine> {
    let pieces = lines.into_par_iter().flat_map_iter(|line| {
        let whole: Vec<TransversalLine> = if line.dark.is_empty() {
            vec![line]
        } else {
            let open = |points: &[SectionPoint]| TransversalLine {
                plane: line.plane,
                points: points.to_vec(),
                closed: false,
                dark: Vec::new(),
            };
            line.pieces().map(open).collect()
        };
        whole.into_iter().flat_map(|line| {
            let gone = gone(&line);
            if gone.is_empty() { vec![line] } else { without(&line, &gone) }
        })
    });
    pieces.collect()
}

/// Where a line is nearer than a radius to the segments of a tree: sorted, apart.
fn stretches_within(line: &TransversalLine, tree: &Tree, radius_mm: f64) -> Vec<Stretch> {
    let mut all: Vec<Stretch> = Vec::new();
    for (i, (a, b)) in line.sides().enumerate() {
        for (from, to) in tree.shares_within(&a.p, &b.p, radius_mm) {
            let (from, to) = (i as f64 + from, i as f64 + to);
            match all.last_mut() {
                // On over a point of the line.
                Some(last) if from <= last.1 => last.1 = to,
                _ => all.push((from, to)),
            }
        }
    }
    all
}

/// What is left between stretches from 0 to an end.
fn rest(gone: &[Stretch], end: f64) -> Vec<Stretch> {
    let from = std::iter::once(0.0).chain(gone.iter().map(|g| g.1));
    let to = gone.iter().map(|g| g.0).chain([end]);
    from.zip(to).filter(|(from, to)| from < to).collect()
}

/// The point at a place of a line.
fn at(sides: &[(SectionPoint, SectionPoint)], place: f64) -> Option<SectionPoint> {
    let (a, b) = sides.get((place as usize).min(sides.len().checked_sub(1)?))?;
    let t = place - (place as usize).min(sides.len() - 1) as f64;
    let on = |t: f64| SectionPoint { p: a.p + (b.p - a.p) * t, n: between(&a.n, &b.n, t) };
    Some(if t <= 0.0 {
        *a
    } else if t >= 1.0 {
        *b
    } else {
        on(t)
    })
}

fn without(line: &TransversalLine, gone: &[Stretch]) -> Vec<TransversalLine> {
    let sides: Vec<_> = line.sides().collect();
    let end = sides.len() as f64;
    let mut pieces: Vec<Vec<SectionPoint>> = Vec::new();
    let kept = rest(gone, end);
    for &(from, to) in &kept {
        let inner = (from as usize + 1..).take_while(|&i| (i as f64) < to).filter_map(|i| sides.get(i)).map(|s| s.0);
        let points = at(&sides, from).into_iter().chain(inner).chain(at(&sides, to));
        pieces.push(distinct(points));
    }
    // Over the start of a closed line a piece goes on.
    let goes_round = line.closed && kept.first().is_some_and(|k| k.0 == 0.0) && kept.last().is_some_and(|k| k.1 == end);
    if goes_round && pieces.len() > 1 {
        let first = pieces.remove(0);
        if let Some(last) = pieces.last_mut() {
            last.extend(first.into_iter().skip(1));
        }
    }
    let long = |points: &Vec<SectionPoint>| length_mm(points) > NOTHING_MM;
    let open = |points| TransversalLine { plane: line.plane, points, closed: false, dark: Vec::new() };
    pieces.into_iter().filter(long).map(open).collect()
}

fn length_mm(points: &[SectionPoint]) -> f64 {
    points.windows(2).map(|w| (w[1].p - w[0].p).norm()).fold(0.0, |a, b| a + b)
}

/// Points without those at the very place of the one before.
fn distinct(points: impl Iterator<Item = SectionPoint>) -> Vec<SectionPoint> {
    let mut out: Vec<SectionPoint> = Vec::new();
    for q in points {
        let same = |last: &SectionPoint, q: &Point3<f64>| (last.p - q).norm() <= HAIR_MM;
        if out.last().is_none_or(|last| !same(last, &q.p)) {
            out.push(q);
        }
    }
    out
}
