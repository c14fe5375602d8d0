//! Finds the motion that lays a scan on the model (P3 4.4's registration), and says how sure it is.
//!
//! Coarse from turns everywhere (`coarse`, no features: machined parts have none), fine by point to plane on the mesh
//! (`fine`), then without what is worn. What slides (`sliding`) and what fits as well (`rivals`) is told, never
//! chosen in silence. It does not say where scan or part stand in the robot's cell.

pub(super) mod coarse;
pub(super) mod field;
pub(super) mod fine;
pub(super) mod in_field;
mod measures;
pub(super) mod noise;
mod normals;
mod options;
mod outcome;
mod pairs;
#[cfg(test)]
mod parts_for_tests;
pub(super) mod plane_fit;
mod rivals;
mod samples;
mod search;
pub(super) mod sliding;
pub(super) mod starts;
pub(super) mod surface;
#[cfg(test)]
mod tests;
pub(super) mod thinned;

pub use normals::SurfaceNormals;
pub use options::{LeftOut, RegistrationOptions, Start};
pub use outcome::{Registration, RegistrationError, WithWorn};
pub use rivals::{Rival, TellingPatch};
pub use sliding::{Sliding, SlidingKind, SlidingMotion};

use super::Cloud;
use crate::part::Part;
use crate::part::bvh::closest_search::ClosestSearch;
use crate::part::topology::FacetDefect;
use crate::progress::Progress;
use crate::scan::TUKEY;
use nalgebra::{Isometry3, Point3};
use plane_fit::capped_rms_mm;
use search::Search;
use sliding::Held;
use surface::{Model, Row};

/// What a model is off the part that it was made for at the least, as a share of the diagonal: chords of its facets,
/// data without noise.
const MODEL_FLOOR: f64 = 1e-4;
/// Not the same part: points scatter by more than so many times the noise and this share of the diagonal, or fewer than
/// so many lie within 3 σ. Scans of the samples scatter by 0.7 to 1.1 of their noise on their own model, with an overlap
/// above 0.94, and by nearly a hundredth of the diagonal at the least on another's. A thousandth is what scanners, whose noise
/// is less than their error over the whole part, and cast parts need.
const MOST_SIGMA: f64 = 3.0;
const MOST_OFF: f64 = 1e-3;
const LEAST_OVERLAP: f64 = 0.6;
/// Points within so many standard deviations lie on the model.
const WITHIN_SIGMAS: f64 = 3.0;

/// Lays a scan (its frame, mm) on the model. `normals`: those of the part, within its feature surfaces.
///
/// The same input gives the same bytes, on any number of threads.
///
/// # Errors
/// [`RegistrationError`].
pub fn register(
    part: &Part,
    normals: &SurfaceNormals,
    cloud: &Cloud,
    options: &RegistrationOptions,
    progress: &Progress,
) -> Result<Registration, RegistrationError> {
    if !part.mesh.defects.contains(&FacetDefect::None) {
        return Err(RegistrationError::NoModel);
    }
    let closest = ClosestSearch::new(&part.bvh);
    let model = Model { part, search: &closest, normals, left_out: &options.left_out.facets, crease_mm: 0.0 };
    let search = Search::new(model, cloud, &options.left_out.points, progress)?;
    let (best, others) = search.ways(&options.start, progress)?;
    let fine = fine::end(&search.model, cloud, &search.thinned, &best, progress)?;
    let (fit, sigma_mm) = (&fine.fit, fine.sigma_mm);
    let floor_mm = MODEL_FLOOR * part.mesh.diagonal();
    let noise_mm = search.noise_mm;
    let within_mm = WITHIN_SIGMAS * sigma_mm.max(floor_mm);
    let overlap = measures::overlap(&fit.rows, within_mm);
    let limit_mm = (MOST_SIGMA * noise_mm).max(MOST_OFF * part.mesh.diagonal());
    if sigma_mm > limit_mm || overlap < LEAST_OVERLAP {
        return Err(RegistrationError::NotSamePart { sigma_mm, noise_mm, limit_mm, overlap });
    }
    let samples = samples::one_a_voxel(&part.mesh, search.thinned.cell_mm);
    progress.check()?;
    let firsts: Vec<Row> = fine.firsts().collect();
    let coverage = measures::coverage(&samples, &firsts, search.thinned.cell_mm);
    let held = Held::of(fit, sigma_mm);
    let cap_mm = TUKEY * sigma_mm.max(floor_mm);
    let rivals =
        search.rivals(&fine, &best, &others, &rivals::Alike { samples, held: &held, within_mm, cap_mm }, progress)?;
    let with_worn = fine.with_worn.map(|(model_from_scan, share)| {
        let moved_mm = most_moved_mm(part, &(model_from_scan * fit.model_from_scan.inverse()));
        WithWorn { model_from_scan, share, moved_mm }
    });
    Ok(Registration {
        model_from_scan: fit.model_from_scan,
        rms_mm: capped_rms_mm(&fit.rows, cap_mm),
        sigma_mm,
        noise_mm,
        overlap,
        coverage,
        iterations: fine.convergence_mm.len(),
        sliding: held.sliding,
        rivals,
        with_worn,
        convergence_mm: fine.convergence_mm,
    })
}

/// How far a motion moves that corner of the model's box that it moves most, mm.
pub fn most_moved_mm(part: &Part, motion: &Isometry3<f64>) -> f64 {
    let (lo, hi) = part.mesh.bounds();
    let corner = |i: usize| Point3::from([0, 1, 2].map(|k| if i >> k & 1 == 0 { lo[k] } else { hi[k] }));
    (0..8).map(|i| (motion * corner(i) - corner(i)).norm()).fold(0.0, f64::max)
}
