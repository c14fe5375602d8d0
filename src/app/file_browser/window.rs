//! The dialog in the window, drawn: path, places, rows, name, and its buttons.

use super::browser::Browser;
use super::folder::Entry;
use super::wanted::WantedKind;
use crate::text::{grouped, say};
use eframe::egui::{self, Id, Key, Modal, RichText, Role, ScrollArea, TextEdit, WidgetInfo, vec2};
use std::path::{Path, PathBuf};

/// Draws it. `Some` when it has ended: with what was picked, or with nothing.
pub(super) fn ui(ctx: &egui::Context, browser: &mut Browser) -> Option<Option<PathBuf>> {
    let shown = Modal::new(Id::unique("file browser")).show(ctx, |ui| {
        let room = ctx.content_rect().size();
        ui.set_width((room.x - 60.0).clamp(320.0, 680.0));
        ui.heading(&browser.wanted.title);
        let typed = path_row(ui, browser);
        ui.separator();
        let height = (room.y - 260.0).clamp(120.0, 380.0);
        let mut picked = typed;
        ui.allocate_ui(vec2(ui.available_width(), height), |ui| {
            ui.set_max_height(height);
            ui.horizontal_top(|ui| {
                places(ui, height, browser);
                ui.separator();
                let row = ui.vertical(|ui| rows(ui, height, browser)).inner;
                picked = picked.take().or(row);
            });
        });
        ui.separator();
        if let Some(why) = &browser.why {
            ui.label(RichText::new(why).color(ui.visuals().error_fg_color));
        }
        let (named, cancelled) = buttons(ui, browser);
        (picked.or(named), cancelled)
    });
    let closes = shown.should_close();
    let (picked, cancelled) = shown.inner;
    match picked {
        Some(path) => Some(Some(path)),
        None => (cancelled || closes).then_some(None),
    }
}

/// The field of the path, and the way up.
fn path_row(ui: &mut egui::Ui, browser: &mut Browser) -> Option<PathBuf> {
    let mut picked = None;
    ui.horizontal(|ui| {
        let up = ui.add_enabled(browser.folder().parent().is_some(), egui::Button::new("↑"));
        up.widget_info(|| WidgetInfo::labeled(Role::Button, true, say!(browser_up)));
        if up.on_hover_text(say!(browser_up)).clicked() {
            browser.go_up();
        }
        let field = ui.add(TextEdit::singleline(&mut browser.typed).desired_width(f32::INFINITY));
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(browser_path)));
        if field.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter)) {
            picked = browser.take_typed();
        }
    });
    picked
}

fn places(ui: &mut egui::Ui, height: f32, browser: &mut Browser) {
    let mut chosen = None;
    ui.vertical(|ui| {
        ui.set_width(120.0);
        ui.set_min_height(height);
        for place in &browser.places {
            let name = place.file_name().map_or_else(|| place.display().to_string(), |n| n.to_string_lossy().into());
            let button = ui.add(egui::Button::selectable(place == browser.folder(), name).truncate());
            if button.on_hover_text(place.display().to_string()).clicked() {
                chosen = Some(place.clone());
            }
        }
    });
    if let Some(place) = chosen {
        browser.enter(&place);
    }
}

/// The rows of the folder. A click chooses, a double click enters or picks.
fn rows(ui: &mut egui::Ui, height: f32, browser: &mut Browser) -> Option<PathBuf> {
    let rows = match browser.rows() {
        None => {
            ui.spinner();
            return None;
        }
        Some(Err(why)) => {
            ui.label(RichText::new(why).color(ui.visuals().error_fg_color));
            return None;
        }
        Some(Ok(rows)) => rows,
    };
    if rows.is_empty() && browser.wanted.kind != WantedKind::Folder {
        ui.label(RichText::new(say!(browser_empty)).weak());
    }
    let mut picked = None;
    let area = ScrollArea::vertical().id_salt(browser.folder()).max_height(height).auto_shrink([false, false]);
    area.show_rows(ui, 20.0, rows.len(), |ui, range| {
        for entry in &rows[range] {
            let response = row(ui, entry, browser.name == entry.name);
            if response.clicked() && !entry.is_folder && browser.wanted.kind != WantedKind::Folder {
                browser.name.clone_from(&entry.name);
                browser.replaces = None;
            }
            if response.double_clicked() && entry.is_folder {
                let folder = browser.folder().join(&entry.name);
                browser.enter(&folder);
            } else if response.double_clicked() && browser.wanted.kind != WantedKind::Folder {
                browser.name.clone_from(&entry.name);
                picked = browser.pick();
            }
        }
    });
    picked
}

fn row(ui: &mut egui::Ui, entry: &Entry, is_chosen: bool) -> egui::Response {
    let (shown, size) = match entry.is_folder {
        true => (format!("{}/", entry.name), String::new()),
        false => (entry.name.clone(), say!(browser_size, kilobytes = grouped(entry.bytes.div_ceil(1000)))),
    };
    let button = egui::Button::selectable(is_chosen, shown).shortcut_text(size).truncate();
    let row = ui.add(button.min_size(vec2(ui.available_width() - 12.0, 0.0)));
    row.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, is_chosen, entry.name.as_str()));
    row
}

/// The field of the name, the buttons, and what they ask before a file is replaced. What is picked, and whether nothing
/// will be.
fn buttons(ui: &mut egui::Ui, browser: &mut Browser) -> (Option<PathBuf>, bool) {
    let (mut picked, mut cancelled) = (None, false);
    if browser.wanted.kind != WantedKind::Folder {
        ui.horizontal(|ui| {
            ui.label(say!(browser_name));
            let field = ui.add(TextEdit::singleline(&mut browser.name).desired_width(f32::INFINITY));
            field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(browser_name)));
            if field.changed() {
                browser.replaces = None;
            }
            if field.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter)) {
                picked = browser.pick();
            }
        });
        let endings = browser.wanted.endings.join(", ");
        ui.checkbox(&mut browser.shows_all, say!(browser_all)).on_hover_text(say!(browser_all_tip, endings));
    } else if let Some(mut name) = browser.new_folder.take() {
        ui.horizontal(|ui| {
            let field = ui.add(TextEdit::singleline(&mut name).hint_text(say!(browser_new_folder_name)));
            field.widget_info(|| WidgetInfo::labeled(Role::TextInput, true, say!(browser_new_folder_name)));
            field.request_focus();
            browser.new_folder = Some(name.clone());
            if ui.button(say!(browser_make)).clicked() || ui.input(|i| i.key_pressed(Key::Enter)) {
                browser.make_folder(&name);
            }
        });
    } else if ui.button(say!(browser_new_folder)).clicked() {
        browser.new_folder = Some(String::new());
    }
    if let Some(path) = &browser.replaces {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        ui.label(RichText::new(say!(browser_replaces, name)).color(ui.visuals().warn_fg_color));
    }
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        let text = match (&browser.wanted.kind, &browser.replaces) {
            (_, Some(_)) => say!(browser_replace),
            (WantedKind::File, _) => say!(browser_open),
            (WantedKind::NewFile(_), _) => say!(browser_save),
            (WantedKind::Folder, _) => say!(browser_choose),
        };
        let is_ready = browser.wanted.kind == WantedKind::Folder || !browser.name.trim().is_empty();
        let button = ui.add_enabled(is_ready, egui::Button::new(RichText::new(text).strong()));
        if button.on_disabled_hover_text(say!(browser_choose_file)).clicked() {
            picked = browser.pick();
        }
        cancelled = ui.button(say!(ask_cancel)).clicked();
        if browser.wanted.kind == WantedKind::Folder {
            let folder: &Path = browser.folder();
            ui.label(RichText::new(folder.display().to_string()).weak());
        }
    });
    (picked, cancelled)
}
