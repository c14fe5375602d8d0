//! Reads `program.csv` back. What a row says twice (joints, flange, focus) has to agree.

use super::csv::{COLUMNS, CONVENTIONS, COUNT, END};
use super::dialect::{Goal, ProgramFile, Read, ReadError, ReadLine, ReadMove, Reading};
use super::reading::wrong;
use super::steps::{Pace, Way};
use crate::cell::Setup;
use crate::cell::controllers::words::number;
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// How far two accounts of one pose may differ, mm and degrees.
const SAME: f64 = 1e-3;

/// Reads a table.
pub fn read(file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut out = Vec::new();
    let (mut rows, mut in_rows, mut ended) = (0usize, false, false);
    for (i, text) in file.text.lines().enumerate() {
        let line = i + 1;
        let fail = |what: &str| Err(wrong(&file.name, line, what));
        let what = if let Some(expected) = CONVENTIONS.get(i) {
            if text != *expected {
                return fail(&format!("other conventions than this format's; expected {expected:?}"));
            }
            continue;
        } else if ended {
            return fail("stands behind the end; take it out");
        } else if !in_rows {
            if text == COLUMNS {
                in_rows = true;
                continue;
            }
            match text.strip_prefix("# ") {
                Some(said) => Read::Say(said.into()),
                None => return fail("other columns than this format's"),
            }
        } else if let Some(count) = text.strip_prefix(END) {
            if count.parse() != Ok(rows) {
                return fail(&format!("{count} rows are promised and {rows} are there"));
            }
            ended = true;
            continue;
        } else {
            rows += 1;
            row(text, rows, reading.setup).map_err(|what| wrong(&file.name, line, what))?
        };
        out.push(ReadLine { file: file.name.clone(), line, what });
    }
    if ended { Ok(out) } else { Err(ReadError::CutOff { file: file.name.clone(), expected: "its end of rows" }) }
}

fn row(text: &str, index: usize, setup: &Setup) -> Result<Read, String> {
    // The text comes last and may hold commas.
    let cells: Vec<&str> = text.splitn(COUNT, ',').collect();
    let cells: &[&str; COUNT] = cells.as_slice().try_into().map_err(|_| format!("give {COUNT} cells"))?;
    let [at, what, way, rest @ ..] = cells;
    if at.parse() != Ok(index) {
        return Err(format!("index {at:?} instead of {index}: a row is missing or out of order"));
    }
    let (figures, [output, value, said]) = rest.split_last_chunk().ok_or("too short")?;
    let unused = |cells: &[&str]| cells.iter().all(|c| c.is_empty());
    let plain_number = || output.parse::<u32>().map_err(|_| format!("number {output:?}: give a whole number"));
    let level = || number(value).ok_or_else(|| format!("value {value:?}: give a number"));
    if *what == "move" {
        if !unused(&[output, value, said]) {
            return Err("a move has no number, value or text".into());
        }
        return go(way, figures, setup).map(Read::Move);
    }
    if !unused(figures) || !way.is_empty() {
        return Err(format!("{what:?} has cells of a move"));
    }
    match *what {
        "output" => match *value {
            "0" | "1" => Ok(Read::Output { number: plain_number()?, on: *value == "1" }),
            other => Err(format!("value {other:?}: give 1 or 0")),
        },
        "analogue" | "group" => Ok(Read::Level { number: plain_number()?, value: level()?, group: *what == "group" }),
        "wait" => level().map(Read::Wait),
        "say" => {
            let inner = said.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
            inner.map(|t| Read::Say(t.into())).ok_or_else(|| "a text stands in quotation marks".into())
        }
        other => Err(format!("{other:?}: give move, output, analogue, group, wait or say")),
    }
}

/// `figures`: flange, focus, joints, seconds, percent, laser.
fn go(way: &str, figures: &[&str], setup: &Setup) -> Result<ReadMove, String> {
    let way = match way {
        "joint" => Way::Joint,
        "linear" => Way::Linear,
        other => return Err(format!("way {other:?}: give joint or linear")),
    };
    let [flange @ .., seconds, percent, laser] = figures else { return Err("too short".into()) };
    let (flange, rest) = flange.split_at_checked(7).ok_or("too short")?;
    let (focus, joints) = rest.split_at_checked(7).ok_or("too short")?;
    let (flange, focus) = (pose(flange)?, pose(focus)?);
    let pace = match (seconds.is_empty(), percent.is_empty()) {
        (false, true) => number(seconds).map(Pace::Seconds),
        (true, false) => number(percent).map(Pace::Percent),
        _ => None,
    };
    let pace = pace.ok_or("give seconds or percent, one of them")?;
    if !matches!(*laser, "0" | "1") {
        return Err(format!("laser {laser:?}: give 1 or 0"));
    }
    if let Some(focus) = &focus {
        let flange = flange.as_ref().ok_or("a focus without its flange")?;
        agree("flange and focus", &setup.flange_for(focus), flange)?;
    }
    let joints = six(joints)?;
    let goal = match (joints, flange, &setup.robot) {
        (Some(joints), Some(flange), Some(robot)) => {
            agree("joints and flange", &robot.forward(&joints), &flange)?;
            Goal::Joints(joints)
        }
        (Some(_), Some(_), None) => return Err("joints and a flange, and no robot to compare them by".into()),
        (Some(joints), None, _) => Goal::Joints(joints),
        (None, Some(flange), _) => Goal::Flange(flange),
        (None, None, _) => return Err("neither joints nor a pose".into()),
    };
    // Whoever takes the table may look at any of the three.
    let given = [(flange.is_some(), "flange"), (focus.is_some(), "focus"), (joints.is_some(), "joints")];
    let given: Vec<&str> = given.into_iter().filter(|g| g.0).map(|g| g.1).collect();
    Ok(ReadMove { way, goal, pace, rest: format!("laser={laser}, given as {}", given.join(" and ")) })
}

fn all<const N: usize>(cells: &[&str]) -> Result<Option<[f64; N]>, String> {
    if cells.iter().all(|c| c.is_empty()) {
        return Ok(None);
    }
    let list: Option<Vec<f64>> = cells.iter().map(|c| number(c)).collect();
    let list = list.and_then(|l| l.try_into().ok());
    list.map(Some).ok_or_else(|| format!("{cells:?}: give {N} numbers, or none"))
}

fn six(cells: &[&str]) -> Result<Option<[f64; 6]>, String> {
    all(cells)
}

fn pose(cells: &[&str]) -> Result<Option<Isometry3<f64>>, String> {
    let Some([x, y, z, w, i, j, k]) = all::<7>(cells)? else { return Ok(None) };
    let q = Quaternion::new(w, i, j, k);
    if (q.norm() - 1.0).abs() > 1e-6 {
        return Err(format!("a quaternion of length {}: give 1", q.norm()));
    }
    Ok(Some(Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_quaternion(q))))
}

fn agree(which: &str, a: &Isometry3<f64>, b: &Isometry3<f64>) -> Result<(), String> {
    let off_mm = (a.translation.vector - b.translation.vector).norm();
    let off_deg = a.rotation.angle_to(&b.rotation).to_degrees();
    // Also false for what is no number.
    if off_mm <= SAME && off_deg <= SAME {
        return Ok(());
    }
    Err(format!("{which} differ by {off_mm:.4} mm and {off_deg:.4} degrees"))
}
