//! A row of plans by one command: several jobs, or one job on several scans of its part. Each has a folder of its own, and
//! says how it ended in one line of JSON, in the order of the command line; one that fails does not stop the others.

use super::{PlanArguments, PlanRun, write};
use crate::cli::{CommandFailure, CommandOutcome, print};
use crate::text::say;
use serde::Serialize;
use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// How one of them ended.
#[derive(Serialize)]
struct RowLine {
    input: PathBuf,
    #[serde(skip_serializing_if = "Option::is_none")]
    scan: Option<PathBuf>,
    out: PathBuf,
    /// As the exit status of `plan` for it alone.
    status: u8,
    /// Why there is no plan.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<String>,
    #[serde(flatten)]
    made: Option<RowFigures>,
}

/// What was planned. Lengths mm, times s.
#[derive(Serialize)]
struct RowFigures {
    passes: usize,
    work_mm: f64,
    blocked_mm: f64,
    time_s: f64,
    proven: bool,
    problems: usize,
}

/// Makes all of them, as many at once as wanted; the worst decides how the command ends.
pub(super) fn run(a: &PlanArguments) -> Result<CommandOutcome, CommandFailure> {
    let runs = runs(a)?;
    let next = AtomicUsize::new(0);
    let lines: Mutex<(usize, BTreeMap<usize, RowLine>)> = Mutex::default();
    let mut worst = 0;
    std::thread::scope(|scope| {
        let works = || {
            let mut worst = 0;
            loop {
                let at = next.fetch_add(1, Ordering::Relaxed);
                let Some(run) = runs.get(at) else { return worst };
                let line = line_of(a, run);
                worst = worst.max(rank(line.status));
                tell(&lines, at, line);
            }
        };
        let workers: Vec<_> = (0..a.jobs).map(|_| scope.spawn(works)).collect();
        // One that panicked has failed.
        worst = workers.into_iter().map(|w| w.join().unwrap_or(rank(1))).max().unwrap_or(0);
    });
    match worst {
        0 => Ok(CommandOutcome::Done),
        1 => Ok(CommandOutcome::Found),
        2 => Err(CommandFailure::Usage(say!(cli_row_failed))),
        _ => Err(CommandFailure::Failed(say!(cli_row_failed))),
    }
}

/// Statuses by how bad they are.
fn rank(status: u8) -> u8 {
    match status {
        0 => 0,
        3 => 1,
        2 => 2,
        _ => 3,
    }
}

/// Prints the lines that have nothing before them to wait for.
fn tell(lines: &Mutex<(usize, BTreeMap<usize, RowLine>)>, at: usize, line: RowLine) {
    let Ok(mut lines) = lines.lock() else { return };
    lines.1.insert(at, line);
    let (told, waiting) = &mut *lines;
    while let Some(line) = waiting.remove(told) {
        if let Ok(json) = serde_json::to_string(&line) {
            print(&format!("{json}\n"));
        }
        *told += 1;
    }
}

fn line_of(a: &PlanArguments, run: &PlanRun<'_>) -> RowLine {
    let (status, error, made) = match write(a, run) {
        Ok(made) => {
            let report = &made.exported.report;
            let figures = RowFigures {
                passes: report.passes,
                work_mm: report.work_mm,
                blocked_mm: report.blocked_mm,
                time_s: report.time_s,
                proven: report.proven,
                problems: report.problems.len(),
            };
            (if report.is_complete() { 0 } else { 3 }, None, Some(figures))
        }
        Err(CommandFailure::Usage(why)) => (2, Some(why), None),
        Err(CommandFailure::Failed(why)) => (1, Some(why), None),
    };
    RowLine { input: run.input.into(), scan: run.scan.map(Into::into), out: run.out.clone(), status, error, made }
}

/// Each job with each scan, in folders that are named for what differs.
fn runs(a: &PlanArguments) -> Result<Vec<PlanRun<'_>>, CommandFailure> {
    let scans: Vec<Option<&Path>> = match &a.scan[..] {
        [] => vec![None],
        scans => scans.iter().map(|s| Some(s.as_path())).collect(),
    };
    let mut runs: Vec<PlanRun<'_>> = Vec::new();
    for input in &a.inputs {
        for &scan in &scans {
            let (of_job, of_scan) = (stem(input), scan.map(stem));
            let name = match (a.inputs.len(), of_scan) {
                (1, Some(scan)) => scan,
                (_, Some(scan)) if scans.len() > 1 => format!("{of_job}_{scan}"),
                _ => of_job,
            };
            let out = a.out.join(&name);
            if runs.iter().any(|r| r.out == out) {
                return Err(CommandFailure::Usage(say!(cli_row_same_name, name)));
            }
            runs.push(PlanRun { input, scan, out });
        }
    }
    Ok(runs)
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or(OsStr::new("plan")).to_string_lossy().into_owned()
}
