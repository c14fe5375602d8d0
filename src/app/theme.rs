//! Looks: fonts, sizes and colours of words, spacing, the accent colour.

use eframe::egui::{self, Color32, CornerRadius, FontFamily, FontId, Stroke, TextStyle, Theme, vec2};

/// The one accent colour.
pub const ACCENT: Color32 = Color32::from_rgb(0, 118, 190);
/// Something is wrong.
pub const WRONG: Color32 = Color32::from_rgb(214, 48, 49);
/// Something wants attention.
pub const ATTENTION: Color32 = Color32::from_rgb(224, 132, 0);

/// Sizes of words, points: they are read at arm's length from a machine.
const SIZES: [(TextStyle, f32); 5] = [
    (TextStyle::Small, SMALLEST),
    (TextStyle::Body, 13.5),
    (TextStyle::Button, 13.5),
    (TextStyle::Monospace, 13.0),
    (TextStyle::Heading, 18.0),
];
/// No word of a panel is smaller, points.
const SMALLEST: f32 = 12.0;

/// Colours of words, each at least 4.5 times as bright, or dark, as panels and selected rows behind it (WCAG 2.1, 1.4.3).
struct WordColors {
    plain: Color32,
    strong: Color32,
    weak: Color32,
    wrong: Color32,
    attention: Color32,
    accent: Color32,
    /// Behind what is selected.
    selected: Color32,
    on_selected: Color32,
}

const DARK: WordColors = WordColors {
    plain: Color32::from_rgb(205, 209, 213),
    strong: Color32::from_rgb(226, 229, 232),
    weak: Color32::from_rgb(180, 186, 192),
    wrong: Color32::from_rgb(255, 158, 152),
    attention: Color32::from_rgb(255, 184, 92),
    accent: Color32::from_rgb(134, 200, 255),
    selected: Color32::from_rgb(0, 74, 122),
    on_selected: Color32::WHITE,
};

const LIGHT: WordColors = WordColors {
    plain: Color32::from_rgb(52, 58, 64),
    strong: Color32::from_rgb(30, 34, 38),
    weak: Color32::from_rgb(84, 92, 100),
    wrong: Color32::from_rgb(168, 14, 24),
    attention: Color32::from_rgb(130, 70, 0),
    accent: Color32::from_rgb(0, 84, 140),
    selected: Color32::from_rgb(184, 218, 242),
    on_selected: Color32::from_rgb(12, 24, 36),
};

/// Noto Sans SC as far as GB 2312 and the words of this program go; see `assets/fonts/README.md`.
const CHINESE_FONT: &[u8] = include_bytes!("../../assets/fonts/NotoSansSC-subset.otf");
const CHINESE: &str = "Noto Sans SC";

/// Sets fonts, and the style of both themes.
pub fn install(ctx: &egui::Context) {
    // The monospaced font has the arrows and signs that the text font lacks.
    let mut fonts = egui::FontDefinitions::default();
    let signs = fonts.families.get(&egui::FontFamily::Monospace).cloned().unwrap_or_default();
    fonts.families.entry(egui::FontFamily::Proportional).or_default().extend(signs);
    // Neither has Chinese, and a workshop's machine may have no such font either.
    fonts.font_data.insert(CHINESE.into(), egui::FontData::from_static(CHINESE_FONT).into());
    for family in fonts.families.values_mut() {
        family.push(CHINESE.into());
    }
    ctx.set_fonts(fonts);
    for theme in [Theme::Dark, Theme::Light] {
        ctx.style_mut_of(theme, |style| {
            style.spacing.item_spacing = vec2(6.0, 5.0);
            style.spacing.button_padding = vec2(7.0, 3.0);
            style.spacing.interact_size.y = 22.0;
            for (text, points) in &SIZES {
                style.text_styles.insert(text.clone(), FontId::new(*points, family(text)));
            }
            let words = if theme == Theme::Dark { &DARK } else { &LIGHT };
            let visuals = &mut style.visuals;
            visuals.widgets.noninteractive.fg_stroke.color = words.plain;
            visuals.widgets.inactive.fg_stroke.color = words.strong;
            visuals.weak_text_color = Some(words.weak);
            visuals.error_fg_color = words.wrong;
            visuals.warn_fg_color = words.attention;
            visuals.hyperlink_color = words.accent;
            visuals.selection.bg_fill = words.selected;
            visuals.selection.stroke = Stroke::new(1.0, words.on_selected);
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

fn family(text: &TextStyle) -> FontFamily {
    if *text == TextStyle::Monospace { FontFamily::Monospace } else { FontFamily::Proportional }
}

/// A heading of a group.
pub fn heading(ui: &mut egui::Ui, text: &str) {
    ui.add_space(6.0);
    ui.label(egui::RichText::new(text).strong().size(14.5));
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of a colour (WCAG 2.1).
    fn luminance(color: Color32) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
        };
        let [r, g, b, a] = color.to_array();
        assert_eq!(a, 255, "{color:?} lets through what is behind it");
        0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)
    }

    #[test]
    fn words_can_be_read_in_either_theme() {
        let ctx = egui::Context::default();
        install(&ctx);
        for theme in [Theme::Dark, Theme::Light] {
            let style = ctx.style_of(theme);
            let v = &style.visuals;
            let words = [v.text_color(), v.weak_text_color(), v.error_fg_color, v.warn_fg_color, v.hyperlink_color];
            for behind in [v.panel_fill, v.window_fill, v.selection.bg_fill, v.panel_fill.blend(v.faint_bg_color)] {
                for word in words {
                    let (a, b) = (luminance(word), luminance(behind));
                    let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
                    assert!(contrast >= 4.5, "{theme:?}: {word:?} on {behind:?}: {contrast:.2}");
                }
            }
            let pairs = [
                (v.selection.stroke.color, v.selection.bg_fill),
                (v.widgets.inactive.fg_stroke.color, v.widgets.inactive.weak_bg_fill),
                (v.widgets.hovered.fg_stroke.color, v.widgets.hovered.weak_bg_fill),
                (v.widgets.active.fg_stroke.color, v.widgets.active.weak_bg_fill),
            ];
            for (word, behind) in pairs {
                let (a, b) = (luminance(word), luminance(behind));
                assert!((a.max(b) + 0.05) / (a.min(b) + 0.05) >= 4.5, "{theme:?}: {word:?} on {behind:?}");
            }
            assert!(style.text_styles.values().all(|font| font.size >= SMALLEST));
        }
    }

    /// Nobody sees a box instead of a word, whatever fonts the machine has.
    #[test]
    fn every_word_of_every_language_can_be_drawn() {
        let ctx = egui::Context::default();
        install(&ctx);
        ctx.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/text");
        let mut seen = std::collections::BTreeSet::new();
        let languages = std::fs::read_dir(root).expect("the words").map(|entry| entry.expect("readable").path());
        for language in languages.filter(|path| path.is_dir()) {
            for file in std::fs::read_dir(language).expect("readable") {
                seen.extend(std::fs::read_to_string(file.expect("readable").path()).expect("text").chars());
            }
        }
        for family in [egui::FontFamily::Proportional, egui::FontFamily::Monospace] {
            let font = egui::FontId::new(13.0, family);
            let drawn = |c: &char| ctx.fonts_mut(|fonts| fonts.has_glyph(&font, *c));
            let missing: String = seen.iter().filter(|c| !c.is_control() && !drawn(c)).collect();
            assert!(missing.is_empty(), "{missing}");
        }
    }
}
