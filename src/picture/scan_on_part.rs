//! A scan that was compared with its part, as window and `render` show it: the same scale, and the same distances. Which
//! colours a scale has is said in `deviation`.

use super::deviation::{DepthMesh, DeviationScale, model_item};
use super::scan::{ScanLook, ScanPicture};
use crate::document::model::JobScan;
use crate::part::Part;
use crate::planning::scanned::{ComparedScan, LaidScan};
use crate::view::{CloudItem, MeshItem};
use nalgebra::Isometry3;

/// The scale of a scan: it ends at the farthest patch.
pub fn deviation_scale(compared: &ComparedScan, scan: &JobScan) -> DeviationScale {
    let farthest_mm = compared.patches.patches.iter().map(|p| p.depth_mm).fold(0.0, f64::max);
    DeviationScale::of_patches(scan.min_depth_mm, scan.tolerance_mm, farthest_mm)
}

/// Its points in the part frame, coloured by how far they are off the part: smoothed, as single points show the noise
/// of the scanner.
pub fn deviation_points(laid: &LaidScan, compared: &ComparedScan, scale: DeviationScale) -> CloudItem {
    let cloud = laid.cloud_in_part.clone();
    let key = cloud.digest().0 as u64;
    let look = ScanLook::Deviation { deviation_mm: &compared.smoothed_mm(), scale };
    ScanPicture::new(cloud, key).item(look, &Isometry3::identity())
}

/// The model in the colours of the scale: where a patch may be as fine as the scan resolves, elsewhere facet by facet.
pub fn deviation_on_model(part: &Part, compared: &ComparedScan, scale: &DeviationScale) -> MeshItem {
    let mut sums = vec![(0.0, 0u32); part.mesh.facets.len()];
    for (&facet, &depth_mm) in compared.deviation.facet.iter().zip(&compared.depth_mm) {
        if let Some((sum, count)) = sums.get_mut(facet as usize).filter(|_| depth_mm.is_finite()) {
            *sum += f64::from(depth_mm);
            *count += 1;
        }
    }
    // Nought of nought is no number: nothing was scanned there.
    let mean: Vec<f64> = sums.into_iter().map(|(sum, count)| sum / f64::from(count)).collect();
    let field = &compared.patches.field;
    let fine = DepthMesh {
        vertices: &field.vertices,
        triangles: &field.triangles,
        parent: &field.parent,
        depth_mm: &field.depth_mm,
    };
    model_item(&part.mesh, fine, &mean, scale)
}
