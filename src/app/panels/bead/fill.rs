//! P3's relation between a bead's size and the distance of centres: which of them would make beads fill their layer.

use super::super::fields::{Owner, SPACING};
use super::group::LEAST_MM;
use crate::document::{Job, Parameter};
use crate::process::bead::Bead;
use crate::text::{fixed, say};
use eframe::egui::{self, RichText, Role, WidgetInfo};

const WIDTH: &Parameter = Parameter::named("bead.width_mm");
const HEIGHT: &Parameter = Parameter::named("bead.height_mm");
/// From this relative difference on, a word is said of a spacing at which the beads do not fill their layer.
const OTHER_SPACING: f64 = 0.005;

/// What is changed so that beads fill their layer.
#[derive(Clone, Copy)]
enum Measure {
    Spacing,
    Height,
    Width,
}

impl Measure {
    /// Text, name and tip of the button that sets it.
    fn words(self, mm: f64) -> [String; 3] {
        let mm = &fixed(mm, 2);
        match self {
            Measure::Spacing => {
                [say!(bead_panel_spacing, mm), say!(bead_panel_take_spacing, mm), say!(bead_panel_spacing_tip)]
            }
            Measure::Height => {
                [say!(bead_panel_height, mm), say!(bead_panel_take_height, mm), say!(bead_panel_height_tip)]
            }
            Measure::Width => [say!(bead_panel_width, mm), say!(bead_panel_take_width, mm), say!(bead_panel_width_tip)],
        }
    }
}

/// How beads fill their layer at the spacing that is set, and buttons for what would fill it; returns key and value of
/// what was clicked.
pub(super) fn fill(ui: &mut egui::Ui, owner: Owner, job: &Job) -> Option<(&'static str, f64)> {
    let bead = job.section_of_bead()?;
    let (spacing_mm, own_mm) = (job.layers.spacing_mm, bead.spacing_mm());
    if (spacing_mm / own_mm - 1.0).abs() <= OTHER_SPACING {
        ui.label(RichText::new(say!(bead_panel_filled)).small());
        return None;
    }
    let mean_mm = bead.area_mm2() / spacing_mm;
    let text = say!(bead_panel_not_filled, mean = fixed(mean_mm, 2), planned = fixed(bead.height_mm(), 2));
    ui.label(RichText::new(text).color(ui.visuals().warn_fg_color));
    let ways = [
        (Measure::Spacing, SPACING, Some(own_mm)),
        (Measure::Height, HEIGHT, Bead::of_width(bead.width_mm(), spacing_mm).map(|b| b.height_mm())),
        (Measure::Width, WIDTH, Bead::of_height(bead.height_mm(), spacing_mm).map(|b| b.width_mm())),
    ];
    let mut taken = None;
    ui.horizontal_wrapped(|ui| {
        for (measure, p, mm) in ways {
            // A micrometre is more than anybody can set.
            let mm = mm.map(|mm| (mm * 1e3).round() / 1e3);
            let may = |mm: &f64| *mm >= LEAST_MM && p.check(*mm).is_ok();
            let Some(mm) = mm.filter(may) else { continue };
            let [text, told, tip] = measure.words(mm);
            let button = ui.button(text).on_hover_text(tip);
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, owner.told(told.clone())));
            if button.clicked() {
                taken = Some((p.key, mm));
            }
        }
    });
    taken
}
