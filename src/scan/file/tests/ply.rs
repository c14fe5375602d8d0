//! PLY in all encodings, with whatever stands around the vertices.

use super::*;
use crate::part::file::PlyFault;

const HEADER: &str = "ply\nformat FORMAT 1.0\nobj_info made by a scanner\nelement camera 1\nproperty float view\n\
    property list uchar int ids\nelement vertex COUNT\nproperty uchar red\nproperty float x\nproperty double y\n\
    property float z\nproperty uchar green\nproperty uchar blue\nproperty float nx\nproperty float ny\n\
    property float nz\nproperty ushort quality\nproperty uchar alpha\nelement face 2\n\
    property list uchar int vertex_indices\nend_header\n";

fn header(format: &str, count: usize) -> String {
    HEADER.replace("FORMAT", format).replace("COUNT", &count.to_string())
}

fn ascii(points: &[Full]) -> String {
    let mut out = header("ascii", points.len()) + "0.5 2 1 2\n";
    for Full { place: [x, y, z], normal: [nx, ny, nz], colour: [r, g, b], intensity } in points {
        out += &format!("{r} {x} {y} {z} {g} {b} {nx} {ny} {nz} {} 9\n", intensity * 4.0);
    }
    out + "3 0 1 2\n3 0 2 3\n"
}

/// The file in binary form; `list` puts a list into each vertex.
fn binary(points: &[Full], is_big: bool, list: bool) -> Vec<u8> {
    let header = header(if is_big { "binary_big_endian" } else { "binary_little_endian" }, points.len());
    let listed = header.replace("property uchar alpha\n", "property uchar alpha\nproperty list uchar short seen_by\n");
    let mut out = (if list { listed } else { header }).into_bytes();
    macro_rules! put {
        ($value:expr) => {
            out.extend(if is_big { $value.to_be_bytes() } else { $value.to_le_bytes() })
        };
    }
    put!(0.5f32);
    put!(2u8);
    put!(1i32);
    put!(2i32);
    for (i, p) in points.iter().enumerate() {
        put!(p.colour[0]);
        put!(p.place[0] as f32);
        put!(p.place[1]);
        put!(p.place[2] as f32);
        put!(p.colour[1]);
        put!(p.colour[2]);
        p.normal.iter().for_each(|n| put!(*n as f32));
        put!((p.intensity * 4.0) as u16);
        put!(9u8);
        if list {
            put!((i % 3) as u8);
            (0..i % 3).for_each(|k| put!(k as i16));
        }
    }
    for face in [[0i32, 1, 2], [0, 2, 3]] {
        put!(3u8);
        face.iter().for_each(|c| put!(*c));
    }
    out
}

/// The points with the intensity that the files above have.
fn expected(count: usize) -> Vec<Full> {
    points(count, -2.0).into_iter().map(|p| Full { intensity: p.intensity * 4.0, ..p }).collect()
}

#[test]
fn all_encodings_hold_the_same_points() {
    let points = points(999, -2.0);
    let element = |name: &str, count| ScanFinding::NotRead { element: name.into(), count };
    let files = [
        ascii(&points).into_bytes(),
        ascii(&points).replace('\n', "\r\n").into_bytes(),
        format!("\u{feff}{}", ascii(&points)).encode_utf16().flat_map(u16::to_le_bytes).collect(),
        binary(&points, false, false),
        binary(&points, true, false),
        binary(&points, false, true),
        binary(&points, true, true),
    ];
    for bytes in files {
        let found = scan("a.ply", &bytes);
        assert_holds(&found, &expected(999));
        assert_eq!(has(&found), [true; 3]);
        let names: Vec<String> = found
            .findings
            .iter()
            .filter_map(|f| match f {
                ScanFinding::ColumnsNotRead { names } => Some(names.clone()),
                _ => None,
            })
            .flatten()
            .collect();
        assert_eq!(names[0], "alpha");
        assert!(found.findings.contains(&element("camera", 1)) && found.findings.contains(&element("face", 2)));
        assert_eq!(found.findings.len(), 3, "{:?}", found.findings);
        let utf16 = bytes.starts_with(b"\xff\xfe");
        for cut in [bytes.len() / 2, bytes.len() - 4 - 4 * usize::from(utf16)] {
            let cut = refused("a.ply", &bytes[..cut]);
            assert!(matches!(cut, ScanFileError::Ply(PlyFault::CutOff { .. })), "{cut}");
        }
    }
}

#[test]
fn rows_that_windows_cut_are_whole() {
    let points = points(45_000, 0.0);
    for bytes in [ascii(&points).into_bytes(), binary(&points, false, false), binary(&points, true, true)] {
        assert!(bytes.len() > 5 << 18);
        let found = scan("a.ply", &bytes);
        assert_eq!(found.cloud.len(), points.len());
        for i in (0..points.len()).step_by(97) {
            assert!((0..3).all(|k| (found.cloud.point(i)[k] - points[i].place[k]).abs() < 1e-5), "{i}");
        }
    }
}

#[test]
fn colours_are_bytes_fractions_or_words() {
    let file = |kind: &str, rows: &str| {
        let colours: String = ["red", "green", "blue"].map(|c| format!("property {kind} {c}\n")).concat();
        format!(
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
             {colours}end_header\n{rows}"
        )
    };
    let colours = |kind: &str, rows: &str| scan("a.ply", file(kind, rows).as_bytes()).cloud.colours;
    let expected = Some(vec![[0, 128, 255], [255, 1, 64]]);
    assert_eq!(colours("uchar", "0 0 0 0 128 255\n1 1 1 255 1 64\n"), expected);
    assert_eq!(colours("float", "0 0 0 0 0.5 1\n1 1 1 1 0.0039 0.25\n"), expected);
    assert_eq!(colours("float", "0 0 0 0 1 1\n1 1 1 255 1 64\n"), Some(vec![[0, 1, 1], [255, 1, 64]]));
    assert_eq!(colours("float", "0 0 0 0 nan 1\n1 1 1 1 1 1\n"), None);
    let clamped = scan("a.ply", file("int", "0 0 0 -1 128 300\n1 1 1 255 1 64\n").as_bytes());
    assert_eq!(clamped.findings, [ScanFinding::ColoursClamped { count: 2 }]);
}

#[test]
fn what_is_no_number_is_dropped_and_counted() {
    let rows = "nan 0 0\n1 1 1\n0 inf 0\n3 1 1\n0 -inf nan\n";
    let file = |rows: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
             end_header\n{rows}",
            rows.lines().count()
        )
    };
    let found = scan("a.ply", file(rows).as_bytes());
    assert_eq!(found.cloud.points().map(|p| p.x).collect::<Vec<_>>(), [1.0, 3.0]);
    assert_eq!(found.findings, [ScanFinding::PointsDropped { nan: 2, infinite: 1 }]);
    let none = refused("a.ply", file("nan nan nan\nnan 1 1\n").as_bytes());
    assert!(matches!(none, ScanFileError::AllDropped { dropped: 2 }));
    assert!(matches!(refused("a.ply", file("").as_bytes()), ScanFileError::NoPoints));
    let far = refused("a.ply", file("0 0 0\n1e39 0 0\n").replace("float x", "double x").as_bytes());
    assert!(matches!(far, ScanFileError::TooFar { point: 1 }), "{far}");
    let more = scan("a.ply", (file("0 0 0\n1 1 1\n") + "7 8").as_bytes());
    assert!(matches!(more.findings[..], [ScanFinding::BytesPassedOver { count: 3, .. }]));
    let comma = refused("a.ply", file("0 0 0\n1 1,5 1\n").as_bytes());
    assert!(matches!(comma, ScanFileError::DecimalComma { .. }));
    let word = refused("a.ply", file("0 0 0\n1 x 1\n").as_bytes());
    assert!(matches!(word, ScanFileError::Ply(PlyFault::Value { row: 1, .. })));
}

#[test]
fn headers_that_lie_or_lack_are_refused() {
    let bytes = binary(&points(10, 0.0), false, false);
    let text = header("binary_little_endian", 10);
    let with =
        |from: &str, to: &str| refused("a.ply", &[text.replace(from, to).as_bytes(), &bytes[text.len()..]].concat());
    for count in ["11", "4000000000", "18446744073709551615"] {
        let lies = with("vertex 10", &format!("vertex {count}"));
        assert!(matches!(lies, ScanFileError::Ply(PlyFault::CutOff { .. })), "{count}: {lies}");
    }
    for (from, to) in [("float x", "float height"), ("vertex", "point")] {
        let lacks = with(from, to);
        let is_told =
            matches!(lacks, ScanFileError::Ply(PlyFault::NoCoordinates) | ScanFileError::NoCoordinates { .. });
        assert!(is_told, "{lacks}");
    }
    assert!(matches!(with("double y", "quad y"), ScanFileError::Ply(PlyFault::HeaderLine { line: 10 })));
}
