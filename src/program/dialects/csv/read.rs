//! Reads `program.csv` back. What a row says twice (joints, flange, focus) has to agree.

use super::{COLUMNS, CONVENTIONS, COUNT, END};
use crate::cell::Setup;
use crate::cell::controllers::templates::{non_blank_lines, number};
use crate::program::dialect::{Goal, ProgramFile, ReadContext, ReadLine, ReadMove, Statement};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::read_error::{LineFault, MoveGivenBy, ReadError, RowFault};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};

/// How far two figures that give one pose may differ, mm and degrees.
const SAME: f64 = 1e-3;

/// Where in a table a line stands.
enum TablePlace {
    Head,
    Rows,
    Ended,
}

/// Reads a table.
pub fn read(file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
    let mut out = Vec::new();
    let (mut rows, mut place) = (0usize, TablePlace::Head);
    for (i, (line, text)) in non_blank_lines(&file.text).enumerate() {
        let fail = |fault: LineFault| Err(fault.at(&file.name, line));
        if let Some(expected) = CONVENTIONS.get(i) {
            if text != *expected {
                return fail(LineFault::expected([*expected], text));
            }
            continue;
        }
        let what = match place {
            TablePlace::Ended => return fail(LineFault::BehindEnd { end: END.trim_end().into() }),
            TablePlace::Head if text == COLUMNS => {
                place = TablePlace::Rows;
                continue;
            }
            TablePlace::Head => match text.strip_prefix('#') {
                Some(said) => Statement::Comment(said.trim().into()),
                None => return fail(RowFault::OtherColumns.into()),
            },
            TablePlace::Rows => match text.strip_prefix(END) {
                Some(count) if count.parse() == Ok(rows) => {
                    place = TablePlace::Ended;
                    continue;
                }
                Some(count) => {
                    return fail(LineFault::Count { of: END.trim_end(), promised: Some(count.into()), found: rows });
                }
                None if text.starts_with('#') => Statement::Comment(text.into()),
                None => {
                    rows += 1;
                    row(text, rows, reading.setup).map_err(|fault| fault.at(&file.name, line))?
                }
            },
        };
        out.push(ReadLine { file: file.name.clone(), line, what });
    }
    match place {
        TablePlace::Ended => Ok(out),
        _ => Err(ReadError::CutOff { file: file.name.clone(), expected: END.trim_end().into() }),
    }
}

fn row(text: &str, index: usize, setup: &Setup) -> Result<Statement, LineFault> {
    let too_short = || LineFault::expected([COLUMNS], text);
    // The text comes last and may hold commas.
    let cells: Vec<&str> = text.splitn(COUNT, ',').map(str::trim).collect();
    let cells: &[&str; COUNT] = cells.as_slice().try_into().map_err(|_| too_short())?;
    let [at, what, way, rest @ ..] = cells;
    if at.parse() != Ok(index) {
        return Err(LineFault::OutOfOrder { found: (*at).into(), expected: index });
    }
    let (figures, [output, value, said]) = rest.split_last_chunk().ok_or_else(too_short)?;
    let unused = |cells: &[&str]| cells.iter().all(|c| c.is_empty());
    let unused = match *what {
        "move" => unused(&[output, value, said]),
        _ => unused(figures) && way.is_empty(),
    };
    if !unused {
        return Err(RowFault::UnusedCells { what: (*what).into() }.into());
    }
    let plain_number = || output.parse::<u32>().map_err(|_| LineFault::numbers(1, output));
    let plain_value = || number(value).ok_or_else(|| LineFault::numbers(1, value));
    match *what {
        "move" => read_move(way, figures, setup).map(Statement::Move),
        "output" => match *value {
            "0" | "1" => Ok(Statement::Output { number: plain_number()?, on: *value == "1" }),
            other => Err(LineFault::expected(["1", "0"], other)),
        },
        "analogue" | "group" => {
            Ok(Statement::OutputValue { number: plain_number()?, value: plain_value()?, group: *what == "group" })
        }
        "force" => plain_value().map(Statement::Force),
        "wait" => plain_value().map(Statement::Wait),
        "say" => {
            let inner = said.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
            inner.map(|t| Statement::Comment(t.into())).ok_or_else(|| LineFault::expected(["\"…\""], said))
        }
        other => Err(LineFault::expected(["move", "output", "analogue", "group", "wait", "say"], other)),
    }
}

/// `figures`: flange, focus, joints, seconds, percent, laser.
fn read_move(way: &str, figures: &[&str], setup: &Setup) -> Result<ReadMove, LineFault> {
    let interpolation = match way {
        "joint" => Interpolation::Joint,
        "linear" => Interpolation::Linear,
        other => return Err(LineFault::expected(["joint", "linear"], other)),
    };
    let too_short = || LineFault::expected([COLUMNS], &figures.join(","));
    let [flange @ .., seconds, percent, laser] = figures else { return Err(too_short()) };
    let (flange, rest) = flange.split_at_checked(7).ok_or_else(too_short)?;
    let (focus, joints) = rest.split_at_checked(7).ok_or_else(too_short)?;
    let (flange, focus, joints) = (pose(flange)?, pose(focus)?, all(joints)?);
    let timing = match (seconds.is_empty(), percent.is_empty()) {
        (false, true) => number(seconds).map(MoveTiming::Seconds),
        (true, false) => number(percent).map(MoveTiming::Percent),
        _ => None,
    };
    let timing = timing.ok_or(RowFault::NoTiming)?;
    if !matches!(*laser, "0" | "1") {
        return Err(LineFault::expected(["1", "0"], laser));
    }
    if let Some(focus) = &focus {
        let flange = flange.as_ref().ok_or(RowFault::FocusWithoutFlange)?;
        agree([MoveGivenBy::Flange, MoveGivenBy::Focus], &setup.flange_for(focus), flange)?;
    }
    let goal = goal(joints, flange, setup)?;
    // Whoever takes the table may look at any of the three.
    let given = [
        (flange.is_some(), MoveGivenBy::Flange),
        (focus.is_some(), MoveGivenBy::Focus),
        (joints.is_some(), MoveGivenBy::Joints),
    ];
    let given: Vec<&str> = given.into_iter().filter(|g| g.0).map(|g| g.1.word()).collect();
    Ok(ReadMove { interpolation, goal, timing, rest: format!("laser={laser}, given as {}", given.join(" and ")) })
}

fn goal(joints: Option<[f64; 6]>, flange: Option<Isometry3<f64>>, setup: &Setup) -> Result<Goal, LineFault> {
    match (joints, flange, &setup.robot) {
        (Some(joints), Some(flange), Some(robot)) => {
            agree([MoveGivenBy::Joints, MoveGivenBy::Flange], &robot.forward(&joints), &flange)?;
            Ok(Goal::Joints(joints))
        }
        (Some(_), Some(_), None) => Err(RowFault::NoRobotToCompare.into()),
        (Some(joints), None, _) => Ok(Goal::Joints(joints)),
        (None, Some(flange), _) => Ok(Goal::Flange(flange)),
        (None, None, _) => Err(RowFault::NoGoal.into()),
    }
}

fn all<const N: usize>(cells: &[&str]) -> Result<Option<[f64; N]>, LineFault> {
    if cells.iter().all(|c| c.is_empty()) {
        return Ok(None);
    }
    let list: Option<Vec<f64>> = cells.iter().map(|c| number(c)).collect();
    let list = list.and_then(|l| l.try_into().ok());
    list.map(Some).ok_or_else(|| LineFault::numbers(N, &cells.join(",")))
}

fn pose(cells: &[&str]) -> Result<Option<Isometry3<f64>>, LineFault> {
    let Some([x, y, z, w, i, j, k]) = all::<7>(cells)? else { return Ok(None) };
    let q = Quaternion::new(w, i, j, k);
    if (q.norm() - 1.0).abs() > 1e-6 {
        return Err(LineFault::Quaternion { length: q.norm() });
    }
    Ok(Some(Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::from_quaternion(q))))
}

fn agree(given_by: [MoveGivenBy; 2], a: &Isometry3<f64>, b: &Isometry3<f64>) -> Result<(), RowFault> {
    let off_mm = (a.translation.vector - b.translation.vector).norm();
    let off_deg = a.rotation.angle_to(&b.rotation).to_degrees();
    // Also false for what is no number.
    if off_mm <= SAME && off_deg <= SAME { Ok(()) } else { Err(RowFault::Disagree { given_by, off_mm, off_deg }) }
}
