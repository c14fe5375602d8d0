//! The proof of a plan's lit moves as its program is written, while the plan can still be changed. What is read
//! from a file on disk is `verify`'s.

use super::super::plan::surface_plan::process_settings;
use super::prover;
use super::verify::{Poses, Verdict, drive_program, moves};
use crate::cell::Setup;
use crate::document::model::Job;
use crate::part::Part;
use crate::planning::plan::Plan;
use crate::pose::Blocker;
use crate::program::dialect::{ReadContext, ReadLine, Statement};
use crate::program::sweep::{LitMove, Proof};
use crate::program::{DialectError, Move, Program, ReadError, WITHOUT_WORDS, dialects, lines};
use crate::progress::{Cancelled, Progress};
use thiserror::Error;

/// A lit move on which beam or head hits something as the program is written.
pub struct Refuted {
    /// The target that the move leads to: pass and point.
    pub target: (usize, usize),
    /// What hits what.
    pub blocker: Blocker,
}

/// Why a program cannot be proven as it is written.
#[derive(Debug, Error, PartialEq)]
pub enum UnprovenProgram {
    /// It cannot be written.
    #[error(transparent)]
    Unwritable(#[from] DialectError),
    /// There is none.
    #[error("no program")]
    Empty,
    /// It cannot be read back.
    #[error(transparent)]
    Unreadable(#[from] ReadError),
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for UnprovenProgram {
    fn from(_: Cancelled) -> UnprovenProgram {
        UnprovenProgram::Cancelled
    }
}

/// Proves the lit moves of a plan as its program is written: rounded to the program's digits, a move that just
/// clears a facet may hit it.
///
/// # Errors
/// The program cannot be written, or read back; [`UnprovenProgram::Cancelled`] when `progress` says so.
pub fn proven_as_written(
    part: &Part,
    plan: &Plan,
    setup: &Setup,
    job: &Job,
    progress: &Progress,
) -> Result<(Proof, Vec<Refuted>), UnprovenProgram> {
    let lines = lines(&plan.steps, setup);
    let dialect = dialects::known(&job.cell.dialect).map_err(DialectError::from)?;
    let planned = moves(&lines);
    let program = Program { head: Vec::new(), lines: lines.clone(), setup, wording: WITHOUT_WORDS };
    let files = dialect.write(&program).map_err(DialectError::from)?;
    let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let first = files.first().ok_or(UnprovenProgram::Empty)?;
    let read = dialect.read(first, &ReadContext { setup, open: &open })?;
    let mut numbers = 0..planned.len();
    let of_line = |l: &ReadLine| matches!(l.what, Statement::Move(_)).then(|| numbers.next()).flatten();
    let number: Vec<Option<usize>> = read.iter().map(of_line).collect();
    let of_plan: Vec<Option<&Move>> = number.iter().map(|n| n.and_then(|n| planned.get(n).copied())).collect();
    let poses = Poses { setup, defocus_mm: process_settings(job, &setup.tool).defocus_mm };
    let driven = drive_program(&poses, &read, &of_plan, &mut Verdict::default());
    let lit: Vec<LitMove> = driven.iter().map(|d| d.lit).collect();
    let proof = prover(part, setup, job).on_layers(&plan.grown).under(progress).prove(lit)?;
    let target = |at: usize| {
        let from = number.get(at).copied().flatten()?;
        // A move between two targets belongs to the one that it leads to.
        planned.get(from..)?.iter().find_map(|m| m.target)
    };
    let refuted = proof
        .refuted
        .iter()
        .filter_map(|(n, blocker)| Some(Refuted { target: target(driven.get(*n)?.place)?, blocker: *blocker }))
        .collect();
    Ok((proof, refuted))
}
