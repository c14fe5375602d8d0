//! The file dialogs that the window draws where the system has none.

mod common;

use clearbeam::app::{App, Command};
use clearbeam::document::Edit;
use common::window::{sample, settle, wait_for, window_with_own_dialogs};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

fn click(h: &mut Harness<'_, App>, label: &str) {
    h.get_by_label(label).click();
    h.run_steps(8);
}

fn is_shown(h: &Harness<'_, App>, label: &str) -> bool {
    h.query_all_by_label(label).next().is_some()
}

#[test]
fn a_part_is_found_and_opened() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("parts")).expect("made");
    std::fs::copy(sample("workpiece.stl"), folder.path().join("parts/plate.stl")).expect("copies");
    std::fs::write(folder.path().join("notes.txt"), "no part").expect("writes");
    let mut h = window_with_own_dialogs(None, folder.path());
    h.state_mut().give(Command::Open, &[]);
    wait_for(&mut h, "parts");
    assert!(!is_shown(&h, "notes.txt"), "what is no part is left out");
    click(&mut h, "Show all files");
    assert!(is_shown(&h, "notes.txt"));
    h.run_steps(30);
    for _ in 0..2 {
        h.get_by_label("parts").click();
        h.step();
    }
    wait_for(&mut h, "plate.stl");
    click(&mut h, "plate.stl");
    // The menu bar has one as well; the dialog is drawn after it.
    h.query_all_by_label("Open").last().expect("the dialog's").click();
    settle(&mut h);
    assert!(h.state().document().job().part.file.ends_with("plate.stl"));
    assert_eq!(h.state().surfaces().len(), 18);
}

#[test]
fn nothing_is_picked_where_the_dialog_is_left() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window_with_own_dialogs(None, folder.path());
    h.state_mut().give(Command::Open, &[]);
    wait_for(&mut h, "Cancel");
    // Keys are the dialog's: none gives a command.
    h.key_press_modifiers(Modifiers::NONE, Key::Num5);
    click(&mut h, "Cancel");
    settle(&mut h);
    assert!(h.state().surfaces().is_empty() && !is_shown(&h, "Cancel"));
}

#[test]
fn a_job_is_saved_and_replaced_only_when_that_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window_with_own_dialogs(Some(sample("workpiece.stl")), folder.path());
    for power_w in [321.0, 654.0] {
        h.state_mut().send(Edit::Set("beam.power_w", power_w));
        h.state_mut().give(Command::SaveAs, &[]);
        wait_for(&mut h, "Save");
        click(&mut h, "Save");
        if power_w == 654.0 {
            assert!(is_shown(&h, "workpiece.toml exists already"));
            click(&mut h, "Replace");
        }
        settle(&mut h);
        let text = std::fs::read_to_string(folder.path().join("workpiece.toml")).expect("saved");
        assert!(text.contains(&format!("power_w = {power_w:?}")), "{text}");
    }
}

#[test]
fn a_folder_is_made_for_the_program() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = window_with_own_dialogs(Some(sample("workpiece.toml")), folder.path());
    h.state_mut().give(Command::Export, &[]);
    wait_for(&mut h, "New folder…");
    click(&mut h, "New folder…");
    h.get_by_label("name of the new folder").type_text("cell 3");
    h.run_steps(2);
    click(&mut h, "Make it");
    click(&mut h, "Choose this folder");
    settle(&mut h);
    assert!(h.query_by_label_contains("Nothing: no file of these names is there").is_some());
    h.get_by_label("Export").click();
    settle(&mut h);
    assert!(folder.path().join("cell 3/report.json").is_file());
}
