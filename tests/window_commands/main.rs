//! Every command has its effect: each is given to the real window, and what has changed is looked at: the job, its
//! files, the picture, the camera, the selection. All are matched, so a new command without a test does not compile.

#[path = "../common/mod.rs"]
mod common;
mod job;
mod plan;
mod view;
mod window;

use clearbeam::app::Command;
use clearbeam::view::Navigation;
use common::window::{Answers, press, sample, settle};
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;
use window::Window;

const JOB: &str = "[clean]\nsurfaces = [2, 3]\n[layers]\nspacing_mm = 4.0\ndirection = \"z\"\n";
/// The laser is so far out that part of the cup is beyond the arm.
const REFUSED: &str = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 16.0\n[beam]\nspeed_mm_s = 20.0\n[cell]\nrobot = \"mz04\"\n\
    base_from_laser = { position_mm = [620.0, 0.0, 300.0], rz_ry_rx_deg = [0.0, 0.0, 0.0] }\n";
const DRIVEN: &str =
    "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 16.0\n[beam]\nspeed_mm_s = 20.0\n[cell]\nrobot = \"mz04\"\n";

/// What the tests are done in.
struct Stage {
    /// Without a robot.
    part: Window,
    /// With one that reaches everything.
    robot: Window,
}

fn has_its_effect(stage: &mut Stage, command: Command) {
    use Command as C;
    let w = &mut stage.part;
    match command {
        C::Open | C::OpenScan | C::OpenWeld | C::Save | C::SaveAs | C::Export | C::ExportDryRun => {
            job::file(w, command)
        }
        C::ExportFromPass => job::go_on(w),
        C::Undo | C::Redo => job::undo_and_redo(w, command),
        C::Clean | C::Unclean | C::CleanEarlier | C::CleanLater => job::lists(w, command),
        C::Select(more) => job::select(w, more),
        C::Merge | C::Split | C::Rename | C::FlipSurface | C::FlipShell => job::surfaces(w, command),
        C::PickOrigin | C::LayFlat => job::pick(w, command),
        C::QuarterTurn(axis) => job::turn(w, axis),
        C::Look(_) | C::Fit | C::Projection => view::camera(w, command),
        C::Hide | C::Isolate | C::ShowAll => view::hide(w, command),
        C::Toggle(what) => view::toggle(stage, what),
        C::Theme => {
            let preference = |w: &Window| w.h.ctx.options(|o| o.theme_preference);
            let mut seen = vec![preference(w)];
            for _ in 0..3 {
                w.give(command, &[]);
                seen.push(preference(w));
            }
            assert_eq!(seen[0], seen[3], "dark, light and the system's in turn");
            assert!(seen[0] != seen[1] && seen[1] != seen[2] && seen[2] != seen[0], "{seen:?}");
        }
        C::Navigate(_) => {
            assert!(!w.says("Middle drag orbits"));
            w.give(command, &[]);
            w.give(C::Help, &[]);
            let habits = command != C::Navigate(Navigation::Slicer);
            assert_eq!(w.says("Middle drag orbits"), habits, "{command:?}");
            w.give(C::Help, &[]);
            w.give(C::Navigate(Navigation::Slicer), &[]);
        }
        C::SelectByPainting => job::takes_tool(w, command, "Paint over surfaces"),
        C::Measure => job::takes_tool(w, command, "Click two places"),
        // It is the whole process's, and other tests run beside this one: `window_chinese` gives it.
        C::Language => {}
        C::Plan | C::Cancel => plan::cancelled_and_planned_again(),
        C::BetterSetup => plan::better_setup(),
        C::Play => plan::play(&mut stage.robot),
        C::Go(jump) => plan::go(w, jump),
        C::SelectRow(step) => job::select_row(w, step),
        C::Palette => {
            w.give(command, &[]);
            w.h.get_by_label("Type what you are looking for").type_text("find flip sh");
            settle(&mut w.h);
            assert!(!w.says("command Flip side"), "every word is looked for");
            press(&mut w.h, Modifiers::COMMAND, Key::A);
            w.h.get_by_label("Type what you are looking for").type_text("shortc");
            press(&mut w.h, Modifiers::NONE, Key::Enter);
            assert!(w.says("Left drag orbits") && !w.says("Type what you"), "it is given, and the search is over");
            w.give(C::Help, &[]);
            w.give(command, &[]);
            press(&mut w.h, Modifiers::NONE, Key::Escape);
            assert!(!w.says("Type what you"));
        }
        C::Help => {
            w.give(command, &[]);
            assert!(w.says("Left drag orbits"));
            w.give(command, &[]);
            assert!(!w.says("Left drag orbits"));
        }
        C::Escape => {
            w.give(C::Help, &[2]);
            w.give(command, &[]);
            assert!(!w.says("Left drag orbits") && w.app().selected().len() == 1, "one step at a time");
            w.give(command, &[]);
            assert!(w.app().selected().is_empty());
        }
    }
}

#[test]
fn every_command_has_its_effect() {
    let mut stage = Stage { part: Window::on("workpiece", JOB), robot: Window::on("acetabular_cup", DRIVEN) };
    let begun = stage.part.job();
    for command in Command::ALL {
        has_its_effect(&mut stage, *command);
        assert_eq!(stage.part.job(), begun, "{command:?} is taken back for the next");
    }
}

#[test]
fn every_command_can_be_given_at_any_time() {
    use Command as C;
    let nothing_needed = [C::Open, C::OpenWeld, C::Theme, C::Language, C::Palette, C::Help, C::Escape];
    let nothing_needed: Vec<C> = nothing_needed.into_iter().chain(Navigation::ALL.map(C::Navigate)).collect();
    let mut h = common::window::window(None, &Answers::default());
    for command in Command::ALL {
        assert_eq!(h.state().can(*command), nothing_needed.contains(command), "{command:?} without a part");
        if let Some(keys) = command.keys() {
            press(&mut h, keys.modifiers, keys.logical_key);
        }
        if *command != C::Language {
            h.state_mut().give(*command, &[]);
        }
        settle(&mut h);
    }
    assert!(h.query_by_label("File").is_some(), "the window is still there");
    let mut h = common::window::window(Some(sample("workpiece.stl")), &Answers::default());
    for keys in Command::ALL.iter().filter_map(|c| c.keys()) {
        press(&mut h, keys.modifiers, keys.logical_key);
    }
    assert!(h.query_by_label("File").is_some(), "the window is still there");
}
