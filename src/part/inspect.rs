//! The report of `inspect`: facets, vertices, edges, shells, what was repaired or dropped, size and surfaces.
//!
//! Which of the figures an operator should know about is decided in [`super::finding`].

use super::{Part, PartFinding, Shape, SurfaceRule, Surfaces};
use crate::progress::Progress;
use rayon::prelude::*;
use serde::{Serialize, Serializer};

/// `inspect --json`: names and order are a contract.
#[derive(Clone, Debug, Serialize)]
pub struct InspectReport {
    /// Facets that were kept.
    pub facets: usize,
    /// Vertices after welding.
    pub vertices: usize,
    /// Edges between them.
    pub edges: usize,
    /// Edges with one facet.
    pub boundary_edges: usize,
    /// Edges with more than two facets.
    pub non_manifold_edges: usize,
    /// Vertices that vanished because corners of open edges a rounding apart were joined.
    pub joined_corners: usize,
    /// Shells: facets connected through edges.
    pub shells: usize,
    /// Whether every edge has exactly two facets.
    pub watertight: bool,
    /// Facets without area.
    pub degenerate_facets: usize,
    /// Facets with the vertices of an earlier one.
    pub duplicate_facets: usize,
    /// Facets that were turned.
    pub flipped_facets: usize,
    /// Facets that were dropped.
    pub invalid_facets: usize,
    /// Area of all facets, mm².
    pub area_mm2: f64,
    /// Enclosed volume, mm³; `None`: not watertight.
    pub volume_mm3: Option<f64>,
    /// The box around the part.
    pub bounds_mm: BoundsMm,
    /// Crease angle that the surfaces were cut at, degrees.
    pub angle_deg: f64,
    /// The feature surfaces.
    pub surfaces: Vec<SurfaceRow>,
    /// What is to be known of the file, by the codes of the report; a clean file has no such key.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<PartFinding>,
}

/// A box in the part frame, mm.
#[derive(Clone, Debug, Serialize)]
pub struct BoundsMm {
    /// Its lowest corner.
    pub min: [f64; 3],
    /// Its highest corner.
    pub max: [f64; 3],
}

/// A feature surface.
#[derive(Clone, Debug, Serialize)]
pub struct SurfaceRow {
    /// Its number.
    pub surface: u32,
    /// How many facets it has.
    pub facets: usize,
    /// Their area, mm².
    pub area_mm2: f64,
    /// Its shape; in JSON its word.
    #[serde(serialize_with = "as_word")]
    pub shape: Shape,
}

fn as_word<S: Serializer>(shape: &Shape, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(shape.word())
}

impl InspectReport {
    /// The report of a part segmented by a rule. `spot_mm2`: area of the spot that surfaces are to be larger than.
    pub fn new(part: &Part, surfaces: &Surfaces, rule: &SurfaceRule, spot_mm2: f64) -> InspectReport {
        // Nobody can cancel it.
        let shattered = PartFinding::shattered(part, surfaces, rule, spot_mm2, &Progress::default());
        let (mesh, found) = (&part.mesh, &part.figures);
        let (lo, hi) = mesh.bounds();
        InspectReport {
            facets: mesh.facets.len(),
            vertices: mesh.vertices.len(),
            edges: mesh.edges.len(),
            boundary_edges: found.boundary_edges,
            non_manifold_edges: found.non_manifold_edges,
            joined_corners: found.joined_corners,
            shells: part.orientation.shells,
            watertight: part.orientation.watertight,
            degenerate_facets: found.degenerate_facets,
            duplicate_facets: found.duplicate_facets,
            flipped_facets: part.orientation.flipped_facets,
            invalid_facets: found.invalid.len(),
            area_mm2: mesh.areas.iter().sum(),
            volume_mm3: found.volume_mm3,
            bounds_mm: BoundsMm { min: lo.coords.into(), max: hi.coords.into() },
            angle_deg: rule.angle_deg,
            surfaces: surfaces
                .list
                .par_iter()
                .map(|s| SurfaceRow {
                    surface: s.number,
                    facets: s.facets.len(),
                    area_mm2: s.area_mm2,
                    shape: Shape::of(mesh, s),
                })
                .collect(),
            findings: PartFinding::with(PartFinding::of(part), shattered.unwrap_or_default()),
        }
    }
}
