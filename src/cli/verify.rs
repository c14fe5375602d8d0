//! `clearbeam verify`: a program on disk against the plan of its job.

use super::{CommandFailure, CommandOutcome, print, print_json};
use crate::document::files;
use crate::planning::verify::{DifferenceKind, Finding, Verdict};
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
    moves: usize,
    lit_moves: usize,
    worst_mm: f64,
    worst_deg: f64,
    proof: &'a Proof,
    findings: Vec<FindingRecord<'a>>,
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
    fn new(program: String, of: &'a ComparedProgram) -> VerdictRecord<'a> {
        let ComparedProgram { dialect, variant, verdict: ref v } = *of;
        let row = |f: &'a Finding| FindingRecord { file: &f.file, line: f.line, kind: f.kind, text: f.sentence() };
        let findings = v.findings.iter().map(row).collect();
        let Verdict { moves, lit_moves, worst_mm, worst_deg, ref proof, .. } = *v;
        VerdictRecord { program, dialect, variant, moves, lit_moves, worst_mm, worst_deg, proof, findings }
    }
}

/// Reads, plans, compares.
pub fn run(a: &VerifyArguments) -> Result<CommandOutcome, CommandFailure> {
    let job = files::read(&a.job).map_err(CommandFailure::failed)?;
    let first = read(&a.program)?;
    let folder = a.program.parent().unwrap_or(Path::new("")).to_path_buf();
    let open = move |name: &str| {
        // A called name is a file of the same folder, and no way out of it.
        let plain = Path::new(name).file_name().is_some_and(|n| n.to_string_lossy() == name);
        plain.then(|| read(&folder.join(name)).ok().map(|f| f.text)).flatten()
    };
    let source = files::read_part(&job, Some(&a.job)).map_err(CommandFailure::failed)?;
    let (_, planned) = Pipeline::planned(Arc::new(source), &job, Some(&a.job))
        .map_err(|e| say!(cli_not_planned, job = a.job.display().to_string(), reason = e.sentence()))
        .map_err(CommandFailure::Failed)?;
    let compared = planning::compared(&planned, &job, &first, &open).map_err(CommandFailure::failed)?;
    if a.json {
        print_json(&VerdictRecord::new(a.program.display().to_string(), &compared))?;
    } else {
        print(&text(&compared));
    }
    Ok(if compared.verdict.findings.is_empty() { CommandOutcome::Done } else { CommandOutcome::Found })
}

fn read(path: &Path) -> Result<ProgramFile, CommandFailure> {
    let not_read = |e: std::io::Error| say!(file_not_read, file = path.display().to_string(), reason = e.to_string());
    let bytes = std::fs::read(path).map_err(|e| CommandFailure::Failed(not_read(e)))?;
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    Ok(ProgramFile { name, text: String::from_utf8_lossy(&bytes).into_owned() })
}

fn text(of: &ComparedProgram) -> String {
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
    if v.findings.iter().any(|f| f.kind == DifferenceKind::Unreadable) {
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
    let _ = writeln!(out, "{}", say!(verify_count, count = v.findings.len()));
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
            text(&ComparedProgram { dialect: "kuka", variant: Variant::WHOLE, verdict })
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
