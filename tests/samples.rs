//! The shipped samples and their jobs are what is made here, byte for byte; each job plans, and
//! what the samples are there to show holds.
//!
//! `CLEARBEAM_BLESS=1 cargo test --test samples` writes them anew.

use clearbeam::document::{Job, files, segmented};
use clearbeam::part::digest_of;
use clearbeam::planning::report::Report;
use clearbeam::planning::{self, PlanCache};
use clearbeam::progress::Progress;
use clearbeam::sample::weld_panel::{self, WeldScene};
use clearbeam::sample::{SAMPLES, camshaft, camshaft_scan, stl_bytes};
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples")
}

fn blessing() -> bool {
    std::env::var_os("CLEARBEAM_BLESS").is_some()
}

/// The job of a sample: what its paper cleans or clads, with that paper's parameters.
fn sample_job(name: &str, stl: &[u8]) -> Job {
    let mut job = Job::default();
    job.part.file = format!("{name}.stl");
    job.part.sha256 = digest_of(stl);
    let (surfaces, direction) = match name {
        // P1 Fig. 14: crater, lug boss, plane with holes.
        "workpiece" => (vec![2, 3, 1], "z"),
        // P1 Figs 7 and 8: the tooth gaps, at D = 3 mm.
        "worm_gear" => ((0..26).map(|gap| 2 * gap + 1).collect(), "z"),
        "acetabular_cup" => (vec![1], "z"),
        "connecting_rod" => (vec![3], "z"),
        // P3 4.1: planes square to the camshaft's axis.
        "camshaft" => (vec![camshaft::WORN_SURFACE], "x"),
        // P1 Fig. 2b: both journals and the tube.
        _ => (vec![5, 7, 11], "z"),
    };
    job.settings.choose(surfaces);
    job.layers.direction = direction.parse().expect("a direction");
    if name == "worm_gear" {
        job.beam.defocus_mm = 3.0;
    }
    if name == "acetabular_cup" {
        // P2 Table 3.
        job.layers.spacing_mm = 6.0;
        job.beam.defocus_mm = 15.0;
        job.path.chord_error_mm = 0.5;
        job.path.max_step_mm = 1000.0;
        job.path.max_turn_deg = 90.0;
    }
    if name == "camshaft" {
        // P3 4.4; its bead is not told: one layer of this one fills wear of 0.2 mm, with lines as far apart as Eq. 1 says.
        (job.beam.power_w, job.beam.speed_mm_s, job.beam.spot_mm) = (800.0, 8.0, 2.0);
        (job.bead.width_mm, job.bead.height_mm, job.layers.spacing_mm) = (2.0, 0.3, 1.35);
    }
    job
}

fn assert_shipped(name: &str, made: &[u8]) {
    let file = folder().join(name);
    if blessing() {
        std::fs::write(&file, made).expect("writes");
    }
    let shipped = std::fs::read(&file).unwrap_or_default();
    assert!(shipped == made, "{} differs from what is made here", file.display());
}

#[test]
fn the_files_are_what_is_made_here() {
    for s in SAMPLES {
        let stl = stl_bytes(&(s.triangles)());
        assert_shipped(&format!("{}.stl", s.name), &stl);
        let text = files::to_toml(&sample_job(s.name, &stl)).expect("writes");
        assert_shipped(&format!("{}.toml", s.name), text.as_bytes());
    }
    let scan = camshaft_scan::scan();
    assert_shipped("camshaft_scan.ply", &camshaft_scan::ply_bytes(&scan.points));
    assert_shipped("camshaft_truth.json", camshaft_scan::truth_json(&scan).as_bytes());
}

/// The images of the weld, by their pixels: how well a file is packed may differ from machine to machine.
#[test]
fn the_images_of_the_weld_are_what_is_made_here() {
    let scene = WeldScene::new();
    let (grey, depth) = scene.images(weld_panel::NOISE_MM, weld_panel::SEED);
    let made = [("gray.png", weld_panel::grey_png(&grey)), ("depth.png", weld_panel::depth_png(&depth))];
    let mut bytes = 0;
    for (name, png) in made {
        let file = folder().join("weld").join(name);
        if blessing() {
            std::fs::write(&file, &png).expect("writes");
        }
        let shipped = std::fs::read(&file).unwrap_or_default();
        let pixels = |png: &[u8]| image::load_from_memory(png).ok();
        assert!(
            pixels(&shipped).is_some_and(|p| Some(p) == pixels(&png)),
            "{} differs from what is made here",
            file.display()
        );
        bytes += shipped.len();
    }
    assert!(bytes < 1_000_000, "{bytes} bytes of images");
    assert_shipped("weld/camera.toml", weld_panel::camera_toml().as_bytes());
    assert_shipped("weld/truth.json", weld_panel::truth_json(&scene).as_bytes());
}

#[test]
fn every_job_plans_and_shows_what_it_is_there_for() {
    for s in SAMPLES {
        let file = folder().join(format!("{}.toml", s.name));
        let job = files::read(&file).expect("reads");
        let part = files::load_part(&job, Some(&file)).expect("loads");
        let setup = files::load_setup(&job, Some(&file)).expect("a cell");
        let surfaces = segmented(&part, &job);
        let plan =
            planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()).expect(s.name);
        let report = Report::new(&plan, &surfaces);
        assert_eq!(report.blocked, 0, "{}: nothing that the papers clean stays blocked", s.name);
        let corrected = ["workpiece", "worm_gear"].contains(&s.name);
        assert_eq!(report.interfering > 50, corrected, "{}: {} interfere", s.name, report.interfering);
        if s.name == "acetabular_cup" {
            assert_eq!(report.passes, 5);
        }
    }
}
