//! Fields that say how lines are laid, for the job and for recipes: the strategy and its settings.

use super::super::theme;
use super::entry::{Entry, refused};
use super::fields::{Change, NAMES, Owner, back, name};
use crate::document::StartFrom;
use crate::path::{Direction, Order, Strategy};
use crate::text::{Sentence as _, choices, say};
use eframe::egui::{self, ComboBox, RichText, Role, WidgetInfo};

/// How lines are laid.
pub(super) fn strategy(
    ui: &mut egui::Ui,
    owner: Owner,
    now: Strategy,
    to: Option<Strategy>,
) -> Option<Change<Strategy>> {
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(laying_strategy), to.is_some_and(|to| to != now)).on_hover_text(say!(laying_strategy_tip));
        let combo = ComboBox::from_id_salt((owner, "strategy")).width(96.0).selected_text(choices::strategy(now));
        let shown = combo.show_ui(ui, |ui| {
            for s in Strategy::ALL {
                let (strategy, hint) = (choices::strategy(s), choices::strategy_hint(s));
                let row = ui.selectable_label(s == now, say!(laying_strategy_row, strategy, hint));
                if row.clicked() && s != now {
                    wanted = Some(Change::To(s));
                }
            }
        });
        let told = || owner.told(say!(laying_strategy_name));
        let response = shown.response.on_hover_text(choices::strategy_hint(now));
        response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, told()));
        if let Some(to) = to
            && back(ui, owner, &say!(laying_strategy_name), &choices::strategy(to))
        {
            wanted = Some(Change::Back);
        }
    });
    wanted
}

/// Normal of the section planes.
pub(super) fn direction(
    ui: &mut egui::Ui,
    owner: Owner,
    now: Direction,
    to: Option<Direction>,
) -> Option<Change<Direction>> {
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(laying_direction), to.is_some_and(|to| to != now)).on_hover_text(say!(laying_direction_tip));
        for direction in Direction::AXES.map(|(_, axis)| axis).into_iter().chain([Direction::Auto]) {
            let word = choices::direction(direction);
            let button = ui.selectable_label(now == direction, &word);
            let told = || owner.told(say!(laying_direction_choice, direction = &word));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, now == direction, told()));
            if button.clicked() && now != direction {
                wanted = Some(Change::To(direction));
            }
        }
        if let Some(to) = to
            && back(ui, owner, &say!(laying_direction_name), &choices::direction(to))
        {
            wanted = Some(Change::Back);
        }
    });
    let Direction::Along(mut v) = now else { return wanted };
    let mut drawn = Vec::new();
    ui.horizontal(|ui| {
        theme::name(ui, &say!(laying_vector), NAMES);
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let shown = Entry { speed: 0.01, ..Entry::new(-1.0..=1.0, String::new()) }.show(ui, &mut v[k]);
            let told = || owner.told(say!(laying_vector_name, axis));
            shown.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told()));
            if shown.response.changed() && v.iter().any(|c| c.abs() > 1e-6) {
                wanted = Some(Change::To(Direction::Along(v)));
            }
            drawn.push(shown);
        }
    });
    refused(ui, &drawn);
    wanted
}

/// Sense and order of the lines.
pub(super) fn order(
    ui: &mut egui::Ui,
    owner: Owner,
    strategy: Strategy,
    now: Order,
    to: Option<Order>,
) -> Option<Change<Order>> {
    // The pieces of a spiral have a sense of their own.
    let is_spiral = strategy == Strategy::Spiral;
    let turns: &[Order] = match strategy {
        Strategy::Spiral => &[Order::Zigzag, Order::Shortest],
        _ => &[Order::Zigzag, Order::OneWay, Order::Shortest],
    };
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(laying_lines), to.is_some_and(|to| to != now)).on_hover_text(say!(laying_lines_tip));
        for &order in turns {
            let on = now == order || is_spiral && order == Order::Zigzag && now == Order::OneWay;
            let is_in_turn = is_spiral && order == Order::Zigzag;
            let word = if is_in_turn { say!(laying_in_turn) } else { choices::order(order) };
            let button = ui.selectable_label(on, &word);
            if owner != Owner::Job {
                let told = || owner.told(say!(laying_order_choice, order = &word));
                button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, on, told()));
            }
            if button.clicked() && !on {
                wanted = Some(Change::To(order));
            }
        }
        if let Some(to) = to
            && back(ui, owner, &say!(laying_order_name), &choices::order(to))
        {
            wanted = Some(Change::Back);
        }
    });
    wanted
}

/// The border that offset lines start from, or the whole outline; `to`: what it can go back to.
pub(super) fn border(
    ui: &mut egui::Ui,
    owner: Owner,
    now: StartFrom,
    to: Option<StartFrom>,
) -> Option<Change<StartFrom>> {
    let (mut wanted, mut drawn) = (None, None);
    ui.horizontal(|ui| {
        let label = name(ui, &say!(laying_start_from), to.is_some_and(|to| to != now));
        label.on_hover_text(say!(laying_start_from_tip));
        let mut whole = now == StartFrom::Whole;
        let check = ui.checkbox(&mut whole, say!(laying_whole_outline));
        let told = || owner.told(say!(laying_whole_outline));
        check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, whole, told()));
        if check.changed() {
            wanted = Some(Change::To(if whole { StartFrom::Whole } else { StartFrom::Border(0) }));
        }
        if let StartFrom::Border(index) = now {
            let mut number = f64::from(index.saturating_add(1));
            let prefix = say!(laying_border_prefix);
            let field = Entry { speed: 0.05, decimals: 0, prefix, ..Entry::new(1.0..=1000.0, String::new()) };
            let shown = field.show(ui, &mut number);
            let told = || owner.told(say!(laying_border_name));
            shown.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told()));
            if shown.response.changed() {
                wanted = Some(Change::To(StartFrom::Border((number.round() as u32).saturating_sub(1))));
            }
            drawn = Some(shown);
        }
        if let Some(to) = to
            && back(ui, owner, &say!(laying_border_name), &to.sentence())
        {
            wanted = Some(Change::Back);
        }
    });
    refused(ui, &drawn);
    wanted
}

/// Whether a spiral runs inwards.
pub(super) fn inward(ui: &mut egui::Ui, owner: Owner, now: bool, to: Option<bool>) -> Option<Change<bool>> {
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(laying_spiral_runs), to.is_some_and(|to| to != now));
        for sense in [false, true] {
            let button = ui.selectable_label(now == sense, choices::spiral_sense(sense));
            let told = || owner.told(choices::spiral_sense(sense));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, now == sense, told()));
            if button.clicked() && now != sense {
                wanted = Some(Change::To(sense));
            }
        }
        if let Some(to) = to
            && back(ui, owner, &say!(laying_spiral_name), &choices::spiral_sense(to))
        {
            wanted = Some(Change::Back);
        }
    });
    wanted
}

/// The centre of a spiral; returns whether the way back was taken. `is_set`: the owner has a centre of its own.
pub(super) fn centre(ui: &mut egui::Ui, owner: Owner, now: Option<[f64; 3]>, is_set: bool) -> bool {
    let row = ui.horizontal(|ui| {
        let tip = say!(laying_centre_tip);
        name(ui, &say!(laying_centre), is_set).on_hover_text(&tip);
        ui.label(now.map_or_else(|| say!(laying_centre_middle), choices::place)).on_hover_text(tip);
        is_set && back(ui, owner, &say!(laying_centre_name), "")
    });
    if now.is_none() {
        ui.label(RichText::new(say!(laying_centre_how)).small().weak());
    }
    row.inner
}
