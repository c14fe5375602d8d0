//! What an operator should know of a part's file, as data, the worst first; its sentences stand in `text`.

use super::far_from_origin::FarFromOrigin;
use super::raw_part::{InvalidFacet, UnreadKind};
use super::units::StatedUnit;
use super::{Part, Units};
use serde::Serialize;

/// Something about a part's file that an operator should know. The order of the variants is how bad they are.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum PartFinding {
    /// In the given unit the part is far larger or smaller than anything that a robot carries.
    ImplausibleSize {
        /// Unit that was taken.
        units: Units,
        /// Size of the box around the part in it, mm.
        size_mm: [f64; 3],
        /// Unit in which the size would be plausible; `None`: it is in none.
        #[serde(skip_serializing_if = "Option::is_none")]
        better_units: Option<Units>,
        /// Size in that, mm.
        #[serde(skip_serializing_if = "Option::is_none")]
        better_size_mm: Option<[f64; 3]>,
    },
    /// The part lies so far from the origin of its file that its coordinates are coarse there.
    FarFromOrigin(FarFromOrigin),
    /// The file states a unit, and the part is taken in another.
    UnitOverridden {
        /// The unit that the file states.
        stated: StatedUnit,
        /// The unit that was taken.
        units: Units,
    },
    /// Facets that cannot be used are missing from the part.
    FacetsDropped {
        /// How many.
        count: usize,
        /// The first of them, at most [`NAMED`].
        first: Vec<InvalidFacet>,
    },
    /// The file holds other facets than it says.
    CountDiffers {
        /// Facets by its header.
        promised: usize,
        /// Facets that were read.
        read: usize,
    },
    /// Something that the file holds is not read.
    NotRead {
        /// What.
        what: UnreadKind,
        /// How many of it.
        count: usize,
    },
    /// Bytes that belong to nothing that is known, behind the last facet or between them.
    BytesPassedOver {
        /// How many.
        count: usize,
        /// Where the first of them stands in the file.
        at: usize,
    },
    /// Hundreds of its surfaces are smaller than the spot, and absorbing islands brings them to order.
    Shattered {
        /// All surfaces.
        surfaces: usize,
        /// Those that are smaller than the spot.
        smaller: usize,
        /// Area of the spot, mm².
        smaller_than_mm2: f64,
        /// The least area of the ladder below which islands are to be absorbed, mm².
        absorb_below_mm2: f64,
        /// All surfaces then.
        surfaces_then: usize,
    },
    /// Edges with one facet: the surface is not closed there.
    OpenEdges {
        /// How many.
        count: usize,
    },
    /// Edges with more than two facets.
    NonManifoldEdges {
        /// How many.
        count: usize,
    },
    /// Facets whose winding was turned.
    FlippedFacets {
        /// How many.
        count: usize,
    },
    /// Facets with the vertices of an earlier one, which are passed over.
    DuplicateFacets {
        /// How many.
        count: usize,
    },
    /// Facets that are the other side of an earlier one, on sheets without thickness.
    TwoSidedFacets {
        /// How many.
        count: usize,
    },
    /// Facets without area.
    DegenerateFacets {
        /// How many.
        count: usize,
    },
    /// Corners of open edges that were a rounding apart and became one vertex.
    JoinedCorners {
        /// Vertices that vanished.
        count: usize,
        /// The farthest way that one of them went, mm.
        within_mm: f64,
    },
    /// Several solids of one file became one part.
    SolidsJoined {
        /// How many.
        count: usize,
    },
    /// The file is a scan, and its facets were laid through the points.
    Meshed {
        /// Points that they were laid through.
        points: usize,
        /// Points that were left out.
        dropped: usize,
        /// Side of the cells, mm: what is smaller is not there.
        cell_mm: f64,
        /// Root of the mean square of the points' distances to the facets, mm.
        rms_mm: f64,
        /// Whether outside was guessed, since the points have no normals.
        is_side_guessed: bool,
    },
    /// The file states a unit other than millimetres, and the part is taken in it.
    UnitTaken {
        /// The unit.
        stated: StatedUnit,
    },
}

/// So many dropped facets are named singly.
pub const NAMED: usize = 3;

impl PartFinding {
    /// What there is to say of a part's file, the worst first; empty for a clean one. What its surfaces tell is
    /// [`PartFinding::shattered`], and takes its place by [`PartFinding::with`].
    pub fn of(part: &Part) -> Vec<PartFinding> {
        let found = &part.figures;
        let dropped = (!found.invalid.is_empty()).then(|| PartFinding::FacetsDropped {
            count: found.invalid.len(),
            first: found.invalid.iter().take(NAMED).copied().collect(),
        });
        let counted = [
            (found.boundary_edges, (|count| PartFinding::OpenEdges { count }) as fn(usize) -> PartFinding),
            (found.non_manifold_edges - found.sheet_edges, |count| PartFinding::NonManifoldEdges { count }),
            (part.orientation.flipped_facets, |count| PartFinding::FlippedFacets { count }),
            (found.duplicate_facets - found.back_facets, |count| PartFinding::DuplicateFacets { count }),
            (found.back_facets, |count| PartFinding::TwoSidedFacets { count }),
            (found.degenerate_facets, |count| PartFinding::DegenerateFacets { count }),
        ];
        let counted = counted.into_iter().filter(|(count, _)| *count > 0).map(|(count, finding)| finding(count));
        let (count, within_mm) = (found.joined_corners, found.joined_within_mm);
        let mut out: Vec<PartFinding> = implausible_size(part).into_iter().collect();
        out.extend(found.far_from_origin.map(PartFinding::FarFromOrigin));
        out.extend(unit(part, true));
        out.extend(dropped);
        out.extend(of_reading(part));
        out.extend(counted);
        out.extend((count > 0).then_some(PartFinding::JoinedCorners { count, within_mm }));
        out.extend((found.solids > 1).then_some(PartFinding::SolidsJoined { count: found.solids }));
        out.extend(found.meshed.map(|m| PartFinding::Meshed {
            points: m.points,
            dropped: m.dropped,
            cell_mm: m.cell,
            rms_mm: m.rms,
            is_side_guessed: m.is_side_guessed,
        }));
        out.extend(unit(part, false));
        out
    }
}

/// What is to be known of the unit that the file states. `overridden`: where it is not the one that was taken.
fn unit(part: &Part, overridden: bool) -> Option<PartFinding> {
    let (stated, units) = (part.figures.stated_unit?, part.figures.units);
    if stated.taken() != units {
        return overridden.then_some(PartFinding::UnitOverridden { stated, units });
    }
    (!overridden && stated != StatedUnit::Millimeter).then_some(PartFinding::UnitTaken { stated })
}

/// What the reader counted otherwise, left unread or passed over.
fn of_reading(part: &Part) -> impl Iterator<Item = PartFinding> {
    let found = &part.figures;
    let differs = found.count_differs.map(|c| PartFinding::CountDiffers { promised: c.promised, read: c.read });
    let unread = found.unread.iter().map(|u| PartFinding::NotRead { what: u.what.clone(), count: u.count });
    let passed_over = found.passed_over.map(|p| PartFinding::BytesPassedOver { count: p.count, at: p.at });
    differs.into_iter().chain(unread).chain(passed_over)
}

fn implausible_size(part: &Part) -> Option<PartFinding> {
    let found = &part.figures;
    if found.has_plausible_size {
        return None;
    }
    let (lo, hi) = part.mesh.bounds();
    let (size, units, better_units) = (hi - lo, found.units, found.better_units);
    let better_size_mm = better_units.map(|better| (size / found.mm_per_unit * better.mm()).into());
    Some(PartFinding::ImplausibleSize { units, size_mm: size.into(), better_units, better_size_mm })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Placement;
    use crate::sample::{solids, stl_bytes};

    fn codes(bytes: &[u8], units: Units) -> Vec<String> {
        let part = Part::from_bytes(bytes, units, &Placement::default(), &[]).expect("a part");
        let code = |f: &PartFinding| serde_json::to_value(f).expect("plain data")["code"].as_str().map(str::to_owned);
        PartFinding::of(&part).iter().filter_map(code).collect()
    }

    #[test]
    fn a_clean_file_has_none_and_the_worst_comes_first() {
        let mut cube = solids::cube(10.0);
        assert_eq!(codes(&stl_bytes(&cube), Units::Mm), Vec::<String>::new());
        // Without a side, the other one twice, one that is no number, and a tail.
        cube.truncate(10);
        cube.push(cube[0]);
        cube.push([[f64::NAN; 3]; 3]);
        let mut bytes = stl_bytes(&cube);
        bytes.extend([7; 5]);
        let expected = [
            "implausible_size",
            "facets_dropped",
            "bytes_passed_over",
            "open_edges",
            "non_manifold_edges",
            "duplicate_facets",
        ];
        let found = codes(&bytes, Units::M);
        let order: Vec<_> = found.iter().map(|c| expected.iter().position(|e| e == c)).collect();
        assert!(order.is_sorted() && order.iter().all(Option::is_some), "{found:?}");
        for code in ["implausible_size", "facets_dropped", "open_edges", "duplicate_facets", "bytes_passed_over"] {
            assert!(found.iter().any(|f| f == code), "{code}: {found:?}");
        }
    }
}
