//! `clearbeam verify`: a program on disk against the plan of its job.

use super::changed::part_of;
use super::{CommandFailure, CommandOutcome, print, print_json};
use crate::document::files::{self, InputDigest, InputKind};
use crate::document::model::Job;
use crate::part::Source;
use crate::planning::export::recorded_inputs;
use crate::planning::verify::{DifferenceKind, Finding, InputChange, Verdict, changed_inputs};
use crate::planning::{self, ComparedProgram, Pipeline};
use crate::program::sweep::Proof;
use crate::program::{ProgramFile, Variant};
use crate::text::{Sentence as _, fixed, id, say};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Options of `verify`.
#[derive(clap::Args, Debug)]
pub struct VerifyArguments {
    #[arg(help = say!(cli_verify_program))]
    program: PathBuf,
    #[arg(long, value_name = "JOB.toml", help = say!(cli_verify_job))]
    job: PathBuf,
    #[arg(long, help = say!(cli_verify_json))]
    json: bool,
}

/// Findings shown in full.
const SHOWN: usize = 40;

#[derive(Serialize)]
struct VerdictRecord<'a> {
    program: String,
    dialect: &'a str,
    #[serde(flatten)]
    variant: Variant,
    /// Whether a report says which files the program was made from.
    inputs_recorded: bool,
    inputs: Vec<InputRecord<'a>>,
    moves: usize,
    lit_moves: usize,
    /// Null where nothing was compared.
    worst_mm: Option<f64>,
    worst_deg: Option<f64>,
    proof: Option<&'a Proof>,
    findings: Vec<FindingRecord<'a>>,
}

/// A file that has changed since the program was made.
#[derive(Serialize)]
struct InputRecord<'a> {
    kind: InputKind,
    name: &'a str,
    was: Option<&'a str>,
    is: Option<&'a str>,
}

/// A finding: its kind for scripts, its text for people.
#[derive(Serialize)]
struct FindingRecord<'a> {
    file: &'a str,
    line: usize,
    kind: DifferenceKind,
    text: String,
}

impl<'a> VerdictRecord<'a> {
    fn new(program: String, inputs: &'a Inputs, of: &'a ComparedProgram) -> VerdictRecord<'a> {
        let ComparedProgram { dialect, variant, verdict: ref v } = *of;
        let row = |f: &'a Finding| FindingRecord { file: &f.file, line: f.line, kind: f.kind, text: f.sentence() };
        let input = |c: &'a InputChange| InputRecord {
            kind: c.kind,
            name: &c.name,
            was: c.was.as_deref(),
            is: c.is.as_deref(),
        };
        let is_compared = !is_unreadable(v);
        VerdictRecord {
            program,
            dialect,
            variant,
            inputs_recorded: inputs.are_recorded,
            inputs: inputs.changes.iter().map(input).collect(),
            moves: v.moves,
            lit_moves: v.lit_moves,
            worst_mm: is_compared.then_some(v.worst_mm),
            worst_deg: is_compared.then_some(v.worst_deg),
            proof: is_compared.then_some(&v.proof),
            findings: v.findings.iter().map(row).collect(),
        }
    }
}

/// What is known of the files that the program was made from.
struct Inputs {
    are_recorded: bool,
    changes: Vec<InputChange>,
}

impl Inputs {
    /// As the report beside the program says, or the one beside the job; of the part the job knows it, too.
    fn of(a: &VerifyArguments, job: &Job) -> Inputs {
        let name = a.program.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
        let beside = |file: &Path| recorded_inputs(file.parent().unwrap_or(Path::new("")), &name);
        let recorded = beside(&a.program).or_else(|| beside(&a.job));
        let now = files::inputs(job, Some(&a.job));
        let mut changes = recorded.as_ref().map_or_else(Vec::new, |then| changed_inputs(then, &now));
        if let Some(part) = now.iter().find(|i| i.kind == InputKind::Part)
            && job.part.is_of_another_file(&part.sha256)
            && !changes.iter().any(|c| c.kind == InputKind::Part)
        {
            let then = InputDigest { sha256: job.part.sha256.clone(), ..part.clone() };
            changes.splice(0..0, changed_inputs(&[then], std::slice::from_ref(part)));
        }
        Inputs { are_recorded: recorded.is_some(), changes }
    }

    fn lines(&self) -> String {
        let unknown = (!self.are_recorded).then(|| say!(verify_inputs_unknown));
        let lines = unknown.into_iter().chain(self.changes.iter().map(|c| c.sentence()));
        lines.map(|line| line + "\n").collect()
    }
}

/// Reads, plans, compares. Files that have changed are named before anything is compared.
pub fn run(a: &VerifyArguments) -> Result<CommandOutcome, CommandFailure> {
    let job = files::read(&a.job).map_err(CommandFailure::failed)?;
    let first = read(&a.program)?;
    let inputs = Inputs::of(a, &job);
    if !a.json {
        print(&inputs.lines());
    }
    let folder = a.program.parent().unwrap_or(Path::new("")).to_path_buf();
    let open = move |name: &str| {
        // A called name is a file of the same folder, and no way out of it.
        let plain = Path::new(name).file_name().is_some_and(|n| n.to_string_lossy() == name);
        plain.then(|| read(&folder.join(name)).ok().map(|f| f.text)).flatten()
    };
    let (job, source) = part_as_it_is(job, &a.job)?;
    let (_, planned) = Pipeline::planned(Arc::new(source), &job, Some(&a.job))
        .map_err(|e| say!(cli_not_planned, job = a.job.display().to_string(), reason = e.sentence()))
        .map_err(CommandFailure::Failed)?;
    let compared = planning::compared(&planned, &job, &first, &open).map_err(CommandFailure::failed)?;
    if a.json {
        print_json(&VerdictRecord::new(a.program.display().to_string(), &inputs, &compared))?;
    } else {
        print(&text(&compared, inputs.changes.len()));
    }
    let is_clean = compared.verdict.findings.is_empty() && inputs.changes.is_empty();
    Ok(if is_clean { CommandOutcome::Done } else { CommandOutcome::Found })
}

/// The part as it is now. Where it has changed the job is carried over to it, as `plan` does it; where not all of its
/// surfaces are found again they go by their numbers, and the comparison shows what that comes to.
fn part_as_it_is(job: Job, job_file: &Path) -> Result<(Job, Source), CommandFailure> {
    match part_of(job.clone(), Some(job_file)) {
        Ok((job, source, _)) => Ok((job, source)),
        Err(why) => {
            let file = files::part_file(&job, Some(job_file)).map_err(CommandFailure::failed)?;
            let source = super::source_of(&file, job.depth_camera(Some(job_file)).as_deref()).map_err(|_| why)?;
            let mut job = job;
            job.part.sha256.clone_from(&source.sha256);
            Ok((job, source))
        }
    }
}

fn is_unreadable(v: &Verdict) -> bool {
    v.findings.iter().any(|f| f.kind == DifferenceKind::Unreadable)
}

fn read(path: &Path) -> Result<ProgramFile, CommandFailure> {
    let not_read = |e: std::io::Error| say!(file_not_read, file = path.display().to_string(), reason = e.to_string());
    let bytes = std::fs::read(path).map_err(|e| CommandFailure::Failed(not_read(e)))?;
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    Ok(ProgramFile { name, text: String::from_utf8_lossy(&bytes).into_owned() })
}

/// What is printed of a comparison; `changes`: files that were found to be others before.
fn text(of: &ComparedProgram, changes: usize) -> String {
    use std::fmt::Write as _;
    let ComparedProgram { dialect, variant, verdict: v } = of;
    let dialect = *dialect;
    let mut out = String::new();
    if variant.dry_run {
        let _ = writeln!(out, "{}", say!(verify_dry_run));
    }
    if let Some(pass) = variant.from_pass {
        let _ = writeln!(out, "{}", say!(verify_from_pass, pass = id(pass)));
    }
    // Of what cannot be read there are no figures.
    if is_unreadable(v) {
        let _ = writeln!(out, "{}", say!(verify_unreadable, dialect));
    } else {
        let _ = writeln!(out, "{}", say!(verify_moves, dialect, moves = v.moves, lit = v.lit_moves));
        let (mm, deg) = (fixed(v.worst_mm, 4), fixed(v.worst_deg, 4));
        let _ = writeln!(out, "{}", say!(verify_furthest, mm, deg));
    }
    for f in v.findings.iter().take(SHOWN) {
        // What cannot be read names its place itself.
        let _ = match f.kind {
            DifferenceKind::Unreadable => writeln!(out, "{}", f.sentence()),
            _ => writeln!(out, "{}", say!(verify_finding, file = &f.file, line = id(f.line), what = f.sentence())),
        };
    }
    if v.findings.len() > SHOWN {
        let _ = writeln!(out, "{}", say!(verify_more, count = v.findings.len() - SHOWN));
    }
    let _ = writeln!(out, "{}", say!(verify_count, count = v.findings.len() + changes));
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planning::verify::Difference;
    use crate::program::LineFault;

    #[test]
    fn figures_are_told_of_what_was_read_alone() {
        let finding = |what: Difference| Finding { file: "a.src".into(), line: 3, kind: what.kind(), what };
        let odd = LineFault::NestedCall.at("a.src", 3);
        let with = |what| {
            let verdict = Verdict { findings: vec![finding(what)], ..Verdict::default() };
            text(&ComparedProgram { dialect: "kuka", variant: Variant::WHOLE, verdict }, 0)
        };
        assert!(with(Difference::EndsLit).contains("furthest from the plan"));
        let unreadable = with(Difference::Unreadable(Arc::new(odd)));
        assert!(!unreadable.contains("furthest") && !unreadable.contains("0 moves"), "{unreadable}");
        assert!(
            unreadable.contains("a.src, line 3: a sub-program calls none itself\n")
                && unreadable.ends_with("1 finding\n"),
            "{unreadable}"
        );
    }
}
