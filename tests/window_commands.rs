//! Every command has its effect: each is given to the real window, and what has changed is looked at: the job, its
//! files, the picture, the camera, the selection. All are matched, so a new command without a test does not compile.

mod common;

use clearbeam::app::{App, Command, Jump, More, Purpose, Toggle, TurnAxis};
use clearbeam::document::{Edit, Job};
use clearbeam::part::{SurfaceId, angle};
use clearbeam::progress::Activity;
use clearbeam::view::StandardView;
use common::held::Bare;
use common::window::{Answers, click, job_on, press, sample, settle, window};
use eframe::egui::{self, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use std::path::PathBuf;

const JOB: &str = "[clean]\nsurfaces = [2, 3]\n[layers]\nspacing_mm = 4.0\ndirection = \"x\"\n";
/// The laser is so far out that part of the cup is beyond the arm.
const REFUSED: &str = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 16.0\n[cell]\nrobot = \"mz04\"\n\
    base_from_laser = { position_mm = [620.0, 0.0, 300.0], rz_ry_rx_deg = [0.0, 0.0, 0.0] }\n";
const DRIVEN: &str = "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 16.0\n[cell]\nrobot = \"mz04\"\n";

/// The real window, and the folder that its files are in.
struct Window {
    h: Harness<'static, App>,
    folder: tempfile::TempDir,
}

impl Window {
    fn on(name: &str, text: &str) -> Window {
        let folder = tempfile::tempdir().expect("a folder");
        let job = job_on(&folder, name, text);
        let answers = Answers::default();
        answers.0.lock().expect("fresh").extend([
            (Purpose::Open, sample("front_shaft.stl")),
            (Purpose::SaveJob, folder.path().join("other.toml")),
            (Purpose::Export, folder.path().join("program")),
        ]);
        Window { h: window(Some(job), &answers), folder }
    }

    fn app(&self) -> &App {
        self.h.state()
    }

    fn job(&self) -> Job {
        self.app().document().job().clone()
    }

    fn give(&mut self, command: Command, selected: &[u32]) {
        self.h.state_mut().give(command, selected);
        settle(&mut self.h);
    }

    fn send(&mut self, edit: Edit) {
        self.h.state_mut().send(edit);
        settle(&mut self.h);
    }

    /// Takes the last edit back: the next command finds the job as it was.
    fn undo(&mut self) {
        press(&mut self.h, Modifiers::COMMAND, Key::Z);
    }

    fn to_clean(&self) -> Vec<u32> {
        let ids = self.job().settings.chosen(self.app().surfaces().into_iter().map(SurfaceId));
        ids.into_iter().map(|id| id.0).collect()
    }

    fn says(&self, part: &str) -> bool {
        self.h.query_by_label_contains(part).is_some()
    }

    fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The pixels of the 3D view, without what lies over it.
    fn picture(&mut self) -> Vec<u8> {
        self.h.remove_cursor();
        settle(&mut self.h);
        let rect = self.h.get_by_label("3D view").rect().shrink(2.0);
        let image = self.h.render().expect("rendered");
        let at = |v: f32| v.round() as u32;
        let rows = at(rect.top())..at(rect.bottom());
        rows.flat_map(|y| (at(rect.left())..at(rect.right())).flat_map(move |x| [x, y]))
            .collect::<Vec<u32>>()
            .chunks_exact(2)
            .flat_map(|xy| image.get_pixel(xy[0], xy[1]).0)
            .collect()
    }

    /// Clicks into the middle of the 3D view.
    fn click_part(&mut self) {
        let middle = self.h.get_by_label("3D view").rect().center();
        for pressed in [true, false] {
            self.h.hover_at(middle);
            let (pos, button, modifiers) = (middle, egui::PointerButton::Primary, Modifiers::NONE);
            self.h.event(egui::Event::PointerButton { pos, button, pressed, modifiers });
            self.h.step();
        }
        settle(&mut self.h);
    }
}

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
        C::Open | C::Save | C::SaveAs | C::Export => file(w, command),
        C::Undo | C::Redo => undo_and_redo(w, command),
        C::Clean | C::Unclean | C::CleanEarlier | C::CleanLater => lists(w, command),
        C::Select(more) => select(w, more),
        C::Merge | C::Split | C::Rename | C::FlipSurface | C::FlipShell => surfaces(w, command),
        C::PickOrigin | C::LayFlat => pick(w, command),
        C::QuarterTurn(axis) => turn(w, axis),
        C::Look(_) | C::Fit | C::Projection => camera(w, command),
        C::Hide | C::Isolate | C::ShowAll => hide(w, command),
        C::Toggle(what) => toggle(stage, what),
        C::Theme => {
            let before = w.h.ctx.theme();
            w.give(command, &[]);
            assert_ne!(w.h.ctx.theme(), before);
            w.give(command, &[]);
            assert_eq!(w.h.ctx.theme(), before);
        }
        C::Plan | C::Cancel => cancelled_and_planned_again(),
        C::BetterSetup => better_setup(),
        C::Play => play(&mut stage.robot),
        C::Go(jump) => go(w, jump),
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
        let r = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            has_its_effect(&mut stage, *command);
            assert_eq!(stage.part.job(), begun, "{command:?} is taken back for the next");
        }));
        if r.is_err() {
            eprintln!("FAILED {command:?}");
        }
    }
}

#[test]
fn every_command_can_be_given_at_any_time() {
    let nothing_needed = [Command::Open, Command::Theme, Command::Help, Command::Escape];
    let mut h = window(None, &Answers::default());
    for command in Command::ALL {
        assert_eq!(h.state().can(*command), nothing_needed.contains(command), "{command:?} without a part");
        if let Some(keys) = command.keys() {
            press(&mut h, keys.modifiers, keys.logical_key);
        }
        h.state_mut().give(*command, &[]);
        settle(&mut h);
    }
    assert!(h.query_by_label("File").is_some(), "the window is still there");
    let mut h = window(Some(sample("workpiece.stl")), &Answers::default());
    for keys in Command::ALL.iter().filter_map(|c| c.keys()) {
        press(&mut h, keys.modifiers, keys.logical_key);
    }
    assert!(h.query_by_label("File").is_some(), "the window is still there");
}

fn file(w: &mut Window, command: Command) {
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
        _ => {
            w.give(command, &[]);
            assert!(w.file("program/MZ04-01-A.001").exists());
        }
    }
}

fn undo_and_redo(w: &mut Window, command: Command) {
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

fn lists(w: &mut Window, command: Command) {
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

fn select(w: &mut Window, more: More) {
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
        More::Neighbours => {
            let near = all.neighbours(&part.mesh, 1);
            w.app().surfaces().into_iter().filter(|n| *n == 1 || near.contains(n)).collect()
        }
    };
    assert!(expected.contains(&1) && expected.len() < 18);
    assert_eq!(w.app().selected().iter().copied().collect::<Vec<u32>>(), expected, "{more:?}");
}

fn surfaces(w: &mut Window, command: Command) {
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
            assert_eq!(w.job().part.flipped_shells, [0]);
        }
    }
    w.undo();
}

fn pick(w: &mut Window, command: Command) {
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

fn turn(w: &mut Window, axis: TurnAxis) {
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

fn camera(w: &mut Window, command: Command) {
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
    // Back to where the part is seen whole.
    w.give(Command::Look(StandardView::Iso), &[]);
    w.give(Command::Escape, &[]);
    w.give(Command::Fit, &[]);
}

fn hide(w: &mut Window, command: Command) {
    let shown = w.picture();
    w.give(Command::Hide, &[1]);
    assert!(w.app().hidden().iter().eq(&[1]));
    assert_ne!(w.picture(), shown);
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
        | Toggle::Spacing => None,
    }
}

fn toggle(stage: &mut Stage, what: Toggle) {
    let w = match what {
        Toggle::Cell | Toggle::Plots => &mut stage.robot,
        _ => &mut stage.part,
    };
    let needs = match what {
        // What was before the correction is seen with beams only.
        Toggle::BeforeCorrection => vec![Toggle::Beams],
        // The camera turns onto the section, and stays so.
        Toggle::SectionPlane => vec![what, what],
        _ => Vec::new(),
    };
    needs.iter().for_each(|n| w.give(Command::Toggle(*n), &[]));
    let before = w.picture();
    let shown = |w: &mut Window| match words_of(what) {
        Some(words) => w.h.query_all_by_label_contains(words).next().is_some(),
        None => w.picture() != before,
    };
    assert!(!shown(w), "{what:?} before");
    w.give(Command::Toggle(what), &[]);
    assert!(shown(w), "{what:?} is seen");
    w.give(Command::Toggle(what), &[]);
    assert!(!shown(w), "{what:?} goes again");
    needs.into_iter().for_each(|n| w.give(Command::Toggle(n), &[]));
}

fn bare(name: &str, text: &str) -> (Bare, tempfile::TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let job = job_on(&folder, name, text);
    (Bare::new(&egui::Context::default(), job), folder)
}

fn cancelled_and_planned_again() {
    let (mut bare, _folder) = bare("workpiece", JOB);
    bare.app.send(Edit::Set("layers.spacing_mm", 15.0));
    bare.step();
    bare.app.give(Command::Cancel, &[]);
    bare.settle();
    assert!(bare.app.plan().is_none() && bare.app.why_no_plan().is_some_and(|why| why.contains("cancelled")));
    bare.app.give(Command::Plan, &[]);
    bare.settle();
    assert!(bare.app.plan().is_some());
}

fn better_setup() {
    let (mut bare, _folder) = bare("acetabular_cup", REFUSED);
    bare.app.give(Command::BetterSetup, &[]);
    assert!(bare.held.take_stage(Activity::LookingForSetup).is_some(), "it is being looked for");
    assert!(!bare.app.can(Command::BetterSetup), "once is enough");
}

fn play(w: &mut Window) {
    let at = |w: &Window| w.app().target_at();
    w.give(Command::Go(Jump::FirstPoint), &[]);
    w.give(Command::Play, &[]);
    w.h.run_steps(60);
    let reached = at(w);
    assert!(reached > (0, 0) && w.says("Pause"));
    w.give(Command::Play, &[]);
    let stopped = at(w);
    w.h.run_steps(30);
    assert_eq!(at(w), stopped);
}

fn go(w: &mut Window, jump: Jump) {
    let planned = w.app().plan().expect("a plan").clone();
    let points = |pass: usize| planned.plan.passes[pass].targets.len();
    let last = planned.plan.passes.len() - 1;
    assert!(last >= 3 && points(1) >= 2 && points(2) >= 2, "something to step through");
    // From the second point of the third pass, and over the ends of passes.
    w.give(Command::Go(Jump::FirstPoint), &[]);
    for to in [Jump::NextPass, Jump::NextPass, Jump::NextPoint] {
        w.give(Command::Go(to), &[]);
    }
    assert_eq!(w.app().target_at(), (2, 1));
    w.give(Command::Go(jump), &[]);
    let once = match jump {
        Jump::NextPoint if points(2) > 2 => (2, 2),
        Jump::NextPoint => (3, 0),
        Jump::PreviousPoint => (2, 0),
        Jump::NextPass => (3, 0),
        Jump::PreviousPass => (1, 0),
        Jump::FirstPoint => (0, 0),
        Jump::LastPoint => (last, points(last) - 1),
    };
    assert_eq!(w.app().target_at(), once, "{jump:?}");
    w.give(Command::Go(jump), &[]);
    if jump == Jump::PreviousPoint {
        assert_eq!(w.app().target_at(), (1, points(1) - 1), "over the end of a pass");
    }
}
