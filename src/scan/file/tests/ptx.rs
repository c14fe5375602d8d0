//! PTX: clouds one behind the other, each in its place.

use super::*;
use crate::scan::file::PtxFault;

/// A cloud of 2 columns: a quarter turn about z and a shift, so that x becomes y.
fn cloud(points: &[Full], with_colours: bool, shift: f64) -> String {
    let mut out = format!(
        "2\n{}\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n{shift} 0 100 1\n",
        points.len().div_ceil(2)
    );
    for Full { place: [x, y, z], colour: [r, g, b], intensity, .. } in points {
        let colour = if with_colours { format!(" {r} {g} {b}") } else { String::new() };
        out += &format!("{x} {y} {z} {intensity}{colour}\n");
    }
    out
}

fn placed(points: &[Full], shift: f64) -> Vec<Full> {
    points.iter().map(|p| Full { place: [shift - p.place[1], p.place[0], p.place[2] + 100.0], ..*p }).collect()
}

#[test]
fn clouds_are_put_in_their_places() {
    let points = points(400, 0.5);
    let text = cloud(&points, true, 0.0) + &cloud(&points, true, 1e6);
    let found = scan("a.ptx", text.as_bytes());
    assert_eq!(found.findings, [ScanFinding::CloudsJoined { count: 2 }]);
    assert_eq!(has(&found), [false, true, true]);
    let expected = [placed(&points, 0.0), placed(&points, 1e6)].concat();
    // The box is a million long, so single numbers hold a tenth.
    for (place, full) in found.cloud.points().zip(&expected) {
        assert!((0..3).all(|k| (place[k] - full.place[k]).abs() < 0.13), "{place} {:?}", full.place);
    }
    let one = scan("any name", cloud(&points, false, 1e6).as_bytes());
    assert_holds(&one, &placed(&points, 1e6));
    assert_eq!((has(&one), one.findings), ([false, false, true], vec![]));
}

#[test]
fn cells_without_echo_are_dropped_and_counted() {
    let mut points = points(400, 0.5);
    points.iter_mut().step_by(4).for_each(|p| p.place = [0.0; 3]);
    let found = scan("a.ptx", cloud(&points, false, 0.0).as_bytes());
    assert_eq!((found.cloud.len(), &found.findings[..]), (300, &[ScanFinding::InvalidPoints { count: 100 }][..]));
    points.iter_mut().for_each(|p| p.place = [0.0; 3]);
    let none = refused("a.ptx", cloud(&points, false, 0.0).as_bytes());
    assert!(matches!(none, ScanFileError::AllDropped { dropped: 400 }));
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    let text = cloud(&points(40, 0.5), true, 0.0);
    let with = |from: &str, to: &str| refused("a.ptx", text.replacen(from, to, 1).as_bytes());
    let line = |error: ScanFileError| match error {
        ScanFileError::Ptx { line, fault } => (line, fault),
        other => panic!("{other}"),
    };
    assert_eq!(line(with("0 1 0 0\n", "0 2 0 0\n")), (10, PtxFault::NoMotion));
    assert_eq!(line(with("0 0 1 0\n", "0 0 -1 0\n")), (10, PtxFault::NoMotion));
    let words = text.lines().map(|l| if l.ends_with(" 2 0 255") { "1 2" } else { l }).collect::<Vec<_>>().join("\n");
    assert_eq!(line(refused("a.ptx", words.as_bytes())), (13, PtxFault::Point));
    let cut = refused("a.ptx", &text.as_bytes()[..text.len() - 60]);
    assert!(
        matches!(cut, ScanFileError::CutOff { promised: 40, present: 36..=39 } | ScanFileError::Ptx { .. }),
        "{cut}"
    );
    let lies = with("2\n20\n", "2\n2000000000000\n");
    assert!(matches!(lies, ScanFileError::CutOff { promised: 4_000_000_000_000, .. }), "{lies}");
    assert_eq!(line(refused("a.ptx", (text.clone() + "3\n4\n1 1 1\n7\n").as_bytes())), (54, PtxFault::Pose));
}
