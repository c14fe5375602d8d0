//! Several scans of one part in one frame: by markers that are seen in more than one ([`by_markers`]), or by the area that
//! they share ([`by_overlap`]). What lays a scan on a model is registration.

mod cloud_surface;
mod markers;
mod overlap;
mod overlap_fit;
mod sampled;
#[cfg(test)]
mod tests;

pub use markers::{Marker, MarkerError, MarkerFit, by_markers};
pub use overlap::by_overlap;
pub use overlap_fit::{OverlapError, OverlapFit, OverlapStart};

use super::cloud::Cloud;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Vector3};

/// One cloud of several, each brought into the common frame, one after the other. Normals, colours and intensities are
/// kept where all clouds with points have them.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn merged(scans: &[(&Cloud, Isometry3<f64>)], progress: &Progress) -> Result<Cloud, Cancelled> {
    let scans: Vec<_> = scans.iter().filter(|(cloud, _)| !cloud.is_empty()).collect();
    let Some((first, common_from_first)) = scans.first() else { return Ok(Cloud::default()) };
    let origin = common_from_first * first.origin;
    let single = |v: Vector3<f64>| [v.x as f32, v.y as f32, v.z as f32];
    let mut whole = Cloud {
        origin,
        normals: scans.iter().all(|(c, _)| c.normals.is_some()).then(Vec::new),
        colours: scans.iter().all(|(c, _)| c.colours.is_some()).then(Vec::new),
        intensities: scans.iter().all(|(c, _)| c.intensities.is_some()).then(Vec::new),
        ..Cloud::default()
    };
    for (cloud, common_from_scan) in scans {
        for i in 0..cloud.len() {
            if i % 65_536 == 0 {
                progress.check()?;
            }
            whole.offsets.push(single(common_from_scan * cloud.point(i) - origin));
            if let Some((normals, normal)) = whole.normals.as_mut().zip(cloud.normal(i)) {
                normals.push(single(common_from_scan * normal));
            }
        }
        if let Some((all, colours)) = whole.colours.as_mut().zip(cloud.colours.as_ref()) {
            all.extend_from_slice(colours);
        }
        if let Some((all, intensities)) = whole.intensities.as_mut().zip(cloud.intensities.as_ref()) {
            all.extend_from_slice(intensities);
        }
    }
    Ok(whole)
}
