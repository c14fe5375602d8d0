//! The robot cell: which robot, what it carries, in which language its program is written.

use super::super::actions::Actions;
use super::super::command::Command;
use super::super::context::Context;
use super::super::dialogs::Purpose;
use super::super::theme;
use super::{frames, numbers};
use crate::cell::{Mount, Robot, Spin};
use crate::document::Edit;
use crate::document::parameter::Group;
use crate::program::dialects::{self, DIALECTS};
use crate::text::{Sentence, choices, say};
use eframe::egui::{self, ComboBox, RichText};

const WIDTH: f32 = 170.0;

pub(super) fn ui(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    theme::heading(ui, &say!(cell_panel_heading));
    robot(ui, context, actions);
    mount(ui, context, actions);
    spin(ui, context, actions);
    numbers::of_job(ui, Group::Cell, context, actions);
    dialect(ui, context, actions);
    cell_file(ui, context, actions);
    frames::ui(ui, context, actions);
    better_setup(ui, context, actions);
}

fn robot(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let now = &context.document.job().cell.robot;
    let shown = match context.derived.pipeline.setup() {
        _ if now.is_empty() => say!(cell_panel_no_robot),
        Some(Ok(setup)) => setup.robot_name().to_owned(),
        _ => now.clone(),
    };
    ui.horizontal(|ui| {
        let label = theme::name(ui, &say!(cell_panel_robot), 90.0);
        let combo = ComboBox::from_id_salt("robot").width(WIDTH).selected_text(shown).show_ui(ui, |ui| {
            if ui.selectable_label(now.is_empty(), say!(cell_panel_no_robot)).clicked() {
                actions.robot(String::new());
            }
            for key in Robot::shipped() {
                let name = Robot::load(key, None).map_or_else(|_| key.to_owned(), |r| r.name);
                if ui.selectable_label(now == key, name).clicked() {
                    actions.robot(key.to_owned());
                }
            }
            if ui.selectable_label(false, say!(cell_panel_robot_file)).clicked() {
                actions.ask(Purpose::Robot);
            }
        });
        combo.response.labelled_by(label.id).on_hover_text(say!(cell_panel_robot_tip));
    });
    let Some(Ok(setup)) = context.derived.pipeline.setup() else { return };
    let unverified = setup.robot.as_ref().map_or(&[][..], |r| &r.unverified);
    if !unverified.is_empty() {
        let text = RichText::new(say!(cell_panel_unverified)).small().color(ui.visuals().warn_fg_color);
        ui.label(text).on_hover_text(format!("{}\n{}", say!(cell_panel_unverified_tip), unverified.join("\n")));
    }
}

fn mount(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let Some(Ok(setup)) = context.derived.pipeline.setup() else { return };
    let options = [
        (Mount::PartInHand, say!(cell_panel_the_part), say!(cell_panel_carries_part)),
        (Mount::ToolInHand, say!(cell_panel_the_head), say!(cell_panel_carries_head)),
    ];
    let label = [say!(cell_panel_carries), say!(cell_panel_carries_tip)];
    if let Some(mount) = choice(ui, label, options, setup.mount) {
        actions.edit(Edit::Mount(mount));
    }
}

fn spin(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let option = |s: Spin| (s, choices::spin(s), say!(cell_panel_spin_name, spin = choices::spin(s)));
    let label = [say!(cell_panel_spin), say!(cell_panel_spin_tip)];
    let now = context.document.job().cell.spin;
    if let Some(spin) = choice(ui, label, [Spin::Free, Spin::Travel].map(option), now) {
        actions.edit(Edit::Spin(spin));
    }
}

fn dialect(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    let now = &context.document.job().cell.dialect;
    ui.horizontal(|ui| {
        let label = theme::name(ui, &say!(cell_panel_program_for), 90.0);
        let combo = ComboBox::from_id_salt("dialect").width(WIDTH).selected_text(now).show_ui(ui, |ui| {
            for word in DIALECTS.iter().map(|d| d.name()) {
                if ui.selectable_label(now == word, word).clicked() {
                    actions.edit(Edit::Dialect(word.to_owned()));
                }
            }
        });
        let mut tip = say!(cell_panel_program_for_tip);
        let unverified = match (dialects::by_name(now), context.derived.pipeline.setup()) {
            (Some(dialect), Some(Ok(setup))) => dialect.unverified(setup),
            _ => Vec::new(),
        };
        if !unverified.is_empty() {
            tip = format!("{tip}\n{}\n{}", say!(cell_panel_words_unverified), unverified.join("\n"));
        }
        combo.response.labelled_by(label.id).on_hover_text(tip);
    });
}

fn cell_file(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        theme::name(ui, &say!(cell_panel_frames), 90.0).on_hover_text(say!(cell_panel_frames_tip));
        if ui.button(say!(cell_panel_cell_file)).clicked() {
            actions.ask(Purpose::Cell);
        }
    });
    match context.derived.pipeline.setup() {
        Some(Ok(setup)) => {
            // What a shipped cell is called tells of its own mount, whatever the job's is.
            let is_shipped = context.document.job().cell.file.is_empty();
            let name = if is_shipped { say!(cell_panel_shipped_cell) } else { setup.cell.name.clone() };
            ui.label(RichText::new(name).small().weak())
        }
        Some(Err(why)) => ui.label(RichText::new(why.sentence()).color(ui.visuals().error_fg_color)),
        None => return,
    };
}

fn better_setup(ui: &mut egui::Ui, context: Context<'_>, actions: &mut Actions) {
    if context.document.job().cell.robot.is_empty() {
        return;
    }
    ui.add_space(2.0);
    let button = egui::Button::new(Command::BetterSetup.name());
    let response = ui.add_enabled(context.is_enabled(Command::BetterSetup), button);
    let response = response.on_hover_text(say!(cell_panel_better_tip));
    let is_better_setup_sought = context.derived.suggestions.is_better_setup_sought();
    let why = if is_better_setup_sought { say!(cell_panel_better_running) } else { say!(cell_panel_nothing_refused) };
    if response.on_disabled_hover_text(why).clicked() {
        actions.command(Command::BetterSetup);
    }
    ui.add_space(4.0);
}

/// One of two values, each with its word and its accessible name, behind a name with a tip.
fn choice<T: Copy + PartialEq>(
    ui: &mut egui::Ui,
    [name, tip]: [String; 2],
    options: [(T, String, String); 2],
    now: T,
) -> Option<T> {
    let mut chosen = None;
    ui.horizontal(|ui| {
        theme::name(ui, &name, 90.0).on_hover_text(tip);
        for (value, word, told) in options {
            let button = ui.selectable_label(now == value, word);
            let is_on = now == value;
            button.widget_info(|| egui::WidgetInfo::selected(egui::Role::RadioButton, true, is_on, told.clone()));
            if button.clicked() {
                chosen = Some(value);
            }
        }
    });
    chosen
}
