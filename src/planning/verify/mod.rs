//! A program that was read, against the plan it should be: moves, outputs and times one by one, joint
//! ranges and speeds of what is written, and the beam on the way between.
//!
//! What a dialect says beside its moves (tools, zones, settings) is compared with the same plan written
//! afresh and read by the same reader, so that rounding is no deviation and a changed word is one. So is
//! another kind of target: joint angles where the plan has a pose, wherever they lead.
//! Comments do nothing and are not looked at.

mod compare;
mod driven;
mod likeness;

use super::plan::{self, Plan};
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::Part;
use crate::program::dialect::{Goal, ReadError, ReadLine, Reading};
use crate::program::sweep::{Proof, Prover};
use crate::program::{Dialect, Line, Move, Program, ProgramFile, dialects, lines, lit};
use compare::compare;
pub(super) use driven::driven;
use driven::interference;
use nalgebra::{Isometry3, Point3};
use serde::Serialize;

/// The spot may stand so far from where it was planned, mm.
pub const MOST_OFF_MM: f64 = 0.01;
/// And the beam with its spin may be turned by so much, degrees.
pub const MOST_TURNED_DEG: f64 = 0.01;

/// What is wrong with a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The text cannot be read on from here.
    Unreadable,
    /// A line of the plan is not there.
    Missing,
    /// A line that the plan does not have.
    Extra,
    /// The move leads elsewhere.
    Deviation,
    /// The move takes another time.
    Time,
    /// An output, a wait, a setting or a word differs.
    Setting,
    /// A joint beyond its range, or a pose out of reach.
    Limit,
    /// A joint faster than it can go.
    Speed,
    /// The beam hits the part with the laser on.
    Interference,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// The file.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// What kind.
    pub kind: Kind,
    /// What, with figures.
    pub text: String,
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Verdict {
    /// Moves that were read.
    pub moves: usize,
    /// Moves with the laser on.
    pub lit_moves: usize,
    /// Largest deviation of the spot from the plan among moves that were found, mm.
    pub worst_mm: f64,
    /// Largest turn from the plan, degrees.
    pub worst_deg: f64,
    /// What is proven of the moves with the laser on.
    pub proof: Proof,
    /// In the order of the program.
    pub findings: Vec<Finding>,
}

/// A part, the setup, and what the program should be.
pub struct Expected<'a> {
    /// The part.
    pub part: &'a Part,
    /// Cell and robot.
    pub setup: &'a Setup,
    /// D, mm.
    pub defocus_mm: f64,
    /// Proves its lit moves.
    pub prover: Prover<'a>,
    /// The plan's moves in order.
    pub moves: Vec<&'a Move>,
    /// The plan as it is written, and read again.
    pub written: &'a [ReadLine],
}

/// Reads a program from its first file and compares it with the plan. `open` gives the text of another
/// file in the same folder.
///
/// # Errors
/// The text is of no dialect, or the plan cannot be written in it.
pub fn check(
    part: &Part,
    planned: &Plan,
    setup: &Setup,
    job: &Job,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
    with_checker: bool,
) -> Result<(&'static str, Verdict), String> {
    let dialect = dialect_of(first)?;
    let lines = lines(&planned.steps, setup);
    let files = dialect.write(&Program { head: Vec::new(), lines: lines.clone(), setup }).map_err(|e| e.to_string())?;
    let own = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let Some(main) = files.first() else { return Err("the plan has no program".into()) };
    let written =
        dialect.read(main, &Reading { setup, open: &own }).map_err(|e| format!("the plan's own program: {e}"))?;
    let prover = plan::prover(part, setup, job).on_layers(&planned.grown);
    let expected =
        Expected { part, setup, defocus_mm: job.beam.defocus_mm, prover, moves: moves(&lines), written: &written };
    let verdict = match dialect.read(first, &Reading { setup, open }) {
        Ok(read) => verify(&expected, &read, with_checker),
        Err(e) => {
            let (file, line) = match &e {
                ReadError::Line { file, line, .. } | ReadError::Gone { file, line, .. } => (file.clone(), *line),
                ReadError::CutOff { file, .. } => (file.clone(), 0),
            };
            let findings = vec![Finding { file, line, kind: Kind::Unreadable, text: e.to_string() }];
            Verdict { findings, ..Verdict::default() }
        }
    };
    Ok((dialect.name(), verdict))
}

/// Reads a program that was just written, its first file first, and compares it with the plan: its words
/// are the plan's own, so it is written and read once.
///
/// # Errors
/// It cannot be read back.
pub fn check_own(
    part: &Part,
    plan: &Plan,
    setup: &Setup,
    job: &Job,
    written: &[ProgramFile],
) -> Result<Verdict, String> {
    let Some(first) = written.first() else { return Ok(Verdict::default()) };
    let open = |name: &str| written.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let read = dialect_of(first)?.read(first, &Reading { setup, open: &open }).map_err(|e| e.to_string())?;
    let lines = lines(&plan.steps, setup);
    let prover = plan::prover(part, setup, job).on_layers(&plan.grown);
    let defocus_mm = job.beam.defocus_mm;
    let expected = Expected { part, setup, defocus_mm, prover, moves: moves(&lines), written: &read };
    Ok(verify(&expected, &read, false))
}

fn dialect_of(first: &ProgramFile) -> Result<&'static dyn Dialect, String> {
    dialects::of_text(&first.text).ok_or_else(|| {
        format!(
            "{}: is no program of any dialect known here ({}); give the file that was exported",
            first.name,
            dialects::names()
        )
    })
}

pub(super) fn moves(lines: &[Line]) -> Vec<&Move> {
    lines.iter().filter_map(|l| if let Line::Move(m) = l { Some(m.as_ref()) } else { None }).collect()
}

/// Compares a program with the plan.
pub fn verify(expected: &Expected<'_>, read: &[ReadLine], with_checker: bool) -> Verdict {
    let mut verdict = Verdict::default();
    let poses = Poses { setup: expected.setup, defocus_mm: expected.defocus_mm };
    let planned = compare(expected, &poses, read, &mut verdict);
    let driven = driven(&poses, read, &planned, &mut verdict);
    interference(expected, &poses, &driven, with_checker, &mut verdict);
    verdict.findings.sort_by_key(|f| order_of(read, f));
    verdict
}

/// Files in the order in which they are run.
fn order_of(read: &[ReadLine], f: &Finding) -> (usize, usize) {
    (read.iter().position(|l| l.file == f.file).unwrap_or(usize::MAX), f.line)
}

/// Poses of what was read.
pub(super) struct Poses<'a> {
    pub(super) setup: &'a Setup,
    pub(super) defocus_mm: f64,
}

impl Poses<'_> {
    /// Focus in the part; `None` for joints without a robot.
    fn focus(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.focus_for(&self.setup.robot.as_ref()?.forward(joints))),
            Goal::Flange(flange) => Some(self.setup.focus_for(flange)),
            Goal::Focus(focus) => Some(*focus),
        }
    }

    fn flange(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.robot.as_ref()?.forward(joints)),
            Goal::Flange(flange) => Some(*flange),
            Goal::Focus(focus) => Some(self.setup.flange_for(focus)),
        }
    }

    fn spot(&self, focus: &Isometry3<f64>) -> Point3<f64> {
        lit::foot(focus, self.defocus_mm)
    }
}

fn finding(at: &ReadLine, kind: Kind, text: String) -> Finding {
    Finding { file: at.file.clone(), line: at.line, kind, text }
}
