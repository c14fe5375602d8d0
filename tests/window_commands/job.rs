//! Effects on the job: its files, its lists and surfaces, where its part stands.

use crate::JOB;
use crate::common::window::{click, press};
use crate::window::Window;
use clearbeam::app::{Command, Jump, More, RowStep, Toggle, TurnAxis};
use clearbeam::document::Edit;
use clearbeam::part::{SurfaceId, angle};
use eframe::egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable as _;

pub fn file(w: &mut Window, command: Command) {
    let power = w.job().beam.power_w;
    match command {
        Command::Open => {
            w.send(Edit::Set("beam.power_w", power + 1.0));
            w.give(command, &[]);
            assert!(w.says("Save changes?"), "what is not saved is asked about");
            click(&mut w.h, "Cancel");
            w.undo();
            // Another window, as this one shall keep its part.
            let mut other = Window::on("workpiece", JOB);
            other.give(command, &[]);
            assert!(other.job().part.file.ends_with("front_shaft.stl"));
        }
        Command::OpenScan => {
            std::fs::write(w.file("scan.xyz"), "0 0 0\n1 0 0\n0 1 0\n").expect("writes");
            w.give(command, &[]);
            let scan = &w.job().scan.files[0];
            assert_eq!((scan.file.as_str(), scan.sha256.len()), ("scan.xyz", 64));
            w.undo();
        }
        Command::OpenWeld => {
            w.give(command, &[]);
            let images = &w.job().weld.images;
            assert!(images.gray.file.ends_with("gray.png") && images.depth.sha256.len() == 64, "{images:?}");
            w.undo();
        }
        Command::Save => {
            w.send(Edit::Set("beam.power_w", power + 2.0));
            w.give(command, &[]);
            assert!(!w.app().document().is_dirty());
            let text = std::fs::read_to_string(w.file("job.toml")).expect("saved");
            assert!(text.contains(&format!("power_w = {:?}", power + 2.0)), "{text}");
            w.undo();
        }
        Command::SaveAs => {
            w.give(command, &[]);
            assert_eq!(w.app().document().file(), Some(w.file("other.toml").as_path()));
            assert!(w.file("other.toml").exists());
        }
        Command::ExportDryRun => {
            export(w, command);
            assert!(w.file("program/MZ04-01-A.001").exists(), "the program that was exported before stays beside it");
            let dry = std::fs::read_to_string(w.file("program/MZ04-01-A.401")).expect("written");
            assert!(dry.contains("DRY RUN") && !dry.lines().any(|l| l.starts_with("SET ")), "{dry}");
        }
        _ => {
            export(w, command);
            assert!(w.file("program/MZ04-01-A.001").exists() && !w.file("program/dose.ply").exists());
            w.give(Command::Toggle(Toggle::Dose), &[]);
            export(w, command);
            assert!(w.file("program/dose.ply").exists(), "a dose that is looked at is written");
            w.give(Command::Toggle(Toggle::Dose), &[]);
        }
    }
}

/// Gives a command, and goes on from the page that it shows.
fn export(w: &mut Window, command: Command) {
    w.give(command, &[]);
    assert!(w.says("Not done") && w.says("Assumed"), "what is written is told before");
    click(&mut w.h, "Export");
}

/// Passes before the current one are dimmed and left out of exports until the chip is clicked.
pub fn go_on(w: &mut Window) {
    let before = w.picture();
    w.give(Command::Go(Jump::NextPass), &[]);
    w.give(Command::Go(Jump::NextPass), &[]);
    export(w, Command::ExportFromPass);
    let left = std::fs::read_to_string(w.file("program/MZ04-01-A.201")).expect("written");
    assert!(left.contains("goes on from pass 2") && !left.contains("pass 1, surface"), "{left}");
    assert!(w.says("Export from pass 2 on") && w.picture() != before);
    export(w, Command::ExportDryRun);
    assert!(w.file("program/MZ04-01-A.601").exists(), "what is left can be tried dry");
    click(&mut w.h, "From pass 2 on ×");
    assert!(!w.says("Export from pass 2 on"));
    w.give(Command::Go(Jump::FirstPoint), &[]);
    assert!(w.picture() == before, "all passes are shown as before");
}

pub fn undo_and_redo(w: &mut Window, command: Command) {
    let power = w.job().beam.power_w;
    w.send(Edit::Set("beam.power_w", power + 1.0));
    w.give(Command::Undo, &[]);
    assert_eq!(w.job().beam.power_w, power);
    if command == Command::Redo {
        w.give(command, &[]);
        assert_eq!(w.job().beam.power_w, power + 1.0);
        w.undo();
    }
}

pub fn lists(w: &mut Window, command: Command) {
    let (surface, expected): (u32, &[u32]) = match command {
        Command::Clean => (5, &[2, 3, 5]),
        Command::Unclean => (2, &[3]),
        Command::CleanEarlier => (3, &[3, 2]),
        _ => (2, &[3, 2]),
    };
    w.give(command, &[surface]);
    assert_eq!(w.to_clean(), expected);
    w.undo();
}

pub fn select(w: &mut Window, more: More) {
    w.give(Command::Select(more), &[1]);
    let planned = w.app().plan().expect("a plan").clone();
    let (part, all) = (&planned.part, &planned.surfaces);
    let flat = |n: u32, normal| {
        let facets = &all.get(n).expect("there").facets;
        facets.iter().all(|f| angle::between_deg(&all.normals[*f as usize], &normal) < 1.0)
    };
    let own = all.normals[all.get(1).expect("there").facets[0] as usize];
    let expected: Vec<u32> = match more {
        More::Listed => w.app().surfaces().into_iter().filter(|n| ![2, 3].contains(n)).collect(),
        More::SameShape => w
            .app()
            .surfaces()
            .into_iter()
            .filter(|n| {
                let first = all.get(*n).expect("there").facets[0] as usize;
                flat(*n, all.normals[first])
            })
            .collect(),
        More::SameNormal => w.app().surfaces().into_iter().filter(|n| flat(*n, own)).collect(),
        More::Larger => {
            let area = |n: u32| all.get(n).expect("there").area_mm2;
            w.app().surfaces().into_iter().filter(|n| area(*n) >= area(1)).collect()
        }
        More::Neighbours => {
            let near = all.neighbours(&part.mesh, 1);
            w.app().surfaces().into_iter().filter(|n| *n == 1 || near.contains(n)).collect()
        }
    };
    assert!(expected.contains(&1) && expected.len() < 18);
    assert_eq!(w.app().selected().iter().copied().collect::<Vec<u32>>(), expected, "{more:?}");
}

/// A tool is taken into the hand, and laid down with Escape.
pub fn takes_tool(w: &mut Window, command: Command, says: &str) {
    assert!(!w.says(says));
    w.give(command, &[]);
    assert!(w.says(says), "{command:?}");
    w.give(Command::Escape, &[]);
    assert!(!w.says(says));
}

/// The rows of a list are gone through from the surface that was selected last.
pub fn select_row(w: &mut Window, step: RowStep) {
    let next = match step {
        RowStep::Below => 6,
        RowStep::Above => 4,
    };
    click(&mut w.h, "surface 5 plane");
    w.give(Command::SelectRow(step), &[]);
    assert!(w.app().selected().iter().eq(&[next]), "{:?}", w.app().selected());
    // A surface that was moved stays selected; the next one is that beside it.
    w.give(Command::Clean, &[]);
    assert!(w.to_clean().contains(&next) && w.app().selected().iter().eq(&[next]));
    w.give(Command::SelectRow(step), &[]);
    assert!(w.app().selected().iter().eq(&[next + 1]), "{:?}", w.app().selected());
    w.undo();
}

pub fn surfaces(w: &mut Window, command: Command) {
    let count = w.app().surfaces().len();
    match command {
        Command::Merge => {
            w.give(command, &[4, 5]);
            assert_eq!(w.app().surfaces().len(), count - 1);
        }
        Command::Split => {
            w.give(Command::Merge, &[4, 5]);
            w.give(command, &[4]);
            assert!(w.app().surfaces().len() >= count, "where they were joined they are cut again");
            w.undo();
        }
        Command::Rename => {
            w.give(command, &[4]);
            w.h.get_by_label("surface name").type_text("Bore");
            press(&mut w.h, Modifiers::NONE, Key::Enter);
            assert_eq!(w.job().settings.of(SurfaceId(4)).name, "Bore");
        }
        Command::FlipSurface => {
            w.give(command, &[4]);
            assert!(w.job().settings.of(SurfaceId(4)).flipped);
        }
        _ => {
            w.give(command, &[4]);
            assert_eq!(w.job().part.flipped_shells, [1]);
        }
    }
    w.undo();
}

pub fn pick(w: &mut Window, command: Command) {
    let before = w.job().part.placement;
    w.give(command, &[]);
    let asks = if command == Command::PickOrigin { "Click where the origin" } else { "Click the face to lay down" };
    assert!(w.says(asks));
    w.click_part();
    assert!(!w.says(asks));
    let after = w.job().part.placement;
    assert_ne!(after, before);
    assert_eq!(after.rotation_deg == before.rotation_deg, command == Command::PickOrigin, "only laying down turns");
    w.undo();
}

pub fn turn(w: &mut Window, axis: TurnAxis) {
    let before = w.job().part.placement;
    w.give(Command::QuarterTurn(axis), &[]);
    let number = match axis {
        TurnAxis::X => 0,
        TurnAxis::Y => 1,
        TurnAxis::Z => 2,
    };
    assert_eq!(w.job().part.placement, before.quarter_turn(number));
    w.undo();
}
