//! FANUC listings as they are written.

use super::{MOST_MSEC, is_coupled, templates};
use crate::cell::Setup;
use crate::cell::controllers::Fanuc;
use crate::cell::controllers::templates::{fixed, text};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::flange::printed;
use crate::program::dialects::subprograms::subprograms;
use crate::program::neutral::comment::Wording;
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;

/// The listing, or a main one that calls subprograms.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let cell = &program.setup.cell;
    let fanuc = &cell.fanuc;
    let templates = templates(fanuc);
    templates.check()?;
    let most = fanuc.max_lines as usize;
    let mut head: Vec<String> = templates.head(&program.head, program.wording).iter().map(|l| instruction(l)).collect();
    head.push(format!("  UFRAME_NUM={} ;", fanuc.user_frame));
    head.push(format!("  UTOOL_NUM={} ;", fanuc.user_tool));
    let count = |line: &ProgramLine| match line {
        ProgramLine::Comment(comment) => templates.comments(&(program.wording)(comment)).len(),
        _ => 1,
    };
    let listing = |name: &str, head, lines: &[ProgramLine]| listing(program.setup, name, head, lines, program.wording);
    if head.len() + program.lines.iter().map(count).sum::<usize>() <= most {
        return Ok(vec![listing(&fanuc.program, head, &program.lines)?]);
    }
    let subprograms = subprograms(&program.lines, cell.outputs.laser.number, most, count);
    let names: Vec<String> = (1..=subprograms.len()).map(|i| format!("{}{i}", fanuc.program)).collect();
    head.extend(names.iter().map(|name| format!("  CALL {name} ;")));
    let mut files = vec![listing(&fanuc.program, head, &[])?];
    for (name, subprogram) in names.iter().zip(subprograms) {
        let lines = subprogram.iter().map(count).sum::<usize>();
        if lines > most {
            return Err(WriteError::PieceTooLong { lines, most });
        }
        files.push(listing(name, Vec::new(), subprogram)?);
    }
    Ok(files)
}

fn instruction(text: &str) -> String {
    format!("  {text} ;")
}

/// A program file: `head` are lines without numbers, the others come behind them.
fn listing(
    setup: &Setup,
    name: &str,
    head: Vec<String>,
    lines: &[ProgramLine],
    wording: Wording,
) -> Result<ProgramFile, WriteError> {
    let fanuc = &setup.cell.fanuc;
    let (mut body, mut positions) = (head, Vec::new());
    for (i, line) in lines.iter().enumerate() {
        let ProgramLine::Move(m) = line else {
            body.extend(templates(fanuc).write(line, wording)?.iter().map(|l| instruction(l)));
            continue;
        };
        let number = positions.len() / LINES_OF_POSITION + 1;
        positions.extend(position(setup, number, m)?);
        let goes_on = m.at_work && matches!(lines.get(i + 1), Some(ProgramLine::Move(next)) if next.at_work);
        body.push(write_move(fanuc, number, m, goes_on)?);
    }
    let mut out = attributes(name, body.len());
    out.extend(body.iter().enumerate().map(|(i, l)| format!("{:4}:{l}", i + 1)));
    out.push("/POS".into());
    out.append(&mut positions);
    out.push("/END".into());
    Ok(ProgramFile { name: format!("{name}.LS"), text: text(&out, fanuc.crlf) })
}

fn attributes(name: &str, lines: usize) -> Vec<String> {
    let count = format!("LINE_COUNT = {lines};");
    [
        &format!("/PROG {name}"),
        "/ATTR",
        "OWNER = MNEDITOR;",
        "COMMENT = \"clearbeam\";",
        "PROG_SIZE = 0;",
        "VERSION = 0;",
        &count,
        "MEMORY_SIZE = 0;",
        "PROTECT = READ_WRITE;",
        "TCD: STACK_SIZE = 0,",
        " TASK_PRIORITY = 50,",
        " TIME_SLICE = 0,",
        " BUSY_LAMP_OFF = 0,",
        " ABORT_REQUEST = 0,",
        " PAUSE_REQUEST = 0;",
        "DEFAULT_GROUP = 1,*,*,*,*;",
        "CONTROL_CODE = 00000000 00000000;",
        "/MN",
    ]
    .map(String::from)
    .to_vec()
}

fn write_move(fanuc: &Fanuc, number: usize, m: &Move, goes_on: bool) -> Result<String, WriteError> {
    let speed = match m.timing {
        MoveTiming::Seconds(s) if s * 1000.0 <= MOST_MSEC => format!("{}msec", fixed((s * 1000.0).max(1.0), 0)),
        MoveTiming::Seconds(s) => format!("{}sec", fixed(s, 1)),
        MoveTiming::Percent(p) if m.interpolation == Interpolation::Joint => {
            format!("{}%", fixed(p.clamp(1.0, 100.0), 0))
        }
        MoveTiming::Percent(_) => return Err(WriteError::StraightInPercent("fanuc")),
    };
    let interpolation = match m.interpolation {
        Interpolation::Joint => "J",
        Interpolation::Linear => "L",
    };
    let termination = if goes_on { &fanuc.termination } else { "FINE" };
    Ok(format!("{interpolation} P[{number}] {speed} {termination} ;"))
}

/// Lines that a position takes.
const LINES_OF_POSITION: usize = 6;

fn position(setup: &Setup, number: usize, m: &Move) -> Result<[String; LINES_OF_POSITION], WriteError> {
    let fanuc = &setup.cell.fanuc;
    let frames = format!("\tUF : {}, UT : {},", fanuc.user_frame, fanuc.user_tool);
    let (frames, first, second) = match (&m.joints_deg, &m.base_from_flange) {
        (Some(j), _) => {
            let mut j = *j;
            if is_coupled(setup) {
                j[2] -= j[1];
            }
            let deg = |i: usize| format!("\tJ{}= {} deg", i + 1, fixed(j[i], 4));
            let three = |i: usize| [deg(i), deg(i + 1), deg(i + 2)].join(",");
            (frames, format!("{},", three(0)), three(3))
        }
        (None, Some(flange)) => {
            let [x, y, z, rz, ry, rx] = printed(flange);
            (
                format!("{frames}\tCONFIG : '{}',", fanuc.configuration),
                format!("\tX = {x} mm,\tY = {y} mm,\tZ = {z} mm,"),
                format!("\tW = {rx} deg,\tP = {ry} deg,\tR = {rz} deg"),
            )
        }
        (None, None) => return Err(WriteError::NoRobot("fanuc")),
    };
    Ok([format!("P[{number}]{{"), "   GP1:".into(), frames, first, second, "};".into()])
}
