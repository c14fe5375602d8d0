//! How beads and areas without height are ground, and how the tool is led.

use super::super::super::actions::Actions;
use super::super::super::context::Context;
use super::super::super::theme;
use super::super::numbers;
use crate::document::WeldEdit;
use crate::document::model::GrindingStrategy;
use crate::document::parameter::Group;
use crate::text::say;
use crate::weld::bead::AreaKind;
use eframe::egui::{self, CollapsingHeader, Role, WidgetInfo};

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(weld_panel_strategy));
    let weld = &context.document.job().weld;
    for kind in [AreaKind::Bead, AreaKind::Flat] {
        let now = weld.strategy_of(kind == AreaKind::Bead);
        ui.label(title(kind));
        ui.horizontal_wrapped(|ui| {
            // Only a bead has a centre line.
            let all = GrindingStrategy::ALL.into_iter();
            for strategy in all.filter(|s| kind == AreaKind::Bead || *s != GrindingStrategy::Along) {
                let button = ui.selectable_label(now == strategy, name(strategy)).on_hover_text(hint(strategy));
                let told = || say!(weld_panel_strategy_name, what = title(kind), strategy = name(strategy));
                button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, now == strategy, told()));
                if button.clicked() {
                    actions.grind(edit(kind, strategy));
                }
            }
        });
    }
    CollapsingHeader::new(say!(weld_panel_tool_numbers)).id_salt("how the tool is led").show(ui, |ui| {
        numbers::of_job(ui, Group::Grinding, context, actions);
    });
}

/// The edit that grinds areas of a kind otherwise.
pub(super) fn edit(kind: AreaKind, strategy: GrindingStrategy) -> WeldEdit {
    match kind {
        AreaKind::Bead => WeldEdit::BeadStrategy(strategy),
        AreaKind::Flat => WeldEdit::Strategy(strategy),
    }
}

/// The name of a strategy.
pub(super) fn name(strategy: GrindingStrategy) -> String {
    match strategy {
        GrindingStrategy::OneWay => say!(weld_panel_one_way),
        GrindingStrategy::Zigzag => say!(weld_panel_zigzag),
        GrindingStrategy::Spiral => say!(weld_panel_spiral),
        GrindingStrategy::Along => say!(weld_panel_along),
    }
}

/// Areas of a kind, as a title.
pub(super) fn title(kind: AreaKind) -> String {
    match kind {
        AreaKind::Bead => say!(weld_panel_beads),
        AreaKind::Flat => say!(weld_panel_defects),
    }
}

fn hint(strategy: GrindingStrategy) -> String {
    match strategy {
        GrindingStrategy::OneWay => say!(weld_panel_one_way_hint),
        GrindingStrategy::Zigzag => say!(weld_panel_zigzag_hint),
        GrindingStrategy::Spiral => say!(weld_panel_spiral_hint),
        GrindingStrategy::Along => say!(weld_panel_along_hint),
    }
}
