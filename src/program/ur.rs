//! URScript: one file with one program, `def Clean(): … end` and its call. The tool centre point
//! is set to the flange, so the poses are the flange's. Long programs are cut into functions.
//!
//! Not verified on a controller: how many moves a function may have, and how the arm keeps the
//! times of short moves that are rounded. The reader is in `ur_reader`.

use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::lines::{Line, Move};
use super::pages::{moves, pages};
use super::steps::{Pace, Way};
use super::ur_reader;
use crate::cell::controllers::Ur as Words;
use crate::cell::controllers::words::{check_template, filled, fixed, plain, text};
use nalgebra::Isometry3;

/// The dialect.
pub struct Ur;

/// The flange is what moves.
const TCP: &str = "set_tcp(p[0,0,0,0,0,0])";
/// Share of the way to the nearer neighbour that rounding may take: the controller leaves out
/// targets whose roundings meet.
const BLEND_SHARE: f64 = 0.4;

impl Dialect for Ur {
    fn name(&self) -> &'static str {
        "ur"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let cell = &program.setup.cell;
        let words = &cell.ur;
        check(words)?;
        let mut out: Vec<String> = program.head.iter().map(|t| said(t)).collect();
        out.extend([format!("def {}():", words.program), format!("  {TCP}")]);
        let pages = pages(&program.lines, cell.outputs.laser.number, words.max_moves as usize, moves);
        if let [only] = pages[..] {
            body(words, only, "  ", &mut out)?;
        } else {
            let name = |i: usize| format!("{}{}", words.program, i + 1);
            for (i, page) in pages.iter().enumerate() {
                out.push(format!("  def {}():", name(i)));
                body(words, page, "    ", &mut out)?;
                out.push("  end".into());
            }
            out.extend((0..pages.len()).map(|i| format!("  {}()", name(i))));
        }
        out.extend(["end".into(), format!("{}()", words.program)]);
        Ok(vec![ProgramFile { name: format!("{}.script", words.program), text: text(&out, words.crlf) }])
    }

    fn claims(&self, text: &str) -> bool {
        text.lines().any(|l| l.trim_start().starts_with("def ")) && text.contains("set_tcp(")
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        ur_reader::read(file, reading)
    }
}

fn check(words: &Words) -> Result<(), WriteError> {
    check_template("ur.output_on", &words.output_on, &["n"])?;
    check_template("ur.output_off", &words.output_off, &["n"])?;
    check_template("ur.analogue", &words.analogue, &["n", "v"])?;
    check_template("ur.group", &words.group, &["n", "v"])?;
    if words.output_on == words.output_off {
        return Err(WriteError::Rule("ur.output_off is the same as ur.output_on; the laser would stay on".into()));
    }
    Ok(())
}

fn said(text: &str) -> String {
    format!("# {}", plain(text, &[]))
}

fn body(words: &Words, lines: &[Line], indent: &str, out: &mut Vec<String>) -> Result<(), WriteError> {
    let mut before: Option<&Move> = None;
    for (i, line) in lines.iter().enumerate() {
        let statement = match line {
            Line::Say(text) => said(text),
            Line::Output { number, on } => {
                let template = if *on { &words.output_on } else { &words.output_off };
                filled(template, &[("n", &number.to_string())])
            }
            Line::Level { number, value, group } => {
                let (template, decimals) = if *group { (&words.group, 0) } else { (&words.analogue, 4) };
                filled(template, &[("n", &number.to_string()), ("v", &fixed(*value, decimals))])
            }
            Line::Wait(seconds) => format!("sleep({})", fixed(*seconds, 3)),
            Line::Move(m) => {
                let after = if let Some(Line::Move(after)) = lines.get(i + 1) { Some(&**after) } else { None };
                let blend_mm = blend_mm(words, before.replace(m), m, after);
                go(words, m, blend_mm)?
            }
        };
        out.push(format!("{indent}{statement}"));
    }
    Ok(())
}

/// How far from a target its rounding may begin, mm.
fn blend_mm(words: &Words, before: Option<&Move>, m: &Move, after: Option<&Move>) -> f64 {
    let way = |a: &Move, b: &Move| {
        let (a, b) = (a.base_from_flange?, b.base_from_flange?);
        Some((a.translation.vector - b.translation.vector).norm())
    };
    let Some(after) = after.filter(|a| a.lit && m.lit && a.way == Way::Linear && m.way == Way::Linear) else {
        return 0.0;
    };
    let shortest = [before.and_then(|b| way(b, m)), way(m, after)].into_iter().flatten().fold(f64::INFINITY, f64::min);
    words.blend_mm.min(BLEND_SHARE * shortest)
}

fn go(words: &Words, m: &Move, blend_mm: f64) -> Result<String, WriteError> {
    let list = |numbers: [f64; 6]| numbers.map(|v| fixed(v, 7)).join(", ");
    // A straight move goes to a pose: the arm's own calibration finds its joints.
    let joints = m.joints_deg.filter(|_| m.way == Way::Joint || m.base_from_flange.is_none());
    let target = match (joints, &m.base_from_flange) {
        (Some(joints), _) => format!("[{}]", list(joints.map(f64::to_radians))),
        (None, Some(flange)) => format!("p[{}]", list(numbers(flange))),
        (None, None) => return Err(WriteError::NoRobot("UR")),
    };
    let (word, full, acceleration) = match m.way {
        Way::Joint => ("movej", words.full_speed_deg_s.to_radians(), words.acceleration_deg_s2.to_radians()),
        Way::Linear => ("movel", words.full_speed_mm_s / 1000.0, words.acceleration_mm_s2 / 1000.0),
    };
    let (speed, time) = match m.pace {
        // t=0 would ask for the default speed. With t given, a and v are not looked at.
        Pace::Seconds(s) => (full, format!(", t={}", fixed(s.max(0.001), 4))),
        Pace::Percent(p) => (full * p / 100.0, String::new()),
    };
    let blend = if blend_mm > 0.0 { format!(", r={}", fixed(blend_mm / 1000.0, 6)) } else { String::new() };
    Ok(format!("{word}({target}, a={}, v={}{time}{blend})", fixed(acceleration, 4), fixed(speed, 6)))
}

/// Metres, and the rotation vector in radians; 7 decimals are 0.0001 mm and 0.000006°.
fn numbers(base_from_flange: &Isometry3<f64>) -> [f64; 6] {
    let (t, r) = (base_from_flange.translation.vector / 1000.0, base_from_flange.rotation.scaled_axis());
    [t.x, t.y, t.z, r.x, r.y, r.z]
}
