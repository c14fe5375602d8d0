//! A small reader of NACHI programs for tests, and the way back from flange poses to the part.
#![allow(dead_code, reason = "each test file uses its own share")]

use super::parts::{Planned, cell, job, on, part, planned, sample};
use clearbeam::cell::Cell;
use clearbeam::pose::Target;
use clearbeam::program::dialects::nachi;
use nalgebra::{Isometry3, Rotation3, Translation3, UnitQuaternion, Vector3};

/// A line of the program that does something.
#[derive(Clone, Debug)]
pub enum Line {
    Comment(String),
    Laser(bool),
    Home,
    /// Pose of the flange in the base, and `T=` (none: `R=`, per cent).
    Go(Isometry3<f64>, Option<f64>),
    End,
}

/// The program of a plan, its sub-programs where they are called.
pub fn text(p: &Planned) -> String {
    let files = p.files();
    let named = |name: &str| {
        let file = files.iter().find(|f| f.name == name).expect("the program");
        String::from_utf8(file.bytes.clone()).expect("text")
    };
    let main = nachi::file_name(&cell());
    let (unit, _) = main.rsplit_once('.').expect("unit and number");
    let whole = |line: &str| match line.strip_prefix("CALLP ") {
        Some(n) => named(&format!("{unit}.{n:0>3}")).strip_suffix("END\n").expect("an end").to_owned(),
        None => format!("{line}\n"),
    };
    named(&main).lines().map(whole).collect()
}

/// `R = Rz·Ry·Rx`, written out.
pub fn rotation([rz, ry, rx]: [f64; 3]) -> UnitQuaternion<f64> {
    let about = |axis: Vector3<f64>, deg: f64| {
        Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(axis), deg.to_radians())
    };
    UnitQuaternion::from_rotation_matrix(&(about(Vector3::z(), rz) * about(Vector3::y(), ry) * about(Vector3::x(), rx)))
}

/// Reads a program; what is not a line of one fails.
pub fn read(text: &str) -> Vec<Line> {
    let cell = cell();
    text.lines()
        .map(|line| {
            if line == cell.nachi.output_on.replace("{n}", "3") {
                return Line::Laser(true);
            } else if line == cell.nachi.output_off.replace("{n}", "3") {
                return Line::Laser(false);
            } else if line == "END" {
                return Line::End;
            } else if let Some(said) = line.strip_prefix("REM ") {
                return Line::Comment(said.trim_matches('"').into());
            }
            let rest = line.strip_prefix("MOVEX A=1,AC=0,SM=0,").unwrap_or_else(|| panic!("not a line: {line}"));
            let (head, rest) = rest.split_once(",(").expect("a bracket");
            let (numbers, rest) = rest.split_once("),").expect("a bracket");
            let v: Vec<f64> = numbers.split(',').map(|n| n.parse().expect("a number")).collect();
            let [x, y, z, rz, ry, rx] = v.try_into().expect("six numbers");
            let speed = rest.strip_suffix(",H=1,MS").expect("H=1,MS");
            match (head, speed.strip_prefix("T="), speed.strip_prefix("R=")) {
                ("M1J,P", None, Some("10.0")) => Line::Home,
                ("M1X,L" | "M1X,P", seconds, percent) => {
                    assert_eq!(head == "M1X,P", percent.is_some(), "{line}");
                    let at = Translation3::new(x, y, z);
                    let seconds = seconds.map(|s| s.parse().expect("seconds"));
                    Line::Go(Isometry3::from_parts(at, rotation([rz, ry, rx])), seconds)
                }
                _ => panic!("not a move: {line}"),
            }
        })
        .collect()
}

/// `G⁻¹·T⁻¹·L`.
pub fn frame_on_part(cell: &Cell, flange: &Isometry3<f64>) -> Isometry3<f64> {
    cell.flange_from_part.isometry().inverse() * flange.inverse() * cell.base_from_laser.isometry()
}

/// The worm gear: gaps, a tip land, end face and shaft hole, at D = 3 mm.
pub fn gear() -> Planned {
    let mut job = on(job("z", 1.1), &[1, 2, 7, 54, 55]);
    job.beam.defocus_mm = 3.0;
    planned(part(&sample("worm_gear")), job)
}

/// The workpiece: crater, plate, lug, block and a hole.
pub fn workpiece() -> Planned {
    planned(part(&sample("workpiece")), on(job("z", 3.0), &[2, 1, 4, 6, 8, 10]))
}

/// A pose of a lit piece with the row it belongs to.
pub struct Lit {
    pub flange: Isometry3<f64>,
    pub row: Target,
    /// Time of the move from the pose before, and the length between the rows; none for a start.
    pub way: Option<(f64, f64)>,
}

/// The poses of the lit pieces in order; fails unless they are those of the rows.
pub fn lit(p: &Planned, lines: &[Line]) -> Vec<Lit> {
    let mut rows =
        p.plan.passes.iter().flat_map(|pass| {
            pass.lit_pieces().into_iter().map(move |(first, last)| pass.targets[first..=last].to_vec())
        });
    let mut out: Vec<Lit> = Vec::new();
    let mut last = None;
    let mut piece: Option<std::vec::IntoIter<Target>> = None;
    for line in lines {
        match (line, &mut piece) {
            (Line::Laser(true), _) => {
                let mut targets = rows.next().expect("a lit piece").into_iter();
                let (flange, row) = (last.expect("a pose before"), targets.next().expect("a row"));
                out.push(Lit { flange, row, way: None });
                piece = Some(targets);
            }
            (Line::Laser(false), _) => {
                assert!(piece.take().is_none_or(|mut rest| rest.next().is_none()), "a row is missing");
            }
            (Line::Go(pose, seconds), Some(targets)) => {
                let row = targets.next().expect("no pose without its row");
                let length = (row.p - out[out.len() - 1].row.p).norm();
                out.push(Lit { flange: *pose, row, way: Some((seconds.expect("T="), length)) });
            }
            _ => {}
        }
        if let Line::Go(pose, _) = line {
            last = Some(*pose);
        }
    }
    assert!(rows.next().is_none(), "every lit piece is in the program");
    out
}

/// Moves with the laser off, from pose to pose.
pub fn air(lines: &[Line]) -> Vec<(Isometry3<f64>, Isometry3<f64>)> {
    let (mut is_on, mut last, mut out) = (false, None, Vec::new());
    for line in lines {
        match line {
            Line::Laser(on) => is_on = *on,
            Line::Go(pose, _) => {
                out.extend(last.filter(|_| !is_on).map(|l| (l, *pose)));
                last = Some(*pose);
            }
            _ => {}
        }
    }
    out
}
