//! The points of a scan as lines can be laid through them: those that lie on the model, with normals of their own that
//! point to the model's outside.

use super::{ComparedScan, LaidScan};
use crate::part::Part;
use crate::part::measured::MeasuredPoints;
use crate::progress::{Cancelled, Progress};
use crate::scan::deviation::Footing;
use crate::scan::neighbours::Neighbours;
use crate::scan::normals::fitted_normals;
use nalgebra::Vector3;

/// Neighbours that a normal is fitted to: as many as the noise of a scan is told from.
const NEIGHBOURS: usize = 20;

/// The points that lie on the model, in the part frame.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub(super) fn measured(
    part: &Part,
    laid: &LaidScan,
    compared: &ComparedScan,
    progress: &Progress,
) -> Result<MeasuredPoints, Cancelled> {
    let off = &compared.deviation;
    let is_on = |i: &u32| off.footing[*i as usize] == Footing::OnModel;
    let on: Vec<u32> = (0..off.footing.len() as u32).filter(is_on).collect();
    let cloud = laid.cloud_in_part.picked(&on);
    let neighbours = Neighbours::new(&cloud, progress)?;
    let mut normals = fitted_normals(&cloud, &neighbours, NEIGHBOURS, progress)?;
    for (normal, i) in normals.iter_mut().zip(&on) {
        let outward = part.mesh.normals[off.facet[*i as usize] as usize];
        if Vector3::from(normal.map(f64::from)).dot(&outward) < 0.0 {
            *normal = normal.map(|c| -c);
        }
    }
    Ok(MeasuredPoints::new(cloud.origin, cloud.offsets, normals))
}
