//! PCD in its three forms.

use super::super::pcd::pack;
use super::*;
use crate::scan::file::PcdFault;

const HEADER: &str = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n\
    FIELDS x y z rgb normal_x normal_y normal_z intensity _ histogram\nSIZE 4 8 4 4 4 4 4 4 1 2\n\
    TYPE F F F F F F F F U I\nCOUNT 1 1 1 1 1 1 1 1 3 2\nWIDTH COUNTED\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n\
    POINTS COUNTED\nDATA FORM\n";

fn header(form: &str, count: usize) -> String {
    HEADER.replace("COUNTED", &count.to_string()).replace("FORM", form)
}

/// The bytes of each field of a point.
fn fields(p: &Full) -> Vec<Vec<u8>> {
    let [r, g, b] = p.colour;
    let f = |v: f64| (v as f32).to_le_bytes().to_vec();
    let mut out = vec![f(p.place[0]), p.place[1].to_le_bytes().to_vec(), f(p.place[2])];
    // With the highest byte set, as a float it is a NaN, and a colour all the same.
    out.push(u32::from_be_bytes([255, r, g, b]).to_le_bytes().to_vec());
    out.extend(p.normal.map(f));
    out.push(p.intensity.to_le_bytes().to_vec());
    out.extend([vec![0; 3], vec![1, 0, 2, 0]]);
    out
}

fn binary(points: &[Full]) -> Vec<u8> {
    let rows = points.iter().flat_map(|p| fields(p).concat());
    header("binary", points.len()).into_bytes().into_iter().chain(rows).collect()
}

fn compressed(points: &[Full]) -> Vec<u8> {
    let rows: Vec<Vec<Vec<u8>>> = points.iter().map(fields).collect();
    let columns: Vec<u8> = (0..10).flat_map(|k| rows.iter().flat_map(move |r| r[k].clone())).collect();
    let packed = pack(&columns);
    let sizes = [packed.len() as u32, columns.len() as u32].map(u32::to_le_bytes).concat();
    [header("binary_compressed", points.len()).as_bytes(), &sizes, &packed].concat()
}

fn ascii(points: &[Full]) -> Vec<u8> {
    let mut out = header("ascii", points.len()).replace("TYPE F F F F", "TYPE F F F U");
    for Full { place: [x, y, z], normal: [nx, ny, nz], colour: [r, g, b], intensity } in points {
        let rgb = u32::from_be_bytes([0, *r, *g, *b]);
        out += &format!("{x} {y} {z} {rgb} {nx} {ny} {nz} {intensity} 0 0 0 1 2\n");
    }
    out.into_bytes()
}

#[test]
fn all_forms_hold_the_same_points() {
    for count in [1, 998, 30_000] {
        let points = points(count, 3.0);
        for bytes in [ascii(&points), binary(&points), compressed(&points)] {
            let found = scan("a.pcd", &bytes);
            assert_holds(&found, &points);
            assert_eq!(has(&found), [true; 3]);
            assert_eq!(found.findings, [ScanFinding::ColumnsNotRead { names: vec!["histogram".into()] }]);
            let is_packed =
                header("binary_compressed", count).len() < bytes.len() && bytes.windows(6).any(|w| w == b"_compr");
            let cut = refused("a.pcd", &bytes[..bytes.len() - 20]);
            let is_told = matches!(cut, ScanFileError::CutOff { promised, .. } if promised == count as u64);
            assert!(is_told || matches!(cut, ScanFileError::Pcd(PcdFault::Row { .. })) || is_packed, "{cut}");
        }
    }
}

#[test]
fn a_float_that_is_a_colour_is_read_from_text() {
    let rgb = f32::from_bits(0x0012_34ff);
    let text = format!(
        "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 2\nHEIGHT 1\nDATA ascii\n0 0 0 {rgb:e}\n1 1 1 0\n"
    );
    assert_eq!(scan("a.pcd", text.as_bytes()).cloud.colours, Some(vec![[0x12, 0x34, 0xff], [0, 0, 0]]));
    let lacking = scan("a.pcd", text.replace("1 1 1 0", "1 1 1 nan").as_bytes());
    assert_eq!(lacking.cloud.colours, None);
    assert!(matches!(lacking.findings[..], [ScanFinding::NotForAll { without: 1, .. }]));
    let seen = scan("a.pcd", text.replace("WIDTH", "VIEWPOINT 0 0 1 1 0 0 0\nWIDTH").as_bytes());
    assert_eq!(seen.findings, [ScanFinding::ViewpointNotApplied]);
}

#[test]
fn an_organised_cloud_loses_its_empty_cells() {
    let mut points = points(50, 0.0);
    points.iter_mut().step_by(5).for_each(|p| (p.place, p.normal) = ([f64::NAN; 3], [f64::NAN; 3]));
    for bytes in [ascii(&points), binary(&points), compressed(&points)] {
        let found = scan("a.pcd", &bytes);
        let kept: Vec<Full> = points.iter().copied().filter(|p| !p.place[0].is_nan()).collect();
        assert_holds(&found, &kept);
        assert_eq!(found.findings[0], ScanFinding::PointsDropped { nan: 10, infinite: 0 });
        assert_eq!(has(&found), [true; 3]);
    }
}

#[test]
fn what_is_wrong_is_told() {
    let points = points(20, 0.0);
    let pcd = |fault| format!("{:?}", ScanFileError::Pcd(fault));
    let with = |bytes: Vec<u8>, from: &str, to: &str| {
        let text = bytes.iter().map(|b| char::from(*b)).collect::<String>().replacen(from, to, 1);
        format!("{:?}", refused("a.pcd", &text.chars().map(|c| c as u8).collect::<Vec<u8>>()))
    };
    assert_eq!(format!("{:?}", refused("a.pcd", b"1 2 3\n4 5 6\n")), pcd(PcdFault::NoHeader));
    let begin = header("binary", 20);
    let begin = begin.split_at(begin.len() - 12).0.as_bytes();
    assert_eq!(format!("{:?}", refused("a.pcd", begin)), pcd(PcdFault::NoData));
    assert_eq!(with(binary(&points), "DATA binary", "DATA zipped"), pcd(PcdFault::Line { line: 11 }));
    assert_eq!(with(binary(&points), "TYPE F", "TYPE Q"), pcd(PcdFault::Type { field: "x".into() }));
    assert_eq!(with(binary(&points), "SIZE 4", "SIZE 3"), pcd(PcdFault::Type { field: "x".into() }));
    assert_eq!(with(binary(&points), "POINTS 20", "POINTS 21"), pcd(PcdFault::Counts { points: 21, grid: 20 }));
    assert!(with(binary(&points), "FIELDS x", "FIELDS height").contains("NoCoordinates"));
    let lies = |bytes: Vec<u8>| {
        let bytes = with(bytes, "WIDTH 20", "WIDTH 4000000000");
        assert!(bytes.contains("Counts"));
    };
    lies(binary(&points));
    for form in [binary(&points), ascii(&points), compressed(&points)] {
        let text: String = form.iter().map(|b| char::from(*b)).collect();
        let text = text.replacen("WIDTH 20", "WIDTH 4000000000", 1).replacen("POINTS 20", "POINTS 4000000000", 1);
        let error = refused("a.pcd", &text.chars().map(|c| c as u8).collect::<Vec<u8>>());
        assert!(matches!(error, ScanFileError::CutOff { .. } | ScanFileError::Pcd(PcdFault::Size { .. })), "{error}");
    }
    let mut broken = compressed(&points);
    let body = header("binary_compressed", 20).len() + 8;
    broken[body] = 0xff;
    assert!(matches!(refused("a.pcd", &broken), ScanFileError::Pcd(PcdFault::Packed { .. })));
}
