//! The model that a scan is compared with: the part, or, where the job names damage, the part without it: its own sound
//! regions are continued across (P3's third case).

use super::ScanError;
use crate::document::model::{ContinuedDamage, ContinuedKind, JobScan};
use crate::document::{Job, segmented};
use crate::part::reshaped::reshaped;
use crate::part::{Part, Surfaces, angle};
use crate::progress::Progress;
use crate::scan::continuation::{
    ContinuationError, ContinuedSurface, DamagedRegion, PointState, SurfaceKind, continued,
};
use nalgebra::{Point3, Vector3};
use std::sync::Arc;

/// Noise of a part that was not meshed from a scan, as a share of its diagonal: what is left of rounding.
const ROUNDING: f64 = 1e-6;

/// What the scan is compared with.
#[derive(Clone, Debug, Default)]
pub struct ScanModel {
    /// The part, without what the job names as damage.
    pub part: Arc<Part>,
    /// Its surfaces.
    pub surfaces: Arc<Surfaces>,
    /// What was continued, in the order of the job.
    pub continued: Vec<ContinuedFigures>,
}

/// What was found of a surface that goes on across a damage. Lengths mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContinuedFigures {
    /// Which kind it is.
    pub by: ContinuedKind,
    /// Root of the mean square of the sound points' distances to it.
    pub rms_mm: f64,
    /// How wide the damage is.
    pub gap_mm: f64,
    /// Standard deviation of the surface where it is least sure.
    pub spread_mm: f64,
}

/// Makes the model.
///
/// # Errors
/// What is called sound tells no such surface, or the work was cancelled.
pub(super) fn model(
    part: &Arc<Part>,
    surfaces: &Arc<Surfaces>,
    job: &Job,
    progress: &Progress,
) -> Result<ScanModel, ScanError> {
    let JobScan { continued: damage, .. } = &job.scan;
    let mut model = ScanModel { part: part.clone(), surfaces: surfaces.clone(), continued: Vec::new() };
    for (number, one) in damage.iter().enumerate() {
        let (vertices, surface) =
            without(&model.part, one, progress).map_err(|source| ScanError::Continued { number, source })?;
        model.part = Arc::new(reshaped(&model.part, vertices, progress)?);
        let ContinuedSurface { rms_mm, gap_mm, spread_mm, .. } = surface;
        model.continued.push(ContinuedFigures { by: one.by, rms_mm, gap_mm, spread_mm });
    }
    if !damage.is_empty() {
        // Where the damage was there are no creases now.
        model.surfaces = Arc::new(segmented(&model.part, job));
    }
    Ok(model)
}

/// The places of a part's vertices without a damage, and the surface that goes on across it.
fn without(
    part: &Part,
    damage: &ContinuedDamage,
    progress: &Progress,
) -> Result<(Vec<Point3<f64>>, ContinuedSurface), ContinuationError> {
    let mesh = &part.mesh;
    let state = |p: &Point3<f64>| {
        if damage.damaged.iter().any(|r| r.contains(p)) {
            PointState::Damaged
        } else if damage.sound.iter().any(|r| r.contains(p)) {
            PointState::Sound
        } else {
            PointState::Other
        }
    };
    let state: Vec<PointState> = mesh.vertices.iter().map(state).collect();
    let normal = |v: u32| {
        let sum = mesh.vertex_facets(v).iter().map(|&f| mesh.normals[f as usize] * mesh.areas[f as usize]);
        angle::unit(sum.fold(Vector3::zeros(), |a, b| a + b)).unwrap_or_else(Vector3::z)
    };
    let normals: Vec<Vector3<f64>> = (0..mesh.vertices.len() as u32).map(normal).collect();
    let noise_mm = part.figures.meshed.map_or(0.0, |m| m.rms).max(ROUNDING * mesh.diagonal());
    let region = DamagedRegion { points: &mesh.vertices, normals: &normals, state: &state, noise_mm };
    let surface = continued(&region, kind(damage.by), progress)?;
    let vertices = surface.repaired(&region, progress)?;
    Ok((vertices, surface))
}

fn kind(of: ContinuedKind) -> SurfaceKind {
    match of {
        ContinuedKind::Plane => SurfaceKind::Plane,
        ContinuedKind::Cylinder => SurfaceKind::Cylinder,
        ContinuedKind::Revolved => SurfaceKind::Revolved,
        ContinuedKind::Extruded => SurfaceKind::Extruded,
        ContinuedKind::Smooth => SurfaceKind::Smooth,
    }
}
