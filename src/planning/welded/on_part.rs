//! Where the camera's points lie on the part. Without a model the part is the skin that the images show, in the camera's
//! frame; else they are laid on it as a scan is, from anywhere, without what stands on it.

use super::{HeldReason, MeasuredWeld, ReadWeld, WeldError};
use crate::document::Job;
use crate::document::segmented;
use crate::part::raw_part::RawPart;
use crate::part::{Part, Placement, Source, Surfaces, Units, Weld};
use crate::progress::Progress;
use crate::scan::Cloud;
use crate::scan::registration::{Registration, RegistrationOptions, SlidingKind, SurfaceNormals, register};
use crate::weld::points::points;
use crate::weld::skin::{AreaOnParent, skin};
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// The part that a weld is on.
#[derive(Clone, Debug)]
pub struct WeldPart {
    /// The part, without its weld.
    pub part: Arc<Part>,
    /// Its surfaces.
    pub surfaces: Arc<Surfaces>,
    /// From the camera's frame to the part's.
    pub part_from_camera: Isometry3<f64>,
    /// How that was found; `None`: the part is what the camera sees.
    pub registration: Option<Registration>,
}

impl WeldPart {
    /// How far the part may lie off, mm: what the registration leaves open.
    pub fn slack_mm(&self) -> f64 {
        self.registration.as_ref().map_or(0.0, Registration::slack_mm)
    }

    /// Why nobody knows where on the part the areas are, unless he knows where the camera stood.
    pub(super) fn open_place(&self) -> Option<HeldReason> {
        let found = self.registration.as_ref()?;
        let slides = found.sliding.iter().any(|s| s.kind == SlidingKind::Slides);
        let is_anywhere = slides || !found.rivals.is_empty();
        let slack_mm = (!is_anywhere).then(|| found.slack_mm());
        slack_mm.is_none_or(|mm| mm > PLACED_MM).then_some(HeldReason::Place { slack_mm })
    }
}

/// As far as a camera may be off that ten poses calibrate, nine times of ten (see the tests of `cell::hand_eye`), mm: images
/// that lie on the part to that are as good as those of a camera whose place is known.
const PLACED_MM: f64 = 1.6;

/// So many points are enough to lay them on a part.
const LAID_POINTS: usize = 60_000;

/// The part of a weld. `model`: the job's part and surfaces; it is left aside where the job's part is its depth image.
///
/// # Errors
/// The camera's points do not lie on the model, or the work was cancelled.
pub fn weld_part(
    read: &ReadWeld,
    measured: &MeasuredWeld,
    (part, surfaces): (&Arc<Part>, &Arc<Surfaces>),
    job: &Job,
    progress: &Progress,
) -> Result<WeldPart, WeldError> {
    if job.is_on_depth_image() {
        return skin_part(read, measured, job, progress);
    }
    let mut sound = points(&read.depth, &read.camera, None);
    let bare = |[u, v]: [u32; 2]| {
        let on = |area: &super::MeasuredArea| area.outline.at(u as usize, v as usize) == Some(&true);
        !measured.areas.iter().any(|area| area.bead.is_some() && on(area))
    };
    sound.retain(|p| bare(p.pixel));
    let step = sound.len().div_ceil(LAID_POINTS).max(1);
    let places: Vec<Point3<f64>> = sound.iter().step_by(step).map(|p| p.point).collect();
    let normals = SurfaceNormals::new(&part.mesh, &surfaces.of_facet);
    let found = register(part, &normals, &Cloud::of_points(&places), &RegistrationOptions::default(), progress);
    let found = found.map_err(WeldError::Registration)?;
    Ok(WeldPart {
        part: part.clone(),
        surfaces: surfaces.clone(),
        part_from_camera: found.model_from_scan,
        registration: Some(found),
    })
}

/// The skin around all areas as the part.
fn skin_part(read: &ReadWeld, measured: &MeasuredWeld, job: &Job, progress: &Progress) -> Result<WeldPart, WeldError> {
    let areas: Vec<AreaOnParent<'_>> =
        measured.areas.iter().map(|area| AreaOnParent { outline: &area.outline, parent: &area.parent }).collect();
    let raw = RawPart { facets: skin(&read.camera, &areas), solids: 1, ..RawPart::default() };
    let source = Source { raw, sha256: job.part.sha256.clone() };
    let made = source.part(Units::Mm, Weld::Exact, &Placement::default(), &[], progress);
    let part = made.map_err(|_| WeldError::NoSkin)?.ok_or(WeldError::Cancelled)?;
    let surfaces = segmented(&part, job);
    Ok(WeldPart {
        part: Arc::new(part),
        surfaces: Arc::new(surfaces),
        part_from_camera: Isometry3::identity(),
        registration: None,
    })
}
