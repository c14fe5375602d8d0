//! A program that was read, against the plan it should be: moves, outputs and times one by one, joint
//! ranges and speeds of what is written, and the beam on the way between.
//!
//! What a dialect says beside its moves (tools, zones, settings) is compared with the same plan written
//! afresh and read by the same reader, so that rounding is no deviation and a changed word is one. So is
//! another kind of target: joint angles where the plan has a pose, wherever they lead.
//! Comments do nothing and are not looked at.

mod compare;
mod differences;
mod driven;
mod error;
mod expected;
mod inputs;
mod likeness;
mod verdict;

pub use differences::AsWritten;
pub(super) use driven::drive_program;
pub use error::VerifyError;
pub use expected::Expected;
pub(super) use expected::{Poses, moves};
pub use inputs::{InputChange, changed_inputs};
pub use likeness::{MOST_OFF_MM, MOST_TURNED_DEG};
pub use verdict::{Difference, DifferenceKind, Finding, JointOff, SpotOff, Verdict};

use super::prover;
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::Part;
use crate::planning::plan::Plan;
use crate::planning::plan::surface_plan::process_settings;
use crate::program::dialect::{ReadContext, ReadLine};
use crate::program::{Dialect, ProgramFile, ReadError, Variant, dialects};
use crate::progress::{Cancelled, Progress};
use compare::compare;
use driven::interference;
use std::sync::Arc;

/// Reads a program from its first file and compares it with the plan. `open` gives the text of another
/// file in the same folder.
///
/// # Errors
/// The text is of no dialect, or it can be read and the plan cannot be written in its dialect.
pub fn check(
    part: &Part,
    planned: &Plan,
    setup: &Setup,
    job: &Job,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
    with_checker: bool,
) -> Result<(&'static str, Verdict), VerifyError> {
    check_variant(part, (planned, Variant::WHOLE), setup, job, first, open, with_checker)
}

/// Reads a variant of the program from its first file and compares it with `planned`, what the variant has of the plan.
///
/// # Errors
/// As [`check`].
pub fn check_variant(
    part: &Part,
    (planned, variant): (&Plan, Variant),
    setup: &Setup,
    job: &Job,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
    with_checker: bool,
) -> Result<(&'static str, Verdict), VerifyError> {
    let dialect = dialect_of(first)?;
    // A program is read under its own name.
    let named = &dialect.named(setup, variant);
    let verdict = match dialect.read(first, &ReadContext { setup: named, open }) {
        Ok(read) => {
            let written = AsWritten::new(dialect, dialect.lines(variant, &planned.steps, setup), named)?;
            let prover = prover(part, setup, job).on_layers(&planned.grown);
            let (moves, defocus_mm) = (moves(&written.lines), process_settings(job, &setup.tool).defocus_mm);
            let expected = Expected { part, setup, defocus_mm, prover, known: None, moves, written: &written.read };
            verify(&expected, &read, with_checker)?
        }
        // Of a program that cannot be read it does not matter whether the plan could be written.
        Err(e) => Verdict { findings: vec![unreadable(e)], ..Verdict::default() },
    };
    Ok((dialect.name(), verdict))
}

fn unreadable(e: ReadError) -> Finding {
    let (file, line) = match &e {
        ReadError::Line { file, line, .. } | ReadError::Gone { file, line, .. } => (file.clone(), *line),
        ReadError::CutOff { file, .. } => (file.clone(), 0),
    };
    Finding { file, line, kind: DifferenceKind::Unreadable, what: Difference::Unreadable(Arc::new(e)) }
}

/// Reads a program that was just written, its first file first, and compares it with the plan: its words
/// are the plan's own, so it is written and read once; and moves that are, to the last bit, those that were proven with the
/// plan are not proven again.
///
/// # Errors
/// It cannot be read back; [`VerifyError::Cancelled`] when `progress` says so.
pub fn check_own(
    part: &Part,
    (plan, variant): (&Plan, Variant),
    setup: &Setup,
    job: &Job,
    written: &[ProgramFile],
    progress: &Progress,
) -> Result<Verdict, VerifyError> {
    let Some(first) = written.first() else { return Ok(Verdict::default()) };
    let open = |name: &str| written.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let dialect = dialect_of(first)?;
    let named = &dialect.named(setup, variant);
    let read = dialect.read(first, &ReadContext { setup: named, open: &open }).map_err(VerifyError::OwnUnreadable)?;
    let lines = dialect.lines(variant, &plan.steps, setup);
    let prover = prover(part, setup, job).on_layers(&plan.grown).under(progress);
    let defocus_mm = process_settings(job, &setup.tool).defocus_mm;
    let known = plan.proof.as_ref();
    let expected = Expected { part, setup, defocus_mm, prover, known, moves: moves(&lines), written: &read };
    Ok(verify(&expected, &read, false)?)
}

fn dialect_of(first: &ProgramFile) -> Result<&'static dyn Dialect, VerifyError> {
    dialects::of_text(&first.text).ok_or_else(|| VerifyError::NoDialect { file: first.name.clone() })
}

/// Compares a program with the plan.
///
/// # Errors
/// [`Cancelled`] when the work that the prover is asked by should end.
pub fn verify(expected: &Expected<'_>, read: &[ReadLine], with_checker: bool) -> Result<Verdict, Cancelled> {
    let mut verdict = Verdict::default();
    let poses = Poses { setup: expected.setup, defocus_mm: expected.defocus_mm };
    let planned = compare(&expected.moves, expected.written, &poses, read, &mut verdict);
    let driven = drive_program(&poses, read, &planned, &mut verdict);
    interference(expected, &poses, &driven, with_checker, &mut verdict)?;
    verdict.findings.sort_by_key(|f| order_of(read, f));
    Ok(verdict)
}

/// Files in the order in which they are run.
fn order_of(read: &[ReadLine], f: &Finding) -> (usize, usize) {
    (read.iter().position(|l| l.file == f.file).unwrap_or(usize::MAX), f.line)
}
