//! Which program of a plan a file is: by its name, which is what the controller is told to start. A comment of it never
//! decides, and where names are numbers that do not tell the pass, the moves do.

use super::from_pass::FromPassError;
use super::plan::Plan;
use super::proof::verify::{self, Verdict, VerifyError};
use super::{PlannedJob, from_pass};
use crate::cell::Setup;
use crate::document::Job;
use crate::program::dialect::{Goal, ReadContext, ReadLine, Statement};
use crate::program::{Dialect, Program, ProgramFile, ProgramLine, Variant, WITHOUT_WORDS, dialects};
use crate::progress::Progress;
use std::collections::BTreeMap;
use thiserror::Error;

/// Why a program on disk was not compared with its plan.
#[derive(Debug, Error)]
pub enum NotCompared {
    /// The text is of no dialect, or the plan cannot be written in it.
    #[error(transparent)]
    Verify(#[from] VerifyError),
    /// The plan cannot go on from the pass that the program begins with.
    #[error(transparent)]
    FromPass(#[from] FromPassError),
}

/// What a program on disk is, and how it compares with that.
pub struct ComparedProgram {
    /// Its dialect.
    pub dialect: &'static str,
    /// Which program of the plan it is.
    pub variant: Variant,
    /// What was found.
    pub verdict: Verdict,
}

/// Compares a program on disk, by its first file, with that program of the plan which it is named as; one of another name
/// is taken for the whole. `job`: as it was read. `open` gives the text of another file in the same folder.
///
/// # Errors
/// What cannot be compared.
pub fn compared(
    of: &PlannedJob,
    job: &Job,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
) -> Result<ComparedProgram, NotCompared> {
    let PlannedJob { part, setup, plan, .. } = of;
    let variant = dialects::of_text(&first.text).map_or(Variant::WHOLE, |d| recognised(d, setup, plan, first, open));
    let left = variant.from_pass.map(|n| from_pass(part, plan, setup, job, n, &Progress::default())).transpose()?;
    let plan = (left.as_ref().unwrap_or(plan), variant);
    let (dialect, verdict) = verify::check_variant(part, plan, setup, job, first, open, true)?;
    Ok(ComparedProgram { dialect, variant, verdict })
}

/// The program of the plan that a file is named as.
fn recognised(
    dialect: &dyn Dialect,
    setup: &Setup,
    plan: &Plan,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
) -> Variant {
    let main_name = |variant: Variant| dialect.file_names(setup, variant).into_iter().next();
    let is_named = |variant: Variant| main_name(variant).is_some_and(|n| n == first.name);
    // Figures of the name may be those of a pass.
    let figures = first.name.split(|c: char| !c.is_ascii_digit()).filter_map(|n| n.parse().ok());
    let named_passes: Vec<usize> = figures.filter(|n| *n < plan.passes.len()).collect();
    for whole in [Variant::WHOLE, Variant::WHOLE.dry()] {
        let of_pass = |n: usize| Variant { from_pass: Some(n), ..whole };
        let named = named_passes.iter().map(|n| of_pass(*n)).find(|v| is_named(*v));
        // All passes have one name: the first that fits is as good as any.
        let is_unnamed = main_name(of_pass(0)) == main_name(of_pass(1));
        if is_unnamed && is_named(of_pass(0)) {
            let named = &dialect.named(setup, of_pass(0));
            let found = first_pass(dialect, setup, plan, whole, &ReadContext { setup: named, open }, first);
            return found.map_or(whole, of_pass);
        }
        match named {
            Some(variant) => return variant,
            None if is_named(whole) => return whole,
            None => {}
        }
    }
    Variant::WHOLE
}

/// The pass that a program begins with, by its moves: behind it as many are left as in the plan. Of a program that lacks
/// some, the pass that it goes to first. `None`: none of them.
fn first_pass(
    dialect: &dyn Dialect,
    setup: &Setup,
    plan: &Plan,
    whole: Variant,
    reading: &ReadContext<'_>,
    first: &ProgramFile,
) -> Option<usize> {
    let lines = dialect.lines(whole, &plan.steps, setup);
    let mut begins: BTreeMap<usize, usize> = BTreeMap::new();
    let moves = lines.iter().filter_map(|l| if let ProgramLine::Move(m) = l { Some(m.target) } else { None });
    for (number, target) in moves.enumerate() {
        if let Some((pass, _)) = target {
            begins.entry(pass).or_insert(number);
        }
    }
    let files = dialect.write(&Program { head: Vec::new(), lines, setup, wording: WITHOUT_WORDS }).ok()?;
    let own = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let written = goals(&dialect.read(files.first()?, &ReadContext { setup, open: &own }).ok()?);
    let read = goals(&dialect.read(first, reading).ok()?);
    let aligned = begins.iter().find(|(_, at)| {
        let place = (read.len() + **at).checked_sub(written.len());
        place.is_some_and(|place| place > 0 && read.get(place) == written.get(**at))
    });
    let gone_to = || read.iter().find_map(|goal| begins.iter().find(|(_, at)| written.get(**at) == Some(goal)));
    aligned.or_else(gone_to).map(|(pass, _)| *pass)
}

/// Where the moves of a program lead.
fn goals(read: &[ReadLine]) -> Vec<Goal> {
    read.iter().filter_map(|l| if let Statement::Move(m) = &l.what { Some(m.goal) } else { None }).collect()
}
