//! The command line: `inspect`, `plan`, `verify`, `render`. Names, files and exit statuses are a contract.
//!
//! Exit status: 0 done · 3 done, but something is blocked, missed or found · 2 wrong usage · 1 failed,
//! with one line that says what, where and what to do.

mod changed;
mod inspect;
mod legend;
mod number_options;
mod options;
mod plan;
mod render;
mod verify;
mod word_options;

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

pub use options::PlanOptions;

/// Plans robot laser cleaning of chosen surfaces of a part: from an STL file to a robot program.
#[derive(Parser, Debug)]
#[command(name = "clearbeam", version, about, args_conflicts_with_subcommands = true)]
pub struct Arguments {
    /// Part or job to open in the window
    pub file: Option<PathBuf>,
    /// What to do without a window
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What to do without a window.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Say what a part file holds: topology, faults, feature surfaces
    Inspect(inspect::Arguments),
    /// Plan a job and write job, program, report and path into a folder
    Plan(Box<plan::Arguments>),
    /// Read a program back and compare it with the plan of its job
    Verify(verify::Arguments),
    /// Draw a part, or a planned job, into a picture
    Render(render::Arguments),
}

/// How a command ended.
pub enum Outcome {
    /// All done.
    Done,
    /// Done, but something is blocked or missed.
    Found,
}

/// Why a command did not do its work.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// An option cannot be taken.
    #[error("{0}")]
    Usage(String),
    /// The work failed.
    #[error("{0}")]
    Failed(#[from] anyhow::Error),
}

/// Runs a command and says how it ended.
pub fn run(command: &Command) -> ExitCode {
    let result = match command {
        Command::Inspect(a) => inspect::run(a),
        Command::Plan(a) => plan::run(a),
        Command::Verify(a) => verify::run(a),
        Command::Render(a) => render::run(a),
    };
    match result {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Found) => ExitCode::from(3),
        Err(failure) => {
            eprintln!("clearbeam: {}", failure.to_string().replace('\n', " "));
            ExitCode::from(if matches!(failure, Failure::Usage(_)) { 2 } else { 1 })
        }
    }
}

/// Prints, and takes a reader who has gone (`| head`) for an answer.
fn print(text: &str) {
    use std::io::Write as _;
    let _ = std::io::stdout().write_all(text.as_bytes());
}
