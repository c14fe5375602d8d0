//! The fields of a place, x, y and z in a row.

use super::super::entry::{Entry, refused};
use crate::text::{say, short};
use eframe::egui::{self, Role, WidgetInfo};

/// Three fields up to `far_mm` from nought; `told`: the accessible name of an axis' field.
pub(super) fn place(ui: &mut egui::Ui, place: &mut [f64; 3], far_mm: f64, told: impl Fn(&str) -> String) {
    let row = ui.horizontal(|ui| {
        let fields = ["x", "y", "z"].into_iter().zip(place.iter_mut()).map(|(axis, value)| {
            let (prefix, size) = (format!("{axis} "), Some([82.0, 20.0]));
            let entry = Entry {
                speed: 0.05,
                prefix,
                size,
                written: Some(short),
                ..Entry::new(-far_mm..=far_mm, say!(unit_mm))
            };
            let drawn = entry.show(ui, value);
            drawn.response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, told(axis)));
            drawn
        });
        fields.collect::<Vec<_>>()
    });
    refused(ui, &row.inner);
}
