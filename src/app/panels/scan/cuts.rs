//! Cuts through the points of a scan as cleaning steps: by a box, a plane or a brush, with what each would take out in
//! the view before it is taken over.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::scan_tool::{CutDraft, CutShape, ScanTool};
use super::super::entry::{Entry, refused};
use super::place::place;
use super::tool_button::{brush_mm, hint, radius, tool_button};
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::Scanned;
use crate::scan::cleaning::Keep;
use crate::text::say;
use eframe::egui::{self, RichText, Role, WidgetInfo};
use nalgebra::{Point3, Vector3};

/// Places in a scan may be far from its origin, mm.
const FAR_MM: f64 = 1e9;

pub(super) fn ui(ui: &mut egui::Ui, scanned: &Scanned, context: Context<'_>, actions: &mut Actions) {
    let Some(cleaned) = &scanned.cleaned else { return };
    let draft = match context.scan_tool() {
        Some(ScanTool::Cut(draft)) => Some(draft),
        _ => None,
    };
    let shape = draft.map(|d| &d.shape);
    ui.horizontal_wrapped(|ui| {
        ui.label(say!(scan_cut));
        let whole = || cleaned.cloud.bounds().unwrap_or((Point3::origin(), Point3::origin()));
        let is_box = matches!(shape, Some(CutShape::Box { .. }));
        tool_button(ui, named(say!(scan_cut_by_box)), is_box, actions, || {
            let (min, max) = whole();
            let [min, max] = [min, max].map(|p| p.coords.into());
            of_shape(CutShape::Box { min, max, keep: Keep::Inside, corner: None })
        });
        let is_plane = matches!(shape, Some(CutShape::Plane { .. }));
        tool_button(ui, named(say!(scan_cut_by_plane)), is_plane, actions, || {
            let (min, _) = whole();
            let (through, normal) = (min.coords.into(), [0.0, 0.0, 1.0]);
            of_shape(CutShape::Plane { through, normal, shift_mm: 0.0, clicked: Vec::new() })
        });
        let is_brush = matches!(shape, Some(CutShape::Brush { .. }));
        let radius_mm = brush_mm(context);
        tool_button(ui, named(say!(scan_cut_by_brush)), is_brush, actions, || {
            of_shape(CutShape::Brush { centres: Vec::new(), radius_mm })
        });
    });
    let Some(draft) = draft else { return };
    let mut now = draft.clone();
    match &mut now.shape {
        CutShape::Box { min, max, keep, corner } => {
            hint(ui, if corner.is_none() { say!(scan_cut_hint_box) } else { say!(scan_cut_hint_other_corner) });
            corners(ui, min, max);
            kept(ui, keep);
        }
        CutShape::Plane { normal, shift_mm, clicked, .. } => {
            hint(ui, say!(scan_cut_hint_plane));
            normals(ui, normal, clicked);
            let place = Entry {
                speed: 0.05,
                prefix: say!(scan_cut_shift_prefix),
                ..Entry::new(-FAR_MM..=FAR_MM, say!(unit_mm))
            };
            let drawn = place.show(ui, shift_mm);
            drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(scan_cut_shift)));
            refused(ui, [&drawn]);
        }
        CutShape::Brush { centres, radius_mm } => {
            hint(ui, say!(scan_cut_hint_brush));
            let row = ui.horizontal_wrapped(|ui| {
                let drawn = radius(ui, radius_mm);
                if ui.add_enabled(!centres.is_empty(), egui::Button::new(say!(scan_cut_brush_anew)).small()).clicked() {
                    centres.clear();
                }
                drawn
            });
            refused(ui, [&row.inner]);
        }
    }
    if now != *draft {
        actions.session(move |s| s.scan_tool = Some(ScanTool::Cut(now)));
    }
    take_over(ui, draft, context, actions);
}

/// The word on a button, and its accessible name.
fn named(what: String) -> [String; 2] {
    let told = say!(scan_cut_name, what = &what);
    [what, told]
}

fn of_shape(shape: CutShape) -> ScanTool {
    ScanTool::Cut(CutDraft { shape })
}

/// How many points would go, and the button that makes a step of it.
fn take_over(ui: &mut egui::Ui, draft: &CutDraft, context: Context<'_>, actions: &mut Actions) {
    let dropped = context.tool.dropped();
    if let Some((dropped, of)) = dropped {
        ui.label(RichText::new(say!(scan_cut_dropped, dropped, of)).strong());
    }
    ui.horizontal(|ui| {
        let cuts = dropped.is_some_and(|(dropped, of)| 0 < dropped && dropped < of);
        let add = ui.add_enabled(cuts, egui::Button::new(say!(scan_cut_add)));
        if add.on_disabled_hover_text(say!(scan_cut_add_not)).clicked() {
            actions.scan(ScanEdit::AddStep(draft.step()));
            actions.session(|s| s.scan_tool = None);
        }
        if ui.button(say!(scan_cut_cancel)).clicked() {
            actions.session(|s| s.scan_tool = None);
        }
    });
}

/// The two corners of a box, in the frame of the scan. They stay in order.
fn corners(ui: &mut egui::Ui, min: &mut [f64; 3], max: &mut [f64; 3]) {
    let before = (*min, *max);
    for (name, corner) in [(say!(scan_cut_from), &mut *min), (say!(scan_cut_to), &mut *max)] {
        place(ui, corner, FAR_MM, |axis| say!(scan_cut_corner, corner = &name, axis));
    }
    for k in 0..3 {
        if min[k] > max[k] {
            (min[k], max[k]) = if min[k] == before.0[k] { (max[k], max[k]) } else { (min[k], min[k]) };
        }
    }
}

fn kept(ui: &mut egui::Ui, keep: &mut Keep) {
    ui.horizontal(|ui| {
        for (side, name) in [(Keep::Inside, say!(scan_cut_keep_inside)), (Keep::Outside, say!(scan_cut_keep_outside))] {
            ui.radio_value(keep, side, name);
        }
    });
}

/// The normal of a plane along an axis of the scan, and which side stays.
fn normals(ui: &mut egui::Ui, normal: &mut [f64; 3], clicked: &mut Vec<[f64; 3]>) {
    ui.horizontal(|ui| {
        ui.label(say!(scan_cut_across));
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let along: [f64; 3] = Vector3::ith(axis, 1.0).into();
            let is_on = Vector3::from(*normal).normalize().abs() == Vector3::ith(axis, 1.0);
            let button = ui.selectable_label(is_on, name);
            button.widget_info(|| {
                WidgetInfo::selected(Role::RadioButton, true, is_on, say!(scan_cut_across_name, axis = name))
            });
            if button.clicked() {
                *normal = along;
                clicked.truncate(1);
            }
        }
        if ui.button(say!(scan_cut_flip)).on_hover_text(say!(scan_cut_flip_tip)).clicked() {
            *normal = normal.map(|c| -c);
        }
    });
}
