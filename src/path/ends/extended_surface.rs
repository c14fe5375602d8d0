//! A surface extended by the facets around it, for the spot to run on over its rim.

use super::rim::rim;
use super::tree::Tree;
use crate::part::distance::{segment_triangle, segments};
use crate::part::{Mesh, angle::between_deg, surfaces::Surface, topology::FacetDefect, topology::NO_EDGE};
use nalgebra::Point3;
use std::collections::{BTreeSet, VecDeque};

/// The spot runs on over creases below this, degrees.
const SHARP_DEG: f64 = 60.0;

/// A surface and its neighbourhood.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExtendedSurface {
    /// Its facets and those around: what lines are cut on.
    pub surface: Surface,
    /// The facets around, in file order.
    pub beyond: Vec<u32>,
    /// How far beyond the rim they were looked for, mm.
    pub over_mm: f64,
    /// Edges at which the part ends or bends too sharply before that, mm.
    pub stops: Vec<[Point3<f64>; 2]>,
}

/// The surface with the part's facets within `over_mm` of its rim, as far as they are reached over edges
/// whose facets meet at less than 60°.
pub fn extended(mesh: &Mesh, surface: &Surface, over_mm: f64) -> ExtendedSurface {
    let outline = rim(mesh, surface);
    let tree = Tree::new(outline.segments(0.0));
    let own = |f: u32| surface.facets.binary_search(&f).is_ok();
    let ends = |e: u32| mesh.edges[e as usize].map(|v| mesh.vertices[v as usize]);
    let near_facet = |f: u32| {
        let corners = mesh.corners(f as usize);
        let (lo, hi) = crate::part::topology::bounds_of(corners.iter().copied());
        let mut near = false;
        tree.visit(&lo, &hi, over_mm, |[a, b]| near = near || segment_triangle(a, b, &corners) <= over_mm);
        near
    };
    let near_edge = |e: u32| {
        let [p, q] = ends(e);
        let mut near = false;
        tree.visit(&p, &q, over_mm, |[a, b]| near = near || segments(&p, &q, a, b) < over_mm);
        near
    };
    let (mut beyond, mut stops): (BTreeSet<u32>, BTreeSet<u32>) = (BTreeSet::new(), BTreeSet::new());
    let edges: BTreeSet<u32> = outline.loops.iter().flat_map(|l| l.edges.iter().copied()).collect();
    let mut queue: VecDeque<u32> = edges.into_iter().collect();
    while let Some(edge) = queue.pop_front() {
        let is_in = |f: u32| own(f) || beyond.contains(&f);
        let from = live(mesh, edge).find(|&f| is_in(f));
        let Some(next) = from.and_then(|f| gentle(mesh, edge, f)) else {
            stops.insert(edge);
            continue;
        };
        if is_in(next) {
            continue;
        }
        if !near_facet(next) {
            continue;
        }
        let others = mesh.facet_edges[next as usize].into_iter().filter(|&e| e != NO_EDGE && e != edge);
        // A facet that also meets the surface sharply would lead lines over that edge.
        let sharp =
            others.clone().find(|&e| gentle(mesh, e, next).is_none() && mesh.edge_facets(e).iter().any(|&f| own(f)));
        if sharp.is_some() {
            stops.insert(edge);
            continue;
        }
        beyond.insert(next);
        queue.extend(others.filter(|&e| near_edge(e)));
    }
    let mut facets: Vec<u32> = surface.facets.iter().copied().chain(beyond.iter().copied()).collect();
    facets.sort_unstable();
    let area_mm2 = surface.area_mm2 + beyond.iter().map(|&f| mesh.areas[f as usize]).fold(0.0, |a, b| a + b);
    ExtendedSurface {
        surface: Surface { number: surface.number, facets, area_mm2 },
        beyond: beyond.into_iter().collect(),
        over_mm,
        stops: stops.into_iter().map(ends).collect(),
    }
}

/// The facets of an edge that lines can be laid on.
fn live(mesh: &Mesh, edge: u32) -> impl Iterator<Item = u32> {
    mesh.edge_facets(edge).iter().copied().filter(|&f| mesh.defects[f as usize] == FacetDefect::None)
}

/// The other one of the two live facets of an edge on this side of the part, where they meet at less than the limit,
/// wound alike.
fn gentle(mesh: &Mesh, edge: u32, facet: u32) -> Option<u32> {
    let other = match mesh.back_of(facet) {
        Some(_) => mesh.across(facet, edge)?,
        None => {
            let mut others = live(mesh, edge).filter(|&f| f != facet);
            others.next().filter(|_| others.next().is_none())?
        }
    };
    let turn_deg = between_deg(&mesh.normals[facet as usize], &mesh.normals[other as usize]);
    (mesh.is_smooth([facet, other], edge) && turn_deg < SHARP_DEG).then_some(other)
}
