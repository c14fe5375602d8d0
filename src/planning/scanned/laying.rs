//! A cleaned scan is laid on the part: by the job's own transform, from the pairs that the operator picked, or from
//! anywhere.

use super::continuing::model;
use super::{ScanError, ScanModel};
use crate::document::Job;
use crate::document::model::JobScan;
use crate::fit::PlacedPair;
use crate::part::{Part, Surfaces};
use crate::progress::Progress;
use crate::scan::Cloud;
use crate::scan::file::unit_doubt;
use crate::scan::registration::{LeftOut, Registration, RegistrationOptions, Start, SurfaceNormals, register};
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// A scan on its part.
#[derive(Clone, Debug)]
pub struct LaidScan {
    /// From the scan's frame to the part's.
    pub model_from_scan: Isometry3<f64>,
    /// How it was found; `None` where the job gives it.
    pub registration: Option<Registration>,
    /// The points in the part frame.
    pub cloud_in_part: Arc<Cloud>,
    /// What they were laid on.
    pub model: ScanModel,
}

impl LaidScan {
    /// How far the part may lie off, mm: what the registration leaves open, 0 where the job tells where the scan lies.
    pub fn slack_mm(&self) -> f64 {
        self.registration.as_ref().map_or(0.0, Registration::slack_mm)
    }
}

/// Lays a scan on a part.
///
/// # Errors
/// Scan and part are in different units, or the scan lies nowhere.
pub fn lay(
    part: &Arc<Part>,
    surfaces: &Arc<Surfaces>,
    cloud: &Cloud,
    job: &Job,
    progress: &Progress,
) -> Result<LaidScan, ScanError> {
    let scan = &job.scan;
    let model = model(part, surfaces, job, progress)?;
    let (part, surfaces) = (&*model.part, &*model.surfaces);
    let diagonals_mm = [cloud.diagonal(), part.mesh.diagonal()];
    if let Some(doubt) = unit_doubt(diagonals_mm, [scan.units, part.figures.units]) {
        return Err(ScanError::Units { doubt, diagonals_mm });
    }
    let given = scan.model_from_scan().map_err(ScanError::Matrix)?;
    let (model_from_scan, registration) = match given {
        Some(model_from_scan) => (model_from_scan, None),
        None => {
            let normals = SurfaceNormals::new(&part.mesh, &surfaces.of_facet);
            let found = register(part, &normals, cloud, &options(part, scan), progress);
            let found = found.map_err(ScanError::Registration)?;
            (found.model_from_scan, Some(found))
        }
    };
    let cloud_in_part = Arc::new(cloud.clone().moved(&model_from_scan));
    Ok(LaidScan { model_from_scan, registration, cloud_in_part, model })
}

fn options(part: &Part, scan: &JobScan) -> RegistrationOptions {
    let pair = |p: &crate::document::model::PickedPair| PlacedPair {
        from: Point3::from(p.scan_mm),
        onto: Point3::from(p.model_mm),
        weight: 1.0,
    };
    let start =
        if scan.pairs.is_empty() { Start::Anywhere } else { Start::Pairs(scan.pairs.iter().map(pair).collect()) };
    let is_left_out = |f: usize| scan.left_out.iter().any(|region| region.contains(&part.mesh.centroid(f)));
    let facets = match scan.left_out.is_empty() {
        true => Vec::new(),
        false => (0..part.mesh.facets.len()).map(is_left_out).collect(),
    };
    RegistrationOptions { start, left_out: LeftOut { points: Vec::new(), facets } }
}
