//! A scan in the real window: opened, laid on its part, compared, its patch planned and ready for export; taken away
//! again; refused on another part. The sample's scan has one worn place, 0.2 mm deep.

mod common;

use clearbeam::app::{App, Command, Purpose, Toggle};
use clearbeam::document::Edit;
use clearbeam::document::model::PatchChoice;
use common::window::{Answers, click, job_on, press, reveal, sample, says, settle, snapshot, window};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const JOB: &str = "[clean]\nsurfaces = [52]\n[layers]\nspacing_mm = 2.0\ndirection = \"x\"\n";

/// The window on a sample with the scan of the camshaft opened on it.
fn with_scan(folder: &tempfile::TempDir, part: &str, job: &str) -> Harness<'static, App> {
    let job = job_on(folder, part, job);
    let scan = folder.path().join("worn.ply");
    std::fs::copy(sample("camshaft_scan.ply"), &scan).expect("copies");
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Scan, scan));
    let mut h = window(Some(job), &answers);
    assert!(!h.state().can(Command::Toggle(Toggle::Scan)), "there are no points to be shown");
    reveal(&mut h, "Scan");
    click(&mut h, "Scan");
    reveal(&mut h, "Open scan…");
    h.get_by_label("Open scan…").click();
    h.step();
    h.step();
    // Taken away while it is looked at, it comes back as if it had never gone.
    h.state_mut().give(Command::Undo, &[]);
    h.step();
    h.state_mut().give(Command::Redo, &[]);
    h.step();
    assert!(h.state().plan().is_none() && !h.state().can(Command::Export), "nothing is current while it is looked at");
    settle(&mut h);
    h
}

fn planned_surfaces(h: &Harness<'_, App>) -> Vec<u32> {
    let planned = h.state().plan().expect("a plan");
    let mut all: Vec<u32> = planned.plan.passes.iter().map(|pass| pass.surface).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Depths of the patches that are listed, mm.
fn depths(h: &Harness<'_, App>) -> Vec<f64> {
    let words = |n: egui_kittest::Node<'_>| n.accesskit_node().label().unwrap_or_default();
    let rows = h.query_all_by_label_contains("mm deep").map(words);
    let number = |row: String| row.split_whitespace().nth(1)?.parse().ok();
    rows.filter_map(number).collect()
}

#[test]
fn the_worn_place_of_a_scan_is_found_planned_and_taken_away_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = with_scan(&folder, "camshaft", JOB);
    assert_eq!(h.state().why_no_plan(), None);
    assert_eq!(h.state().document().job().scan.files[0].file, "worn.ply", "named from the job's folder");
    reveal(&mut h, "Keep this position");
    assert!(says(&h, "mm rms, noise").contains("of the points lie on the part"));
    assert!(says(&h, "points read").contains("left"));
    let [depth] = depths(&h)[..] else { panic!("one patch, not {:?}", depths(&h)) };
    assert!((depth - 0.2).abs() < 0.015, "{depth} mm");
    assert!(h.query_by_label("scale of the deviation").is_some(), "the legend of the points");
    snapshot(&mut h, "scan");

    // What is planned is the patch, and nobody moves surfaces.
    let on_patch = planned_surfaces(&h);
    assert!(!on_patch.contains(&52) && !on_patch.is_empty(), "{on_patch:?}");
    assert!(h.state().can(Command::Export));
    let begun = h.state().document().job().clone();
    for command in [Command::Clean, Command::Unclean, Command::CleanLater, Command::Merge, Command::FlipSurface] {
        h.state_mut().give(command, &[52, on_patch[0]]);
        assert_eq!(*h.state().document().job(), begun, "{command:?}");
    }
    h.state_mut().set("surfaces.angle_deg", 60.0);
    assert_eq!(*h.state().document().job(), begun, "the crease angle cuts the facets of the file");
    settle(&mut h);

    // Undone, the model is as it was.
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(planned_surfaces(&h), [52]);
    assert!(h.state().surfaces().iter().all(|n| !on_patch.contains(n)));
    assert!(depths(&h).is_empty() && !h.state().can(Command::Toggle(Toggle::Scan)));
}

#[test]
fn a_patch_is_left_out_and_the_position_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = with_scan(&folder, "camshaft", JOB);
    let on_patch = planned_surfaces(&h);
    let found = depths(&h);
    reveal(&mut h, "work patch 1");
    click(&mut h, "work patch 1");
    assert_eq!(h.state().document().job().scan.patches, PatchChoice::At(Vec::new()));
    assert!(h.state().plan().is_none_or(|of| of.plan.passes.is_empty()), "nothing is left to be worked");
    assert_eq!(depths(&h), found, "it is still a patch");
    reveal(&mut h, "work patch 1");
    click(&mut h, "work patch 1");
    assert_eq!(h.state().document().job().scan.patches, PatchChoice::All);
    assert_eq!(planned_surfaces(&h), on_patch);

    reveal(&mut h, "Keep this position");
    click(&mut h, "Keep this position");
    let kept = h.state().document().job().scan.transform;
    assert!(kept.is_some() && h.query_by_label("The job gives the position").is_some());
    assert_eq!(depths(&h), found);
    assert!(h.state().can(Command::Export));
    reveal(&mut h, "Look for it again");
    click(&mut h, "Look for it again");
    assert_eq!(h.state().document().job().scan.transform, None);

    reveal(&mut h, "+ thinning");
    click(&mut h, "+ thinning");
    let counts = says(&h, " → ");
    let [before, after] = [0, 1].map(|k| {
        let digits = counts.split(" → ").nth(k).unwrap_or_default().chars().filter(char::is_ascii_digit);
        digits.collect::<String>().parse::<u64>().expect("a number")
    });
    assert!(0 < after && after < before, "{counts}");
    reveal(&mut h, "take cleaning step 1 out");
    click(&mut h, "take cleaning step 1 out");
    assert!(h.state().document().job().scan.steps.is_empty());
}

#[test]
fn a_scan_of_another_part_is_refused_and_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut h = with_scan(&folder, "front_shaft", "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 4.0\n");
    let why = h.state().why_no_plan().expect("a reason");
    assert!(why.contains("not a scan of the part") || why.contains("another unit"), "{why}");
    assert!(h.query_all_by_label(&why).next().is_some(), "it is shown");
    assert!(h.state().plan().is_none() && !h.state().can(Command::Export));
    assert!(depths(&h).is_empty() && !h.state().can(Command::Toggle(Toggle::Scan)));
    let scan = h.state().document().job().scan.clone();
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.state().can(Command::Export), "without it the job is as it was");
    let edit = clearbeam::document::scan_edit::ScanEdit::Files(scan.files, scan.units);
    h.state_mut().send(Edit::Scan(Box::new(edit)));
    settle(&mut h);
    assert!(h.state().why_no_plan().is_some());
}
