//! What the view shows while a tool for the scan is in the hand: the scan beside the model, alone with what a cut would
//! take out, or the model with what does not count.

use super::super::App;
use super::super::context::Context;
use super::draft::{CutDraft, CutShape, ScanTool};
use crate::document::model::ScanRegion;
use crate::part::{Hasher, Part};
use crate::picture::palette::scan as colors;
use crate::picture::regions::RegionLines;
use crate::picture::{PartLook, ScanLook, ScanPicture};
use crate::planning::Stage;
use crate::progress::Activity;
use crate::scan::Cloud;
use crate::scan::cleaning::{Cleaned, clean};
use crate::view::{Bounds, Camera, CloudItem, CloudPick, Depth, MeshItem, PointItem, Scene, ViewSize, cloud_point_at};
use nalgebra::{Isometry3, Point2, Point3, Translation3, Unit, Vector3};
use std::convert::Infallible;
use std::mem::{Discriminant, discriminant};
use std::sync::Arc;

/// Between model and scan side by side, as a share of their size.
const GAP: f64 = 0.12;
/// How near to a point a click has to be, pixels.
const REACH_PX: f64 = 8.0;
const DOT_PX: f32 = 11.0;

/// What is shown for a tool, kept while it is in the hand.
#[derive(Default)]
pub(in super::super) struct ToolView {
    scan: Option<ToolScan>,
    /// Where the scan lay last: it stays there while it is laid again.
    model_from_scan: Option<Isometry3<f64>>,
    /// Which points a cut would keep.
    preview: Stage<Vec<bool>, Infallible>,
    /// The tool that the camera was turned to.
    fitted: Option<Discriminant<ScanTool>>,
    left_out: LeftOutFacets,
}

/// Facets of the part that do not count when the scan is laid, and what tells them.
#[derive(Default)]
struct LeftOutFacets {
    regions: Vec<ScanRegion>,
    part: Option<Arc<Part>>,
    facets: Arc<Vec<u32>>,
}

impl LeftOutFacets {
    fn sync(&mut self, part: &Arc<Part>, regions: Vec<ScanRegion>) {
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
struct ToolScan {
    of: Arc<Cleaned>,
    cloud: Arc<Cloud>,
    picture: ScanPicture,
    middle: Point3<f64>,
    item: CloudItem,
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

    /// Makes what the tool needs.
    fn sync(&mut self, tool: &ScanTool, context: &SyncedWith<'_>) {
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
    fn scene_from_scan(&self, tool: &ScanTool, part: &Bounds, place: Isometry3<f64>) -> Option<Isometry3<f64>> {
        let scan = self.scan.as_ref()?;
        let onto_middle = || Isometry3::from(Translation3::from(part.center() - scan.middle));
        let on_part = self.model_from_scan.unwrap_or_else(onto_middle);
        if !matches!(tool, ScanTool::Pairs(_)) {
            return Some(place * on_part);
        }
        let turned = scan.picture.bounds(&on_part)?;
        let (part_mm, scan_mm) = (part.max - part.min, turned.max - turned.min);
        // Along the axis on which both are narrow they stay large in the view.
        let axis = (part_mm + scan_mm).imin();
        let mut way = part.center() - turned.center();
        way[axis] = part.max[axis] - turned.min[axis] + GAP * part_mm.norm().max(scan_mm.norm());
        Some(place * Translation3::from(way) * on_part)
    }
}

/// What a tool's picture is made from.
struct SyncedWith<'a> {
    cleaned: Option<&'a Arc<Cleaned>>,
    model_from_scan: Option<Isometry3<f64>>,
    executor: &'a dyn crate::planning::Executor,
}

impl App {
    /// Brings what is shown for the tool up to date; without a scan there is no tool.
    pub(in super::super) fn sync_tool_of_scan(&mut self) {
        if !self.document.job().scan.is_there() {
            self.session.scan_tool = None;
        }
        let of_job = &self.document.job().scan.left_out;
        let regions = match &self.session.scan_tool {
            Some(ScanTool::LeaveOut(draft)) => draft.regions(of_job),
            _ => of_job.clone(),
        };
        if let Some(part) = &self.derived.part {
            self.tool.left_out.sync(part, regions);
        }
        let Some(tool) = &self.session.scan_tool else {
            let ToolView { fitted, left_out, .. } = std::mem::take(&mut self.tool);
            self.tool = ToolView { fitted, left_out, ..ToolView::default() };
            return;
        };
        let scanned = self.derived.pipeline.scanned();
        let with = SyncedWith {
            cleaned: scanned.as_ref().and_then(|s| s.cleaned.as_ref()),
            model_from_scan: scanned.as_ref().and_then(|s| Some(s.laid.as_ref()?.model_from_scan)),
            executor: &**self.derived.pipeline.executor(),
        };
        self.tool.sync(tool, &with);
    }

    /// Turns the camera to what a tool shows, once when it is taken into the hand, and back when it is laid down.
    pub(in super::super) fn fit_to_tool(&mut self) {
        let now = self.session.scan_tool.as_ref().map(discriminant);
        let Some(part) = self.derived.picture.as_ref().map(|p| p.bounds) else { return };
        if now == self.tool.fitted {
            return;
        }
        if now.is_some() && self.context().is_in_cell() {
            self.leave_cell();
        }
        let moves = self.session.scan_tool.as_ref().is_some_and(ScanTool::moves_scan);
        let scan = self.tool.scan.as_ref().map(|s| &s.picture).zip(self.context().scene_from_scan());
        let bounds = match (scan, &self.session.scan_tool) {
            (Some((scan, place)), Some(ScanTool::Pairs(_))) => scan.bounds(&place).map(|b| b.union(&part)),
            (Some((scan, place)), Some(ScanTool::Cut(_))) => scan.bounds(&place),
            // The points come with the next frames.
            _ if moves => return,
            _ => Some(part),
        };
        if let Some(bounds) = bounds {
            self.viewport.set_scene_bounds(bounds.union(&part));
            self.viewport.fit(bounds);
        }
        self.tool.fitted = now;
    }

    /// Adds what is shown for the tool in the hand; whether that is all there is to be shown.
    pub(in super::super) fn add_scan_tool(&self, scene: &mut Scene) -> bool {
        let context = self.context();
        let (Some(tool), Some(picture)) = (&self.session.scan_tool, &self.derived.picture) else { return false };
        let place = context.scene_from_part();
        let mut part = || {
            let look = PartLook { left_out: context.tool.left_out().clone(), ..PartLook::default() };
            scene.meshes.push(MeshItem { scene_from_item: place, ..picture.item(&self.derived.surfaces, &look) });
        };
        match tool {
            ScanTool::Label => return false,
            ScanTool::Pairs(_) => part(),
            ScanTool::LeaveOut(draft) => {
                part();
                scene.lines.push(lines_of(&draft.regions(&self.document.job().scan.left_out)).item(place));
                scene.points.extend(draft.corner.map(|c| dots(&[c.into()], place)));
            }
            ScanTool::Cut(_) => {}
        }
        let (Some(scan), Some(scene_from_scan)) = (&self.tool.scan, context.scene_from_scan()) else { return true };
        let moved = scene_from_scan * scan.item.scene_from_item;
        scene.clouds.push(CloudItem { scene_from_item: moved, ..scan.item.clone() });
        match tool {
            ScanTool::Pairs(draft) => {
                let on_scan = draft.pairs.iter().map(|p| p.scan_mm).chain(draft.scan_mm);
                let on_model = draft.pairs.iter().map(|p| p.model_mm).chain(draft.model_mm);
                scene.points.push(dots(&on_scan.map(Point3::from).collect::<Vec<_>>(), scene_from_scan));
                scene.points.push(dots(&on_model.map(Point3::from).collect::<Vec<_>>(), place));
            }
            ScanTool::Cut(draft) => add_cut(scene, draft, scan, scene_from_scan),
            ScanTool::LeaveOut(_) | ScanTool::Label => {}
        }
        true
    }
}

impl Context<'_> {
    /// Where the scan stands in the scene while a tool moves it.
    pub fn scene_from_scan(self) -> Option<Isometry3<f64>> {
        let (tool, part) = (self.session.scan_tool.as_ref()?, &self.derived.picture.as_ref()?.bounds);
        self.tool.scene_from_scan(tool, part, self.scene_from_part())
    }

    /// The point of the scan under a pixel while a tool moves the scan: its place in the scan's frame, and how far along the
    /// ray it is, mm.
    pub(super) fn scan_point_at(self, camera: &Camera, px: Point2<f64>, size: ViewSize) -> Option<(Point3<f64>, f64)> {
        let scan = self.tool.scan.as_ref()?;
        let scene_from_item = self.scene_from_scan()? * scan.item.scene_from_item;
        let item = CloudItem { scene_from_item, ..scan.item.clone() };
        let CloudPick { index, along_mm } = cloud_point_at(&item, camera, px, size, REACH_PX)?;
        Some((scan.cloud.point(index as usize), along_mm))
    }

    /// The middle of the scan, in its frame.
    pub(super) fn scan_middle(self) -> Option<Point3<f64>> {
        self.tool.scan.as_ref().map(|s| s.middle)
    }
}

/// The lines of regions, part frame.
fn lines_of(regions: &[ScanRegion]) -> RegionLines {
    let mut lines = RegionLines::default();
    for region in regions {
        match region {
            ScanRegion::Sphere { centre_mm, radius_mm } => lines.ball((*centre_mm).into(), *radius_mm),
            ScanRegion::Box { min_mm, max_mm } => lines.cuboid((*min_mm).into(), (*max_mm).into()),
        }
    }
    lines
}

/// The box or plane that cuts, and what was clicked of it.
fn add_cut(scene: &mut Scene, draft: &CutDraft, scan: &ToolScan, scene_from_scan: Isometry3<f64>) {
    let mut lines = RegionLines::default();
    let mut clicked = Vec::new();
    match &draft.shape {
        CutShape::Box { min, max, corner, .. } => {
            lines.cuboid((*min).into(), (*max).into());
            clicked.extend(*corner);
        }
        CutShape::Plane { through, normal, shift_mm, clicked: points } => {
            let normal = Unit::try_new(Vector3::from(*normal), 0.0).unwrap_or_else(Vector3::z_axis);
            let through = Point3::from(*through) + normal.into_inner() * *shift_mm;
            // Drawn around the scan, wherever on the plane it was clicked.
            let around = scan.middle - normal.into_inner() * (scan.middle - through).dot(&normal);
            lines.plane(around, normal, 0.4 * scan.cloud.diagonal());
            clicked.extend(points);
        }
        CutShape::Brush { .. } => {}
    }
    scene.lines.push(lines.item(scene_from_scan));
    let clicked: Vec<Point3<f64>> = clicked.into_iter().map(Point3::from).collect();
    scene.points.push(dots(&clicked, scene_from_scan));
}

/// Dots on top of everything.
fn dots(at: &[Point3<f64>], scene_from_item: Isometry3<f64>) -> PointItem {
    let [r, g, b] = colors::REGION;
    let single = |p: &Point3<f64>| ([p.x as f32, p.y as f32, p.z as f32], [r, g, b, 255]);
    let points: Vec<([f32; 3], [u8; 4])> = at.iter().map(single).collect();
    let bits: Vec<u32> = points.iter().flat_map(|(p, _)| p.map(f32::to_bits)).collect();
    PointItem {
        key: Hasher::default().u32s(&bits).finish().0 as u64,
        points: Arc::new(points),
        size_px: DOT_PX,
        depth: Depth::OnTop,
        scene_from_item,
    }
}
