//! The part as it is ground: every area is a surface of its own, a bead stands on it, and what each pass grinds down to is
//! kept with its surfaces.

use super::on_part::WeldPart;
use super::{HeldReason, MeasuredArea, MeasuredWeld, ReadWeld, WeldError, WeldProgress};
use crate::document::Job;
use crate::part::ground::CentrePoint;
use crate::part::patched::{GroundPatch, PatchCut, PatchSurface, RefinedFacets, grounds, standing, with_patches};
use crate::part::topology::FacetDefect;
use crate::part::{Part, Surfaces};
use crate::progress::{Cancelled, Progress};
use crate::scan::deviation::refined::{RefinedPiece, refined};
use crate::weld::area_samples::AreaSamples;
use crate::weld::outline_distance::OutlineDistance;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::sync::Arc;

/// Facets in and around areas are no larger than this, mm: the cap of a bead 12 mm wide and 15 mm high is 0.15 mm off
/// halfway between, and its outline 0.02 mm.
const CELL_MM: f64 = 1.2;
/// So far around an area facets are as fine, mm.
const AROUND_MM: f64 = 4.0;
/// More triangles than this nobody waits for; areas so large get coarser ones.
const MOST_TRIANGLES: usize = 2_000_000;
/// A bead rises no more steeply from its outline: one of 12 mm width and 15 mm height rises by 5 mm a mm at its foot. It
/// keeps heights and outline together, whatever noise there is at the rim.
const STEEPEST_RISE: f64 = 5.0;

/// The part of a weld with its areas as surfaces.
#[derive(Clone, Debug)]
pub struct GroundWeld {
    /// The part with its bead standing on it.
    pub part: Arc<Part>,
    /// Its surfaces; those that are ground are named, with what each pass takes off them.
    pub surfaces: Arc<Surfaces>,
    /// Of each area its surfaces, in the order of the areas.
    pub patches: Vec<Vec<PatchSurface>>,
    /// The part without its bead, and the surfaces of the areas on it.
    pub bare: (Arc<Part>, Arc<Surfaces>),
}

/// Makes surfaces of the areas.
///
/// # Errors
/// The work was cancelled.
pub fn ground(
    (read, measured, on): (&ReadWeld, &MeasuredWeld, &WeldPart),
    passes: &WeldProgress,
    job: &Job,
    progress: &Progress,
) -> Result<GroundWeld, WeldError> {
    let areas = measured.areas.iter().map(|a| AreaOnPart::new(a, on, progress)).collect::<Result<Vec<_>, _>>()?;
    let piece = fine_piece(&on.part, &areas, progress)?;
    let (depth_mm, triangles) = depths(&piece, &areas, (read, on), progress)?;
    let RefinedPiece { vertices, triangles: corners, parent } = &piece;
    let refined = RefinedFacets { vertices, triangles: corners, parent, depth_mm: &depth_mm };
    let mut levels_mm = passes.levels_mm(job.weld.at_once);
    let patches: Vec<GroundPatch> = areas
        .iter()
        .map(|area| match area.of.bead {
            Some(_) => GroundPatch { levels_mm: levels_mm.clone(), centre_line: area.centre_line.clone() },
            None => GroundPatch::default(),
        })
        .collect();
    levels_mm.retain(|mm| *mm > 0.0);
    levels_mm.reverse();
    let cut = PatchCut { above_mm: 0.0, levels_mm: &levels_mm, triangles: &triangles };
    let mut patched = with_patches(&on.part, &on.surfaces, &refined, &cut, progress)?;
    patched.surfaces.grounds = grounds(&patched, &patches);
    let is_given_out = |area: &AreaOnPart<'_>| match (passes.held, &area.of.bead) {
        (Some(HeldReason::Place { .. }), _) => false,
        (held, Some(_)) => held.is_none() && !passes.left.is_empty(),
        (_, None) => true,
    };
    let is_worked = |area: &AreaOnPart<'_>| is_given_out(area) && area.of.is_chosen(&job.weld.areas);
    let chosen = areas.iter().zip(&patched.patches).filter(|(area, _)| is_worked(area));
    patched.surfaces.worked = Some(chosen.flat_map(|(_, pieces)| pieces.iter().map(|piece| piece.surface)).collect());
    let raised = standing(&patched.part, &patched.surfaces, progress)?;
    Ok(GroundWeld {
        part: Arc::new(raised.part),
        surfaces: Arc::new(raised.surfaces),
        patches: patched.patches,
        bare: (Arc::new(patched.part), Arc::new(patched.surfaces)),
    })
}

/// An area with what is asked of it at places of the part.
struct AreaOnPart<'a> {
    of: &'a MeasuredArea,
    distance: OutlineDistance,
    /// Heights at the feet of a bead's points, and nought at those of any other area.
    samples: AreaSamples,
    centre_line: Vec<CentrePoint>,
}

impl<'a> AreaOnPart<'a> {
    fn new(of: &'a MeasuredArea, on: &WeldPart, progress: &Progress) -> Result<AreaOnPart<'a>, Cancelled> {
        let to_part = |p: &Point3<f64>| on.part_from_camera * p;
        let samples: Vec<(Point3<f64>, f64)> = match &of.bead {
            Some(bead) => bead.points.iter().map(|p| (to_part(&p.foot), p.height_mm)).collect(),
            None => of.places.iter().map(|p| (to_part(p), 0.0)).collect(),
        };
        let centre = |(p, n): (Point3<f64>, Vector3<f64>)| {
            let p = to_part(&p);
            let p = on.part.bvh.closest(&p, AROUND_MM).map_or(p, |closest| closest.foot);
            CentrePoint { p, n: on.part_from_camera * n }
        };
        let sections = of.bead.iter().flat_map(|bead| &bead.sections);
        let centre_line = sections.map(|s| centre((s.centre, s.normal))).collect();
        let distance = OutlineDistance::of(&of.outline);
        Ok(AreaOnPart { of, distance, samples: AreaSamples::new(&samples, progress)?, centre_line })
    }
}

/// The facets of the part in and around all areas, cut fine.
fn fine_piece(part: &Part, areas: &[AreaOnPart<'_>], progress: &Progress) -> Result<RefinedPiece, Cancelled> {
    let is_near = |corners: &[Point3<f64>; 3]| {
        let middle = Point3::from((corners[0].coords + corners[1].coords + corners[2].coords) / 3.0);
        let reach = corners.iter().map(|c| (c - middle).norm()).fold(0.0, f64::max);
        areas.iter().any(|area| area.samples.is_near(&middle, reach + AROUND_MM))
    };
    let is_too_large = |corners: &[Point3<f64>; 3]| {
        (0..3).any(|k| (corners[(k + 1) % 3] - corners[k]).norm() > CELL_MM) && is_near(corners)
    };
    let mesh = &part.mesh;
    let proper = (0..mesh.facets.len() as u32).filter(|&f| mesh.defects[f as usize] == FacetDefect::None);
    let taken: Vec<u32> = proper.filter(|&f| is_near(&mesh.corners(f as usize))).collect();
    refined(part, taken.into_iter(), MOST_TRIANGLES, is_too_large, progress)
}

/// Height at each vertex, below 0 outside of all outlines and NaN far from them; and the triangles of each area.
fn depths(
    piece: &RefinedPiece,
    areas: &[AreaOnPart<'_>],
    (read, on): (&ReadWeld, &WeldPart),
    progress: &Progress,
) -> Result<(Vec<f64>, Vec<Vec<u32>>), Cancelled> {
    let eye = on.part_from_camera * Point3::origin();
    let (mesh, mut normals) = (&on.part.mesh, vec![Vector3::zeros(); piece.vertices.len()]);
    // The camera sees one side of a plate.
    let is_seen = |f: u32| mesh.normals[f as usize].dot(&(mesh.centroid(f as usize) - eye)) < 0.0;
    for (corners, &f) in piece.triangles.iter().zip(&piece.parent).filter(|(_, f)| is_seen(**f)) {
        corners.iter().for_each(|&v| normals[v as usize] = mesh.normals[f as usize]);
    }
    let camera_from_part = on.part_from_camera.inverse();
    let at = |room: &mut Vec<_>, v: usize| {
        progress.check_at(v)?;
        let place = &piece.vertices[v];
        let seen = camera_from_part * place;
        // Nor what lies behind the skin, or hides it.
        let is_on = |area: &AreaOnPart<'_>| area.of.parent.foot(&seen).height_mm.abs() < AROUND_MM;
        let is_faced = normals[v] != Vector3::zeros();
        let within =
            |area: &AreaOnPart<'_>| area.distance.at_mm(&seen, &read.camera).filter(|_| is_faced && is_on(area));
        let nearest = areas.iter().enumerate().filter_map(|(i, area)| Some((i, within(area)?)));
        let nearest = nearest.fold(None, |best: Option<(usize, f64)>, (i, mm)| match best {
            Some(best) if best.1 >= mm => Some(best),
            _ => Some((i, mm)),
        });
        let Some((i, within_mm)) = nearest.filter(|(_, mm)| *mm > -AROUND_MM) else { return Ok((0, f64::NAN)) };
        let rise_mm = STEEPEST_RISE * within_mm;
        let area = &areas[i];
        let height_mm = match area.of.bead {
            Some(_) if within_mm > 0.0 => area.samples.value_mm(place, &normals[v], room),
            _ => None,
        };
        // Something stands wherever the outline says so, be it ever so low.
        Ok((i, height_mm.map_or(rise_mm, |mm| mm.max(LEAST_HEIGHT_MM).min(rise_mm))))
    };
    let found: Vec<(usize, f64)> =
        (0..piece.vertices.len()).into_par_iter().map_init(Vec::new, at).collect::<Result<_, Cancelled>>()?;
    let mut of_area = vec![Vec::new(); areas.len()];
    let seen = (0u32..).zip(&piece.triangles).zip(&piece.parent).filter(|(_, f)| is_seen(**f));
    for ((number, corners), _) in seen {
        let standing = corners.iter().map(|&v| found[v as usize]).find(|(_, mm)| *mm > 0.0);
        if let Some((i, _)) = standing
            && corners.iter().all(|&v| found[v as usize].1.is_finite())
        {
            of_area[i].push(number);
        }
    }
    Ok((found.into_iter().map(|(_, mm)| mm).collect(), of_area))
}

/// The least height within an outline, mm.
const LEAST_HEIGHT_MM: f64 = 1e-3;
