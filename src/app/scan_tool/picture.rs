//! What the view shows while a tool for the scan is in the hand: the scan beside the model, alone with what a cut would
//! take out, or the model with what does not count.

use super::super::App;
use super::super::context::Context;
use super::draft::{CutDraft, CutShape, ScanTool};
use super::view::{SyncedWith, ToolScan};
use crate::document::model::ScanRegion;
use crate::part::Hasher;
use crate::picture::PartLook;
use crate::picture::palette::scan as colors;
use crate::picture::regions::RegionLines;
use crate::view::{Bounds, Camera, CloudItem, CloudPick, Depth, MeshItem, PointItem, Scene, ViewSize, cloud_point_at};
use nalgebra::{Isometry3, Point2, Point3, Unit, Vector3};
use std::mem::discriminant;
use std::sync::Arc;

/// How near to a point a click has to be, pixels.
const REACH_PX: f64 = 8.0;
const DOT_PX: f32 = 11.0;

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
            self.tool.lay_down();
            return;
        };
        let scanned = self.derived.pipeline.scanned();
        let with = SyncedWith {
            cleaned: scanned.as_ref().and_then(|s| s.cleaned.as_ref()),
            model_from_scan: scanned.as_ref().and_then(|s| Some(s.laid.as_ref()?.model_from_scan)),
            right: self.viewport.camera.axes().column(0).into_owned(),
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
        // What stays on the part leaves the camera where it is.
        if let Some(bounds) = bounds.filter(|_| moves || self.tool.is_moved) {
            let beams = Vector3::repeat(self.document.job().beam.defocus_mm.abs());
            let Bounds { min, max } = bounds.union(&part);
            self.viewport.set_scene_bounds(Bounds { min: min - beams, max: max + beams });
            self.viewport.fit(bounds);
        }
        (self.tool.fitted, self.tool.is_moved) = (now, moves);
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
