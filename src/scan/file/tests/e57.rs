//! E57, written by the crate that reads it.

use super::*;
use crate::part::units::StatedUnit;
use crate::scan::file::{Attribute, E57Fault};
use ::e57::{E57Writer, Quaternion, Record, RecordDataType, RecordName, RecordValue, Transform, Translation};
use std::io::Cursor;

/// A quarter turn about z and a shift.
fn pose() -> Transform {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    Transform {
        rotation: Quaternion { w: half, x: 0.0, y: 0.0, z: half },
        translation: Translation { x: 1000.0, y: 0.0, z: 5.0 },
    }
}

fn prototype(with_colours: bool) -> Vec<Record> {
    let single = RecordDataType::Single { min: None, max: None };
    let scaled = RecordDataType::ScaledInteger { min: -1_000_000, max: 1_000_000, scale: 1e-3, offset: 2.0 };
    let byte = RecordDataType::Integer { min: 0, max: 255 };
    let mut all = vec![
        (RecordName::CartesianX, RecordDataType::Double { min: None, max: None }),
        (RecordName::CartesianY, single.clone()),
        (RecordName::CartesianZ, scaled),
        (RecordName::CartesianInvalidState, RecordDataType::Integer { min: 0, max: 2 }),
        (RecordName::Intensity, single),
    ];
    if with_colours {
        all.extend([RecordName::ColorRed, RecordName::ColorGreen, RecordName::ColorBlue].map(|n| (n, byte.clone())));
    }
    all.into_iter().map(|(name, data_type)| Record { name, data_type }).collect()
}

/// A file with a scan of these points for each of the poses; every tenth point of each is marked as not measured.
fn file(points: &[Full], scans: &[(Option<Transform>, bool)]) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut file, "file").expect("begins");
    for (pose, with_colours) in scans {
        let mut scan = writer.add_pointcloud("scan", prototype(*with_colours)).expect("begins");
        scan.set_transform(pose.clone());
        for (i, p) in points.iter().enumerate() {
            let mut record = vec![
                RecordValue::Double(p.place[0]),
                RecordValue::Single(p.place[1] as f32),
                RecordValue::ScaledInteger(((p.place[2] - 2.0) * 1e3).round() as i64),
                RecordValue::Integer(if i % 10 == 9 { 2 } else { 0 }),
                RecordValue::Single(p.intensity),
            ];
            record.extend(p.colour.iter().filter(|_| *with_colours).map(|c| RecordValue::Integer(i64::from(*c))));
            scan.add_point(record).expect("fits");
        }
        scan.finalize().expect("ends");
    }
    writer.finalize().expect("ends");
    drop(writer);
    file.into_inner()
}

fn measured(points: &[Full]) -> Vec<Full> {
    points.iter().enumerate().filter(|(i, _)| i % 10 != 9).map(|(_, p)| *p).collect()
}

#[test]
fn scans_are_put_in_their_places_and_keep_what_all_have() {
    let points = points(5000, 0.5);
    let found = scan("a.e57", &file(&points, &[(None, true)]));
    assert_holds(&found, &measured(&points));
    assert_eq!((has(&found), found.stated_unit), ([false, true, true], Some(StatedUnit::Meter)));
    assert_eq!(found.findings, [ScanFinding::InvalidPoints { count: 500 }]);
    let both = scan("a.e57", &file(&points, &[(Some(pose()), true), (Some(pose()), false)]));
    let placed = measured(&points).into_iter().map(|p| {
        let [x, y, z] = p.place;
        Full { place: [1000.0 - y, x, z + 5.0], ..p }
    });
    let placed: Vec<Full> = placed.collect();
    assert_holds(&both, &[placed.clone(), placed].concat());
    assert_eq!(has(&both), [false, false, true]);
    let expected = [
        ScanFinding::InvalidPoints { count: 1000 },
        ScanFinding::NotForAll { what: Attribute::Colours, without: 4500 },
        ScanFinding::CloudsJoined { count: 2 },
    ];
    assert_eq!(both.findings, expected);
}

#[test]
fn spherical_coordinates_become_cartesian() {
    let mut file = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut file, "file").expect("begins");
    let double = RecordDataType::Double { min: None, max: None };
    let names = [RecordName::SphericalRange, RecordName::SphericalAzimuth, RecordName::SphericalElevation];
    let prototype = names.map(|name| Record { name, data_type: double.clone() }).to_vec();
    let mut scan_of = writer.add_pointcloud("scan", prototype).expect("begins");
    let right = std::f64::consts::FRAC_PI_2;
    for place in [[2.0, 0.0, 0.0], [3.0, right, 0.0], [4.0, 0.0, right]] {
        scan_of.add_point(place.map(RecordValue::Double).to_vec()).expect("fits");
    }
    scan_of.finalize().expect("ends");
    writer.finalize().expect("ends");
    drop(writer);
    let found = scan("a.e57", file.get_ref());
    for (place, expected) in found.cloud.points().zip([[2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 4.0]]) {
        assert!((0..3).all(|k| (place[k] - expected[k]).abs() < 1e-6), "{place}");
    }
}

#[test]
fn damage_is_told_by_its_page() {
    let bytes = file(&points(5000, 0.5), &[(None, true)]);
    let pages = bytes.len() / 1024;
    for page in [1, pages / 2, pages - 1] {
        let mut damaged = bytes.clone();
        damaged[page * 1024 + 500] ^= 4;
        match refused("a.e57", &damaged) {
            ScanFileError::E57(E57Fault::Checksum { page: found }) => assert_eq!(found, page as u64),
            other => panic!("{other}"),
        }
    }
    for cut in [60, 1024, bytes.len() - 1024, bytes.len() - 7] {
        let error = refused("a.e57", &bytes[..cut]);
        let is_told = matches!(error, ScanFileError::E57(E57Fault::Length { present, .. }) if present == cut as u64);
        assert!(is_told, "{cut}: {error}");
    }
    assert!(matches!(refused("a.e57", b"1 2 3\n"), ScanFileError::Unknown));
    let none = file(&[], &[(None, false)]);
    assert!(matches!(refused("a.e57", &none), ScanFileError::NoPoints));
}
