//! Effects on what is seen: the camera, and what is shown and hidden.

use crate::Stage;
use crate::common::window::settle;
use crate::window::Window;
use clearbeam::app::{Command, Toggle};
use clearbeam::document::model::ScanFile;
use clearbeam::document::{Edit, ScanEdit};
use clearbeam::part::Units;
use clearbeam::scan::cleaning::Step;
use clearbeam::view::StandardView;
use egui_kittest::kittest::Queryable as _;

pub fn camera(w: &mut Window, command: Command) {
    let before = *w.app().camera();
    w.give(command, &[2]);
    let after = *w.app().camera();
    match command {
        Command::Look(view) => {
            let (yaw_rad, pitch_rad) = view.angles_rad();
            assert!((after.yaw_rad - yaw_rad).abs() < 1e-9 && (after.pitch_rad - pitch_rad).abs() < 1e-9, "{view:?}");
        }
        Command::Fit => {
            let planned = w.app().plan().expect("a plan").clone();
            let facets = &planned.surfaces.get(2).expect("there").facets;
            let corners = || facets.iter().flat_map(|f| planned.part.mesh.corners(*f as usize));
            let middle = |k: usize| {
                let [min, max] = [f64::min, f64::max].map(|f| corners().map(|c| c[k]).reduce(f).expect("some"));
                (min + max) / 2.0
            };
            assert!((0..3).all(|k| (after.target[k] - middle(k)).abs() < 1e-6), "{:?}", after.target);
        }
        _ => assert_ne!(after.projection, before.projection),
    }
    seen_whole(w);
}

/// Turns the camera back to where the whole part is seen.
fn seen_whole(w: &mut Window) {
    w.give(Command::Look(StandardView::Iso), &[]);
    w.give(Command::Escape, &[]);
    w.give(Command::Fit, &[]);
}

pub fn hide(w: &mut Window, command: Command) {
    let shown = w.picture();
    w.give(Command::Hide, &[1]);
    assert!(w.app().hidden().iter().eq(&[1]));
    assert!(w.picture() != shown, "it is gone from the picture");
    if command == Command::Isolate {
        w.give(command, &[1, 2]);
        let others = w.app().surfaces().into_iter().filter(|n| *n > 2);
        assert!(w.app().hidden().iter().copied().eq(others));
    }
    w.give(Command::ShowAll, &[]);
    assert!(w.app().hidden().is_empty());
}

/// What a toggle shows in words; `None`: it is seen in the picture alone.
fn words_of(what: Toggle) -> Option<&'static str> {
    match what {
        Toggle::Plots => Some("curves of joints"),
        Toggle::ProgramText => Some("MOVEX"),
        Toggle::AccessMap => Some("access map"),
        Toggle::Dose => Some("histogram of the dose"),
        Toggle::ScanSection => Some("section of part and scan"),
        Toggle::WeldImages => Some("depth image of the weld"),
        // They are there at first: what stands in them goes.
        Toggle::Lists => Some("Feature surfaces"),
        Toggle::Settings => Some("settings: Path"),
        Toggle::PathLines
        | Toggle::PoseFrames
        | Toggle::Beams
        | Toggle::ConnectingMoves
        | Toggle::BeforeCorrection
        | Toggle::PlainPart
        | Toggle::HideChosen
        | Toggle::SectionPlane
        | Toggle::Cell
        | Toggle::ToolBodies
        | Toggle::Spacing
        | Toggle::Cut
        | Toggle::Scan
        | Toggle::DroppedPoints
        | Toggle::DeviationOnModel
        | Toggle::WeldPoints => None,
    }
}

pub fn toggle(stage: &mut Stage, what: Toggle) {
    if matches!(what, Toggle::WeldImages | Toggle::WeldPoints) {
        // Another window, as its part is the weld's own.
        return is_seen_and_goes(&mut Window::on_weld(), what);
    }
    let w = match what {
        Toggle::Cell | Toggle::Plots => &mut stage.robot,
        _ => &mut stage.part,
    };
    is_seen_and_goes(w, what);
}

fn is_seen_and_goes(w: &mut Window, what: Toggle) {
    prepare(w, what);
    let before = w.picture();
    let is_changed = |w: &mut Window| match words_of(what) {
        Some(words) => w.h.query_all_by_label_contains(words).next().is_some(),
        None => w.picture() != before,
    };
    let is_there_first = matches!(what, Toggle::Lists | Toggle::Settings);
    assert_eq!(is_changed(w), is_there_first, "{what:?} before");
    w.give(Command::Toggle(what), &[]);
    assert_eq!(is_changed(w), !is_there_first, "{what:?} is seen");
    w.give(Command::Toggle(what), &[]);
    assert_eq!(is_changed(w), is_there_first, "{what:?} goes again");
    clear_up(w, what);
}

/// What a toggle needs to be seen.
fn prepare(w: &mut Window, what: Toggle) {
    match what {
        // What was before the correction is seen with beams only.
        Toggle::BeforeCorrection => w.give(Command::Toggle(Toggle::Beams), &[]),
        // The camera turns onto the section, and stays so.
        Toggle::SectionPlane => (0..2).for_each(|_| w.give(Command::Toggle(what), &[])),
        Toggle::ToolBodies => {
            let stack = "[[part]]\nfrom_mm = 30.0\nto_mm = 60.0\nr0_mm = 2.0\nr1_mm = 8.0\n";
            std::fs::write(w.file("head.toml"), stack).expect("writes");
            w.send(Edit::Head("head.toml".into()));
        }
        Toggle::Scan | Toggle::DroppedPoints | Toggle::DeviationOnModel | Toggle::ScanSection => scan(w),
        _ => {}
    }
}

fn clear_up(w: &mut Window, what: Toggle) {
    match what {
        Toggle::BeforeCorrection => w.give(Command::Toggle(Toggle::Beams), &[]),
        Toggle::SectionPlane => seen_whole(w),
        Toggle::ToolBodies => w.undo(),
        Toggle::Scan | Toggle::DroppedPoints | Toggle::DeviationOnModel | Toggle::ScanSection => {
            // All before anything is looked for.
            (0..3).for_each(|_| w.h.state_mut().give(Command::Undo, &[]));
            settle(&mut w.h);
        }
        _ => {}
    }
}

/// A scan in the part's own frame, a millimetre out of it, of which a coarse voxel drops most.
fn scan(w: &mut Window) {
    let part = w.app().plan().expect("a plan").part.clone();
    let out = |f: usize| {
        let [a, b, c] = part.mesh.corners(f);
        (a.coords + b.coords + c.coords) / 3.0 + part.mesh.normals[f]
    };
    let rows = (0..part.mesh.facets.len()).map(out).map(|p| format!("{} {} {}\n", p.x, p.y, p.z));
    std::fs::write(w.file("scan.xyz"), rows.collect::<String>()).expect("writes");
    let files = vec![ScanFile { file: "scan.xyz".into(), ..ScanFile::default() }];
    let as_it_is = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let thin = Step::Thin { voxel_mm: 8.0 };
    // All before anything is looked for.
    for edit in [ScanEdit::Files(files, Units::Mm), ScanEdit::Transform(Some(as_it_is)), ScanEdit::AddStep(thin)] {
        w.h.state_mut().send(Edit::Scan(Box::new(edit)));
    }
    settle(&mut w.h);
    assert!(w.app().can(Command::Toggle(Toggle::Scan)), "{:?}", w.app().why_no_plan());
}
