//! Why a part cannot be loaded, and what was found in its file. What is wrong with a file that is no part stands in
//! `part_file`.

use super::{Arg, Sentence, exact, fixed, id, listed_clauses, quoted, rough, say};
use crate::part::far_from_origin::FarFromOrigin;
use crate::part::raw_part::{FacetFault, InvalidFacet, UnreadKind};
use crate::part::{LoadError, PartFinding};

impl Sentence for LoadError {
    fn sentence(&self) -> String {
        match self {
            LoadError::Io { file, source } => say!(file_not_read, file, reason = source.to_string()),
            LoadError::Folder { file } => say!(part_file_folder, file),
            LoadError::Unusable { file, source } => say!(in_file, file, what = source.sentence()),
            LoadError::OtherUnit { file, stated, units } => {
                say!(
                    part_file_other_unit,
                    file,
                    stated = stated.word(),
                    units = units.word(),
                    key = stated.taken().word()
                )
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
            FacetFault::CrossesItself => say!(facet_crosses_itself),
            FacetFault::TooManyCorners => say!(facet_too_many_corners),
        }
    }
}

impl Sentence for PartFinding {
    fn sentence(&self) -> String {
        match self {
            PartFinding::ImplausibleSize { size_mm, better_units, better_size_mm, .. } => {
                let size_mm = size_mm.map(length).join(" × ");
                match (better_units, better_size_mm) {
                    (Some(units), Some(better_mm)) => {
                        say!(part_implausible_size, size = size_mm, unit = units.word(), other = size(better_mm, 1))
                    }
                    _ => say!(part_implausible_in_any_unit, size = size_mm),
                }
            }
            PartFinding::FarFromOrigin(FarFromOrigin { distance_mm, resolution_mm }) => {
                let distance = length(distance_mm / 1000.0);
                say!(part_far_from_origin, distance, step = rough(*resolution_mm))
            }
            PartFinding::Shattered { surfaces, smaller, smaller_than_mm2, absorb_below_mm2, surfaces_then } => {
                say!(
                    part_shattered,
                    surfaces = *surfaces,
                    smaller = *smaller,
                    spot = fixed(*smaller_than_mm2, 2),
                    below = exact(*absorb_below_mm2),
                    left = *surfaces_then
                )
            }
            PartFinding::UnitOverridden { stated, units } => {
                say!(part_unit_overridden, stated = stated.word(), units = units.word())
            }
            PartFinding::UnitTaken { stated } => say!(part_unit_taken, stated = stated.word()),
            PartFinding::CountDiffers { promised, read } => {
                say!(part_count_differs, promised = *promised, read = *read)
            }
            PartFinding::NotRead { what, count } => not_read(what, *count),
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
            PartFinding::BytesPassedOver { count, at } => {
                say!(part_bytes_passed_over, count = *count, at = id(*at))
            }
            PartFinding::SolidsJoined { count } => say!(part_solids_joined, count = *count),
            PartFinding::Meshed { points, cell_mm, rms_mm, is_side_guessed, .. } => {
                let told = say!(
                    part_meshed,
                    points = *points,
                    rounded = length(2.0 * cell_mm),
                    cell = length(*cell_mm),
                    rms = length(*rms_mm)
                );
                listed_clauses(std::iter::once(told).chain(is_side_guessed.then(|| say!(part_side_guessed))))
            }
        }
    }
}

/// A finding as the command line says it: with the option, or the key of the job, that helps.
pub(crate) fn with_option(finding: &PartFinding) -> String {
    let option = match finding {
        PartFinding::ImplausibleSize { better_units: Some(units), .. } => {
            Some(say!(part_use_units, units = units.word()))
        }
        PartFinding::Shattered { absorb_below_mm2, .. } => {
            Some(say!(part_absorb_in_job, value = exact(*absorb_below_mm2)))
        }
        _ => None,
    };
    listed_clauses(std::iter::once(finding.sentence()).chain(option))
}

/// A length with three decimals, or by its first digits where it has too many before them, or none.
fn length(value: f64) -> String {
    if (0.001..1e7).contains(&value) || value == 0.0 { fixed(value, 3) } else { rough(value) }
}

fn not_read(what: &UnreadKind, count: usize) -> String {
    match what {
        UnreadKind::Lines => say!(part_lines_not_read, count),
        UnreadKind::Points => say!(part_points_not_read, count),
        UnreadKind::FreeForm => say!(part_free_form_not_read, count),
        UnreadKind::UnknownLines => say!(part_unknown_lines, count),
        UnreadKind::Element(name) => say!(part_element_not_read, count, name = quoted(name)),
        UnreadKind::ObjectsNotBuilt => say!(part_objects_not_built, count),
        UnreadKind::Supports => say!(part_supports_not_read, count),
        UnreadKind::LatticeBeams => say!(part_beams_not_read, count),
    }
}

fn dropped(f: &InvalidFacet) -> String {
    say!(part_dropped_facet, facet = id(f.facet), fault = f.fault.sentence(), byte = id(f.byte))
}

/// `1.0 × 2.0 × 3.0`
pub(super) fn size(size_mm: &[f64; 3], decimals: usize) -> Arg<'static> {
    size_mm.map(|mm| fixed(mm, decimals)).join(" × ").into()
}
