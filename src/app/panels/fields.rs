//! Fields that the job's panel and that of a recipe share: what they show, and what the operator wants.

use super::super::{quantity, theme};
use crate::document::{Job, Parameter};
use crate::text::{exact, say};
use eframe::egui::{self, DragValue, RichText, Role, WidgetInfo, vec2};

/// What is wanted of a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change<T> {
    /// Another one.
    To(T),
    /// What it goes back to.
    Back,
}

/// Whose value a field shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Owner {
    /// The job.
    Job,
    /// A recipe.
    Recipe,
    /// One surface.
    Surface,
}

impl Owner {
    /// A field's name where names are read out, so that fields of one name can be told apart.
    pub fn told(self, what: String) -> String {
        match self {
            Owner::Job => what,
            Owner::Recipe => say!(field_of_recipe, what),
            Owner::Surface => say!(field_of_surface, what),
        }
    }

    /// What a value goes back to.
    fn back(self, to: &str) -> String {
        match self {
            Owner::Job => say!(field_back, to),
            Owner::Recipe => say!(field_back_to_job, to),
            Owner::Surface => say!(field_back_to_recipe_or_job),
        }
    }
}

/// Numbers that are whole.
const WHOLE: [&str; 2] = ["layers.passes", "bead.layers"];

/// Width of the names.
pub(super) const NAMES: f32 = 130.0;

/// The name of a field, with a dot where its value is another than the one it goes back to.
pub(super) fn name(ui: &mut egui::Ui, text: &str, is_changed: bool) -> egui::Response {
    let label = theme::name(ui, text, NAMES);
    if is_changed {
        ui.painter().circle_filled(label.rect.left_center() - vec2(5.0, 0.0), 2.5, theme::ACCENT);
    }
    label
}

/// A way back; whether it was taken.
pub(super) fn back(ui: &mut egui::Ui, owner: Owner, what: &str, to: &str) -> bool {
    let reset = ui.small_button("↺").on_hover_text(owner.back(to));
    reset.widget_info(|| WidgetInfo::labeled(Role::Button, true, owner.told(say!(field_reset, what))));
    reset.clicked()
}

/// A number of the table; `to`: what it can go back to.
pub(super) fn number(
    ui: &mut egui::Ui,
    owner: Owner,
    p: &'static Parameter,
    now: f64,
    to: Option<f64>,
) -> Option<Change<f64>> {
    let (low, high) = p.range;
    let low = if p.least_allowed { low } else { low + 1e-6 * (high - low).min(1000.0) };
    number_from(ui, owner, p, low, now, to)
}

/// The same from another least value on.
pub(super) fn number_from(
    ui: &mut egui::Ui,
    owner: Owner,
    p: &'static Parameter,
    low: f64,
    now: f64,
    to: Option<f64>,
) -> Option<Change<f64>> {
    let (mut value, mut wanted) = (now, None);
    let high = p.range.1;
    let is_whole = WHOLE.contains(&p.key);
    let far = |to: f64| (now - to).abs() > 1e-12;
    ui.horizontal(|ui| {
        let label = name(ui, p.label, to.is_some_and(far));
        let suffix = match p.unit {
            "°" | "" => p.unit.into(),
            unit => format!(" {unit}"),
        };
        let field = DragValue::new(&mut value)
            .speed(if is_whole { 0.05 } else { (now.abs() * 0.01).clamp(0.001, 1.0) })
            .range(low..=high)
            .max_decimals(if is_whole { 0 } else { 4 })
            .suffix(suffix)
            .update_while_editing(false)
            .custom_parser(quantity::read);
        let mut tip = format!("{}\n{low:.4} to {high} {}", p.meaning, p.unit);
        if !p.symbol.is_empty() {
            tip.push_str(&format!("\n{}", p.symbol));
        }
        let response = ui.add_sized([96.0, 20.0], field).on_hover_text(&tip);
        if owner == Owner::Job {
            response.clone().labelled_by(label.id);
        } else {
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, owner.told(p.label.into())));
        }
        label.on_hover_text(tip);
        if response.changed() && value != now && value.is_finite() {
            wanted = Some(Change::To(value));
        }
        if let Some(to) = to
            && back(ui, owner, p.label, &format!("{} {}", exact(to), p.unit))
        {
            wanted = Some(Change::Back);
        }
    });
    if let Err(why) = p.check(now) {
        ui.label(RichText::new(why).small().color(theme::WRONG));
    }
    wanted
}

/// The overlap of neighbouring spots; the spacing that is wanted by it, mm.
pub(super) fn overlap(ui: &mut egui::Ui, owner: Owner, job: &Job) -> Option<f64> {
    let now = job.overlap_percent();
    let mut percent = now;
    let response = ui.horizontal(|ui| {
        let tip = match job.section_of_bead() {
            Some(_) => say!(laying_overlap_beads),
            None => say!(laying_overlap_spots),
        };
        let label = name(ui, &say!(laying_overlap), false).on_hover_text(&tip);
        let field = DragValue::new(&mut percent)
            .speed(0.5)
            .range(0.0..=95.0)
            .clamp_existing_to_range(false)
            .max_decimals(1)
            .suffix(say!(unit_percent))
            .update_while_editing(false)
            .custom_parser(quantity::read);
        let response = ui.add_sized([96.0, 20.0], field).on_hover_text(tip);
        if owner == Owner::Job {
            response.clone().labelled_by(label.id);
        } else {
            let told = || owner.told(say!(laying_overlap));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told()));
        }
        response
    });
    let changed = response.inner.changed() && percent != now;
    // Six digits: what is typed as 30 % is 0.7 mm, not 0.7 and a bit.
    let rounded = |mm: f64| (mm * 1e6).round() * 1e-6;
    if changed { job.spacing_of_overlap(percent).ok().map(rounded) } else { None }
}
