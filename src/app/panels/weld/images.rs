//! The window of a weld's images: grey and depth side by side with the mask drawn over both, step by step, and the brush
//! that adds to the mask and takes from it.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::toggle::Toggle;
use super::super::super::weld::{ImageHand, ImageTextures, ImagesView, MaskStep};
use super::super::entry::{Entry, refused};
use super::canvas::{self, Pane};
use super::scale;
use crate::document::WeldEdit;
use crate::planning::welded::ReadWeld;
use crate::text::{fixed, id, say};
use eframe::egui::{self, ComboBox, RichText, Role, Vec2, WidgetInfo, vec2};

const GAP: f32 = 6.0;
/// Least size of an image, points.
const LEAST: [f32; 2] = [160.0, 120.0];
/// Under the images: the line that says what is at the cursor, and the scale.
const BELOW: f32 = 70.0;

/// The window, if it is open.
pub(in super::super::super) fn ui(ctx: &egui::Context, context: Context<'_>, actions: &mut Actions) {
    if !context.session.show.is_on(Toggle::WeldImages) || !context.has_weld() {
        return;
    }
    let (mut view, mut open) = (context.session.images.clone(), true);
    let room = ctx.content_rect().size();
    let size = vec2((room.x - 80.0).clamp(420.0, 1000.0), (room.y - 220.0).clamp(260.0, 560.0));
    let window = egui::Window::new(say!(weld_panel_images_title))
        .id(egui::Id::unique("weld images"))
        .open(&mut open)
        .collapsible(false);
    window.default_size(size).default_pos(egui::pos2(40.0, 90.0)).show(ctx, |ui| {
        tools(ui, &mut view, context, actions);
        let (Some(read), Some(textures)) = (context.weld.read(), context.weld.textures()) else {
            ui.label(RichText::new(say!(weld_panel_no_images)).weak());
            return;
        };
        if let Some(edit) = both(ui, &mut view, read, textures) {
            actions.grind(edit);
        }
    });
    if !open {
        actions.session(|s| s.show.set(Toggle::WeldImages, false));
    }
    if view != context.session.images {
        // What the hand did is drawn in the next frame, which a hand that rests would not ask for.
        ctx.request_repaint();
        actions.session(move |s| s.images = view);
    }
}

/// The step that is shown, what the hand does, and how wide the brush is.
fn tools(ui: &mut egui::Ui, view: &mut ImagesView, context: Context<'_>, actions: &mut Actions) {
    let row = ui.horizontal_wrapped(|ui| {
        let label = ui.label(say!(weld_panel_step));
        let combo = ComboBox::from_id_salt("step of the mask").width(130.0).selected_text(step_name(view.step));
        let shown = combo.show_ui(ui, |ui| {
            for step in MaskStep::ALL {
                ui.selectable_value(&mut view.step, step, step_name(step));
            }
        });
        shown.response.labelled_by(label.id);
        ui.separator();
        let hands = [
            (ImageHand::Pan, say!(weld_panel_pan), say!(weld_panel_pan_tip)),
            (ImageHand::Add, say!(weld_panel_add), say!(weld_panel_add_tip)),
            (ImageHand::Erase, say!(weld_panel_erase), say!(weld_panel_erase_tip)),
        ];
        for (hand, name, tip) in hands {
            ui.selectable_value(&mut view.hand, hand, name).on_hover_text(tip);
        }
        let entry = Entry {
            speed: 0.2,
            decimals: 1,
            prefix: say!(weld_panel_radius_prefix),
            ..Entry::new(0.5..=500.0, say!(weld_panel_px))
        };
        let drawn = entry.show(ui, &mut view.radius_px);
        drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, say!(weld_panel_radius)));
        let is_painted = !context.document.job().weld.painted.is_empty();
        let unpaint = ui.add_enabled(is_painted, egui::Button::new(say!(weld_panel_unpaint)));
        if unpaint.on_disabled_hover_text(say!(weld_panel_not_painted)).clicked() {
            actions.grind(WeldEdit::Unpaint);
        }
        if ui.button(say!(weld_panel_whole)).on_hover_text(say!(weld_panel_whole_tip)).clicked() {
            (view.zoom, view.centre_px) = (1.0, None);
        }
        drawn
    });
    refused(ui, [&row.inner]);
}

/// Both images, what is at the cursor, and the scale of the depths; a stroke that has ended is an edit.
fn both(ui: &mut egui::Ui, view: &mut ImagesView, read: &ReadWeld, textures: &ImageTextures) -> Option<WeldEdit> {
    let room = ui.available_size() - vec2(0.0, BELOW);
    let size = room.max(Vec2::from(LEAST));
    let one = vec2((0.5 * (size.x - GAP)).max(LEAST[0]), size.y);
    let before = view.clone();
    let (mut hovered, mut edit) = (None, None);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        let panes = [
            Pane { image: textures.left(), mask: textures.mask(), told: say!(weld_panel_gray_image) },
            Pane { image: &textures.depth, mask: textures.mask(), told: say!(weld_panel_depth_image) },
        ];
        for pane in &panes {
            let done = canvas::ui(ui, one, pane, read.grey.size(), &before, view);
            hovered = hovered.or(done.hovered_px);
            edit = edit.take().or(done.stroke.map(WeldEdit::Paint));
        }
    });
    ui.label(hovered.and_then(|at| at_cursor(at, read, textures)).unwrap_or_else(|| say!(weld_panel_no_pixel)));
    ui.horizontal(|ui| {
        ui.label(say!(weld_panel_depth_legend));
        let width = ui.available_width().clamp(160.0, 320.0);
        let scale = &textures.scale;
        scale::bar(ui, width, scale.range_mm, |mm| scale.color(mm), &say!(weld_panel_depth_scale));
    });
    edit
}

/// Level and depth of the pixel under the cursor.
fn at_cursor(at: [f64; 2], read: &ReadWeld, textures: &ImageTextures) -> Option<String> {
    let [u, v] = at.map(|x| x.round().max(0.0) as usize);
    let level = fixed(f64::from(*read.grey.at(u, v)?), 0);
    let depth = read.depth.at(u, v).and_then(|d| textures.scale.mm(*d));
    let (column, row) = (id(u), id(v));
    Some(match depth {
        Some(mm) => say!(weld_panel_pixel, column, row, level, depth = fixed(mm, 2)),
        None => say!(weld_panel_pixel_hole, column, row, level),
    })
}

fn step_name(step: MaskStep) -> String {
    match step {
        MaskStep::Gray => say!(weld_panel_step_gray),
        MaskStep::Evened => say!(weld_panel_step_evened),
        MaskStep::Smoothed => say!(weld_panel_step_smoothed),
        MaskStep::Above => say!(weld_panel_step_above),
        MaskStep::Opened => say!(weld_panel_step_opened),
        MaskStep::Closed => say!(weld_panel_step_closed),
        MaskStep::Painted => say!(weld_panel_step_painted),
        MaskStep::Areas => say!(weld_panel_step_areas),
        MaskStep::Edges => say!(weld_panel_step_edges),
    }
}
