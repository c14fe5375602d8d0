//! Scans of the sample parts, each in three positions of its own with 30 % missing, laid on their parts again; what is
//! swept over more is a bench (`benches/registration.rs`).

use clearbeam::part::{Part, Placement, Units};
use clearbeam::progress::Progress;
use clearbeam::sample::scan_maker::{ScanRecipe, made_scan};
use clearbeam::sample::{SAMPLES, Triangles, stl_bytes};
use clearbeam::scan::Cloud;
use clearbeam::scan::registration::{RegistrationOptions, SurfaceNormals, most_moved_mm, register};

const POSES: u64 = 3;
const POINTS: usize = 30_000;

fn triangles(name: &str) -> Triangles {
    (SAMPLES.iter().find(|s| s.name == name).expect("a sample").triangles)()
}

/// Lays each scan and tells how far off the worst one is, mm.
fn worst_mm(name: &str) -> f64 {
    let triangles = triangles(name);
    let part = Part::from_bytes(&stl_bytes(&triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
    let normals = SurfaceNormals::at_usual_creases(&part);
    let off = |seed: u64| {
        let noise_mm = 2e-4 * part.mesh.diagonal();
        let recipe = ScanRecipe { noise_mm, missing_share: 0.3, ..ScanRecipe::of(POINTS, 100 + seed) };
        let made = made_scan(&triangles, &recipe);
        let cloud = Cloud::of_points(&made.points);
        let options = RegistrationOptions::default();
        let found = register(&part, &normals, &cloud, &options, &Progress::default()).expect("it lies on its part");
        most_moved_mm(&part, &(found.model_from_scan * made.model_from_scan.inverse()))
    };
    (0..POSES).map(off).fold(0.0, f64::max)
}

#[test]
fn the_camshaft_is_found_in_every_position() {
    let worst_mm = worst_mm("camshaft");
    assert!(worst_mm < 0.03, "{worst_mm}");
}

#[test]
fn the_connecting_rod_is_found_in_every_position() {
    let worst_mm = worst_mm("connecting_rod");
    assert!(worst_mm < 0.03, "{worst_mm}");
}

#[test]
fn the_front_shaft_is_found_in_every_position() {
    let worst_mm = worst_mm("front_shaft");
    assert!(worst_mm < 0.03, "{worst_mm}");
}
