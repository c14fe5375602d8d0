//! The law of the window: whatever is done to it and in whichever order its work ends, a plan that it calls
//! current is, byte for byte, the one that the command line makes of the saved job.

mod common;

use clearbeam::app::Command;
use clearbeam::cell::Mount;
use clearbeam::document::save::save;
use clearbeam::document::{Document, Edit, IfChanged, Job, Recipe, files};
use clearbeam::part::{SurfaceId, Units};
use clearbeam::path::{Order, Strategy as Laying};
use clearbeam::planning::{Pipeline, PlannedJob};
use clearbeam::pose::Correction;
use clearbeam::sample::{solids, stl_bytes};
use clearbeam::text::{Sentence as _, program_comment};
use common::held::Bare;
use eframe::egui;
use proptest::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a hand or the scheduler can do.
#[derive(Clone, Debug)]
enum Deed {
    Scale(u8),
    Unit(u8),
    Turn(usize),
    Angle(u8),
    Merge(usize, usize),
    Split(usize),
    Choose(usize),
    Unchoose(usize),
    Spacing(u8),
    Laying(u8),
    Order(u8),
    Inset(u8),
    Flip(usize),
    Uncorrected(bool),
    Recipe(usize, u8),
    Head(bool),
    Mount(bool),
    Dialect(u8),
    Power(u8),
    Threshold(u8),
    Rename(usize),
    Undo,
    Redo,
    PlanAgain,
    Cancel,
    /// A piece of work ends.
    Deliver(usize),
    /// The window draws.
    Frame,
}

fn deed() -> impl Strategy<Value = Deed> {
    use Deed as D;
    let n = || 0usize..12;
    prop_oneof![
        2 => (0u8..3).prop_map(D::Scale),
        1 => (0u8..2).prop_map(D::Unit),
        1 => (0usize..3).prop_map(D::Turn),
        2 => (0u8..4).prop_map(D::Angle),
        1 => (n(), n()).prop_map(|(a, b)| D::Merge(a, b)),
        1 => n().prop_map(D::Split),
        4 => n().prop_map(D::Choose),
        2 => n().prop_map(D::Unchoose),
        2 => (0u8..3).prop_map(D::Spacing),
        1 => (0u8..3).prop_map(D::Laying),
        1 => (0u8..3).prop_map(D::Order),
        1 => (0u8..3).prop_map(D::Inset),
        1 => n().prop_map(D::Flip),
        1 => any::<bool>().prop_map(D::Uncorrected),
        2 => (n(), 0u8..3).prop_map(|(a, b)| D::Recipe(a, b)),
        1 => any::<bool>().prop_map(D::Head),
        1 => any::<bool>().prop_map(D::Mount),
        1 => (0u8..3).prop_map(D::Dialect),
        1 => (0u8..2).prop_map(D::Power),
        1 => (0u8..2).prop_map(D::Threshold),
        1 => n().prop_map(D::Rename),
        3 => Just(D::Undo),
        1 => Just(D::Redo),
        1 => Just(D::PlanAgain),
        1 => Just(D::Cancel),
        8 => n().prop_map(D::Deliver),
        6 => Just(D::Frame),
    ]
}

fn done(bare: &mut Bare, deed: &Deed) {
    let all = bare.app.surfaces();
    let number = |n: usize| all.get(n.checked_rem(all.len()).unwrap_or(0)).copied().unwrap_or(1);
    let surface = |n: usize| SurfaceId(number(n));
    let app = &mut bare.app;
    match *deed {
        Deed::Scale(k) => app.set("part.placement.scale", [1.0, 2.0, 0.5][usize::from(k)]),
        Deed::Unit(k) => app.send(Edit::Units([Units::Mm, Units::Inch][usize::from(k)])),
        Deed::Turn(axis) => {
            let placement = app.document().job().part.placement.quarter_turn(axis);
            app.send(Edit::Place(placement));
        }
        Deed::Angle(k) => app.set("surfaces.angle_deg", [20.0, 5.0, 50.0, 100.0][usize::from(k)]),
        Deed::Merge(a, b) => app.give(Command::Merge, &[number(a), number(b)]),
        Deed::Split(n) => app.give(Command::Split, &[number(n)]),
        Deed::Choose(n) => app.send(Edit::Clean(vec![surface(n)])),
        Deed::Unchoose(n) => app.send(Edit::Unclean(vec![surface(n)])),
        Deed::Spacing(k) => app.set("layers.spacing_mm", [1.0, 1.5, 4.0][usize::from(k)]),
        Deed::Laying(k) => app.send(Edit::Strategy([Laying::Planes, Laying::Offset, Laying::Cross][usize::from(k)])),
        Deed::Order(k) => app.send(Edit::Order(Order::ALL[usize::from(k)])),
        Deed::Inset(k) => app.set("layers.inset_mm", [0.0, 0.3, -0.4][usize::from(k)]),
        Deed::Flip(n) => app.give(Command::FlipSurface, &[number(n)]),
        Deed::Uncorrected(none) => {
            app.send(Edit::Correction(if none { Correction::None } else { Correction::SectionPlane }));
        }
        Deed::Recipe(n, k) => {
            let values = [("layers.spacing_mm".to_owned(), 0.8 + f64::from(k))].into();
            let recipe = Recipe { name: format!("R{k}"), values, ..Recipe::default() };
            app.send(Edit::GiveRecipe(vec![surface(n)], (k > 0).then(|| Box::new(recipe))));
        }
        Deed::Head(there) => app.send(Edit::Head(if there { "head.toml".into() } else { String::new() })),
        Deed::Mount(tool) => app.send(Edit::Mount(if tool { Mount::ToolInHand } else { Mount::PartInHand })),
        Deed::Dialect(k) => app.send(Edit::Dialect(["nachi", "kuka", "nonsense"][usize::from(k)].into())),
        Deed::Power(k) => app.set("beam.power_w", [500.0, 300.0][usize::from(k)]),
        Deed::Threshold(k) => app.set("dose.low_j_cm2", [0.0, 10.0][usize::from(k)]),
        Deed::Rename(n) => app.send(Edit::Rename(surface(n), "Rim".into())),
        Deed::Undo => app.give(Command::Undo, &[]),
        Deed::Redo => app.give(Command::Redo, &[]),
        Deed::PlanAgain => app.give(Command::Plan, &[]),
        Deed::Cancel => app.give(Command::Cancel, &[]),
        Deed::Deliver(k) => drop(bare.held.run(k)),
        Deed::Frame => bare.step(),
    }
}

/// What an export would write, the dose apart.
fn written(planned: &PlannedJob, job: &Job) -> Vec<(String, String)> {
    use clearbeam::planning::export;
    let PlannedJob { setup, plan, report, .. } = planned;
    let program = match export::program(job, "part.stl", setup, plan, report, program_comment) {
        Ok(files) => files.into_iter().map(|f| (f.name, f.text)).collect(),
        Err(why) => vec![("no program".to_owned(), why.to_string())],
    };
    let report = serde_json::to_string(report).expect("a report");
    [program, vec![("path.csv".into(), export::path_csv(plan)), ("report.json".into(), report)]].concat()
}

/// What the command line writes for the saved job, or why it writes nothing.
fn by_command_line(document: &Document, folder: &Path) -> Result<Vec<(String, String)>, String> {
    let (file, job) = (folder.join("saved.toml"), document.job());
    let saved = save(job, document.job_file(), &file, IfChanged::Overwrite).map_err(|e| e.sentence())?.0;
    let read = files::read(&file).expect("what was saved can be read");
    assert_eq!(read, saved);
    let source = files::read_part(&read, Some(&file)).map_err(|e| e.sentence())?;
    let (_, planned) = Pipeline::planned(Arc::new(source), &read, Some(&file)).map_err(|e| e.sentence())?;
    Ok(written(&planned, job))
}

fn is_right(bare: &Bare, folder: &Path) -> Result<(), TestCaseError> {
    let document = bare.app.document();
    if let Some(planned) = bare.app.plan() {
        prop_assert_eq!(Ok(written(planned, document.job())), by_command_line(document, folder));
    }
    Ok(())
}

/// A block with a groove, a bent top and a head that is too wide for it, with a job that has a file.
fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).expect("writes");
    write("part.stl", &stl_bytes(&solids::v_groove(35.0, 2.0, 2.0, 3.0)));
    write("head.toml", b"[[part]]\nfrom_mm = 3.0\nto_mm = 60.0\nr0_mm = 1.0\nr1_mm = 12.0\n");
    let job =
        "[part]\nfile = \"part.stl\"\n[clean]\nsurfaces = [4]\n[layers]\nspacing_mm = 1.0\ndirection = \"auto\"\n";
    write("job.toml", job.as_bytes());
    let job = folder.path().join("job.toml");
    (folder, job)
}

fn sequences(cases: u32) {
    let (folder, job) = folder();
    let ctx = egui::Context::default();
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    proptest!(config, |(deeds in prop::collection::vec(deed(), 1..14))| {
        let mut bare = Bare::new(&ctx, job.clone());
        for deed in &deeds {
            done(&mut bare, deed);
            // While work is under way nothing that is not so may be called current.
            if bare.app.plan().is_some() && !bare.held.is_empty() {
                is_right(&bare, folder.path())?;
            }
        }
        bare.settle();
        is_right(&bare, folder.path())?;
        let document = bare.app.document();
        if bare.app.plan().is_none() && bare.app.why_no_plan().is_some_and(|why| !why.contains("cancelled")) {
            prop_assert_eq!(Err(bare.app.why_no_plan().unwrap_or_default()), by_command_line(document, folder.path()));
        }
    });
}

/// Half of them, so that both cores are used.
fn half() {
    let cases = std::env::var("CLEARBEAM_SEQUENCES").ok().and_then(|n| n.parse().ok()).unwrap_or(2000);
    sequences(cases / 2);
}

#[test]
fn what_the_window_calls_current_is_what_the_command_line_makes() {
    half();
}

#[test]
fn and_so_it_is_in_other_sequences() {
    half();
}
