//! What was found in a file, in numbers and in sentences: facets, vertices, edges, open and
//! non-manifold edges, shells, degenerate, duplicate, flipped and dropped facets, size and unit.

use super::orient::{Orientation, volume};
use super::stl::{InvalidFacet, RawPart};
use super::topology::{Dead, Mesh};
use super::{Shape, Surfaces, Units};
use rayon::prelude::*;
use serde::Serialize;

/// Findings that do not depend on the angle.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Facets that were dropped (not a number, infinite, unreadable).
    pub invalid: Vec<InvalidFacet>,
    /// Edges with one facet.
    pub boundary_edges: usize,
    /// Edges with more than two.
    pub non_manifold_edges: usize,
    /// Facets without area.
    pub degenerate_facets: usize,
    /// Facets with the vertices of an earlier one.
    pub duplicate_facets: usize,
    /// Enclosed volume, mm³; `None` where the part is not watertight.
    pub volume_mm3: Option<f64>,
    /// The unit that was taken, and one that would give a plausible size where that does not.
    pub units: Units,
    /// The better guess.
    pub better_units: Option<Units>,
    /// Solids of a text file beyond the first, and bytes behind a binary one.
    pub notes: Vec<String>,
}

impl Findings {
    /// Counts what there is.
    pub fn new(raw: &RawPart, mesh: &Mesh, orientation: &Orientation, units: Units) -> Findings {
        let facets_at =
            |test: fn(usize) -> bool| (0..mesh.edges.len() as u32).filter(|&e| test(mesh.edge_facets(e).len())).count();
        let dead = |kind| mesh.dead.iter().filter(|&&d| d == kind).count();
        let (lo, hi) = mesh.bounds();
        let mut notes = Vec::new();
        if raw.solids > 1 {
            notes.push(format!("{} solids in one file were joined", raw.solids));
        }
        if raw.tail_bytes > 0 {
            notes.push(format!("{} bytes behind the last facet were passed over", raw.tail_bytes));
        }
        Findings {
            invalid: raw.invalid.clone(),
            boundary_edges: facets_at(|n| n == 1),
            non_manifold_edges: facets_at(|n| n > 2),
            degenerate_facets: dead(Dead::Degenerate),
            duplicate_facets: dead(Dead::Duplicate),
            volume_mm3: orientation.watertight.then(|| volume(mesh)),
            units,
            better_units: units.better_guess((hi - lo).max() / units.mm()),
            notes,
        }
    }

    /// One sentence for everything that an operator should know; empty for a clean file.
    pub fn sentences(&self, mesh: &Mesh, orientation: &Orientation) -> Vec<String> {
        let mut said = Vec::new();
        for i in self.invalid.iter().take(3) {
            said.push(format!("facet {} has {} (byte {}); it was dropped", i.facet, i.why, i.byte));
        }
        if self.invalid.len() > 3 {
            said.push(format!("{} more facets were dropped", self.invalid.len() - 3));
        }
        let mut count = |n: usize, what: &str| {
            if n > 0 {
                said.push(format!("{n} {what}"));
            }
        };
        count(self.boundary_edges, "open edges: the surface is not closed there");
        count(self.non_manifold_edges, "edges have more than two facets; they count as creases");
        count(self.degenerate_facets, "facets have no area; planning skips them");
        count(self.duplicate_facets, "facets stand twice; planning skips the later ones");
        count(orientation.flipped_facets, "facets looked the other way and were turned");
        if let Some(better) = self.better_units {
            let (lo, hi) = mesh.bounds();
            let size = hi - lo;
            let other = size / self.units.mm() * better.mm();
            said.push(format!(
                "a size of {:.3} × {:.3} × {:.3} mm is implausible; in {} it would be {:.1} × {:.1} × {:.1} mm: use --units {}",
                size.x, size.y, size.z, better.word(), other.x, other.y, other.z, better.word()
            ));
        }
        said.extend(self.notes.iter().cloned());
        said
    }
}

/// `inspect --json`: names and order are a contract.
#[derive(Clone, Debug, Serialize)]
pub struct InspectReport {
    facets: usize,
    vertices: usize,
    edges: usize,
    boundary_edges: usize,
    non_manifold_edges: usize,
    shells: usize,
    watertight: bool,
    degenerate_facets: usize,
    duplicate_facets: usize,
    flipped_facets: usize,
    invalid_facets: usize,
    area_mm2: f64,
    volume_mm3: Option<f64>,
    bounds_mm: BoundsMm,
    angle_deg: f64,
    surfaces: Vec<SurfaceRow>,
}

#[derive(Clone, Debug, Serialize)]
struct BoundsMm {
    min: [f64; 3],
    max: [f64; 3],
}

#[derive(Clone, Debug, Serialize)]
struct SurfaceRow {
    surface: u32,
    facets: usize,
    area_mm2: f64,
    shape: &'static str,
}

impl InspectReport {
    /// The report of a part segmented at `angle_deg`.
    pub fn new(part: &super::Part, surfaces: &Surfaces, angle_deg: f64) -> InspectReport {
        let (mesh, found) = (&part.mesh, &part.findings);
        let (lo, hi) = mesh.bounds();
        InspectReport {
            facets: mesh.facets.len(),
            vertices: mesh.vertices.len(),
            edges: mesh.edges.len(),
            boundary_edges: found.boundary_edges,
            non_manifold_edges: found.non_manifold_edges,
            shells: part.orientation.shells,
            watertight: part.orientation.watertight,
            degenerate_facets: found.degenerate_facets,
            duplicate_facets: found.duplicate_facets,
            flipped_facets: part.orientation.flipped_facets,
            invalid_facets: found.invalid.len(),
            area_mm2: mesh.areas.iter().sum(),
            volume_mm3: found.volume_mm3,
            bounds_mm: BoundsMm { min: lo.coords.into(), max: hi.coords.into() },
            angle_deg,
            surfaces: surfaces
                .list
                .par_iter()
                .map(|s| SurfaceRow {
                    surface: s.number,
                    facets: s.facets.len(),
                    area_mm2: s.area_mm2,
                    shape: Shape::of(mesh, s).word(),
                })
                .collect(),
        }
    }

    /// The same for people.
    pub fn text(&self) -> String {
        use std::fmt::Write as _;
        let mut out = String::new();
        let [a, b] = [self.bounds_mm.min, self.bounds_mm.max];
        let _ = writeln!(out, "{} facets, {} vertices, {} edges", self.facets, self.vertices, self.edges);
        let _ =
            writeln!(out, "{} shells, {}", self.shells, if self.watertight { "watertight" } else { "not watertight" });
        let _ = writeln!(
            out,
            "size {:.3} × {:.3} × {:.3} mm, area {:.2} mm²",
            b[0] - a[0],
            b[1] - a[1],
            b[2] - a[2],
            self.area_mm2
        );
        if let Some(v) = self.volume_mm3 {
            let _ = writeln!(out, "volume {v:.2} mm³");
        }
        let _ = writeln!(out, "{} feature surfaces at {}°", self.surfaces.len(), self.angle_deg);
        let _ = writeln!(out, "{:>8} {:>8} {:>14}  shape", "surface", "facets", "area mm²");
        for s in &self.surfaces {
            let _ = writeln!(out, "{:>8} {:>8} {:>14.3}  {}", s.surface, s.facets, s.area_mm2, s.shape);
        }
        out
    }
}
