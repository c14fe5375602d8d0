//! The part as its scan found it: what is built up stands out of it, and what is missing is a surface of its own, worked in
//! place of the job's or left as the model has it.

use super::measuring::measured;
use super::{ComparedScan, LaidScan, ScanError, ScanModel};
use crate::document::Job;
use crate::document::model::{JobScan, PatchChoice, ScanLines, ScanWork};
use crate::part::patched::{
    LayersError, Lowered, PatchCut, PatchLayer, PatchSurface, PatchedPart, RefinedFacets, ScannedShape, fills,
    layer_count, patch_layers, shaped, with_patches,
};
use crate::part::{Part, SurfaceId, Surfaces};
use crate::progress::{Cancelled, Progress};
use crate::scan::deviation::{Patch, PatchKind};
use nalgebra::Point3;
use std::sync::Arc;

/// A part as its scan found it.
#[derive(Clone, Debug, Default)]
pub struct WornPart {
    /// The part: what is built up stands out of it, and where beads are to fill patches these have their floor.
    pub part: Arc<Part>,
    /// Its surfaces; where patches are worked those are named.
    pub surfaces: Arc<Surfaces>,
    /// For each patch that was cut out its surfaces, in the order of the patches.
    pub patches: Vec<Vec<PatchSurface>>,
    /// For each patch of the comparison the layers that fill it; none where nothing is laid on.
    pub layers: Vec<Vec<PatchLayer>>,
}

/// Makes of a part what its scan found.
///
/// # Errors
/// The part is off its model by more than the job allows, or the bead is too low by far; or the work was cancelled.
pub fn worn(
    (laid, compared): (&LaidScan, &ComparedScan),
    job: &Job,
    progress: &Progress,
) -> Result<WornPart, ScanError> {
    let (scan, ScanModel { part, surfaces, .. }) = (&job.scan, &laid.model);
    let (field, patches) = (&compared.patches.field, &compared.patches.patches);
    check_gate(scan, patches)?;
    let are_worked = scan.work == ScanWork::Patches;
    let is_built_up = patches.iter().any(|p| p.kind == PatchKind::Surplus);
    if !are_worked && !is_built_up && scan.lines == ScanLines::Facets {
        return Ok(WornPart { part: part.clone(), surfaces: surfaces.clone(), ..WornPart::default() });
    }
    // Cut where material is missing: what is built up is a part of the surface that it stands on.
    let missing: Vec<&Patch> = patches.iter().filter(|p| are_worked && p.kind == PatchKind::Missing).collect();
    let bead_mm = job.section_of_bead().map(|_| job.bead.height_mm).filter(|_| are_worked);
    let depths_mm: Vec<f64> = missing.iter().map(|p| p.depth_mm).collect();
    let refined = RefinedFacets {
        vertices: &field.vertices,
        triangles: &field.triangles,
        parent: &field.parent,
        depth_mm: &field.depth_mm,
    };
    let triangles: Vec<Vec<u32>> = missing.iter().map(|p| p.triangles.clone()).collect();
    let levels_mm = levels(scan.min_depth_mm, depths_mm.iter().copied().fold(0.0, f64::max), bead_mm)?;
    let cut = PatchCut { above_mm: scan.min_depth_mm, levels_mm: &levels_mm, triangles: &triangles };
    let mut patched = with_patches(part, surfaces, &refined, &cut, progress)?;
    if let Some(bead_mm) = bead_mm {
        patched.surfaces.fills = fills(&patched, &depths_mm, bead_mm);
    }
    if are_worked {
        patched.surfaces.worked = Some(worked(&patched, &scan.patches));
    }
    if scan.lines == ScanLines::Points {
        patched.surfaces.measured = Some(Arc::new(measured(part, laid, compared, progress)?));
    }
    // Spots on the points of the scan are on the part as it is, beads on the floor of what they fill.
    let lowered = match (scan.lines, bead_mm) {
        (ScanLines::Points, _) => Lowered::All,
        (ScanLines::Facets, Some(_)) if !missing.is_empty() => Lowered::Patches,
        (ScanLines::Facets, _) => Lowered::Nothing,
    };
    let (part, surfaces) = match is_built_up || lowered != Lowered::Nothing {
        true => shaped(&patched, &ScannedShape { raised_from_mm: scan.min_depth_mm, lowered }, progress)?,
        false => (patched.part, patched.surfaces),
    };
    let layers_of = |p: &Patch| match bead_mm.filter(|_| p.kind == PatchKind::Missing) {
        Some(mm) => patch_layers(&refined, &p.triangles, scan.min_depth_mm, p.depth_mm, mm, progress),
        None => Ok(Vec::new()),
    };
    let layers = patches.iter().map(layers_of).collect::<Result<_, _>>()?;
    Ok(WornPart { part: Arc::new(part), surfaces: Arc::new(surfaces), patches: patched.patches, layers })
}

/// Refuses a part that is off its model by more than a job allows: it may be another one.
fn check_gate(scan: &JobScan, patches: &[Patch]) -> Result<(), ScanError> {
    let beyond = patches.iter().find(|p| scan.gate_mm > 0.0 && p.depth_mm > scan.gate_mm);
    beyond.map_or(Ok(()), |p| Err(ScanError::Gate { patch: Box::new(p.into()), gate_mm: scan.gate_mm }))
}

/// The depths at which beads end below the model, between the least one and the greatest.
fn levels(least_mm: f64, deepest_mm: f64, bead_mm: Option<f64>) -> Result<Vec<f64>, LayersError> {
    let Some(bead_mm) = bead_mm else { return Ok(Vec::new()) };
    let ends = (1..layer_count(deepest_mm, bead_mm)?).map(|k| f64::from(k) * bead_mm);
    Ok(ends.filter(|mm| *mm > least_mm).collect())
}

/// The surfaces of the patches that are chosen.
fn worked(of: &PatchedPart, choice: &PatchChoice) -> Vec<SurfaceId> {
    let is_worked = |pieces: &[PatchSurface]| match choice {
        PatchChoice::All => true,
        PatchChoice::At(places) => places.iter().any(|place| {
            let closest = of.part.bvh.closest(&Point3::from(*place), f64::INFINITY);
            let at = closest.map(|c| of.surfaces.of_facet[c.facet as usize]);
            pieces.iter().any(|piece| at == Some(piece.surface.0))
        }),
    };
    of.patches.iter().filter(|pieces| is_worked(pieces)).flatten().map(|piece| piece.surface).collect()
}

impl From<LayersError> for ScanError {
    fn from(e: LayersError) -> ScanError {
        match e {
            LayersError::Cancelled => Cancelled.into(),
            LayersError::TooMany { count } => ScanError::BeadTooLow { layers: count },
            LayersError::NoHeight { .. } => ScanError::BeadTooLow { layers: f64::INFINITY },
        }
    }
}
