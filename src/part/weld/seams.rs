//! Open edges that are one edge but for rounding: each lies along one other, end to end, within the tolerance.
//!
//! Edges are matched, and not single corners, so that nothing is joined that does not close an edge; and only edges
//! that are longer than what is bridged, so that a corner is never taken for its neighbour.

use crate::part::angle::between_deg;
use crate::part::edges::{Edges, NO_EDGE};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::cmp::Ordering;

/// Corners count as a rounding apart within this share of the part's diagonal: f32 keeps 6e-8 of a coordinate, and what
/// programs compute in between loses a digit. Below: corners of a cylinder of 64 mm whose last digits differ by facet
/// (1e-7). Beyond: a slot of 0.01 mm in a part of 1 m (1e-5).
const SHARE_OF_DIAGONAL: f64 = 1e-6;
/// How far apart such corners may lie, in steps of f32 at the largest coordinate, for parts far from the origin.
const ULPS: f64 = 4.0;
/// Two facets at an edge lie on top of each other below this angle. See [`crate::part::Mesh::is_fold`].
const FOLD_DEG: f64 = 1.0;
/// Where more open edges than this have their middles in one place, no rounding has made them.
const CROWD: usize = 64;

/// Two open edges that are one, as the vertices to be joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seam {
    /// Vertices of one and the other.
    pub ends: [[u32; 2]; 2],
}

/// How far corners may be apart to be joined, file units.
pub(super) fn tolerance(points: &[[f32; 3]]) -> f64 {
    let (lo, hi) = crate::part::bounds::bounds_of(points.iter().map(point));
    let largest = points.iter().flatten().fold(0.0f32, |m, x| m.max(x.abs()));
    // The exponent alone: its step is that of all numbers up to the next power of two.
    let step = f64::from(f32::from_bits(largest.to_bits() & 0x7f80_0000)) * f64::from(f32::EPSILON);
    (SHARE_OF_DIAGONAL * (hi - lo).norm()).max(ULPS * step)
}

pub(super) fn point(p: &[f32; 3]) -> Point3<f64> {
    Point3::from(p.map(f64::from))
}

/// An edge with one facet.
struct OpenEdge {
    /// Its vertices in the order in which its facet runs it.
    ends: [u32; 2],
    from: Point3<f64>,
    to: Point3<f64>,
    /// From the edge to the facet's third corner, square to the edge.
    inward: Vector3<f64>,
    /// Where its middle lies on a grid of twice the tolerance.
    cell: [i32; 3],
}

impl OpenEdge {
    fn middle(&self) -> Point3<f64> {
        nalgebra::center(&self.from, &self.to)
    }
}

/// The open edges that are one, each with at most one other. Independent of the order of facets, but for edges that
/// are equal in all.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn matched(
    points: &[[f32; 3]],
    facets: &[[u32; 3]],
    edges: &Edges,
    progress: &Progress,
) -> Result<Vec<Seam>, Cancelled> {
    if !(0..edges.ends.len() as u32).any(|e| edges.facets.of(e).len() == 1) {
        return Ok(Vec::new());
    }
    let within = tolerance(points);
    let open = open_edges(points, facets, edges, within, progress)?;
    let mut all = candidates(&open, within, progress)?;
    all.par_sort_by(|a, b| a.compare(b, &open));
    let mut taken = vec![false; open.len()];
    let mut seams = Vec::new();
    for Candidate { edges: [i, j], is_turned, .. } in all {
        if taken[i] || taken[j] {
            continue;
        }
        (taken[i], taken[j]) = (true, true);
        let [a, b] = open[j].ends;
        seams.push(Seam { ends: [open[i].ends, if is_turned { [a, b] } else { [b, a] }] });
    }
    Ok(seams)
}

fn open_edges(
    points: &[[f32; 3]],
    facets: &[[u32; 3]],
    edges: &Edges,
    within: f64,
    progress: &Progress,
) -> Result<Vec<OpenEdge>, Cancelled> {
    let mut open = Vec::new();
    for (number, (corners, of)) in facets.iter().zip(&edges.of_facet).enumerate() {
        progress.check_at(number)?;
        if of.contains(&NO_EDGE) {
            continue;
        }
        for k in (0..3).filter(|&k| edges.facets.of(of[k]).len() == 1) {
            let ends = [corners[k], corners[(k + 1) % 3]];
            let [from, to, third] = [ends[0], ends[1], corners[(k + 2) % 3]].map(|v| point(&points[v as usize]));
            let (along, aside) = (to - from, third - from);
            if along.norm() <= 2.0 * within {
                continue;
            }
            let inward = aside - along * (aside.dot(&along) / along.norm_squared());
            let cell = nalgebra::center(&from, &to).coords.map(|x| on_grid(x, within)).into();
            open.push(OpenEdge { ends, from, to, inward, cell });
        }
    }
    Ok(open)
}

fn on_grid(x: f64, within: f64) -> i32 {
    (x / (2.0 * within)).floor() as i32
}

/// Two open edges that may be one.
struct Candidate {
    edges: [usize; 2],
    /// Both facets run the edge the same way: one of them is wound wrongly.
    is_turned: bool,
    apart: f64,
}

impl Candidate {
    /// Facets that are wound alike first, then the nearest; of those as near the one whose corners come first.
    fn compare(&self, other: &Candidate, open: &[OpenEdge]) -> Ordering {
        let place = |c: &Candidate| {
            let mut ends = c.edges.map(|i| [open[i].from, open[i].to].map(|p| <[f64; 3]>::from(p.coords)));
            ends.sort_by(by_coordinates);
            ends
        };
        let by_place = || {
            let (one, two) = (place(self), place(other));
            by_coordinates(&one[0], &two[0]).then_with(|| by_coordinates(&one[1], &two[1]))
        };
        let nearer = || self.apart.total_cmp(&other.apart);
        self.is_turned.cmp(&other.is_turned).then_with(nearer).then_with(by_place).then(self.edges.cmp(&other.edges))
    }
}

fn by_coordinates(a: &[[f64; 3]; 2], b: &[[f64; 3]; 2]) -> Ordering {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(x, y)| x.total_cmp(y)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
}

/// All pairs of open edges that lie along each other, looked for by their middles on a grid.
fn candidates(open: &[OpenEdge], within: f64, progress: &Progress) -> Result<Vec<Candidate>, Cancelled> {
    let mut by_cell: Vec<usize> = (0..open.len()).collect();
    by_cell.par_sort_unstable_by_key(|&i| (open[i].cell, i));
    let in_cell = |cell: [i32; 3]| {
        let from = by_cell.partition_point(|&i| open[i].cell < cell);
        let there = by_cell[from..].iter().take(CROWD + 1).take_while(|&&i| open[i].cell == cell).count();
        &by_cell[from..from + if there > CROWD { 0 } else { there }]
    };
    let mut all = Vec::new();
    for (i, edge) in open.iter().enumerate() {
        progress.check()?;
        if in_cell(edge.cell).is_empty() {
            continue;
        }
        let middle = edge.middle();
        let [x, y, z]: [[i32; 2]; 3] =
            std::array::from_fn(|k| [-within, within].map(|off| on_grid(middle[k] + off, within)));
        for cell in (0..8).map(|c| [x[c & 1], y[c >> 1 & 1], z[c >> 2]]) {
            all.extend(in_cell(cell).iter().filter(|&&j| j > i).filter_map(|&j| candidate(open, [i, j], within)));
        }
    }
    all.par_sort_unstable_by_key(|c| c.edges);
    all.dedup_by_key(|c| c.edges);
    Ok(all)
}

/// Two open edges as a candidate, if they lie along each other and their facets do not lie on one side.
fn candidate(open: &[OpenEdge], edges: [usize; 2], within: f64) -> Option<Candidate> {
    let [e, f] = edges.map(|i| &open[i]);
    let apart = |[p, q]: [&Point3<f64>; 2]| (e.from - p).norm().max((e.to - q).norm());
    let (opposite, alike) = (apart([&f.to, &f.from]), apart([&f.from, &f.to]));
    let (is_turned, apart) = (alike < opposite, alike.min(opposite));
    (apart <= within && !lie_on_one_side(&e.inward, &f.inward, within)).then_some(Candidate { edges, is_turned, apart })
}

/// Whether the lower of two facets lies on the other, as far as can be told with the tolerance.
fn lie_on_one_side(one: &Vector3<f64>, two: &Vector3<f64>, within: f64) -> bool {
    let lower = one.norm().min(two.norm());
    let turn_deg = between_deg(one, two);
    let aside = lower * libm::sin(turn_deg.to_radians());
    one.dot(two) > 0.0 && (turn_deg < FOLD_DEG || aside <= 2.0 * within)
}
