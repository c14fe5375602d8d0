//! The window: the drawing, a row of numbers for each piece, and where the head goes.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::dialogs::Purpose;
use super::super::entry::{Drawn, Entry, refused};
use super::drawing;
use super::state::HeadDraft;
use crate::beam::{HeadPart, SampleHead};
use crate::text::{Sentence as _, id, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

/// The window, if it is open.
pub(in super::super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    let Some(before) = &context.session.head_draft else { return };
    let (mut draft, mut open) = (before.clone(), true);
    let window = egui::Window::new(say!(head_title)).id(egui::Id::unique("head editor")).open(&mut open);
    let window = window.collapsible(false).resizable(false).default_pos(egui::pos2(330.0, 110.0));
    window.show(ctx, |ui| {
        samples(ui, &mut draft);
        ui.horizontal_top(|ui| {
            let job = context.document.job();
            drawing::ui(ui, &draft.parts, &job.optics, job.beam.defocus_mm);
            ui.vertical(|ui| pieces(ui, &mut draft));
        });
        ui.separator();
        keep(ui, &draft, actions);
    });
    if !open {
        actions.session(|s| s.head_draft = None);
    } else if draft != *before {
        actions.session(|s| s.head_draft = Some(draft));
    }
}

fn samples(ui: &mut egui::Ui, draft: &mut HeadDraft) {
    ui.horizontal_wrapped(|ui| {
        ui.label(say!(head_begin_with));
        for sample in SampleHead::ALL {
            let name = match sample {
                SampleHead::FixedOptic => say!(head_fixed_optic),
                SampleHead::ScanHead => say!(head_scan_head),
                SampleHead::CladdingNozzle => say!(head_cladding_nozzle),
            };
            if ui.button(name).on_hover_text(say!(head_sample_tip)).clicked() {
                draft.parts = sample.parts();
            }
        }
    });
    ui.label(RichText::new(say!(head_how)).weak());
}

/// A row for each piece, the farthest from the part on top, as in the drawing.
fn pieces(ui: &mut egui::Ui, draft: &mut HeadDraft) {
    if ui.button(say!(head_add)).on_hover_text(say!(head_add_tip)).clicked() {
        draft.add();
    }
    let (mut gone, mut drawn) = (None, Vec::new());
    egui::Grid::new("head pieces").num_columns(6).show(ui, |ui| {
        ui.label("");
        for title in [say!(head_from), say!(head_to), say!(head_radius_from), say!(head_radius_to)] {
            ui.label(RichText::new(title).small());
        }
        ui.end_row();
        for (i, part) in draft.parts.iter_mut().enumerate().rev() {
            ui.label((i + 1).to_string());
            drawn.extend(numbers(ui, i, part));
            let remove = ui.small_button("×").on_hover_text(say!(head_remove));
            remove.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(head_remove_name, number = id(i + 1))));
            if remove.clicked() {
                gone = Some(i);
            }
            ui.end_row();
        }
    });
    refused(ui, &drawn);
    if let Some(i) = gone {
        draft.parts.remove(i);
    }
}

fn numbers(ui: &mut egui::Ui, i: usize, part: &mut HeadPart) -> Vec<Drawn> {
    let HeadPart { from_mm, to_mm, r0_mm, r1_mm } = part;
    let fields = [
        (from_mm, say!(head_from), -1000.0..=10_000.0),
        (to_mm, say!(head_to), -1000.0..=10_000.0),
        (r0_mm, say!(head_radius_from), 0.0..=2000.0),
        (r1_mm, say!(head_radius_to), 0.0..=2000.0),
    ];
    let field = |(value, what, range): (&mut f64, String, std::ops::RangeInclusive<f64>)| {
        let size = Some([64.0, 20.0]);
        let shown = Entry { decimals: 1, size, ..Entry::new(range, say!(unit_mm)) }.show(ui, value);
        let name = say!(head_number_name, number = id(i + 1), what);
        let value = *value;
        shown.response.widget_info(|| WidgetInfo { label: Some(name.clone()), ..WidgetInfo::drag_value(true, value) });
        shown
    };
    fields.into_iter().map(field).collect()
}

/// What is wrong with the head, or the button that writes it.
fn keep(ui: &mut egui::Ui, draft: &HeadDraft, actions: &mut Actions) {
    let wrong = draft.text().err();
    if let Some(e) = &wrong {
        ui.label(RichText::new(e.sentence()).color(ui.visuals().error_fg_color));
    }
    let button = ui.add_enabled(wrong.is_none(), egui::Button::new(say!(head_keep)));
    if button.on_hover_text(say!(head_keep_tip)).clicked() {
        actions.ask(Purpose::SaveHead);
    }
}
