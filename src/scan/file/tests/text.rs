//! Rows of text: what divides cells, what columns are, and what is told of rows that do not fit.

use super::*;
use crate::scan::file::{Assumed, Attribute};

fn far() -> Vec<Full> {
    points(300, 4_320_978.25)
}

/// Rows of what `row` makes of each point.
fn rows(points: &[Full], row: impl Fn(&Full) -> String) -> String {
    points.iter().map(|p| row(p) + "\n").collect()
}

fn place(p: &Full) -> String {
    let [x, y, z] = p.place;
    format!("{x} {y} {z}")
}

fn assumed(columns: Assumed) -> ScanFinding {
    ScanFinding::ColumnsAssumed { columns }
}

#[test]
fn points_far_from_nought_keep_their_digits_whatever_divides_them() {
    let points = far();
    let text = rows(&points, place);
    let files = [
        text.clone(),
        text.replace('\n', "\r\n"),
        text.replace('\n', "\r"),
        text.replace(' ', "\t"),
        text.replace(' ', ","),
        text.replace(' ', ", "),
        text.replace(' ', ";"),
        text.replace(' ', " ; "),
        format!("\u{feff}{text}"),
        format!("{}\n{text}", points.len()),
        format!("// a scan\n\n# of a part\n{text}"),
        text.trim_end().to_owned(),
    ];
    for text in files {
        let found = scan("a.xyz", text.as_bytes());
        assert_holds(&found, &points);
        assert_eq!((has(&found), &found.findings[..]), ([false; 3], &[][..]), "{:?}", &text[..60]);
        let wide: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        assert_holds(&scan("a.xyz", &wide), &points);
    }
    for text in
        [text.replace('.', ",").replace(' ', ";"), text.replace('.', ","), text.replace('.', ",").replace(' ', "\t")]
    {
        let found = scan("a.csv", text.as_bytes());
        assert_holds(&found, &points);
        assert_eq!(found.findings, [ScanFinding::DecimalCommas]);
    }
}

#[test]
fn columns_are_told_by_their_names() {
    let points = far();
    let row = |p: &Full| {
        let Full { place: [x, y, z], normal: [nx, ny, nz], colour: [r, g, b], intensity } = p;
        format!("{r},{g},{b},{intensity},label,{x},{y},{z},{nx},{ny},{nz}")
    };
    let names = "R,G,B,Scalar_Intensity,class,X,Y,Z,Nx,Ny,Nz";
    let quoted = "\"R\",\"G\",\"B\",\"intensity\",\"class\",\"X [m]\",\"Y [m]\",\"Z [m]\",\"nx\",\"ny\",\"nz\"";
    for head in [names.to_owned(), format!("//{names}"), format!("# {}", names.replace(',', " ")), quoted.to_owned()] {
        let found = scan("a.txt", format!("{head}\n{}", rows(&points, row)).as_bytes());
        assert_holds(&found, &points);
        assert_eq!(has(&found), [true; 3], "{head}");
        assert_eq!(found.findings, [ScanFinding::ColumnsNotRead { names: vec!["class".into()] }]);
    }
    let none = refused("a.csv", b"Time,Range,Angle\n1,2,3\n4,5,6\n");
    assert!(matches!(none, ScanFileError::NoCoordinates { columns } if columns == ["Time", "Range", "Angle"]));
    assert!(matches!(refused("a.csv", b"X,Y,Z\n"), ScanFileError::NoPoints));
    assert!(matches!(refused("a.csv", b"1 2\n3 4\n"), ScanFileError::NoCoordinates { .. }));
}

#[test]
fn columns_without_names_are_assumed_and_that_is_told() {
    let points = points(400, 0.25);
    let colour = |p: &Full| p.colour.map(|c| c.to_string()).join(" ");
    let normal = |p: &Full| p.normal.map(|c| c.to_string()).join(" ");
    let read = |name: &str, row: &dyn Fn(&Full) -> String| {
        let found = scan(name, rows(&points, row).as_bytes());
        assert_holds(&found, &points);
        (has(&found), found.findings)
    };
    let intensity = |p: &Full| format!("{} {}", place(p), p.intensity);
    assert_eq!(read("a.xyz", &intensity), ([false, false, true], vec![assumed(Assumed::XyzIntensity)]));
    let rgb = |p: &Full| format!("{} {}", place(p), colour(p));
    assert_eq!(read("a.xyz", &rgb), ([false, true, false], vec![assumed(Assumed::XyzRgb)]));
    let normals = |p: &Full| format!("{} {}", place(p), normal(p));
    assert_eq!(read("a.xyz", &normals), ([true, false, false], vec![assumed(Assumed::XyzNormal)]));
    let pts = |p: &Full| format!("{} {} {}", place(p), p.intensity, colour(p));
    assert_eq!(read("a.pts", &pts), ([false, true, true], vec![assumed(Assumed::XyzIntensityRgb)]));
    let fractions =
        |p: &Full| format!("{} {}", place(p), p.colour.map(|c| (f64::from(c) / 255.0).to_string()).join(" "));
    assert_eq!(read("a.xyzrgb", &fractions), ([false, true, false], vec![assumed(Assumed::XyzRgb)]));
    let more = |p: &Full| format!("{} 7 8", place(p));
    let unread = ScanFinding::ColumnsNotRead { names: vec!["4".into(), "5".into()] };
    assert_eq!(read("a.xyz", &more), ([false; 3], vec![assumed(Assumed::Xyz), unread]));
}

#[test]
fn rows_that_do_not_fit_are_counted_with_the_first_line() {
    let text = "5\n0 0 0 1\n1 0 0 2 9\n1 1\n# a comment\nend of the first part\n2 2 2 3\n3 3 x 4\n4 4 4\n5 nan 5 1\n";
    let found = scan("a.pts", text.as_bytes());
    assert_eq!(found.cloud.points().map(|p| p.x).collect::<Vec<_>>(), [0.0, 1.0, 2.0]);
    let expected = [
        ScanFinding::PointsDropped { nan: 1, infinite: 0 },
        ScanFinding::CountDiffers { promised: 5, read: 4 },
        ScanFinding::ShortRows { count: 2, line: 4 },
        ScanFinding::LongRows { count: 1, line: 3 },
        ScanFinding::LinesPassedOver { count: 2, line: 6 },
        assumed(Assumed::XyzIntensity),
    ];
    assert_eq!(found.findings, expected);
    let cut = scan("a.xyz", b"0 0 0\n1 1,5 0,25\n2 2 2\n1");
    assert_eq!(cut.cloud.bounds().map(|(_, hi)| hi.y), Some(2.0));
    assert_eq!(cut.findings, [ScanFinding::ShortRows { count: 1, line: 4 }, ScanFinding::DecimalCommas]);
    let lacking = scan("a.csv", b"x,y,z,intensity\n1,2,3,4\n1,2,3,\n2,2,2,x\n");
    assert_eq!(lacking.findings[0], ScanFinding::NotForAll { what: Attribute::Intensities, without: 1 });
}
