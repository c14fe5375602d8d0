//! Fields of how lines are laid, for the job and for recipes: the strategy, and what concerns it.

use super::super::theme;
use super::fields::{Change, NAMES, Owner, back, name};
use crate::document::StartFrom;
use crate::document::recipe_table::place;
use crate::path::{Direction, Order, Strategy};
use crate::text::Sentence;
use eframe::egui::{self, ComboBox, DragValue, RichText, Role, WidgetInfo};

/// What a strategy is for, in a few words.
fn hint(strategy: Strategy) -> &'static str {
    match strategy {
        Strategy::Planes => "parallel planes, equally far apart",
        Strategy::Adaptive => "planes, closer together on slopes",
        Strategy::Offset => "lines that follow the border",
        Strategy::Spiral => "one line, the laser stays on",
        Strategy::Cross => "two rasters across each other",
    }
}

/// How lines are laid.
pub(super) fn strategy(
    ui: &mut egui::Ui,
    owner: Owner,
    now: Strategy,
    to: Option<Strategy>,
) -> Option<Change<Strategy>> {
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, "Strategy", to.is_some_and(|to| to != now)).on_hover_text("How lines are laid on a surface");
        let combo = ComboBox::from_id_salt(format!("{}strategy", owner.prefix)).width(96.0).selected_text(now.word());
        let shown = combo.show_ui(ui, |ui| {
            for s in Strategy::ALL {
                if ui.selectable_label(s == now, format!("{} – {}", s.word(), hint(s))).clicked() && s != now {
                    wanted = Some(Change::To(s));
                }
            }
        });
        let told = format!("{}strategy", owner.prefix);
        shown.response.on_hover_text(hint(now)).widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, told.clone()));
        if let Some(to) = to
            && back(ui, owner, "strategy", to.word())
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
        name(ui, "Direction", to.is_some_and(|to| to != now)).on_hover_text("Normal of the section planes");
        for (word, direction) in Direction::AXES.into_iter().chain([("auto", Direction::Auto)]) {
            let button = ui.selectable_label(now == direction, word);
            let told = format!("{}direction {word}", owner.prefix);
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, now == direction, told.clone()));
            if button.clicked() && now != direction {
                wanted = Some(Change::To(direction));
            }
        }
        if let Some(to) = to
            && back(ui, owner, "direction", &to.to_string())
        {
            wanted = Some(Change::Back);
        }
    });
    let Direction::Along(mut v) = now else { return wanted };
    ui.horizontal(|ui| {
        theme::name(ui, "Vector", NAMES);
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let field = DragValue::new(&mut v[k]).speed(0.01).range(-1.0..=1.0).max_decimals(3);
            let response = ui.add(field);
            let told = format!("{}direction vector {axis}", owner.prefix);
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told.clone()));
            if response.changed() && v.iter().any(|c| c.abs() > 1e-6) {
                wanted = Some(Change::To(Direction::Along(v)));
            }
        }
    });
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
    let turns: &[(Order, &str)] = match strategy {
        Strategy::Spiral => &[(Order::Zigzag, "in turn"), (Order::Shortest, "shortest")],
        _ => &[(Order::Zigzag, "zigzag"), (Order::OneWay, "one-way"), (Order::Shortest, "shortest")],
    };
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, "Lines", to.is_some_and(|to| to != now)).on_hover_text("In which order and sense lines are run");
        for &(order, word) in turns {
            let on = now == order || strategy == Strategy::Spiral && order == Order::Zigzag && now == Order::OneWay;
            let button = ui.selectable_label(on, word);
            if !owner.prefix.is_empty() {
                let told = format!("{}order {word}", owner.prefix);
                button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, on, told.clone()));
            }
            if button.clicked() && !on {
                wanted = Some(Change::To(order));
            }
        }
        if let Some(to) = to
            && back(ui, owner, "order", to.word())
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
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, "Start from", to.is_some_and(|to| to != now)).on_hover_text(
            "The loops of the outline are counted from the longest, which is 1.\n\
             Right click near one on the part: Offset from this border",
        );
        let mut whole = now == StartFrom::Whole;
        let check = ui.checkbox(&mut whole, "whole outline");
        let told = format!("{}whole outline", owner.prefix);
        check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, whole, told.clone()));
        if check.changed() {
            wanted = Some(Change::To(if whole { StartFrom::Whole } else { StartFrom::Border(0) }));
        }
        if let StartFrom::Border(index) = now {
            let mut number = index.saturating_add(1);
            let response = ui.add(DragValue::new(&mut number).speed(0.05).range(1..=1000).prefix("border "));
            let told = format!("{}border", owner.prefix);
            response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told.clone()));
            if response.changed() {
                wanted = Some(Change::To(StartFrom::Border(number.saturating_sub(1))));
            }
        }
        if let Some(to) = to
            && back(ui, owner, "border", &to.sentence())
        {
            wanted = Some(Change::Back);
        }
    });
    wanted
}

/// Whether a spiral runs inwards.
pub(super) fn inward(ui: &mut egui::Ui, owner: Owner, now: bool, to: Option<bool>) -> Option<Change<bool>> {
    let word = |inward: bool| if inward { "inwards" } else { "outwards" };
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, "Spiral runs", to.is_some_and(|to| to != now));
        for sense in [false, true] {
            let button = ui.selectable_label(now == sense, word(sense));
            let told = format!("{}{}", owner.prefix, word(sense));
            button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, now == sense, told.clone()));
            if button.clicked() && now != sense {
                wanted = Some(Change::To(sense));
            }
        }
        if let Some(to) = to
            && back(ui, owner, "spiral", word(to))
        {
            wanted = Some(Change::Back);
        }
    });
    wanted
}

/// The centre of a spiral; whether it shall go back. `is_set`: it is no one else's.
pub(super) fn centre(ui: &mut egui::Ui, owner: Owner, now: Option<[f64; 3]>, is_set: bool) -> bool {
    let row = ui.horizontal(|ui| {
        let tip = "Right click on the part: Spiral centre here";
        name(ui, "Centre", is_set).on_hover_text(tip);
        ui.label(now.map_or_else(|| "middle of the surface".into(), place)).on_hover_text(tip);
        is_set && back(ui, owner, "centre", "")
    });
    if now.is_none() {
        ui.label(RichText::new("Right click on the part to set it").small().weak());
    }
    row.inner
}
