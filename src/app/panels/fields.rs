//! Fields that the job's panel and that of a recipe share: what they show, and what the operator wants.

use super::super::theme;
use super::entry::{Entry, refused};
use crate::document::job_recipes::OVERLAP_PERCENT;
use crate::document::parameter::Limits;
use crate::document::{Job, Parameter};
use crate::text::parameter::{hint, label, with_unit};
use crate::text::{Sentence as _, say};
use eframe::egui::{self, RichText, Role, WidgetInfo, vec2};

/// What the operator did to a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Change<T> {
    /// Set it to this.
    To(T),
    /// Took the way back to what it would be otherwise.
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

    /// Tip of the way back: whose value it leads to.
    fn back(self, to: &str) -> String {
        match self {
            Owner::Job => say!(field_back, to),
            Owner::Recipe => say!(field_back_to_job, to),
            Owner::Surface => say!(field_back_to_recipe_or_job),
        }
    }
}

/// The row of the spacing, which an overlap sets too.
pub(super) const SPACING: &Parameter = Parameter::named("layers.spacing_mm");

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

/// The button of the way back; returns whether it was clicked.
pub(super) fn back(ui: &mut egui::Ui, owner: Owner, what: &str, to: &str) -> bool {
    let reset = ui.small_button("↺").on_hover_text(owner.back(to));
    reset.widget_info(|| WidgetInfo::labeled(Role::Button, true, owner.told(say!(field_reset, what))));
    reset.clicked()
}

/// Size of a number's field.
const FIELD: [f32; 2] = [96.0, 20.0];

/// A number of the table; `to`: what it can go back to.
pub(super) fn number(
    ui: &mut egui::Ui,
    owner: Owner,
    p: &'static Parameter,
    now: f64,
    to: Option<f64>,
) -> Option<Change<f64>> {
    let Limits { least, greatest, is_above_least } = p.limits;
    let low = if is_above_least { least + 1e-6 * (greatest - least).min(1000.0) } else { least };
    number_from(ui, owner, p, low, now, to)
}

/// A number of the table that begins at another least value.
pub(super) fn number_from(
    ui: &mut egui::Ui,
    owner: Owner,
    p: &'static Parameter,
    low: f64,
    now: f64,
    to: Option<f64>,
) -> Option<Change<f64>> {
    let (mut value, mut wanted, mut drawn) = (now, None, None);
    let (title, unit) = (label(p), p.kind.unit());
    let far = |to: f64| (now - to).abs() > 1e-12;
    ui.horizontal(|ui| {
        let label = name(ui, &title, to.is_some_and(far));
        let suffix = match unit {
            "°" | "" => unit.into(),
            unit => format!(" {unit}"),
        };
        let field = Entry {
            speed: p.kind.drag_step(now),
            decimals: p.kind.decimals(),
            size: Some(FIELD),
            ..Entry::new(low..=p.limits.greatest, suffix)
        };
        let tip = hint(p, low);
        let shown = field.show(ui, &mut value);
        let response = shown.response.clone().on_hover_text(&tip);
        drawn = Some(shown);
        if owner == Owner::Job {
            response.clone().labelled_by(label.id);
        } else {
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, owner.told(title.clone())));
        }
        label.on_hover_text(tip);
        if p.kind.is_whole() {
            value = value.round();
        }
        if response.changed() && value != now {
            wanted = Some(Change::To(value));
        }
        if let Some(to) = to
            && back(ui, owner, &title, &with_unit(to, p.kind))
        {
            wanted = Some(Change::Back);
        }
    });
    refused(ui, &drawn);
    if let Err(why) = p.check(now) {
        ui.label(RichText::new(why.sentence()).small().color(ui.visuals().error_fg_color));
    }
    wanted
}

/// The field of the overlap of neighbouring spots; returns the spacing that was asked for by it, mm.
pub(super) fn overlap(ui: &mut egui::Ui, owner: Owner, job: &Job) -> Option<f64> {
    let now = job.overlap_percent();
    let mut percent = now;
    let row = ui.horizontal(|ui| {
        let tip = match job.section_of_bead() {
            Some(_) => say!(laying_overlap_beads),
            None => say!(laying_overlap_spots),
        };
        let label = name(ui, &say!(laying_overlap), false).on_hover_text(&tip);
        let field = Entry { decimals: 1, size: Some(FIELD), ..Entry::new(OVERLAP_PERCENT, say!(unit_percent)) };
        let drawn = field.show(ui, &mut percent);
        let response = drawn.response.clone().on_hover_text(tip);
        if owner == Owner::Job {
            response.clone().labelled_by(label.id);
        } else {
            let told = || owner.told(say!(laying_overlap));
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told()));
        }
        drawn
    });
    refused(ui, [&row.inner]);
    let changed = row.inner.response.changed() && percent != now;
    // Six digits: what is typed as 30 % is 0.7 mm, not 0.7 and a bit.
    let rounded = |mm: f64| (mm * 1e6).round() * 1e-6;
    if changed { job.spacing_of_overlap(percent).ok().map(rounded) } else { None }
}
