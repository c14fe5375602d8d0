//! A scan in the real window: opened, laid on its part, compared, its patch planned and ready for export; taken away
//! again; refused on another part; told when its file has changed. What the hand does with it is in `window_scan_hand`.

mod common;

use clearbeam::app::{App, Command, Purpose, Toggle};
use clearbeam::document::model::PatchChoice;
use common::scanned::{ScannedPart, WORN_MM, files, scan};
use common::window::{Answers, click, job_on, press, reveal, says, settle, snapshot, window};
use eframe::egui::{DroppedFile, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

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
    let (folder, job) = files(&scan(), None);
    let answers = Answers::default();
    answers.0.lock().expect("fresh").push((Purpose::Scan, folder.path().join("worn.ply")));
    let mut h = window(Some(job), &answers);
    assert!(!h.state().can(Command::Toggle(Toggle::Scan)), "there are no points to be shown");
    h.state_mut().give(Command::OpenScan, &[]);
    while h.state().document().job().scan.files.is_empty() {
        h.step();
    }
    // Taken away while it is looked at, it comes back as if it had never gone.
    h.state_mut().give(Command::Undo, &[]);
    h.step();
    h.state_mut().give(Command::Redo, &[]);
    h.step();
    assert!(h.state().plan().is_none() && !h.state().can(Command::Export), "nothing is current while it is looked at");
    settle(&mut h);
    assert_eq!(h.state().why_no_plan(), None);
    let file = &h.state().document().job().scan.files[0];
    assert_eq!(
        (file.file.as_str(), file.sha256.len()),
        ("worn.ply", 64),
        "named from the job's folder, and known again"
    );
    reveal(&mut h, "Keep this position");
    assert!(says(&h, "mm rms, noise").contains("of the points lie on the part"));
    let [depth] = depths(&h)[..] else { panic!("one patch, not {:?}", depths(&h)) };
    assert!((depth - WORN_MM).abs() < 0.05, "{depth} mm");
    assert!(h.query_by_label("scale of the deviation").is_some(), "the legend of the points");
    snapshot(&mut h, "scan");

    // What is planned is the patch, and nobody moves surfaces.
    let on_patch = planned_surfaces(&h);
    assert!(!on_patch.contains(&2) && !on_patch.is_empty(), "{on_patch:?}");
    assert!(h.state().can(Command::Export));
    let begun = h.state().document().job().clone();
    for command in [Command::Clean, Command::Unclean, Command::CleanLater, Command::Merge, Command::FlipSurface] {
        h.state_mut().give(command, &[2, on_patch[0]]);
        assert_eq!(*h.state().document().job(), begun, "{command:?}");
    }
    h.state_mut().set("surfaces.angle_deg", 60.0);
    assert_eq!(*h.state().document().job(), begun, "the crease angle cuts the facets of the file");

    // Undone, the model is as it was.
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(planned_surfaces(&h), [2]);
    assert!(h.state().surfaces().iter().all(|n| !on_patch.contains(n)));
    assert!(depths(&h).is_empty() && !h.state().can(Command::Toggle(Toggle::Scan)));
}

#[test]
fn a_patch_is_left_out_and_a_step_comes_and_goes() {
    let ScannedPart { mut h, .. } = ScannedPart::laid();
    let on_patch = planned_surfaces(&h);
    let found = depths(&h);
    reveal(&mut h, "work patch 1");
    click(&mut h, "work patch 1");
    assert_eq!(h.state().document().job().scan.patches, PatchChoice::At(Vec::new()));
    assert!(h.state().plan().is_none_or(|of| of.plan.passes.is_empty()), "nothing is left to be worked");
    assert_eq!(depths(&h), found, "it is still a patch");
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert_eq!(planned_surfaces(&h), on_patch);
    assert!(h.query_by_label("The job gives the position").is_some() && h.state().can(Command::Export));

    reveal(&mut h, "+ thinning");
    click(&mut h, "+ thinning");
    let counts = says(&h, " → ");
    let [before, after] = [0, 1].map(|k| {
        let digits = counts.split(" → ").nth(k).unwrap_or_default().chars().filter(char::is_ascii_digit);
        digits.collect::<String>().parse::<u64>().expect("a number")
    });
    assert!(0 < after && after <= before, "{counts}");
    reveal(&mut h, "take cleaning step 1 out");
    click(&mut h, "take cleaning step 1 out");
    assert!(h.state().document().job().scan.steps.is_empty());
}

#[test]
fn a_scan_of_another_part_is_refused_and_says_so() {
    let (folder, _) = files(&scan(), None);
    let other = tempfile::tempdir().expect("a folder");
    let job = job_on(&other, "front_shaft", "[clean]\nsurfaces = [1]\n[layers]\nspacing_mm = 8.0\n");
    let mut h = window(Some(job), &Answers::default());
    let dropped = Arc::new(Dropped(folder.path().join("worn.ply")));
    h.input_mut().dropped_files.push(dropped);
    h.step();
    h.input_mut().dropped_files.clear();
    settle(&mut h);
    assert_eq!(h.state().document().job().scan.files.len(), 1, "a scan that is dropped onto the window is added");
    let why = h.state().why_no_plan().expect("a reason");
    assert!(why.contains("not a scan of the part") || why.contains("another unit"), "{why}");
    assert!(h.query_all_by_label(&why).next().is_some(), "it is shown");
    assert!(h.state().plan().is_none() && !h.state().can(Command::Export));
    assert!(depths(&h).is_empty() && !h.state().can(Command::Toggle(Toggle::Scan)));
    press(&mut h, Modifiers::COMMAND, Key::Z);
    assert!(h.state().can(Command::Export), "without it the job is as it was");
}

#[test]
fn a_scan_that_has_changed_is_told_and_one_click_takes_it() {
    let (folder, job) = files(&scan(), Some(&format!("transform = {:?}", IDENTITY)));
    let text = std::fs::read_to_string(&job).expect("reads");
    std::fs::write(&job, format!("{text}sha256 = \"{}\"\n", "0".repeat(64))).expect("writes");
    let mut h = window(Some(job), &Answers::default());
    let why = h.state().why_no_plan().expect("a reason");
    assert!(why.contains("worn.ply: this is another scan"), "{why}");
    // Not looked for from anywhere: that is another test's.
    std::fs::write(folder.path().join("worn.ply"), "ply\n").expect("writes");
    click(&mut h, "Use the changed scan");
    let scan = &h.state().document().job().scan;
    assert!(scan.files[0].sha256 != "0".repeat(64) && scan.transform.is_none());
    assert!(!h.state().why_no_plan().expect("now it is no scan at all").contains("another scan than"));
}

const IDENTITY: [f64; 16] = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// A file that is let go of over the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|e| e.to_string())
    }
}
