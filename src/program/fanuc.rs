//! FANUC TP program as a listing (`.LS`): numbered lines, and the positions behind them as joints,
//! or as poses without a robot. The controller's joint 3 is the robot file's less joint 2.
//!
//! Not verified on a controller: more than three decimals in positions, and that user frame and
//! tool are as the cell file says. The reader is in `fanuc_reader`.

use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::fanuc_reader;
use super::lines::{Line, Move};
use super::pages::pages;
use super::steps::{Pace, Way};
use crate::cell::Setup;
use crate::cell::controllers::Fanuc as Words;
use crate::cell::controllers::words::{check_template, cut, filled, fixed, plain, text};
use crate::part::rpy;

/// The dialect.
pub struct Fanuc;

/// Longest remark.
const REMARK: usize = 32;
/// Longest time in `msec`; above it is `sec` with one decimal.
const MOST_MSEC: f64 = 32000.0;

impl Dialect for Fanuc {
    fn name(&self) -> &'static str {
        "fanuc"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let cell = &program.setup.cell;
        let words = &cell.fanuc;
        check(words)?;
        let most = words.max_lines as usize;
        let mut head: Vec<String> = program.head.iter().flat_map(|t| said(t)).collect();
        head.push(format!("  UFRAME_NUM={} ;", words.user_frame));
        head.push(format!("  UTOOL_NUM={} ;", words.user_tool));
        let count = |line: &Line| if let Line::Say(text) = line { said(text).len() } else { 1 };
        if head.len() + program.lines.iter().map(count).sum::<usize>() <= most {
            let main = listing(program.setup, &words.program, head, &program.lines)?;
            return Ok(vec![main]);
        }
        let pages = pages(&program.lines, cell.outputs.laser.number, most, count);
        let names: Vec<String> = (1..=pages.len()).map(|i| format!("{}{i}", words.program)).collect();
        head.extend(names.iter().map(|name| format!("  CALL {name} ;")));
        let mut files = vec![listing(program.setup, &words.program, head, &[])?];
        for (name, page) in names.iter().zip(pages) {
            let lines = page.iter().map(count).sum::<usize>();
            if lines > most {
                return Err(WriteError::Rule(format!(
                    "a lit piece needs {lines} lines, and fanuc.max_lines = {most} go into one program; a call would \
                     let the spot stand: plan with fewer targets (--chord-error, --max-step, --max-turn)"
                )));
            }
            files.push(listing(program.setup, name, Vec::new(), page)?);
        }
        Ok(files)
    }

    fn claims(&self, text: &str) -> bool {
        text.lines().find(|l| !l.trim().is_empty()).is_some_and(|l| l.trim_start().starts_with("/PROG"))
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        fanuc_reader::read(file, reading)
    }
}

/// Whether the controller's joint 3 is the file's less joint 2. Every FANUC arm known here has it so.
pub(super) fn is_coupled(setup: &Setup) -> bool {
    setup.robot.as_ref().is_none_or(|r| r.couples_j2_j3)
}

fn check(words: &Words) -> Result<(), WriteError> {
    check_template("fanuc.output_on", &words.output_on, &["n"])?;
    check_template("fanuc.output_off", &words.output_off, &["n"])?;
    check_template("fanuc.analogue", &words.analogue, &["n", "v"])?;
    check_template("fanuc.group", &words.group, &["n", "v"])?;
    if words.output_on == words.output_off {
        return Err(WriteError::Rule(
            "fanuc.output_off is the same as fanuc.output_on; the laser would stay on".into(),
        ));
    }
    Ok(())
}

/// A comment as remarks.
fn said(text: &str) -> Vec<String> {
    cut(&plain(text, &[';']), REMARK).into_iter().map(|t| format!("  !{t} ;")).collect()
}

/// A program file: `head` are lines without numbers, `lines` come behind them.
fn listing(setup: &Setup, name: &str, head: Vec<String>, lines: &[Line]) -> Result<ProgramFile, WriteError> {
    let words = &setup.cell.fanuc;
    let (mut body, mut positions) = (head, Vec::new());
    for (i, line) in lines.iter().enumerate() {
        let instruction = match line {
            Line::Say(text) => {
                body.extend(said(text));
                continue;
            }
            Line::Output { number, on } => {
                let template = if *on { &words.output_on } else { &words.output_off };
                filled(template, &[("n", &number.to_string())])
            }
            Line::Level { number, value, group } => {
                let (template, decimals) = if *group { (&words.group, 0) } else { (&words.analogue, 3) };
                filled(template, &[("n", &number.to_string()), ("v", &fixed(*value, decimals))])
            }
            // A dwell of 0 would say nothing.
            Line::Wait(seconds) => format!("WAIT {}(sec)", fixed(seconds.max(0.01), 2).trim_start_matches('0')),
            Line::Move(m) => {
                let number = positions.len() / LINES_OF_POSITION + 1;
                positions.extend(position(setup, number, m)?);
                let goes_on = m.lit && matches!(lines.get(i + 1), Some(Line::Move(next)) if next.lit);
                body.push(go(words, number, m, goes_on)?);
                continue;
            }
        };
        body.push(format!("  {instruction} ;"));
    }
    let mut out = attributes(name, body.len());
    out.extend(body.iter().enumerate().map(|(i, l)| format!("{:4}:{l}", i + 1)));
    out.push("/POS".into());
    out.append(&mut positions);
    out.push("/END".into());
    Ok(ProgramFile { name: format!("{name}.LS"), text: text(&out, words.crlf) })
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

fn go(words: &Words, number: usize, m: &Move, goes_on: bool) -> Result<String, WriteError> {
    let pace = match m.pace {
        Pace::Seconds(s) if s * 1000.0 <= MOST_MSEC => format!("{}msec", fixed((s * 1000.0).max(1.0), 0)),
        Pace::Seconds(s) => format!("{}sec", fixed(s, 1)),
        Pace::Percent(p) if m.way == Way::Joint => format!("{}%", fixed(p.clamp(1.0, 100.0), 0)),
        Pace::Percent(_) => {
            return Err(WriteError::Rule("a FANUC arm takes no straight move in per cent; give it a time".into()));
        }
    };
    let way = match m.way {
        Way::Joint => "J",
        Way::Linear => "L",
    };
    let termination = if goes_on { &words.termination } else { "FINE" };
    Ok(format!("{way} P[{number}] {pace} {termination} ;"))
}

/// Lines that a position takes.
const LINES_OF_POSITION: usize = 6;

fn position(setup: &Setup, number: usize, m: &Move) -> Result<[String; LINES_OF_POSITION], WriteError> {
    let words = &setup.cell.fanuc;
    let frames = format!("\tUF : {}, UT : {},", words.user_frame, words.user_tool);
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
            let t = flange.translation.vector;
            let [rz, ry, rx] = rpy::from_rotation(&flange.rotation.to_rotation_matrix());
            let mm = |name, v| format!("\t{name} = {} mm,", fixed(v, 3));
            let deg = |name, v| format!("\t{name} = {} deg", fixed(v, 4));
            (
                format!("{frames}\tCONFIG : '{}',", words.configuration),
                [mm("X", t.x), mm("Y", t.y), mm("Z", t.z)].concat(),
                [deg("W", rx), deg("P", ry), deg("R", rz)].join(","),
            )
        }
        (None, None) => return Err(WriteError::NoRobot("FANUC")),
    };
    Ok([format!("P[{number}]{{"), "   GP1:".into(), frames, first, second, "};".into()])
}
