//! The hand on a scan in the real window: pairs that lay it, places that do not count, cuts with what they would take
//! out, labels, the section, and where the scanner stands. Each becomes an edit, and is undone as one.

mod common;

use clearbeam::app::{App, Command, Toggle};
use clearbeam::document::model::ScanRegion;
use clearbeam::scan::cleaning::Step;
use clearbeam::view::StandardView;
use common::scanned::{ScannedPart, scan};
use common::window::{click, drag, press, reveal, says, settle, snapshot, type_into};
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

/// Places on the front of the plate, x and z, mm: apart from each other, and not behind block and lug.
const PLACES: [[f64; 2]; 3] = [[-46.0, 4.0], [46.0, 50.0], [-20.0, 76.0]];

fn begin(h: &mut Harness<'_, App>, label: &str) {
    reveal(h, label);
    click(h, label);
}

fn undo(h: &mut Harness<'_, App>) {
    press(h, Modifiers::COMMAND, Key::Z);
}

#[test]
fn a_scan_that_lies_wrong_is_laid_by_three_pairs() {
    let wrong = "transform = [1, 0, 0, 9, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]";
    let mut of = ScannedPart::with(scan(), wrong);
    begin(&mut of.h, "Pick pairs");
    assert!(of.h.query_by_label_contains("Click a point of the scan").is_some());
    for (i, [x, z]) in PLACES.into_iter().enumerate() {
        let (on_model, in_scan) = of.scanned_at(x, z);
        let scene_from_scan = of.h.state().scene_from_scan().expect("the scan stands beside the part");
        of.click_at(&(scene_from_scan * in_scan));
        if i == 0 {
            assert!(of.h.query_by_label_contains("Now click the same place on the model").is_some());
        }
        of.click_at(&on_model);
    }
    assert_eq!(of.h.state().document().job().scan.pairs.len(), 0, "nothing is in the job before it is taken over");
    assert!(says(&of.h, "Pair 3: ").ends_with("mm off"));
    begin(&mut of.h, "take pair 2 out");
    assert!(of.h.query_by_label("Lay by these 2 pairs").is_some() && of.h.query_by_label("Pair 3").is_none());
    let (on_model, in_scan) = of.scanned_at(PLACES[1][0], PLACES[1][1]);
    let scene_from_scan = of.h.state().scene_from_scan().expect("it stands there still");
    // The other way round is as good.
    of.click_at(&on_model);
    of.click_at(&(scene_from_scan * in_scan));
    begin(&mut of.h, "Lay by these 3 pairs");
    let job = of.h.state().document().job();
    assert_eq!((job.scan.pairs.len(), job.scan.transform), (3, None));
    assert_eq!(of.h.state().why_no_plan(), None);
    assert!(of.h.query_all_by_label_contains("mm deep").count() == 1, "it lies as it should");
    assert!(of.h.state().scene_from_scan().is_none(), "the tool is laid down");
    begin(&mut of.h, "Pick pairs");
    press(&mut of.h, Modifiers::NONE, Key::Escape);
    assert!(of.h.query_by_label("Lay by these 3 pairs").is_none(), "Esc lays it down");
    undo(&mut of.h);
    assert!(of.h.state().document().job().scan.transform.is_some(), "one step back it lies as it did");
}

#[test]
fn places_are_left_out_by_brush_and_box_and_count_again() {
    let mut of = ScannedPart::laid();
    let left_out = |of: &ScannedPart| of.h.state().document().job().scan.left_out.clone();
    begin(&mut of.h, "Leave places out");
    // Higher up the block stands before the plate.
    let [from, to] = [[-46.0, 4.0], [-46.0, 14.0]].map(|[x, z]| of.seen_at(&of.scanned_at(x, z).0));
    let eye = *of.h.state().camera();
    drag(&mut of.h, from, to);
    assert_eq!(*of.h.state().camera(), eye, "a stroke does not turn the view");
    let painted = left_out(&of);
    let on_front = |r: &ScanRegion| matches!(r, ScanRegion::Sphere { centre_mm, .. } if centre_mm[1].abs() < 0.01);
    assert!(painted.len() > 2 && painted.iter().all(on_front), "{painted:?}");
    click(&mut of.h, "Rubber");
    of.click_at(&of.scanned_at(-46.0, 4.0).0);
    assert!(left_out(&of).len() < painted.len());
    undo(&mut of.h);
    assert_eq!(left_out(&of), painted);
    of.h.state_mut().give(Command::Look(StandardView::Iso), &[3]);
    settle(&mut of.h);
    begin(&mut of.h, "Box around the selected surfaces");
    let ScanRegion::Box { min_mm, max_mm } = left_out(&of)[painted.len()] else { panic!("a box") };
    assert!(min_mm[0] < 17.0 && max_mm[0] > 43.0, "around the top of the lug, {min_mm:?} {max_mm:?}");
    begin(&mut of.h, "All count again");
    assert!(left_out(&of).is_empty());
    undo(&mut of.h);
    assert_eq!(left_out(&of).len(), painted.len() + 1);
}

#[test]
fn cuts_show_what_they_would_take_out_before_they_are_steps() {
    let mut of = ScannedPart::laid();
    let steps = |of: &ScannedPart| of.h.state().document().job().scan.steps.clone();
    begin(&mut of.h, "cut by plane");
    begin(&mut of.h, "plane across x");
    assert!(says(&of.h, " points out").starts_with("takes 0 of"));
    type_into(&mut of.h, "shift of the plane", "60");
    let told = says(&of.h, " points out");
    assert!(!told.starts_with("takes 0 of") && steps(&of).is_empty(), "{told}");
    snapshot(&mut of.h, "scan_cut");
    begin(&mut of.h, "Add this step");
    assert!(matches!(steps(&of)[..], [Step::CutPlane { normal: [1.0, 0.0, 0.0], .. }]), "{:?}", steps(&of));
    let after = says(&of.h, " → ");
    undo(&mut of.h);
    assert!(steps(&of).is_empty() && !after.is_empty());

    begin(&mut of.h, "cut by brush");
    let scene_from_scan = of.h.state().scene_from_scan().expect("it is shown alone");
    let [from, to] = [[-46.0, 4.0], [-46.0, 30.0]].map(|[x, z]| of.seen_at(&(scene_from_scan * of.scanned_at(x, z).1)));
    drag(&mut of.h, from, to);
    begin(&mut of.h, "Add this step");
    assert!(matches!(&steps(&of)[..], [Step::Erase { centres, .. }] if centres.len() > 2), "{:?}", steps(&of));
    undo(&mut of.h);

    begin(&mut of.h, "cut by box");
    assert!(says(&of.h, " points out").starts_with("takes 0 of"), "the box is around all at first");
    begin(&mut of.h, "Cancel");
    assert!(steps(&of).is_empty() && of.h.query_by_label("Add this step").is_none());
}

#[test]
fn labels_and_the_section_tell_what_is_off() {
    let mut of = ScannedPart::laid();
    begin(&mut of.h, "Set labels");
    let deepest = of.scanned_at(25.0, 50.0).0;
    of.click_at(&deepest);
    assert!(says(&of.h, "1: -0.4").contains("mm at"), "some 0.5 mm are missing there, smoothed");
    press(&mut of.h, Modifiers::NONE, Key::Escape);
    of.h.state_mut().give(Command::Toggle(Toggle::ScanSection), &[]);
    of.h.state_mut().give(Command::Toggle(Toggle::DeviationOnModel), &[]);
    settle(&mut of.h);
    click(&mut of.h, "section across z");
    assert!(of.h.query_by_label("section of part and scan").is_some());
    snapshot(&mut of.h, "scan_section");
    of.h.state_mut().give(Command::Toggle(Toggle::ScanSection), &[]);
    settle(&mut of.h);
    begin(&mut of.h, "remove label 1");
    assert!(of.h.query_by_label_contains("1: -0.4").is_none());
}

#[test]
fn the_scanner_stands_where_its_frame_or_markers_say() {
    let mut of = ScannedPart::laid();
    let frame = |of: &ScannedPart| of.h.state().document().job().scan.flange_from_scan.clone();
    reveal(&mut of.h, "Type the scanner's frame");
    assert!(of.h.query_all_by_label_contains("othing of the scan goes to the cell").next().is_some());
    // The shipped cell has the part in the robot's hand.
    assert!(of.h.query_all_by_label_contains("as seen from the flange").next().is_some());
    click(&mut of.h, "Type the scanner's frame");
    type_into(&mut of.h, "scanner on the flange x", "700");
    assert_eq!(frame(&of).expect("given").position_mm, [700.0, 0.0, 0.0]);
    begin(&mut of.h, "Forget where it stands");
    assert_eq!(frame(&of), None);
    begin(&mut of.h, "Markers");
    assert!(of.h.query_by_label_contains("Marker 3").is_some() && frame(&of).is_none());
    for (field, value) in [
        ("marker 2 in the scan x", "100"),
        ("marker 2 as seen from the flange x", "100"),
        ("marker 3 in the scan y", "80"),
        ("marker 3 as seen from the flange y", "80.2"),
    ] {
        type_into(&mut of.h, field, value);
    }
    let fitted = frame(&of).expect("three markers tell it");
    assert!(fitted.points().is_some_and(|points| points.len() == 3));
    assert!(says(&of.h, "Marker 3: ").ends_with("mm off"));
}
