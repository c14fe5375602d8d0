//! URScript programs as they are written.

use super::templates;
use crate::cell::controllers::Ur;
use crate::cell::controllers::templates::{fixed, text};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::flange::SHORTEST_S;
use crate::program::dialects::subprograms::{moves, subprograms};
use crate::program::neutral::comment::Wording;
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;
use nalgebra::Isometry3;

/// The flange is what moves.
const TCP: &str = "set_tcp(p[0,0,0,0,0,0])";
/// Share of the way to the nearer neighbour that rounding may take: the controller leaves out
/// targets whose roundings meet.
const BLEND_SHARE: f64 = 0.4;

/// The program, with a function for each subprogram of a long one.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let cell = &program.setup.cell;
    let ur = &cell.ur;
    templates(ur).check()?;
    let mut out = templates(ur).head(&program.head, program.wording);
    out.extend([format!("def {}():", ur.program), format!("  {TCP}")]);
    let subprograms = subprograms(&program.lines, cell.outputs.laser.number, ur.max_moves as usize, moves);
    if let [only] = subprograms[..] {
        out.extend(body(ur, only, program.wording)?.iter().map(|l| format!("  {l}")));
    } else {
        let name = |i: usize| format!("{}{}", ur.program, i + 1);
        for (i, subprogram) in subprograms.iter().enumerate() {
            out.push(format!("  def {}():", name(i)));
            out.extend(body(ur, subprogram, program.wording)?.iter().map(|l| format!("    {l}")));
            out.push("  end".into());
        }
        out.extend((0..subprograms.len()).map(|i| format!("  {}()", name(i))));
    }
    out.extend(["end".into(), format!("{}()", ur.program)]);
    Ok(vec![ProgramFile { name: format!("{}.script", ur.program), text: text(&out, ur.crlf) }])
}

fn body(ur: &Ur, lines: &[ProgramLine], wording: Wording) -> Result<Vec<String>, WriteError> {
    let mut before: Option<&Move> = None;
    let mut out = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        let ProgramLine::Move(m) = line else {
            out.extend(templates(ur).write(line, wording)?);
            continue;
        };
        let after = if let Some(ProgramLine::Move(after)) = lines.get(i + 1) { Some(&**after) } else { None };
        let blend_mm = blend_mm(ur, before.replace(m), m, after);
        out.push(write_move(ur, m, blend_mm)?);
    }
    Ok(out)
}

/// How far from a target its rounding may begin, mm.
fn blend_mm(ur: &Ur, before: Option<&Move>, m: &Move, after: Option<&Move>) -> f64 {
    let way = |a: &Move, b: &Move| {
        let (a, b) = (a.base_from_flange?, b.base_from_flange?);
        Some((a.translation.vector - b.translation.vector).norm())
    };
    let Some(after) = after.filter(|a| {
        a.at_work && m.at_work && a.interpolation == Interpolation::Linear && m.interpolation == Interpolation::Linear
    }) else {
        return 0.0;
    };
    let shortest = [before.and_then(|b| way(b, m)), way(m, after)].into_iter().flatten().fold(f64::INFINITY, f64::min);
    ur.blend_mm.min(BLEND_SHARE * shortest)
}

fn write_move(ur: &Ur, m: &Move, blend_mm: f64) -> Result<String, WriteError> {
    let list = |numbers: [f64; 6]| numbers.map(|v| fixed(v, 7)).join(", ");
    // A straight move goes to a pose: the arm's own calibration finds its joints.
    let joints = m.joints_deg.filter(|_| m.interpolation == Interpolation::Joint || m.base_from_flange.is_none());
    let target = match (joints, &m.base_from_flange) {
        (Some(joints), _) => format!("[{}]", list(joints.map(f64::to_radians))),
        (None, Some(flange)) => format!("p[{}]", list(numbers(flange))),
        (None, None) => return Err(WriteError::NoRobot("ur")),
    };
    let (word, full, acceleration) = match m.interpolation {
        Interpolation::Joint => ("movej", ur.full_speed_deg_s.to_radians(), ur.acceleration_deg_s2.to_radians()),
        Interpolation::Linear => ("movel", ur.full_speed_mm_s / 1000.0, ur.acceleration_mm_s2 / 1000.0),
    };
    let (speed, time) = match m.timing {
        // t=0 would ask for the default speed. With t given, a and v are not looked at.
        MoveTiming::Seconds(s) => (full, format!(", t={}", fixed(s.max(SHORTEST_S), 4))),
        MoveTiming::Percent(p) => (full * p / 100.0, String::new()),
    };
    let blend = if blend_mm > 0.0 { format!(", r={}", fixed(blend_mm / 1000.0, 6)) } else { String::new() };
    Ok(format!("{word}({target}, a={}, v={}{time}{blend})", fixed(acceleration, 4), fixed(speed, 6)))
}

/// Metres, and the rotation vector in radians; 7 decimals are 0.0001 mm and 0.000006°.
fn numbers(base_from_flange: &Isometry3<f64>) -> [f64; 6] {
    let (t, r) = (base_from_flange.translation.vector / 1000.0, base_from_flange.rotation.scaled_axis());
    [t.x, t.y, t.z, r.x, r.y, r.z]
}
