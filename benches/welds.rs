//! The stages of a weld: images read, masked, measured, put on the part; and what was measured beside the truth.
//!
//! `cargo bench --bench welds` takes the sample's scene at two noises of depth, over three seeds each; medians of three.

use clearbeam::document::Job;
use clearbeam::document::model::{JobWeld, NamedImage, WeldFiles};
use clearbeam::planning::welded::{mask_weld, measure_weld, read_weld, weld_on_part};
use clearbeam::progress::Progress;
use clearbeam::sample::weld_panel::{self, WeldScene};
use clearbeam::weld::bead::SeenArea;
use clearbeam::weld::points::points;
use clearbeam::weld::raster::Mask;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

fn main() {
    let scene = WeldScene::new();
    println!(
        "| noise mm | seed | read ms | mask ms | parent ms | measure ms | on the part ms | IoU bead | height mm off | centre line mm rms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for noise_mm in [0.3, 1.0] {
        for seed in 1..=3 {
            row(&scene, noise_mm, seed);
        }
    }
}

fn row(scene: &WeldScene, noise_mm: f64, seed: u64) {
    let (grey, depth) = scene.images(noise_mm, seed);
    let Ok(folder) = tempfile::tempdir() else { return };
    let write = |name: &str, bytes: Vec<u8>| std::fs::write(folder.path().join(name), bytes).is_ok();
    let is_written = write("gray.png", weld_panel::grey_png(&grey))
        && write("depth.png", weld_panel::depth_png(&depth))
        && write("camera.toml", weld_panel::camera_toml().into_bytes());
    if !is_written {
        return;
    }
    let named = |name: &str| NamedImage { file: path(folder.path(), name), ..NamedImage::default() };
    let images = WeldFiles { gray: named("gray.png"), depth: named("depth.png"), camera: named("camera.toml") };
    let job = Job::grinding(JobWeld { images, ..JobWeld::default() });
    let progress = Progress::default();
    let (read_ms, read) = timed(|| read_weld(&job.weld, None, &progress));
    let Ok(read) = read else { return };
    let (mask_ms, masked) = timed(|| mask_weld(&read, &job.weld, &progress));
    let Ok(masked) = masked else { return };
    let all = points(&read.depth, &read.camera, None);
    let (first, covered) = (masked.areas.mask(&[0]), masked.areas.mask_of_all());
    let (parent_ms, _) = timed(|| SeenArea::new(&all, &first, &covered).is_ok());
    let (measure_ms, measured) = timed(|| measure_weld(&read, &masked, &job.weld, &progress));
    let Ok(measured) = measured.map(Arc::new) else { return };
    let nothing = (Arc::default(), Arc::default());
    let (on_ms, _) = timed(|| weld_on_part((&read, &measured), (&nothing.0, &nothing.1), &job, &progress));
    let Some(bead) = measured.bead() else { return };
    let truth = Mask { width: weld_panel::WIDTH, height: weld_panel::HEIGHT, values: scene.bead_mask() };
    let line = scene.centre_line(1501);
    let off = |p: &nalgebra::Point3<f64>| line.iter().map(|q| (q - p).norm()).fold(f64::INFINITY, f64::min);
    let squares: f64 = bead.sections.iter().map(|s| off(&s.centre).powi(2)).sum();
    let rms_mm = (squares / bead.sections.len() as f64).sqrt();
    let (iou, height_mm) = (bead.outline.overlap(&truth), bead.max_height_mm - scene.max_height_mm());
    println!(
        "| {noise_mm} | {seed} | {read_ms:.1} | {mask_ms:.1} | {parent_ms:.1} | {measure_ms:.1} | {on_ms:.1} | {iou:.3} | {height_mm:+.3} | {rms_mm:.3} |"
    );
}

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

/// The middle one of three times, ms, and what was made.
fn timed<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut once = || {
        let begun = Instant::now();
        let made = work();
        (1e3 * begun.elapsed().as_secs_f64(), made)
    };
    let mut all = [once(), once(), once()];
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [_, middle, _] = all;
    middle
}
