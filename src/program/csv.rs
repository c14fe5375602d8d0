//! A table of the program for whatever reads tables: `program.csv`, one row a line of the program,
//! its conventions in its own head.

use super::csv_reader;
use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::lines::{Line, Move};
use super::steps::{Pace, Way};
use crate::cell::controllers::words::{fixed, plain, text};
use nalgebra::Isometry3;

/// The dialect.
pub struct Csv;

/// What the numbers mean; a reader that finds other words here must not take the numbers.
pub(super) const CONVENTIONS: [&str; 10] = [
    "# clearbeam program, format 1",
    "# lengths in mm, angles in degrees, times in s, '.' decimals, one row a line of the program, in order",
    "# what: move, output, analogue, group, wait or say; way: joint (all joints in proportion) or linear",
    "# x y z qw qx qy qz: the flange in the robot's base",
    "# fx fy fz fqw fqx fqy fqz: the focus in the part; its z points along the beam against the light, its y along the travel",
    "# rotations: unit quaternions, scalar first, that turn vectors of the frame named first into the second; no Euler angles (those of the cell file are Rz*Ry*Rx)",
    "# j1 to j6: as in the robot file; empty without a robot",
    "# seconds: duration of the move; percent: share of the joints' full speed; one of them is given",
    "# laser: 1 if the move is made with the laser on",
    "# number, value: an output and 1 or 0, an analogue output or a group and its level; of a wait the value is its seconds",
];
/// The columns.
pub(super) const COLUMNS: &str = "index,what,way,x,y,z,qw,qx,qy,qz,fx,fy,fz,fqw,fqx,fqy,fqz,\
                                  j1,j2,j3,j4,j5,j6,seconds,percent,laser,number,value,text";
/// How many.
pub(super) const COUNT: usize = 29;
/// What the last line begins with; the number of rows follows.
pub(super) const END: &str = "# end of rows: ";
/// Read back, numbers are the same to a millionth.
const DECIMALS: usize = 9;

impl Dialect for Csv {
    fn name(&self) -> &'static str {
        "csv"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let mut lines: Vec<String> = CONVENTIONS.iter().map(|t| (*t).to_string()).collect();
        lines.extend(program.head.iter().map(|t| format!("# {}", plain(t, &[]))));
        lines.push(COLUMNS.into());
        for (index, line) in program.lines.iter().enumerate() {
            lines.push(format!("{},{}", index + 1, row(line).join(",")));
        }
        lines.push(format!("{END}{}", program.lines.len()));
        Ok(vec![ProgramFile { name: "program.csv".into(), text: text(&lines, false) }])
    }

    fn claims(&self, text: &str) -> bool {
        text.lines().next().is_some_and(|l| l.trim_end() == CONVENTIONS[0])
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        csv_reader::read(file, reading)
    }
}

/// All cells but the index.
fn row(line: &Line) -> Vec<String> {
    let bare = |what: &str, number: String, value: String, text: String| {
        let mut cells = vec![String::new(); COUNT - 1];
        cells[0] = what.into();
        cells.splice(COUNT - 4.., [number, value, text]);
        cells
    };
    let number = |n: &u32| n.to_string();
    let none = String::new;
    match line {
        Line::Say(text) => bare("say", none(), none(), format!("\"{}\"", plain(text, &['"']))),
        Line::Output { number: n, on } => bare("output", number(n), u8::from(*on).to_string(), none()),
        Line::Level { number: n, value, group } => {
            bare(if *group { "group" } else { "analogue" }, number(n), fixed(*value, DECIMALS), none())
        }
        Line::Wait(seconds) => bare("wait", none(), fixed(*seconds, DECIMALS), none()),
        Line::Move(m) => go(m),
    }
}

fn go(m: &Move) -> Vec<String> {
    let way = match m.way {
        Way::Joint => "joint",
        Way::Linear => "linear",
    };
    let (seconds, percent) = match m.pace {
        Pace::Seconds(s) => (fixed(s, DECIMALS), String::new()),
        Pace::Percent(p) => (String::new(), fixed(p, DECIMALS)),
    };
    let mut cells = vec!["move".into(), way.into()];
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
