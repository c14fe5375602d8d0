//! A small part with a scan of it in the real window: worn in one place, in a pose of its own, and quickly looked at.
#![allow(dead_code, reason = "each test file uses its own share")]

use super::window::{Answers, settle, window};
use clearbeam::app::App;
use clearbeam::sample::camshaft_scan::ply_bytes;
use clearbeam::sample::scan_maker::{MadeScan, ScanRecipe, SkinPoint, made_scan};
use clearbeam::sample::{SAMPLES, stl_bytes};
use clearbeam::scan::transform_file::rows;
use clearbeam::view::ViewSize;
use eframe::egui::{Event, Modifiers, PointerButton, Pos2, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use nalgebra::{Isometry3, Point2, Point3, UnitVector3, Vector3};
use std::path::PathBuf;
use tempfile::TempDir;

/// Depth of the worn place and its radius, mm; it lies on the front of the plate.
pub const WORN_MM: f64 = 0.5;
const RADIUS_MM: f64 = 14.0;
const MIDDLE: Point3<f64> = Point3::new(25.0, 0.0, 50.0);
/// Half a point per mm²: enough for the worn place.
const POINTS: usize = 12_000;

/// A window on the workpiece with its scan.
pub struct ScannedPart {
    pub h: Harness<'static, App>,
    pub folder: TempDir,
    pub scan: MadeScan,
}

/// The scan of the workpiece; it is turned little, so that its front is seen from the front.
pub fn scan() -> MadeScan {
    let wear = |p: &SkinPoint| {
        let share = (p.place - MIDDLE).norm_squared() / (RADIUS_MM * RADIUS_MM);
        if p.normal.y < -0.9 && share < 1.0 { WORN_MM * (1.0 - share) * (1.0 - share) } else { 0.0 }
    };
    let recipe = ScanRecipe {
        noise_mm: 0.01,
        seen_from: UnitVector3::new_normalize(Vector3::new(0.3, -0.8, 0.5)),
        scan_from_model: Isometry3::new(Vector3::new(60.0, -25.0, 10.0), Vector3::new(0.08, -0.05, 0.12)),
        wear_mm: Some(&wear),
        ..ScanRecipe::of(POINTS, 7)
    };
    made_scan(&(SAMPLES[0].triangles)(), &recipe)
}

/// Part and scan in a folder, with a job whose `[scan]` says this besides; `None`: the job has no scan.
pub fn files(scan: &MadeScan, said: Option<&str>) -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).expect("writes");
    write("part.stl", &stl_bytes(&(SAMPLES[0].triangles)()));
    write("worn.ply", &ply_bytes(&scan.points));
    let of_scan =
        said.map_or_else(String::new, |said| format!("[scan]\n{said}\n[[scan.files]]\nfile = \"worn.ply\"\n"));
    let job = "[part]\nfile = \"part.stl\"\n[clean]\nsurfaces = [2]\n[layers]\nspacing_mm = 4.0\ndirection = \"x\"\n";
    write("job.toml", format!("{job}{of_scan}").as_bytes());
    let file = folder.path().join("job.toml");
    (folder, file)
}

impl ScannedPart {
    /// The scan where it belongs.
    pub fn laid() -> ScannedPart {
        let scan = scan();
        let transform = format!("transform = {:?}", rows(&scan.model_from_scan));
        ScannedPart::with(scan, &transform)
    }

    /// The scan with what `[scan]` says of it.
    pub fn with(scan: MadeScan, said: &str) -> ScannedPart {
        let (folder, job) = files(&scan, Some(said));
        let mut h = window(Some(job), &Answers::default());
        settle(&mut h);
        ScannedPart { h, folder, scan }
    }

    /// The point of the front of the plate that was scanned nearest to a place, on the model and in the scan.
    pub fn scanned_at(&self, x: f64, z: f64) -> (Point3<f64>, Point3<f64>) {
        let place = Point3::new(x, 0.0, z);
        let seen = self.scan.taken_from.iter().zip(&self.scan.points);
        let front = seen.filter_map(|(at, p)| Some((at.filter(|at| at.normal.y < -0.9)?.place, *p)));
        let off = |at: &Point3<f64>| (at - place).norm();
        front.min_by(|a, b| off(&a.0).total_cmp(&off(&b.0))).expect("the front was seen")
    }

    /// Where a point of the scene is seen, in the window.
    pub fn seen_at(&self, scene: &Point3<f64>) -> Pos2 {
        let view = self.h.get_by_label("3D view").rect();
        let size = ViewSize::new(f64::from(view.width()), f64::from(view.height()));
        let (x, y, _) = self.h.state().camera().project(scene, size).expect("in front of the eye");
        let Point2 { coords } = Point2::new(x, y);
        view.min + pos2(coords.x as f32, coords.y as f32).to_vec2()
    }

    /// Clicks a point of the scene.
    pub fn click_at(&mut self, scene: &Point3<f64>) {
        let pos = self.seen_at(scene);
        for pressed in [true, false] {
            self.h.hover_at(pos);
            let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
            self.h.event(Event::PointerButton { pos, button, pressed, modifiers });
            self.h.step();
        }
        settle(&mut self.h);
    }
}
