//! From the points of an image and a mask to the bead under it.

use super::feet::{feet, height_raster, is_in};
use super::model::{AreaKind, WeldBead, WeldBeadError};
use super::traced::{AROUND_MM, Traced};
use super::{outline, rough};
use crate::weld::camera::DepthCamera;
use crate::weld::parent::{ParentError, ParentSurface, mm_per_px};
use crate::weld::pixel_distance::dilated;
use crate::weld::points::PixelPoint;
use crate::weld::raster::Mask;
use nalgebra::{Point3, Vector2};

// What the grey mask may be off, px, when the parent is first fitted; and what the outline may be.
const MARGIN_PX: f64 = 7.0;
pub(super) const OUTLINED_MARGIN_PX: f64 = 2.0;

/// An area of a mask, with the metal around it as far as the mask tells where that is.
#[derive(Clone, Debug)]
pub struct SeenArea<'a> {
    points: &'a [PixelPoint],
    area: &'a Mask,
    covered: &'a Mask,
    /// That metal's surface.
    pub parent: ParentSurface,
}

impl<'a> SeenArea<'a> {
    /// `points`: all of the depth image, row by row; `covered`: all masked areas, none of which counts as parent.
    ///
    /// # Errors
    /// It has no parent surface.
    pub fn new(points: &'a [PixelPoint], area: &'a Mask, covered: &'a Mask) -> Result<SeenArea<'a>, ParentError> {
        let parent = ParentSurface::fit(points, area, covered, MARGIN_PX)?;
        Ok(SeenArea { points, area, covered, parent })
    }

    /// Whether it stands above the metal around it.
    pub fn kind(&self) -> AreaKind {
        let inside: Vec<&PixelPoint> = self.points.iter().filter(|p| is_in(self.area, p)).collect();
        let medians = rough::medians(&height_raster(self.area, &feet(&self.parent, &inside)));
        let all = medians.values.iter().filter(|h| h.is_finite());
        let threshold = rough::threshold_mm(self.parent.noise_mm);
        let (above, count) = all.fold((0, 0), |(a, n), h| (a + usize::from(f64::from(*h) > threshold), n + 1));
        // A mask of a bead has a rim of bare metal: half of its pixels would be too much to ask.
        if 4 * above > count { AreaKind::Bead } else { AreaKind::Flat }
    }

    /// Measures the bead under it.
    ///
    /// # Errors
    /// There is no bead there, or not all of it.
    pub fn measure(&self, camera: &DepthCamera) -> Result<WeldBead, WeldBeadError> {
        let SeenArea { points, area, covered, parent: first } = self;
        let around_px = AROUND_MM / mm_per_px(points).ok_or(ParentError::NothingCovered)?;
        let around = dilated(area, around_px);
        let near: Vec<&PixelPoint> = points.iter().filter(|p| is_in(&around, p)).collect();
        let found = feet(first, &near);
        let threshold_mm = rough::threshold_mm(first.noise_mm);
        let standing = rough::standing_area(&rough::medians(&height_raster(area, &found)), area, threshold_mm)
            .ok_or(WeldBeadError::NothingStands { threshold_mm })?;
        // Medians reach to the rim, however few points they have there.
        if outline::touches_rim(&standing) {
            return Err(WeldBeadError::LeavesImage);
        }
        let on_surface = |[u, v]: &[usize; 2]| {
            let ray = camera.ray(*u as f64, *v as f64)?;
            let depth = first.camera_from_local.translation.vector.z / ray.z;
            let foot = first.foot(&Point3::from(ray * depth));
            foot.is_converged.then_some(Vector2::from(foot.local))
        };
        let way: Vec<Vector2<f64>> = rough::way_along(&standing).iter().filter_map(on_surface).collect();
        let rough = Traced::along(first, &way, &found)?;
        let outlined = rough.outline(camera, area);
        // The other areas stay covered; of this one the outline knows better than its mask.
        let mut no_parent = outlined.clone();
        for ((into, on), of_this) in no_parent.values.iter_mut().zip(&covered.values).zip(&area.values) {
            *into |= *on && !*of_this;
        }
        let parent = ParentSurface::fit(points, &outlined, &no_parent, OUTLINED_MARGIN_PX)?;
        let found = feet(&parent, &near);
        let way: Vec<Vector2<f64>> = rough.stations.iter().map(|s| s.local).collect();
        let traced = Traced::along(&parent, &way, &found)?;
        let outline = traced.outline(camera, area);
        if outline::touches_rim(&outline) {
            return Err(WeldBeadError::LeavesImage);
        }
        Ok(traced.bead(parent, outline, &found))
    }
}
