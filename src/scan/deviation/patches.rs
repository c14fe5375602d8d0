//! Patches: connected areas of the model where material is missing, or where there is too much, with depth, area and
//! volume above the threshold that tells them (P3: "0.2 mm at the worst place").
//!
//! A patch may run over creases and over several surfaces. Its figures are those of the smoothed depths, so a pit
//! smaller than half of the disc that depths are smoothed over is not seen, and is not told either: what is as small
//! is noise.

use super::contour::{Deep, deep_part};
use super::outline::outlines;
use super::{DepthField, SmoothedDepths};
use crate::part::Part;
use crate::part::topology::FacetDefect;
use crate::part::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Share of a patch's vertices that are not deeper than its depth: not the deepest one, which noise makes.
const DEEPEST: f64 = 0.999;
/// Area of the smallest patch, in discs that depths are smoothed over: with less the smoothed depth is that of what is
/// around it.
const SMALLEST: f64 = 0.5;

/// What is told as a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchRules {
    /// The threshold: depth, or surplus, from which on the model counts as worn or built up, mm, above 0.
    pub min_depth_mm: f64,
    /// Patches with less area are dropped, mm²; what the scan does not resolve is dropped in any case.
    pub min_area_mm2: f64,
}

/// Which way the part is off the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatchKind {
    /// Material is missing.
    Missing,
    /// There is too much.
    Surplus,
}

/// A connected area of the model at least as far off as the threshold. Part frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Whether material is missing.
    pub kind: PatchKind,
    /// Area of the model above the threshold, mm².
    pub area_mm2: f64,
    /// Greatest depth or surplus, mm, above 0: the 99.9 % point of the smoothed ones.
    pub depth_mm: f64,
    /// Where on the model that is.
    pub deepest_at: Point3<f64>,
    /// Depth summed over that area, mm³: all of it, not what exceeds the threshold alone.
    pub volume_mm3: f64,
    /// Middle of the area; beside the model where that is curved.
    pub centre: Point3<f64>,
    /// Facets of the part that it lies on, ascending.
    pub facets: Vec<u32>,
    /// Triangles of the field that it lies on, wholly or in part, ascending.
    pub triangles: Vec<u32>,
    /// Closed lines around it and its holes, the patch on their left seen from outside; the first point is not repeated.
    pub outlines: Vec<Vec<Point3<f64>>>,
}

/// The patches of a part, the deepest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Patches {
    /// Each of them.
    pub patches: Vec<Patch>,
    /// Depths over the model where they lie.
    pub field: DepthField,
    /// Patches that were too small, and left out.
    pub too_small: usize,
}

impl Patches {
    /// Finds them.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(
        part: &Part,
        depths: &SmoothedDepths,
        rules: &PatchRules,
        progress: &Progress,
    ) -> Result<Patches, Cancelled> {
        let field = DepthField::new(part, depths, rules.min_depth_mm, progress)?;
        let smallest_mm2 = rules.min_area_mm2.max(SMALLEST * PI * depths.radius_mm() * depths.radius_mm());
        let (mut patches, mut too_small) = (Vec::new(), 0);
        for kind in [PatchKind::Missing, PatchKind::Surplus] {
            progress.check()?;
            for parts in connected(part, &field, kind, rules.min_depth_mm) {
                if parts.iter().map(|p| p.area_mm2).sum::<f64>() < smallest_mm2 {
                    too_small += 1;
                } else {
                    progress.check()?;
                    patches.extend(patch(&field, kind, &parts, rules.min_depth_mm, depths.radius_mm()));
                }
            }
        }
        patches.sort_by(|a, b| b.depth_mm.total_cmp(&a.depth_mm));
        Ok(Patches { patches, field, too_small })
    }
}

impl PatchKind {
    fn sign(self) -> f64 {
        if self == PatchKind::Missing { 1.0 } else { -1.0 }
    }
}

/// The deep parts of all triangles, in groups that hang together over vertices that are deep.
fn connected(part: &Part, field: &DepthField, kind: PatchKind, least_mm: f64) -> Vec<Vec<Deep>> {
    let proper = |t: &u32| part.mesh.defects[field.parent[*t as usize] as usize] == FacetDefect::None;
    let triangles = (0..field.triangles.len() as u32).filter(proper);
    let parts: Vec<Deep> = triangles.filter_map(|t| deep_part(field, t, kind.sign(), least_mm)).collect();
    let mut groups = UnionFind::new(field.vertices.len());
    let deep = |triangle: u32| {
        let is_deep = |v: &u32| kind.sign() * field.depth_mm[*v as usize] >= least_mm;
        field.triangles[triangle as usize].into_iter().filter(is_deep)
    };
    for p in &parts {
        let mut vertices = deep(p.triangle);
        if let Some(first) = vertices.next() {
            vertices.for_each(|v| groups.join(first, v));
        }
    }
    let mut found: BTreeMap<u32, Vec<Deep>> = BTreeMap::new();
    for p in parts {
        if let Some(first) = deep(p.triangle).next() {
            found.entry(groups.root(first)).or_default().push(p);
        }
    }
    found.into_values().collect()
}

/// What smoothing takes off the volume is given back: it lowers a depth by r²/8 × the sum of
/// its second derivatives, and the integral of that over an area is the slope summed along its outline (Gauss). Of wear
/// 0.2 mm deep and 20 mm wide it is 1 %.
fn patch(field: &DepthField, kind: PatchKind, parts: &[Deep], least_mm: f64, radius_mm: f64) -> Option<Patch> {
    let sum = |of: fn(&Deep) -> f64| parts.iter().map(of).sum::<f64>();
    let area_mm2 = sum(|p| p.area_mm2);
    let moment = parts.iter().fold(Vector3::zeros(), |sum, p| sum + p.moment);
    let triangles: Vec<u32> = parts.iter().map(|p| p.triangle).collect();
    let corners = triangles.iter().flat_map(|&t| field.triangles[t as usize]);
    let mut vertices: Vec<u32> = corners.filter(|&v| kind.sign() * field.depth_mm[v as usize] >= least_mm).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let amount = |v: u32| kind.sign() * field.depth_mm[v as usize];
    vertices.sort_by(|a, b| amount(*a).total_cmp(&amount(*b)));
    let last = vertices.len().checked_sub(1)?;
    let deepest = vertices[(last as f64 * DEEPEST).round() as usize];
    let mut facets: Vec<u32> = triangles.iter().map(|&t| field.parent[t as usize]).collect();
    facets.dedup();
    let every: Vec<&Deep> = parts.iter().collect();
    Some(Patch {
        kind,
        area_mm2,
        depth_mm: amount(deepest),
        deepest_at: field.vertices[deepest as usize],
        volume_mm3: sum(|p| p.volume_mm3) + 0.125 * radius_mm * radius_mm * sum(|p| p.slope_mm),
        centre: Point3::from(moment / area_mm2),
        facets,
        triangles,
        outlines: outlines(field, &every, kind.sign(), least_mm),
    })
}
