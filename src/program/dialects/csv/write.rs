//! Tables as they are written.

use super::{COLUMNS, CONVENTIONS, COUNT, END};
use crate::cell::controllers::templates::{fixed, plain, text};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::neutral::comment::Wording;
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use nalgebra::Isometry3;

/// Decimals of all numbers: read back, they differ by less than a millionth.
const DECIMALS: usize = 9;

/// The table.
pub fn write(program: &Program<'_>) -> ProgramFile {
    let mut lines: Vec<String> = CONVENTIONS.iter().map(|t| (*t).to_string()).collect();
    lines.extend(program.head.iter().map(|comment| format!("# {}", plain(&(program.wording)(comment), &[]))));
    lines.push(COLUMNS.into());
    for (index, line) in program.lines.iter().enumerate() {
        lines.push(format!("{},{}", index + 1, row(line, program.wording).join(",")));
    }
    lines.push(format!("{END}{}", program.lines.len()));
    ProgramFile { name: format!("{}.csv", program.setup.cell.csv.name), text: text(&lines, false) }
}

/// All cells but the index.
fn row(line: &ProgramLine, wording: Wording) -> Vec<String> {
    let bare = |what: &str, number: String, value: String, text: String| {
        let mut cells = vec![String::new(); COUNT - 1];
        cells[0] = what.into();
        cells.splice(COUNT - 4.., [number, value, text]);
        cells
    };
    let number = |n: &u32| n.to_string();
    let none = String::new;
    match line {
        ProgramLine::Comment(comment) => {
            bare("say", none(), none(), format!("\"{}\"", plain(&wording(comment), &['"'])))
        }
        ProgramLine::Output { number: n, on } => bare("output", number(n), u8::from(*on).to_string(), none()),
        ProgramLine::OutputValue { number: n, value, group } => {
            bare(if *group { "group" } else { "analogue" }, number(n), fixed(*value, DECIMALS), none())
        }
        ProgramLine::Force(force_n) => bare("force", none(), fixed(*force_n, DECIMALS), none()),
        ProgramLine::Wait(seconds) => bare("wait", none(), fixed(*seconds, DECIMALS), none()),
        ProgramLine::Move(m) => write_move(m),
    }
}

fn write_move(m: &Move) -> Vec<String> {
    let interpolation = match m.interpolation {
        Interpolation::Joint => "joint",
        Interpolation::Linear => "linear",
    };
    let (seconds, percent) = match m.timing {
        MoveTiming::Seconds(s) => (fixed(s, DECIMALS), String::new()),
        MoveTiming::Percent(p) => (String::new(), fixed(p, DECIMALS)),
    };
    let mut cells = vec!["move".into(), interpolation.into()];
    cells.extend(pose(m.base_from_flange.as_ref()));
    cells.extend(pose(m.part_from_focus.as_ref()));
    cells.extend((0..6).map(|i| m.joints_deg.map_or(String::new(), |j| fixed(j[i], DECIMALS))));
    cells.extend([seconds, percent, u8::from(m.lit).to_string(), String::new(), String::new(), String::new()]);
    cells
}

/// Position and quaternion, its sign such that the scalar is not negative.
fn pose(pose: Option<&Isometry3<f64>>) -> Vec<String> {
    let Some(pose) = pose else { return vec![String::new(); 7] };
    let (t, q) = (pose.translation.vector, pose.rotation.quaternion());
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    [t.x, t.y, t.z, sign * q.w, sign * q.i, sign * q.j, sign * q.k].iter().map(|v| fixed(*v, DECIMALS)).collect()
}
