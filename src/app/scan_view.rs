//! The points of the scan as the view shows them: those on the part by how far they are off it, and those that cleaning
//! took out. Made once for each state of the scan, when they are asked for, and only where it lies on the part.

use crate::picture::{DeviationScale, ScanLook, ScanPicture};
use crate::planning::scanned::{ComparedScan, ReadScan, Scanned};
use crate::scan::cleaning::Cleaned;
use crate::scan::deviation::Patch;
use crate::view::CloudItem;
use nalgebra::Isometry3;
use std::sync::Arc;

/// What is shown of a scan, kept while it stays.
#[derive(Default)]
pub(super) struct ScanView {
    points: Option<Points>,
    dropped: Option<Dropped>,
}

/// Points on the part, and what they were made from.
struct Points {
    of: Arc<ComparedScan>,
    scale: DeviationScale,
    item: CloudItem,
}

/// Points that cleaning took out, and what they were made from.
struct Dropped {
    of: Arc<Cleaned>,
    scene_from_scan: Isometry3<f64>,
    item: CloudItem,
}

impl ScanView {
    /// Makes what is not there; what no longer is goes.
    pub fn sync(&mut self, scanned: Option<&Scanned>, tolerance_mm: f64, with_dropped: bool) {
        let laid = scanned.and_then(|s| Some((s, s.laid.as_ref()?)));
        let Some((scanned, laid)) = laid else {
            // Of a scan that is looked at again the points stay until the new ones are there.
            if scanned.is_none() {
                *self = ScanView::default();
            }
            return;
        };
        if let Some(compared) = &scanned.compared {
            let scale = scale(&compared.patches.patches, tolerance_mm);
            let is_known = |p: &Points| Arc::ptr_eq(&p.of, compared) && p.scale == scale;
            if !self.points.as_ref().is_some_and(is_known) {
                let cloud = laid.cloud_in_part.clone();
                let key = cloud.digest().0 as u64;
                let look = ScanLook::Deviation { deviation_mm: &compared.deviation.signed_mm, scale };
                let item = ScanPicture::new(cloud, key).item(look, &Isometry3::identity());
                self.points = Some(Points { of: compared.clone(), scale, item });
            }
        }
        let Some(cleaned) = scanned.cleaned.as_ref().filter(|_| with_dropped) else {
            self.dropped = None;
            return;
        };
        let place = laid.model_from_scan;
        if !self.dropped.as_ref().is_some_and(|d| Arc::ptr_eq(&d.of, cleaned) && d.scene_from_scan == place) {
            let item = dropped(&scanned.read, cleaned, &place);
            self.dropped = Some(Dropped { of: cleaned.clone(), scene_from_scan: place, item });
        }
    }

    /// The scale of the points that are shown.
    pub fn scale(&self) -> Option<DeviationScale> {
        self.points.as_ref().map(|p| p.scale)
    }

    /// Points on the part and points that were taken out, each if it is wanted, on a part that stands there.
    pub fn items(&self, [points, dropped]: [bool; 2], place: &Isometry3<f64>) -> Vec<CloudItem> {
        let points = self.points.as_ref().filter(|_| points).map(|p| &p.item);
        let dropped = self.dropped.as_ref().filter(|_| dropped).map(|d| &d.item);
        let placed = |item: &CloudItem| CloudItem { scene_from_item: place * item.scene_from_item, ..item.clone() };
        points.into_iter().chain(dropped).map(placed).collect()
    }
}

/// The scale goes as far as the farthest patch, and so far beyond the tolerance that its colours are seen.
fn scale(patches: &[Patch], tolerance_mm: f64) -> DeviationScale {
    let farthest_mm = patches.iter().map(|p| p.depth_mm).fold(0.0, f64::max);
    // Rounded up to hundredths, so that the numbers on it are short.
    let limit_mm = (farthest_mm * 100.0 - 1e-9).ceil() * 0.01;
    DeviationScale::new(limit_mm.max(2.0 * tolerance_mm), tolerance_mm)
}

fn dropped(read: &ReadScan, cleaned: &Cleaned, place: &Isometry3<f64>) -> CloudItem {
    let mut is_kept = vec![false; read.cloud.len()];
    for &i in &cleaned.source {
        if let Some(kept) = is_kept.get_mut(i as usize) {
            *kept = true;
        }
    }
    let gone: Vec<u32> = (0u32..).zip(&is_kept).filter(|(_, kept)| !**kept).map(|(i, _)| i).collect();
    let cloud = Arc::new(read.cloud.picked(&gone));
    let (key, kept) = (cloud.digest().0 as u64, vec![false; gone.len()]);
    ScanPicture::new(cloud, key).item(ScanLook::Cleaned { kept: &kept, shows_dropped: true }, place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_shows_the_farthest_patch_and_colours_beyond_the_tolerance() {
        use crate::scan::deviation::PatchKind;
        use nalgebra::Point3;
        let patch = |depth_mm: f64| Patch {
            kind: PatchKind::Missing,
            area_mm2: 1.0,
            depth_mm,
            deepest_at: Point3::origin(),
            volume_mm3: 1.0,
            centre: Point3::origin(),
            facets: Vec::new(),
            triangles: Vec::new(),
            outlines: Vec::new(),
        };
        let limit = |patches: &[Patch], tolerance_mm| scale(patches, tolerance_mm).limit_mm();
        assert!((limit(&[patch(0.302), patch(0.1)], 0.1) - 0.31).abs() < 1e-12);
        assert!((limit(&[patch(0.2)], 0.05) - 0.2).abs() < 1e-12, "what is short already stays");
        assert_eq!(limit(&[patch(0.02)], 0.1), 0.2);
        assert_eq!(limit(&[], 0.1), 0.2);
    }
}
