//! What the view shows of a scan that lies on its part: its points or the model itself by how far they are off one another,
//! the outlines of patches, and the points that cleaning took out. Made once for each state of the scan, when it is asked
//! for.

use crate::document::model::JobScan;
use crate::part::Part;
use crate::picture::patches::{PatchOutline, outlines};
use crate::picture::{DeviationScale, ScanLook, ScanPicture, deviation_on_model, deviation_points, deviation_scale};
use crate::planning::scanned::{ComparedScan, LaidScan, ReadScan, Scanned, WornPart};
use crate::scan::cleaning::Cleaned;
use crate::view::{Camera, CloudItem, LineItem, MeshItem, ViewSize, cloud_point_at};
use nalgebra::{Isometry3, Point2, Point3};
use std::sync::Arc;

/// How near to a point a click has to be, pixels.
const REACH_PX: f64 = 8.0;

/// What is shown of a scan, kept while it stays.
#[derive(Default)]
pub(super) struct ScanView {
    compared: Option<ComparedView>,
    dropped: Option<Dropped>,
    /// Outlines of the layers that fill patches, and the part that they are of.
    layers: Option<(Arc<WornPart>, Vec<LineItem>)>,
}

/// How far a point of the scan is off the model, as it was asked for by a click.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanLabel {
    /// The point, part frame, mm.
    pub at: Point3<f64>,
    /// How far it is off, smoothed over its neighbours, mm; above 0: too much material.
    pub off_mm: f64,
}

/// A scan that was compared, and what is shown of it.
struct ComparedView {
    of: Arc<ComparedScan>,
    laid: Arc<LaidScan>,
    scale: DeviationScale,
    points: CloudItem,
    /// The model in the colours of the scale; made when it is asked for.
    model: Option<MeshItem>,
    outlines: Vec<LineItem>,
}

/// Points that cleaning took out, and what they were made from.
struct Dropped {
    of: Arc<Cleaned>,
    scene_from_scan: Isometry3<f64>,
    item: CloudItem,
}

/// What is asked for besides the points.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ScanWanted {
    /// Points that cleaning took out.
    pub dropped: bool,
    /// The model by its deviation.
    pub model: bool,
}

impl ScanView {
    /// Makes what is not there; what no longer is goes. Whether the points are others. `part`: as its file has it.
    pub fn sync(&mut self, scanned: Option<&Scanned>, scan: &JobScan, part: Option<&Part>, wanted: ScanWanted) -> bool {
        let laid = scanned.and_then(|s| Some((s, s.laid.as_ref()?)));
        let Some((scanned, laid)) = laid else {
            // Of a scan that is looked at again the points stay until the new ones are there.
            if scanned.is_none() {
                *self = ScanView::default();
            }
            return false;
        };
        let mut is_new = false;
        if let Some(compared) = &scanned.compared {
            let scale = deviation_scale(compared, scan);
            let is_known = |v: &ComparedView| Arc::ptr_eq(&v.of, compared) && v.scale == scale;
            if !self.compared.as_ref().is_some_and(is_known) {
                self.compared = Some(ComparedView::new(compared, laid, scale));
                is_new = true;
            }
        }
        if let (Some(view), Some(part)) = (self.compared.as_mut().filter(|v| wanted.model && v.model.is_none()), part) {
            view.model = Some(deviation_on_model(part, &view.of, &view.scale));
        }
        self.sync_layers(scanned.worn.as_ref());
        self.sync_dropped(scanned, laid.model_from_scan, wanted.dropped);
        is_new
    }

    fn sync_layers(&mut self, worn: Option<&Arc<WornPart>>) {
        let is_known = |worn: &Arc<WornPart>| self.layers.as_ref().is_some_and(|(of, _)| Arc::ptr_eq(of, worn));
        match worn {
            None => self.layers = None,
            Some(worn) if is_known(worn) => {}
            Some(worn) => {
                // The first one ends at the outline of its patch.
                let above = worn.layers.iter().flat_map(|layers| layers.iter().skip(1));
                self.layers = Some((worn.clone(), closed_outlines(above.flat_map(|layer| &layer.outlines))));
            }
        }
    }

    fn sync_dropped(&mut self, scanned: &Scanned, place: Isometry3<f64>, is_wanted: bool) {
        let Some(cleaned) = scanned.cleaned.as_ref().filter(|_| is_wanted) else {
            self.dropped = None;
            return;
        };
        if !self.dropped.as_ref().is_some_and(|d| Arc::ptr_eq(&d.of, cleaned) && d.scene_from_scan == place) {
            let item = dropped(&scanned.read, cleaned, &place);
            self.dropped = Some(Dropped { of: cleaned.clone(), scene_from_scan: place, item });
        }
    }

    /// The scale of the points that are shown.
    pub fn scale(&self) -> Option<DeviationScale> {
        self.compared.as_ref().map(|v| v.scale)
    }

    /// Points on the part and points that were taken out, each if it is wanted, on a part that stands there.
    pub fn items(&self, [points, dropped]: [bool; 2], place: &Isometry3<f64>) -> Vec<CloudItem> {
        let points = self.compared.as_ref().filter(|_| points).map(|v| &v.points);
        let dropped = self.dropped.as_ref().filter(|_| dropped).map(|d| &d.item);
        let placed = |item: &CloudItem| CloudItem { scene_from_item: place * item.scene_from_item, ..item.clone() };
        points.into_iter().chain(dropped).map(placed).collect()
    }

    /// The model by its deviation, part frame.
    pub fn model(&self) -> Option<&MeshItem> {
        self.compared.as_ref()?.model.as_ref()
    }

    /// The outlines of all patches, and of the layers that fill them, part frame.
    pub fn outlines(&self) -> impl Iterator<Item = &LineItem> {
        let of_layers = self.layers.iter().flat_map(|(_, outlines)| outlines);
        self.compared.iter().flat_map(|v| &v.outlines).chain(of_layers)
    }

    /// The label of the point under a pixel, on a part that stands there. Points farther along the ray than
    /// `before_mm` are hidden.
    pub fn label_at(
        &self,
        camera: &Camera,
        px: Point2<f64>,
        size: ViewSize,
        place: &Isometry3<f64>,
        before_mm: Option<f64>,
    ) -> Option<ScanLabel> {
        let view = self.compared.as_ref()?;
        let item = CloudItem { scene_from_item: place * view.points.scene_from_item, ..view.points.clone() };
        let pick = cloud_point_at(&item, camera, px, size, REACH_PX)?;
        // Where material is missing the points lie behind the model.
        let reach_mm = f64::from(item.lift_mm) + REACH_PX / camera.px_per_mm(&camera.target, size);
        if before_mm.is_some_and(|mm| pick.along_mm > mm + reach_mm) {
            return None;
        }
        view.label(pick.index)
    }

    /// The label of the point nearest to a place of the part frame.
    pub fn label_near(&self, at: &Point3<f64>) -> Option<ScanLabel> {
        let view = self.compared.as_ref()?;
        let far2 = |p: Point3<f64>| (p - at).norm_squared();
        let nearest = (0u32..).zip(view.laid.cloud_in_part.points()).min_by(|a, b| far2(a.1).total_cmp(&far2(b.1)))?;
        view.label(nearest.0)
    }
}

impl ComparedView {
    fn new(of: &Arc<ComparedScan>, laid: &Arc<LaidScan>, scale: DeviationScale) -> ComparedView {
        ComparedView {
            of: of.clone(),
            laid: laid.clone(),
            scale,
            points: deviation_points(laid, of, scale),
            model: None,
            outlines: closed_outlines(of.patches.patches.iter().flat_map(|p| &p.outlines)),
        }
    }

    /// `None`: the point has nothing to do with the model.
    fn label(&self, index: u32) -> Option<ScanLabel> {
        let off_mm = -f64::from(*self.of.depth_mm.get(index as usize)?);
        off_mm.is_finite().then(|| ScanLabel { at: self.laid.cloud_in_part.point(index as usize), off_mm })
    }
}

/// Closed lines around patches.
fn closed_outlines<'a>(rings: impl Iterator<Item = &'a Vec<Point3<f64>>>) -> Vec<LineItem> {
    let sides = |ring: &Vec<Point3<f64>>| (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]).collect();
    let pieces: Vec<Vec<[Point3<f64>; 2]>> = rings.map(sides).collect();
    let outlined: Vec<PatchOutline<'_>> = pieces.iter().map(|pieces| PatchOutline { pieces, chosen: false }).collect();
    outlines(&outlined)
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
