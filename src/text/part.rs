//! What is wrong with a part's file, and what was found in it.

use super::{Arg, Sentence, fixed, id, listed_clauses, rough, say};
use crate::part::stl::{FacetFault, InvalidFacet, StlError};
use crate::part::{LoadError, PartFinding};

impl Sentence for LoadError {
    fn sentence(&self) -> String {
        match self {
            LoadError::Io { file, source } => say!(file_not_read, file, reason = source.to_string()),
            LoadError::Stl { file, source } => say!(in_file, file, what = source.sentence()),
        }
    }
}

impl Sentence for StlError {
    fn sentence(&self) -> String {
        match *self {
            StlError::Empty => say!(stl_empty),
            StlError::CutOff { promised, needed, present } => say!(stl_cut_off, promised, needed, present),
            StlError::TextCutOff { facets, byte } => say!(stl_text_cut_off, facets, byte = id(byte)),
            StlError::NotStl => say!(stl_not_stl),
            StlError::NoFacet { first: None, .. } => say!(stl_no_facets),
            StlError::NoFacet { dropped, first: Some(first) } => {
                say!(stl_all_dropped, dropped, first = first.sentence())
            }
        }
    }
}

impl Sentence for FacetFault {
    fn sentence(&self) -> String {
        match self {
            FacetFault::Nan => say!(facet_nan),
            FacetFault::Infinite => say!(facet_infinite),
            FacetFault::Unreadable => say!(facet_unreadable),
            FacetFault::NoEnd => say!(facet_no_end),
            FacetFault::NotThreeVertices => say!(facet_not_three_vertices),
            FacetFault::NoArea => say!(facet_no_area),
        }
    }
}

impl Sentence for PartFinding {
    fn sentence(&self) -> String {
        match self {
            PartFinding::ImplausibleSize { size_mm, better_units, better_size_mm, .. } => {
                say!(
                    part_implausible_size,
                    size = size(size_mm, 3),
                    unit = better_units.word(),
                    other = size(better_size_mm, 1)
                )
            }
            PartFinding::FacetsDropped { count, first } => {
                let mut list: Vec<String> = first.iter().map(dropped).collect();
                if *count > first.len() {
                    list.push(say!(part_more_dropped, count = count - first.len()));
                }
                say!(part_facets_dropped, count = *count, list = listed_clauses(list))
            }
            PartFinding::OpenEdges { count } => say!(part_open_edges, count = *count),
            PartFinding::NonManifoldEdges { count } => say!(part_non_manifold_edges, count = *count),
            PartFinding::FlippedFacets { count } => say!(part_flipped_facets, count = *count),
            PartFinding::DuplicateFacets { count } => say!(part_duplicate_facets, count = *count),
            PartFinding::TwoSidedFacets { count } => say!(part_two_sided_facets, count = *count),
            PartFinding::JoinedCorners { count, within_mm } => {
                say!(part_joined_corners, count = *count, within = rough(*within_mm))
            }
            PartFinding::DegenerateFacets { count } => say!(part_degenerate_facets, count = *count),
            PartFinding::BytesPassedOver { count } => say!(part_bytes_passed_over, count = *count),
            PartFinding::SolidsJoined { count } => say!(part_solids_joined, count = *count),
        }
    }
}

fn dropped(f: &InvalidFacet) -> String {
    say!(part_dropped_facet, facet = id(f.facet), fault = f.fault.sentence(), byte = id(f.byte))
}

/// `1.0 × 2.0 × 3.0`
pub(super) fn size(size_mm: &[f64; 3], decimals: usize) -> Arg<'static> {
    size_mm.map(|mm| fixed(mm, decimals)).join(" × ").into()
}
