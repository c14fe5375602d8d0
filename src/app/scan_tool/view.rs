//! What is kept for the tool in the hand: the points of the scan, what a cut would keep of them, the facets that do not
//! count. How that becomes a picture is in `picture`.

use super::draft::{CutDraft, ScanTool};
use crate::document::model::ScanRegion;
use crate::part::{Hasher, Part};
use crate::picture::{ScanLook, ScanPicture};
use crate::planning::{Executor, Stage};
use crate::progress::Activity;
use crate::scan::Cloud;
use crate::scan::cleaning::{Cleaned, clean};
use crate::view::{Bounds, CloudItem};
use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use std::convert::Infallible;
use std::mem::Discriminant;
use std::sync::Arc;

/// Between model and scan side by side, as a share of the larger one's radius.
const GAP: f64 = 0.2;

/// What is shown for a tool, kept while it is in the hand.
#[derive(Default)]
pub(in super::super) struct ToolView {
    pub(super) scan: Option<ToolScan>,
    /// Where the scan lay last: it stays there while it is laid again.
    model_from_scan: Option<Isometry3<f64>>,
    /// Which points a cut would keep.
    preview: Stage<Vec<bool>, Infallible>,
    /// To the right of the view when the tool was taken, of length 1: there the scan stands beside the model, wherever it is
    /// looked at from afterwards.
    aside: Vector3<f64>,
    /// The tool that the camera was turned to.
    pub(super) fitted: Option<Discriminant<ScanTool>>,
    /// Whether that tool moved the scan, and the camera with it.
    pub(super) is_moved: bool,
    pub(super) left_out: LeftOutFacets,
}

/// Facets of the part that do not count when the scan is laid, and what tells them.
#[derive(Default)]
pub(super) struct LeftOutFacets {
    regions: Vec<ScanRegion>,
    part: Option<Arc<Part>>,
    facets: Arc<Vec<u32>>,
}

impl LeftOutFacets {
    pub fn sync(&mut self, part: &Arc<Part>, regions: Vec<ScanRegion>) {
        if self.regions == regions && self.part.as_ref().is_some_and(|known| Arc::ptr_eq(known, part)) {
            return;
        }
        let is_out = |f: &u32| regions.iter().any(|r| r.contains(&part.mesh.centroid(*f as usize)));
        let facets =
            if regions.is_empty() { Vec::new() } else { (0..part.mesh.facets.len() as u32).filter(is_out).collect() };
        *self = LeftOutFacets { facets: Arc::new(facets), part: Some(part.clone()), regions };
    }
}

/// The points as cleaning leaves them.
pub(super) struct ToolScan {
    of: Arc<Cleaned>,
    pub cloud: Arc<Cloud>,
    pub picture: ScanPicture,
    pub middle: Point3<f64>,
    pub item: CloudItem,
    /// What the item shows of a cut.
    kept: Option<Arc<Vec<bool>>>,
}

impl ToolScan {
    fn new(of: &Arc<Cleaned>) -> ToolScan {
        let cloud = Arc::new(of.cloud.clone());
        let picture = ScanPicture::new(cloud.clone(), cloud.digest().0 as u64);
        let place = Isometry3::identity();
        let middle = picture.bounds(&place).map_or_else(Point3::origin, |b| b.center());
        let item = picture.item(ScanLook::Own, &place);
        ToolScan { of: of.clone(), cloud, picture, middle, item, kept: None }
    }
}

impl ToolView {
    /// Whether nothing is being computed for it.
    pub fn is_at_rest(&self) -> bool {
        !self.preview.is_running()
    }

    /// How many points a cut would take out, of how many; `None` while that is not known.
    pub fn dropped(&self) -> Option<(usize, usize)> {
        let kept = self.preview.newest()?.1;
        Some((kept.iter().filter(|k| !**k).count(), kept.len()))
    }

    /// Facets of the part that do not count when the scan is laid, with what is being painted.
    pub fn left_out(&self) -> &Arc<Vec<u32>> {
        &self.left_out.facets
    }

    /// Forgets what is shown for a tool; the camera has still to be turned back.
    pub(super) fn lay_down(&mut self) {
        let ToolView { fitted, is_moved, left_out, .. } = std::mem::take(self);
        *self = ToolView { fitted, is_moved, left_out, ..ToolView::default() };
    }

    /// Makes what the tool needs.
    pub(super) fn sync(&mut self, tool: &ScanTool, context: &SyncedWith<'_>) {
        if self.aside == Vector3::zeros() {
            self.aside = context.right;
        }
        self.model_from_scan = context.model_from_scan.or(self.model_from_scan);
        match context.cleaned.filter(|_| tool.moves_scan()) {
            Some(cleaned) if self.scan.as_ref().is_none_or(|s| !Arc::ptr_eq(&s.of, cleaned)) => {
                self.scan = Some(ToolScan::new(cleaned));
                self.preview.clear();
            }
            _ => {}
        }
        if let ScanTool::Cut(draft) = tool {
            self.sync_preview(draft, context);
        }
    }

    fn sync_preview(&mut self, draft: &CutDraft, context: &SyncedWith<'_>) {
        self.preview.poll();
        let Some(scan) = &mut self.scan else { return };
        let step = draft.step();
        let key = Hasher::default().of(&step).finish();
        if self.preview.lacks(key) {
            let cloud = scan.cloud.clone();
            self.preview.start(key, Activity::CleaningScan, context.executor, move |progress| {
                let mut kept = vec![false; cloud.len()];
                for i in clean(&cloud, &[step], progress)?.source {
                    kept[i as usize] = true;
                }
                Ok(kept)
            });
        }
        let newest = self.preview.newest().map(|(_, kept)| kept.clone());
        if let Some(kept) = newest.filter(|new| scan.kept.as_ref().is_none_or(|old| !Arc::ptr_eq(old, new))) {
            let look = ScanLook::Cleaned { kept: &kept, shows_dropped: true };
            scan.item = scan.picture.item(look, &Isometry3::identity());
            scan.kept = Some(kept);
        }
    }

    /// Where the scan stands for a tool, in the scene: on the part, or beside it.
    pub(super) fn scene_from_scan(
        &self,
        tool: &ScanTool,
        part: &Bounds,
        place: Isometry3<f64>,
    ) -> Option<Isometry3<f64>> {
        let scan = self.scan.as_ref()?;
        let onto_middle = || Isometry3::from(Translation3::from(part.center() - scan.middle));
        let on_part = self.model_from_scan.unwrap_or_else(onto_middle);
        if !matches!(tool, ScanTool::Pairs(_)) {
            return Some(place * on_part);
        }
        let turned = scan.picture.bounds(&on_part)?;
        let half_mm = |bounds: &Bounds| bounds.half_size().dot(&self.aside.abs());
        let gap_mm = GAP * part.radius_mm().max(turned.radius_mm());
        let way = part.center() - turned.center() + self.aside * (half_mm(part) + half_mm(&turned) + gap_mm);
        Some(place * Translation3::from(way) * on_part)
    }
}

/// What a tool's picture is made from.
pub(super) struct SyncedWith<'a> {
    pub cleaned: Option<&'a Arc<Cleaned>>,
    pub model_from_scan: Option<Isometry3<f64>>,
    /// To the right of the view now.
    pub right: Vector3<f64>,
    pub executor: &'a dyn Executor,
}
