//! The stages of a scan on two threads: read, clean, laid on the model from anywhere, compared with it.
//!
//! `cargo bench --bench scans -- PART.stl SCAN.ply [TRUTH.json]…` prints a row for each pair or triple; without files the sample
//! camshaft, its scan made anew with a million points. The truth is JSON with `model_from_scan`, row by row. Medians of
//! three; registration is run once.

use clearbeam::document::{Job, segmented};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::planning::scanned::{LaidScan, ScanModel, compare};
use clearbeam::progress::Progress;
use clearbeam::sample::scan_maker::{ScanRecipe, made_scan};
use clearbeam::sample::{SAMPLES, stl_bytes};
use clearbeam::scan::cleaning::{Step, clean};
use clearbeam::scan::deviation::{Deviation, DeviationRules, PatchRules, Patches, SmoothedDepths};
use clearbeam::scan::registration::{RegistrationOptions, SurfaceNormals, most_moved_mm, register};
use clearbeam::scan::{Cloud, file, ply_file, transform_file};
use nalgebra::Isometry3;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

fn main() {
    let paths: Vec<PathBuf> = std::env::args().skip(1).filter(|a| a != "--bench").map(PathBuf::from).collect();
    println!(
        "| part | facets | points | read s | outliers s | thinned s | register s | off mm | distances s | compared s | deepest mm |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    if paths.is_empty() {
        sample();
    }
    let is_json = |p: &PathBuf| p.extension().is_some_and(|e| e == "json");
    let mut rest = &paths[..];
    while let [part, scan, more @ ..] = rest {
        let truth = more.first().filter(|p| is_json(p));
        rest = if truth.is_some() { &more[1..] } else { more };
        let model_from_scan = truth.and_then(|t| transform_file::read(t).ok());
        match std::fs::read(part) {
            Ok(bytes) => row(&part.display().to_string(), &bytes, scan, model_from_scan),
            Err(error) => eprintln!("{}: {error}", part.display()),
        }
    }
}

fn sample() {
    let Some(sample) = SAMPLES.iter().find(|s| s.name == "camshaft") else { return };
    let triangles = (sample.triangles)();
    let made = made_scan(&triangles, &ScanRecipe { missing_share: 0.3, ..ScanRecipe::of(1_000_000, 1) });
    let Ok(folder) = tempfile::tempdir() else { return };
    let scan = folder.path().join("scan.ply");
    if std::fs::write(&scan, ply_file::bytes(&Cloud::of_points(&made.points), &[])).is_ok() {
        row(sample.name, &stl_bytes(&triangles), &scan, Some(made.model_from_scan));
    }
}

/// The middle one of three times, s, and what was made.
fn timed<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut once = || {
        let begun = Instant::now();
        let made = work();
        (begun.elapsed().as_secs_f64(), made)
    };
    let mut all = [once(), once(), once()];
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [_, middle, _] = all;
    middle
}

fn row(name: &str, stl: &[u8], scan: &Path, truth: Option<Isometry3<f64>>) {
    let progress = Progress::default();
    let Ok(part) = Part::from_bytes(stl, Units::Mm, &Placement::default(), &[]) else { return };
    let (read_s, Ok(raw)) = timed(|| file::read(scan, &progress)) else { return };
    let thin = Step::Thin { voxel_mm: 0.5 };
    let (outliers_s, Ok(cleaned)) = timed(|| clean(&raw.cloud, &[Step::OUTLIERS], &progress)) else { return };
    let (thin_s, _) = timed(|| clean(&raw.cloud, std::slice::from_ref(&thin), &progress).map(|c| c.cloud.len()));
    let normals = SurfaceNormals::at_usual_creases(&part);
    let begun = Instant::now();
    let found = register(&part, &normals, &cleaned.cloud, &RegistrationOptions::default(), &progress);
    let register_s = begun.elapsed().as_secs_f64();
    let found = match found {
        Ok(found) => found,
        Err(why) => return eprintln!("{name}: {why}"),
    };
    let job = Job::default();
    let (surfaces, part) = (Arc::new(segmented(&part, &job)), Arc::new(part));
    let model_from_scan = truth.unwrap_or(found.model_from_scan);
    let laid = LaidScan {
        model_from_scan,
        registration: None,
        cloud_in_part: Arc::new(cleaned.cloud.clone().moved(&model_from_scan)),
        model: ScanModel { part: part.clone(), surfaces, continued: Vec::new() },
    };
    let (compare_s, Ok(compared)) = timed(|| compare(&laid, &job.scan, &progress)) else { return };
    let cloud = &laid.cloud_in_part;
    let rules = DeviationRules { within_mm: 0.05 * part.mesh.diagonal() };
    let (deviation_s, Ok(deviation)) = timed(|| Deviation::new(&part, cloud, &rules, &progress)) else { return };
    let smoothed = timed(|| SmoothedDepths::new(&part, cloud, &deviation, &progress));
    let (smoothed_s, Ok(depths)) = smoothed else { return };
    let rules = PatchRules { min_depth_mm: job.scan.min_depth_mm, min_area_mm2: 0.0 };
    let (patches_s, Ok(patches)) = timed(|| Patches::new(&part, &depths, &rules, &progress)) else { return };
    eprintln!(
        "{name}: smoothed {smoothed_s:.3} s, patches {patches_s:.3} s ({} triangles)",
        patches.field.triangles.len()
    );
    println!(
        "| {name} | {} | {} | {read_s:.3} | {outliers_s:.3} | {thin_s:.3} | {register_s:.2} | {:.4} | {deviation_s:.3} | {compare_s:.3} | {:.4} |",
        part.mesh.facets.len(),
        raw.cloud.len(),
        truth.map_or(f64::NAN, |truth| most_moved_mm(&part, &(found.model_from_scan * truth.inverse()))),
        compared.patches.patches.first().map_or(0.0, |p| p.depth_mm),
    );
}
