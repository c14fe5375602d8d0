//! `clearbeam verify`: a program on disk against the plan of its job.

use super::{Failure, Outcome, print, print_json};
use crate::document::files;
use crate::planning::verify::{self, Kind, Verdict};
use crate::planning::{Pipeline, PlannedJob};
use crate::program::ProgramFile;
use crate::text::{Sentence as _, fixed, id, say};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Options of `verify`.
#[derive(clap::Args, Debug)]
pub struct Arguments {
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
struct Answer<'a> {
    program: String,
    dialect: &'a str,
    #[serde(flatten)]
    verdict: &'a Verdict,
}

/// Reads, plans, compares.
pub fn run(a: &Arguments) -> Result<Outcome, Failure> {
    let job = files::read(&a.job).map_err(Failure::failed)?;
    let first = read(&a.program)?;
    let folder = a.program.parent().unwrap_or(Path::new("")).to_path_buf();
    let open = move |name: &str| {
        // A called name is a file of the same folder, and no way out of it.
        let plain = Path::new(name).file_name().is_some_and(|n| n.to_string_lossy() == name);
        plain.then(|| read(&folder.join(name)).ok().map(|f| f.text)).flatten()
    };
    let source = files::read_part(&job, Some(&a.job)).map_err(Failure::failed)?;
    let (_, planned) = Pipeline::planned(Arc::new(source), &job, Some(&a.job))
        .map_err(|e| say!(cli_not_planned, job = a.job.display().to_string(), reason = e.sentence()))
        .map_err(Failure::Failed)?;
    let PlannedJob { part, setup, plan, .. } = &*planned;
    let (dialect, verdict) = verify::check(part, plan, setup, &job, &first, &open, true).map_err(Failure::Failed)?;
    if a.json {
        let answer = Answer { program: a.program.display().to_string(), dialect, verdict: &verdict };
        print_json(&answer)?;
    } else {
        print(&text(dialect, &verdict));
    }
    Ok(if verdict.findings.is_empty() { Outcome::Done } else { Outcome::Found })
}

fn read(path: &Path) -> Result<ProgramFile, Failure> {
    let not_read = |e: std::io::Error| say!(file_not_read, file = path.display().to_string(), reason = e.to_string());
    let bytes = std::fs::read(path).map_err(|e| Failure::Failed(not_read(e)))?;
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    Ok(ProgramFile { name, text: String::from_utf8_lossy(&bytes).into_owned() })
}

fn text(dialect: &str, v: &Verdict) -> String {
    use std::fmt::Write as _;
    let mut out = String::new();
    // Of what cannot be read there are no figures.
    if v.findings.iter().any(|f| f.kind == Kind::Unreadable) {
        let _ = writeln!(out, "{}", say!(verify_unreadable, dialect));
    } else {
        let _ = writeln!(out, "{}", say!(verify_moves, dialect, moves = v.moves, lit = v.lit_moves));
        let (mm, deg) = (fixed(v.worst_mm, 4), fixed(v.worst_deg, 4));
        let _ = writeln!(out, "{}", say!(verify_furthest, mm, deg));
    }
    for f in v.findings.iter().take(SHOWN) {
        // What cannot be read names its place itself.
        let _ = match f.kind {
            Kind::Unreadable => writeln!(out, "{}", f.text),
            _ => writeln!(out, "{}", say!(verify_finding, file = &f.file, line = id(f.line), what = &f.text)),
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
    use crate::planning::verify::Finding;

    #[test]
    fn figures_are_told_of_what_was_read_alone() {
        let finding = |kind| Finding { file: "a.src".into(), line: 3, kind, text: "a.src, line 3: odd".into() };
        let with = |kind| text("kuka", &Verdict { findings: vec![finding(kind)], ..Verdict::default() });
        assert!(with(Kind::Deviation).contains("furthest from the plan"));
        let unreadable = with(Kind::Unreadable);
        assert!(!unreadable.contains("furthest") && !unreadable.contains("0 moves"), "{unreadable}");
        assert!(unreadable.contains("a.src, line 3: odd\n") && unreadable.ends_with("1 finding\n"), "{unreadable}");
    }
}
