//! Numbers in the window: what the job holds is shown and not changed by that, what cannot be is not taken and told,
//! and a job that cannot be is refused with the words of the command line.

mod common;

use clearbeam::app::App;
use common::window::{Answers, click, job_on, reveal, says, tab, type_into, window};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// Values that may stand in a file, and lie beyond what the window's fields take, or between what they show.
const ODD: &str = "[part.placement]\nrotation_deg = [0.0, 0.0, 725.123456]\n\
    translation_mm = [20000.123456, 0.0, 0.0]\n[clean]\nsurfaces = [3]\n\
    [layers]\nspacing_mm = 7.123456789\noffset_mm = 0.000123456\ndirection = \"3,4,0\"\n\
    [path]\nchord_error_mm = 1e-7\n[[tilts]]\nsurface = 3\nleast_deg = 80.123\n\
    [cell]\nrobot = \"irb1200\"\n[cell.base_from_laser]\nposition_mm = [20000.0, 0.123456, 0.0]\n\
    rz_ry_rx_deg = [0.0, 400.0, 0.0]\n";

/// Shows every tab, with all that is folded in it.
fn open_all(h: &mut Harness<'_, App>) {
    let folded = [
        ("Robot", &[][..]),
        ("Dose", &[]),
        ("Part", &["More on surfaces"]),
        ("Beam", &["Optics", "Clamps"]),
        ("Path", &["Targets, leads", "Rim, joins, passes"]),
    ];
    for (name, headers) in folded {
        tab(h, name);
        for header in headers {
            reveal(h, header);
            click(h, header);
        }
    }
}

#[test]
fn what_a_job_holds_is_not_changed_by_being_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = job_on(&folder, "workpiece", ODD);
    let mut h = window(Some(file), &Answers::default());
    let before = h.state().document().job().clone();
    assert_eq!(before.layers.spacing_mm, 7.123456789, "it was opened");
    open_all(&mut h);
    h.get_by_label("Spacing").click();
    h.run_steps(3);
    h.get_by_label("Chord error").click();
    h.run_steps(3);
    h.key_press_modifiers(Modifiers::NONE, Key::Enter);
    h.run_steps(3);
    assert!(!h.state().document().is_dirty(), "shown, clicked into and left again");
    assert_eq!(*h.state().document().job(), before);
}

#[test]
fn what_is_typed_and_cannot_be_is_not_taken_and_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = job_on(&folder, "workpiece", "[clean]\nsurfaces = [3]\n[layers]\nspacing_mm = 4.0\n");
    let mut h = window(Some(file), &Answers::default());
    for bad in ["5000", "-1", "wide"] {
        type_into(&mut h, "Spacing", bad);
        assert_eq!(h.state().document().job().layers.spacing_mm, 4.0, "{bad}");
        let said = says(&h, "was not taken");
        assert!(said.contains(bad) && said.contains("1000 mm"), "{said}");
    }
    type_into(&mut h, "Spacing", "3");
    assert_eq!(h.state().document().job().layers.spacing_mm, 3.0);
    assert!(h.query_by_label_contains("was not taken").is_none(), "what was told is over");
}

#[test]
fn a_bad_job_is_refused_with_the_words_of_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = job_on(&folder, "workpiece", "[layers]\nspacing_mm = nan\n");
    let h = window(Some(file.clone()), &Answers::default());
    let said = says(&h, "spacing_mm");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_clearbeam"))
        .args(["plan", &file.display().to_string(), "--out", &folder.path().join("out").display().to_string()])
        .output()
        .expect("runs");
    let told = String::from_utf8_lossy(&run.stderr).trim().trim_start_matches("clearbeam: ").to_owned();
    assert_eq!(run.status.code(), Some(1));
    assert!(told.contains("line ") && said.contains(&told), "window: {said}\ncommand line: {told}");
}
