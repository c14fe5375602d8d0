//! Fingerprints of shells: area, centroid and volume.

use super::file_frame::{FileFrame, LoadedAs};
use super::fingerprint::{Fingerprint, FormWord, Landmark};
use crate::part::Part;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

/// All shells of a part in the order of their numbers, as they were before any was flipped.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn shells(part: &Part, loaded: &LoadedAs, progress: &Progress) -> Result<Vec<Landmark>, Cancelled> {
    let (frame, mesh) = (FileFrame::new(loaded), &part.mesh);
    let mut facets: Vec<Vec<usize>> = vec![Vec::new(); part.orientation.shells];
    for (f, &shell) in part.orientation.shell_of.iter().enumerate() {
        if let Some(list) = (shell as usize).checked_sub(1).and_then(|i| facets.get_mut(i)) {
            list.push(f);
        }
    }
    let numbered = (1u32..).zip(&facets);
    numbered
        .map(|(number, facets)| {
            progress.check()?;
            let area: f64 = facets.iter().map(|&f| mesh.areas[f]).sum();
            let over = if area > 0.0 { area } else { 1.0 };
            let moment: Vector3<f64> = facets.iter().map(|&f| mesh.centroid(f).coords * mesh.areas[f]).sum();
            let centroid = Point3::from(moment / over);
            // About the centroid: so that an open sheet has one volume too, wherever it begins.
            let volume: f64 = facets
                .iter()
                .map(|&f| {
                    let [a, b, c] = mesh.corners(f).map(|p| p - centroid);
                    a.dot(&b.cross(&c)) / 6.0
                })
                .sum();
            let edge = libm::cbrt(if loaded.flipped_shells.contains(&number) { -volume } else { volume });
            let print = Fingerprint {
                area: frame.area(area),
                centroid: frame.point(&centroid),
                mean_normal: Vector3::zeros(),
                form: FormWord::Shell,
                size: frame.length(edge),
                neighbours: 0,
                neighbour_area: 0.0,
            };
            Ok(Landmark { number, print })
        })
        .collect()
}
