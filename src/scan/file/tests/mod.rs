//! Every form of file, written here and read back; and what of each is refused or told.

mod damaged;
mod e57;
mod pcd;
mod ply;
mod ptx;
mod text;

use super::{RawScan, ScanFileError, ScanFinding, from_bytes};
use crate::progress::Progress;

/// A point with all that it can have.
#[derive(Clone, Copy, Debug)]
struct Full {
    place: [f64; 3],
    normal: [f64; 3],
    colour: [u8; 3],
    intensity: f32,
}

/// So many points on a lattice of halves, so that single numbers hold all of them, from the origin or far from it.
fn points(count: usize, shift: f64) -> Vec<Full> {
    let point = |i: usize| {
        let at = |step: usize| ((i / step) % 10) as f64 * 0.5 + shift;
        let axis = i % 3;
        Full {
            place: [at(1), at(10), at(100)],
            normal: std::array::from_fn(|k| if k == axis { -1.0 } else { 0.0 }),
            colour: [(i % 256) as u8, (i / 7 % 256) as u8, 255],
            intensity: i as f32 * 0.25,
        }
    };
    (0..count).map(point).collect()
}

fn scan(name: &str, bytes: &[u8]) -> RawScan {
    from_bytes(name, bytes, &Progress::default()).unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn refused(name: &str, bytes: &[u8]) -> ScanFileError {
    from_bytes(name, bytes, &Progress::default()).expect_err(name)
}

/// Compares places, and whatever the scan has beside them.
fn assert_holds(found: &RawScan, expected: &[Full]) {
    let cloud = &found.cloud;
    assert_eq!(cloud.len(), expected.len(), "{:?}", found.findings);
    for (i, full) in expected.iter().enumerate() {
        let place = cloud.point(i);
        assert!((0..3).all(|k| (place[k] - full.place[k]).abs() < 1e-5), "{i}: {place} {:?}", full.place);
        if let Some(normal) = cloud.normal(i) {
            assert!((0..3).all(|k| (normal[k] - full.normal[k]).abs() < 1e-6), "{i}: {normal}");
        }
        assert_eq!(cloud.colours.as_ref().map_or(full.colour, |c| c[i]), full.colour, "{i}");
        assert_eq!(cloud.intensities.as_ref().map_or(full.intensity, |c| c[i]), full.intensity, "{i}");
    }
    let (lo, hi) = cloud.bounds().expect("not empty");
    assert!((cloud.origin - (lo + (hi - lo) * 0.5)).norm() <= 1e-6 * (hi - lo).norm(), "the origin is the middle");
}

/// What the cloud has beside places: normals, colours, intensities.
fn has(found: &RawScan) -> [bool; 3] {
    let cloud = &found.cloud;
    [cloud.normals.is_some(), cloud.colours.is_some(), cloud.intensities.is_some()]
}

#[test]
fn what_is_no_scan_is_named() {
    assert!(matches!(refused("a.xyz", b""), ScanFileError::Empty));
    assert!(matches!(refused("a.txt", b"Dear reader,\nthis is a letter.\n"), ScanFileError::Unknown));
    assert!(matches!(refused("a.ply", b"no ply\n1 2 3\n"), ScanFileError::Unknown));
    assert!(matches!(refused("a.xyz", b"%PDF-1.7\n"), ScanFileError::Other(k) if k.word() == "PDF"));
    assert!(matches!(refused("a.las", b"LASF\0\0"), ScanFileError::Other(k) if k.word() == "LAS / LAZ"));
    let folder = super::read(&std::env::temp_dir(), &Progress::default());
    assert!(matches!(folder, Err(ScanFileError::Folder)));
    let gone = super::read(std::path::Path::new("no such file"), &Progress::default());
    assert!(matches!(gone, Err(ScanFileError::Io(_))));
}

#[test]
fn a_file_on_disk_is_read_as_its_bytes_are() {
    let text = b"0 0 0\n1 0 0\n0 2 0\n";
    let file = tempfile::Builder::new().suffix(".xyz").tempfile().expect("made");
    std::fs::write(file.path(), text).expect("written");
    let found = super::read(file.path(), &Progress::default()).expect("reads");
    assert_eq!(found, scan("a.xyz", text));
    assert_eq!(found.sha256, crate::part::digest_of(text));
}

#[test]
fn corners_of_a_mesh_are_points_once() {
    let bytes = crate::sample::stl_bytes(&crate::sample::solids::cube(10.0));
    let found = scan("cube.stl", &bytes);
    assert_eq!(found.cloud.len(), 8);
    assert_eq!(found.findings, [ScanFinding::CornersTaken { facets: 12, dropped: 0 }]);
    assert!((found.cloud.diagonal() - 300f64.sqrt()).abs() < 1e-5);
    let cut = refused("cube.stl", &bytes[..200]);
    assert!(matches!(cut, ScanFileError::Part(_)), "{cut}");
}

#[test]
fn a_cancelled_reading_ends() {
    let text: String = (0..200_000).map(|i| format!("{i} {i} {i}\n")).collect();
    let all = Progress::ending_after(usize::MAX);
    from_bytes("a.xyz", text.as_bytes(), &all).expect("reads");
    assert!(all.looks() > 5);
    for looks in 1..all.looks() {
        let cancelled = from_bytes("a.xyz", text.as_bytes(), &Progress::ending_after(looks));
        assert!(matches!(cancelled, Err(ScanFileError::Cancelled)), "{looks}");
    }
}
