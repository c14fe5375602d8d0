//! What the pointer does in the view while a tool for the scan is in the hand.

use super::super::actions::Actions;
use super::super::context::Context;
use super::super::session::Session;
use super::draft::{CutDraft, CutShape, LeaveOutDraft, LeaveOutHand, ScanTool};
use crate::document::Edit;
use crate::document::model::ScanRegion;
use crate::document::scan_edit::ScanEdit;
use crate::view::{Camera, ViewportResponse};
use eframe::egui::{self, Color32, Stroke};
use nalgebra::{Point2, Point3, Vector3};

/// What is done with the tool.
pub(in super::super) fn pointer(r: &ViewportResponse, camera: &Camera, context: Context<'_>, actions: &mut Actions) {
    let Some(tool) = &context.session.scan_tool else { return };
    if context.session.hover_place.is_some() {
        actions.session(|s| s.hover_place = None);
    }
    match tool {
        ScanTool::Pairs(_) => pick_pair(r, camera, context, actions),
        ScanTool::LeaveOut(draft) => leave_out(r, camera, draft, context, actions),
        ScanTool::Cut(draft) => cut(r, camera, draft, context, actions),
        ScanTool::Label => set_label(r, camera, context, actions),
    }
}

/// The point of the model under a pixel, part frame, and how far along the ray it is, mm.
fn model_point_at(
    context: Context<'_>,
    camera: &Camera,
    px: Point2<f64>,
    r: &ViewportResponse,
) -> Option<(Point3<f64>, f64)> {
    let ray = camera.ray_through(px, r.size);
    let (_, at) = context.picked_at(ray)?;
    Some((at, (context.scene_from_part() * at - ray.0).dot(&ray.1)))
}

/// A click takes the half of a pair that it meets first.
fn pick_pair(r: &ViewportResponse, camera: &Camera, context: Context<'_>, actions: &mut Actions) {
    let Some(px) = r.clicked_px else { return };
    let scan = context.scan_point_at(camera, px, r.size);
    let model = model_point_at(context, camera, px, r);
    let is_scan = match (&scan, &model) {
        (Some((_, near_mm)), Some((_, far_mm))) => near_mm <= far_mm,
        (scan, _) => scan.is_some(),
    };
    let Some((at, _)) = (if is_scan { scan } else { model }) else { return };
    actions.session(move |s| {
        if let Some(ScanTool::Pairs(draft)) = &mut s.scan_tool {
            if is_scan { draft.pick_scan(at) } else { draft.pick_model(at) }
        }
    });
}

fn leave_out(
    r: &ViewportResponse,
    camera: &Camera,
    draft: &LeaveOutDraft,
    context: Context<'_>,
    actions: &mut Actions,
) {
    let of_job = &context.document.job().scan.left_out;
    let change = |change: fn(&mut LeaveOutDraft, Point3<f64>), at: Point3<f64>| {
        move |s: &mut Session| {
            if let Some(ScanTool::LeaveOut(draft)) = &mut s.scan_tool {
                change(draft, at);
            }
        }
    };
    if draft.hand == LeaveOutHand::Corners {
        let Some((at, _)) = r.clicked_px.and_then(|px| model_point_at(context, camera, px, r)) else { return };
        let Some(first) = draft.corner.map(Point3::from) else {
            actions.session(change(|draft, at| draft.corner = Some(at.coords.into()), at));
            return;
        };
        actions.session(change(|draft, _| draft.corner = None, at));
        let [min, max] = [first.inf(&at), first.sup(&at)];
        actions.edit(left_out(of_job, &[around(min, max, draft.radius_mm)]));
    } else if let Some(px) = r.painted_px {
        if let Some((at, _)) = model_point_at(context, camera, px, r) {
            actions.session(change(|draft, at| draft.paint(at), at));
        }
    } else if !draft.stroke.is_empty() {
        let regions = draft.regions(of_job);
        if regions != *of_job {
            actions.edit(Edit::Scan(Box::new(ScanEdit::LeftOut(regions))));
        }
        actions.session(change(|draft, _| draft.stroke.clear(), Point3::origin()));
    }
}

/// The box between two corners, so much larger on all sides.
pub(in super::super) fn around(min: Point3<f64>, max: Point3<f64>, margin_mm: f64) -> ScanRegion {
    let out = Vector3::repeat(margin_mm);
    ScanRegion::Box { min_mm: (min - out).coords.into(), max_mm: (max + out).coords.into() }
}

/// More regions beside those of the job.
pub(in super::super) fn left_out(of_job: &[ScanRegion], more: &[ScanRegion]) -> Edit {
    Edit::Scan(Box::new(ScanEdit::LeftOut([of_job, more].concat())))
}

fn cut(r: &ViewportResponse, camera: &Camera, draft: &CutDraft, context: Context<'_>, actions: &mut Actions) {
    let is_brush = matches!(draft.shape, CutShape::Brush { .. });
    let px = if is_brush { r.painted_px } else { r.clicked_px };
    let Some((at, _)) = px.and_then(|px| context.scan_point_at(camera, px, r.size)) else { return };
    let middle = context.scan_middle().unwrap_or(at);
    actions.session(move |s| {
        if let Some(ScanTool::Cut(draft)) = &mut s.scan_tool {
            draft.click(at, &middle);
        }
    });
}

/// Sets a label at the point of the scan under the click, unless the model stands before it.
fn set_label(r: &ViewportResponse, camera: &Camera, context: Context<'_>, actions: &mut Actions) {
    let Some(px) = r.clicked_px else { return };
    let before_mm = model_point_at(context, camera, px, r).map(|(_, along_mm)| along_mm);
    let label = context.scan.label_at(camera, px, r.size, &context.scene_from_part(), before_mm);
    actions.session(move |s| s.labels.extend(label));
}

/// The size of the brush at the cursor.
pub(in super::super) fn brush_circle(ui: &egui::Ui, r: &ViewportResponse, camera: &Camera, context: Context<'_>) {
    let Some(px) = r.hover_px.or(r.painted_px) else { return };
    let (place, radius_mm) = match &context.session.scan_tool {
        Some(ScanTool::LeaveOut(draft)) if draft.hand != LeaveOutHand::Corners => {
            (model_point_at(context, camera, px, r).map(|(at, _)| context.scene_from_part() * at), draft.radius_mm)
        }
        Some(ScanTool::Cut(CutDraft { shape: CutShape::Brush { radius_mm, .. } })) => (Some(camera.target), *radius_mm),
        _ => return,
    };
    let Some(place) = place else { return };
    let points = ui.pixels_per_point();
    let radius = (radius_mm * camera.px_per_mm(&place, r.size)) as f32 / points;
    let centre = r.response.rect.min + egui::vec2(px.x as f32, px.y as f32) / points;
    let painter = ui.painter_at(r.response.rect);
    painter.circle_stroke(centre, radius, Stroke::new(2.5, Color32::from_black_alpha(120)));
    painter.circle_stroke(centre, radius, Stroke::new(1.2, Color32::WHITE));
}
