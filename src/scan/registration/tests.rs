//! Scans of parts with known poses, laid on them again.

use super::parts_for_tests::{off_mm, part_of, scan};
use super::scan_for_tests::ScanOf;
use super::*;
use crate::sample::solids::{PlateFeature, plate};

#[test]
fn a_plate_with_a_boss_is_found_from_anywhere() {
    let feature =
        |x: f64, y: f64, diameter: f64, height: f64| PlateFeature { centre: [x, y], diameter, sides: 48, height };
    let part = part_of(&plate([80.0, 50.0, 12.0], &[feature(20.0, 18.0, 24.0, 25.0), feature(60.0, 30.0, 10.0, 0.0)]));
    let normals = SurfaceNormals::at_usual_creases(&part);
    for pose in 0..3 {
        let of = ScanOf { points: 30_000, missing: 0.3, noise_mm: 0.03, outliers: 0.01, pose };
        let (cloud, truth) = scan(&part, &of);
        let found =
            register(&part, &normals, &cloud, &RegistrationOptions::default(), &Progress::default()).expect("found");
        let off = off_mm(&part, &found.model_from_scan, &truth);
        assert!(off < 0.03, "{off} {found:?}");
    }
}
