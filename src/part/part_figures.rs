//! What was counted while a part was read and oriented, whatever the crease angle: open and non-manifold edges,
//! degenerate, duplicate and dropped facets, volume and unit.

use super::Units;
use super::far_from_origin::FarFromOrigin;
use super::orient::{Orientation, volume};
use super::raw_part::{CountDiffers, InvalidFacet, Meshed, PassedOver, RawPart, Unread};
use super::topology::{FacetDefect, Mesh};
use super::units::{StatedUnit, is_plausible};
use super::weld::Joined;

/// Figures of a file that do not depend on the crease angle.
#[derive(Clone, Debug, Default)]
pub struct PartFigures {
    /// Facets that were dropped.
    pub invalid: Vec<InvalidFacet>,
    /// Edges with one facet.
    pub boundary_edges: usize,
    /// Edges with more than two.
    pub non_manifold_edges: usize,
    /// Those of them at which sheets with both sides go on, each side for itself.
    pub sheet_edges: usize,
    /// Facets without area.
    pub degenerate_facets: usize,
    /// Facets with the vertices of an earlier one.
    pub duplicate_facets: usize,
    /// Those of them that are its other side, on sheets without thickness.
    pub back_facets: usize,
    /// Vertices that vanished because corners of open edges a rounding apart were joined.
    pub joined_corners: usize,
    /// The farthest way that one of them went, mm.
    pub joined_within_mm: f64,
    /// Enclosed volume, mm³; `None` where the part is not watertight.
    pub volume_mm3: Option<f64>,
    /// The unit that the file was read in.
    pub units: Units,
    /// Millimetres in one unit of the file's coordinates, before the scale of the placement.
    pub mm_per_unit: f64,
    /// Whether it can be as large as it is in that unit.
    pub has_plausible_size: bool,
    /// A unit that would give a plausible size, where the one above does not.
    pub better_units: Option<Units>,
    /// Where the part lies so far out that its coordinates are coarse.
    pub far_from_origin: Option<FarFromOrigin>,
    /// The unit that the file states.
    pub stated_unit: Option<StatedUnit>,
    /// Solids in the file.
    pub solids: usize,
    /// Bytes that were passed over.
    pub passed_over: Option<PassedOver>,
    /// A count of facets that is not true.
    pub count_differs: Option<CountDiffers>,
    /// What of the file is not read.
    pub unread: Vec<Unread>,
    /// How the facets were laid through the points of a scan, where the file has none; lengths mm.
    pub meshed: Option<Meshed>,
}

impl PartFigures {
    /// Counts them on the oriented mesh. `joined` is in millimetres; `mm_per_unit`: of the coordinates as they are
    /// stored, before the `scale` of the placement.
    pub fn new(
        raw: &RawPart,
        joined: Joined,
        mesh: &Mesh,
        orientation: &Orientation,
        units: Units,
        [mm_per_unit, scale]: [f64; 2],
    ) -> PartFigures {
        let facets_at =
            |test: fn(usize) -> bool| (0..mesh.edges.len() as u32).filter(|&e| test(mesh.edge_facets(e).len())).count();
        let count = |kind| mesh.defects.iter().filter(|&&d| d == kind).count();
        let back_facets = mesh.back_count();
        let (lo, hi) = mesh.bounds();
        let longest_mm = (hi - lo).max();
        let has_plausible_size = is_plausible(longest_mm);
        PartFigures {
            invalid: raw.invalid.clone(),
            boundary_edges: facets_at(|n| n == 1),
            non_manifold_edges: facets_at(|n| n > 2),
            sheet_edges: (0..mesh.edges.len() as u32).filter(|&e| mesh.pairs(e).nth(1).is_some()).count(),
            degenerate_facets: count(FacetDefect::Degenerate),
            duplicate_facets: count(FacetDefect::Duplicate) + back_facets,
            back_facets,
            joined_corners: joined.corners,
            joined_within_mm: joined.within,
            volume_mm3: orientation.watertight.then(|| volume(mesh)),
            units,
            mm_per_unit,
            has_plausible_size,
            better_units: if has_plausible_size { None } else { units.better_guess(longest_mm / mm_per_unit) },
            far_from_origin: FarFromOrigin::of(&raw.facets, mm_per_unit * scale),
            stated_unit: raw.stated_unit,
            solids: raw.solids,
            passed_over: raw.passed_over,
            count_differs: raw.count_differs,
            unread: raw.unread.clone(),
            meshed: raw.meshed.map(|m| Meshed {
                cell: m.cell * mm_per_unit * scale,
                rms: m.rms * mm_per_unit * scale,
                ..m
            }),
        }
    }
}
