//! What is done to the points of a scan, step by step, with the points before and after. Cuts by box, plane and brush
//! are listed and taken out here, and made in `cuts`.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::entry::{Entry, refused};
use super::cuts;
use crate::document::Edit;
use crate::document::scan_edit::ScanEdit;
use crate::planning::scanned::Scanned;
use crate::scan::cleaning::Step;
use crate::text::{id, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// Side of a voxel in a new step, as a share of the scan's diagonal: of a part as large as a hand a voxel of 0.2 mm.
const VOXEL_SHARE: f64 = 1e-3;
/// Radius in a new step that smooths, the same way: several points of a fine scan.
const RADIUS_SHARE: f64 = 3e-3;
/// Diagonal before anything was read, mm.
const UNREAD_MM: f64 = 200.0;
/// The most that the fields take.
const MOST_MM: f64 = 1000.0;

pub(super) fn ui(ui: &mut egui::Ui, scanned: Option<&Scanned>, context: Context<'_>, actions: &mut Actions) {
    if let Some(scanned) = scanned {
        let read = scanned.read.cloud.len();
        let left = scanned.cleaned.as_ref().map_or(read, |c| c.cloud.len());
        ui.label(say!(scan_panel_points, read, left));
    }
    let steps = &context.document.job().scan.steps;
    for (i, step) in steps.iter().enumerate() {
        row(ui, i, step, scanned, actions);
    }
    let diagonal_mm = scanned.map_or(UNREAD_MM, |s| s.read.cloud.diagonal());
    ui.horizontal_wrapped(|ui| {
        ui.label(say!(scan_panel_clean));
        let new = [
            (Step::OUTLIERS, say!(scan_panel_add_outliers)),
            (Step::Thin { voxel_mm: rounded_mm(VOXEL_SHARE * diagonal_mm) }, say!(scan_panel_add_thinning)),
            (
                Step::Smooth { radius_mm: rounded_mm(RADIUS_SHARE * diagonal_mm), noise_mm: None },
                say!(scan_panel_add_smoothing),
            ),
        ];
        for (step, name) in new {
            if ui.small_button(name).clicked() {
                actions.scan(ScanEdit::AddStep(step));
            }
        }
    });
    if let Some(scanned) = scanned {
        cuts::ui(ui, scanned, context, actions);
    }
}

/// To hundredths, and not below one.
fn rounded_mm(mm: f64) -> f64 {
    ((mm * 100.0).round() * 0.01).clamp(0.01, MOST_MM)
}

/// A step: its number and name, its numbers, what it did, and a button that takes it out.
fn row(ui: &mut egui::Ui, at: usize, step: &Step, scanned: Option<&Scanned>, actions: &mut Actions) {
    let (mut now, mut drawn) = (step.clone(), Vec::new());
    ui.horizontal_wrapped(|ui| {
        let remove = ui.small_button("×").on_hover_text(say!(scan_panel_remove_step));
        remove.widget_info(|| {
            WidgetInfo::labeled(Role::Button, true, say!(scan_panel_remove_step_name, step = id(at + 1)))
        });
        if remove.clicked() {
            actions.scan(ScanEdit::RemoveStep(at));
        }
        ui.label(name(step));
        let mut field = |ui: &mut egui::Ui, entry: Entry, what: String, value: &mut f64| {
            let shown = entry.show(ui, value);
            let told = || say!(scan_panel_step_field, step = id(at + 1), what = &what);
            shown.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told()));
            shown.response.clone().on_hover_text(&what);
            drawn.push(shown);
        };
        let size = || Entry { speed: 0.01, ..Entry::new(0.001..=MOST_MM, say!(unit_mm)) };
        match &mut now {
            Step::Outliers { neighbours, sigma } => {
                let mut count = f64::from(*neighbours);
                let whole = Entry { decimals: 0, speed: 0.1, ..Entry::new(1.0..=1000.0, String::new()) };
                field(ui, whole, say!(scan_panel_neighbours), &mut count);
                *neighbours = count.round() as u32;
                let sigmas = Entry { speed: 0.02, ..Entry::new(0.0..=100.0, say!(scan_panel_sigmas)) };
                field(ui, sigmas, say!(scan_panel_sigma), sigma);
            }
            Step::Thin { voxel_mm } => field(ui, size(), say!(scan_panel_voxel), voxel_mm),
            Step::Smooth { radius_mm, .. } => field(ui, size(), say!(scan_panel_radius), radius_mm),
            Step::CutBox { .. } | Step::CutPlane { .. } | Step::Erase { .. } => {}
        }
        if let Some(count) = scanned.and_then(|s| s.cleaned.as_ref()?.counts.get(at).copied()) {
            let text = say!(scan_panel_counts, before = count.before, after = count.after);
            ui.label(RichText::new(text).weak());
        }
    });
    refused(ui, &drawn);
    if now != *step {
        actions.drag(Edit::Scan(Box::new(ScanEdit::AlterStep(at, now))), format!("cleaning step {at}"));
    }
}

fn name(step: &Step) -> String {
    match step {
        Step::Outliers { .. } => say!(scan_panel_outliers),
        Step::Thin { .. } => say!(scan_panel_thinning),
        Step::Smooth { .. } => say!(scan_panel_smoothing),
        Step::CutBox { .. } => say!(scan_panel_cut_box),
        Step::CutPlane { .. } => say!(scan_panel_cut_plane),
        Step::Erase { .. } => say!(scan_panel_erased),
    }
}
