//! A field for a number. What is typed and cannot be is not taken, and a line below says so with what can be; what the
//! job holds is shown as it is, and is not changed by being shown.

use super::super::quantity;
use crate::text::{exact, say};
use eframe::egui::{self, DragValue, RichText};
use std::cell::RefCell;
use std::ops::RangeInclusive;

/// What a field looks like, and what it takes.
pub(super) struct Entry {
    /// From where to where a number may lie.
    pub range: RangeInclusive<f64>,
    /// By how much a drag over one pixel changes it.
    pub speed: f64,
    /// How many decimals are shown, at most.
    pub decimals: usize,
    /// In front of the number.
    pub prefix: String,
    /// Behind it: the unit.
    pub suffix: String,
    /// How the number is written; `None`: with as many decimals as a drag makes.
    pub written: Option<fn(f64) -> String>,
    /// Size of the field; `None`: as wide as it needs to be.
    pub size: Option<[f32; 2]>,
}

/// A field as it was drawn.
pub(super) struct Drawn {
    /// The field.
    pub response: egui::Response,
    /// What was typed last and not taken, with the reason; to be shown below by [`refused`].
    refusal: Option<String>,
}

impl Entry {
    /// A field for numbers of a range, with a unit behind them.
    pub fn new(range: RangeInclusive<f64>, suffix: String) -> Entry {
        Entry { range, speed: 0.5, decimals: 3, prefix: String::new(), suffix, written: None, size: None }
    }

    /// Draws the field. `value` changes only by what the user does.
    pub fn show(self, ui: &mut egui::Ui, value: &mut f64) -> Drawn {
        let (low, high) = (*self.range.start(), *self.range.end());
        let (before, decimals) = (*value, self.decimals);
        let typed = RefCell::new(None);
        let parse = |text: &str| {
            let number = quantity::read(text).filter(|v| (low..=high).contains(v));
            if number.is_none() {
                *typed.borrow_mut() = Some(text.trim().to_owned());
            }
            // What was shown rounded, and left as it was, is no change.
            number.filter(|v| !is_as_shown(text, *v, before, decimals))
        };
        let mut field = DragValue::new(value)
            .speed(self.speed)
            .range(self.range.clone())
            .clamp_existing_to_range(false)
            .max_decimals(self.decimals)
            .prefix(self.prefix)
            .suffix(&self.suffix)
            .update_while_editing(false)
            .custom_parser(parse);
        if let Some(written) = self.written {
            field = field.custom_formatter(move |v, _| written(v));
        }
        let response = match self.size {
            Some(size) => ui.add_sized(size, field),
            None => ui.add(field),
        };
        let key = response.id.with("not taken");
        // Tools for the blind set numbers without typing.
        if response.changed() && !(low..=high).contains(value) {
            *typed.borrow_mut() = Some(exact(*value));
            *value = before;
        }
        if response.changed() || response.gained_focus() {
            ui.data_mut(|d| d.remove::<String>(key));
        }
        if let Some(text) = typed.into_inner() {
            let least = exact(low);
            let said = say!(field_not_taken, text, least, greatest = format!("{}{}", exact(high), self.suffix));
            ui.data_mut(|d| d.insert_temp(key, said));
        }
        let refusal = ui.data(|d| d.get_temp::<String>(key));
        Drawn { response, refusal }
    }
}

/// Whether a text is the number that was there, to the decimals that were shown.
fn is_as_shown(text: &str, number: f64, before: f64, decimals: usize) -> bool {
    let digits = text.split_once(['.', ',']).map_or(0, |(_, d)| d.chars().take_while(char::is_ascii_digit).count());
    digits <= decimals && format!("{number:.decimals$}") == format!("{before:.decimals$}")
}

/// Says below a row of fields what of it was not taken.
pub(super) fn refused<'d>(ui: &mut egui::Ui, drawn: impl IntoIterator<Item = &'d Drawn>) {
    for said in drawn.into_iter().filter_map(|d| d.refusal.as_ref()) {
        ui.label(RichText::new(said).small().color(ui.visuals().error_fg_color));
    }
}
