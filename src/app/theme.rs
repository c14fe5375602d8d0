//! Looks: spacing, the accent colour, one font size for numbers.

use eframe::egui::{self, Color32, CornerRadius, Stroke, Theme, vec2};

/// The one accent colour.
pub const ACCENT: Color32 = Color32::from_rgb(0, 118, 190);
/// Something is wrong.
pub const WRONG: Color32 = Color32::from_rgb(214, 48, 49);
/// Something wants attention.
pub const ATTENTION: Color32 = Color32::from_rgb(224, 132, 0);

/// Sets fonts, and the style of both themes.
pub fn install(ctx: &egui::Context) {
    // The monospaced font has the arrows and signs that the text font lacks.
    let mut fonts = egui::FontDefinitions::default();
    let signs = fonts.families.get(&egui::FontFamily::Monospace).cloned().unwrap_or_default();
    fonts.families.entry(egui::FontFamily::Proportional).or_default().extend(signs);
    ctx.set_fonts(fonts);
    for theme in [Theme::Dark, Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            style.spacing.item_spacing = vec2(6.0, 5.0);
            style.spacing.button_padding = vec2(7.0, 3.0);
            style.spacing.interact_size.y = 22.0;
            style.visuals.selection.bg_fill = ACCENT.gamma_multiply(0.75);
            style.visuals.selection.stroke = Stroke::new(1.0, Color32::WHITE);
            for w in [
                &mut style.visuals.widgets.inactive,
                &mut style.visuals.widgets.hovered,
                &mut style.visuals.widgets.active,
            ] {
                w.corner_radius = CornerRadius::same(4);
            }
            style.visuals.striped = true;
        });
    }
}

/// A heading of a group.
pub fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(egui::RichText::new(text).strong().size(13.5));
}

/// With a capital, as a sentence and a button begin.
pub fn capital(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}

/// The name of a field, at the left of a column of this width.
pub fn name(ui: &mut egui::Ui, text: &str, width: f32) -> egui::Response {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let cell = ui.allocate_ui_with_layout(vec2(width, 20.0), layout, |ui| {
        ui.set_min_width(width);
        ui.add(egui::Label::new(text).truncate())
    });
    cell.inner
}

/// A small filled square of a surface's colour.
pub fn swatch(ui: &mut egui::Ui, [r, g, b]: [u8; 3]) {
    let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), egui::Sense::hover());
    ui.painter().rect(
        rect,
        CornerRadius::same(3),
        Color32::from_rgb(r, g, b),
        Stroke::new(1.0, ui.visuals().weak_text_color()),
        egui::StrokeKind::Inside,
    );
}
