//! The command line: `inspect`, `plan`, `verify`, `render`, `register`, `deviation`, `weld`. Names, files and exit statuses
//! are a contract.
//!
//! Exit status: 0 done · 3 done, but something is blocked, missed or found · 2 wrong usage · 1 failed,
//! with one line that says what, where and what to do.

mod changed;
mod deviation;
mod inspect;
mod language;
mod legend;
mod number_options;
mod options;
mod plan;
mod register;
mod render;
mod scans;
mod verify;
mod weld;
mod word_options;

use crate::document::files::read_source;
use crate::part::{PartFinding, Source};
use crate::progress::Progress;
use crate::text::{Sentence, say, with_option};
use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub use options::PlanOptions;

/// What `clearbeam` was called with.
#[derive(Parser, Debug)]
#[command(name = "clearbeam", version, about = say!(cli_about), args_conflicts_with_subcommands = true)]
pub struct Arguments {
    /// Part or job to open in the window
    #[arg(help = say!(cli_file))]
    pub file: Option<PathBuf>,
    /// What to do without a window
    #[command(subcommand)]
    pub command: Option<CliCommand>,
}

/// What to do without a window.
#[derive(Subcommand, Debug)]
pub enum CliCommand {
    /// Says what a part file holds.
    #[command(about = say!(cli_inspect))]
    Inspect(inspect::InspectArguments),
    /// Plans a job and writes its files.
    #[command(about = say!(cli_plan))]
    Plan(Box<plan::PlanArguments>),
    /// Compares a program with the plan of its job.
    #[command(about = say!(cli_verify))]
    Verify(verify::VerifyArguments),
    /// Draws a part or a planned job.
    #[command(about = say!(cli_render))]
    Render(render::RenderArguments),
    /// Finds where a scan lies on its part.
    #[command(about = say!(cli_register))]
    Register(register::RegisterArguments),
    /// Compares a scan with its part.
    #[command(about = say!(cli_deviation))]
    Deviation(deviation::DeviationArguments),
    /// Grinds a weld that a grey image and a depth image show.
    #[command(about = say!(cli_weld))]
    Weld(Box<weld::WeldArguments>),
}

/// How a command ended.
pub enum CommandOutcome {
    /// All done.
    Done,
    /// Done, but something is blocked, missed or found.
    Found,
}

/// Why a command failed, as a sentence for its user.
#[derive(Debug)]
pub enum CommandFailure {
    /// An option cannot be taken.
    Usage(String),
    /// The work failed.
    Failed(String),
}

impl CommandFailure {
    /// The work failed, for this reason.
    fn failed(why: impl Sentence) -> CommandFailure {
        CommandFailure::Failed(why.sentence())
    }
}

/// Reads the arguments. If they cannot be read, or ask for help or version, prints that and ends the program.
pub fn arguments() -> Arguments {
    let given = language::taken(std::env::args_os());
    let command = Arguments::command().arg(language::option());
    Arguments::from_arg_matches(&command.get_matches_from(given)).unwrap_or_else(|e| e.exit())
}

/// Runs a command and says how it ended.
pub fn run(command: &CliCommand) -> ExitCode {
    let result = match command {
        CliCommand::Inspect(a) => inspect::run(a),
        CliCommand::Plan(a) => plan::run(a),
        CliCommand::Verify(a) => verify::run(a),
        CliCommand::Render(a) => render::run(a),
        CliCommand::Register(a) => register::run(a),
        CliCommand::Deviation(a) => deviation::run(a),
        CliCommand::Weld(a) => weld::run(a),
    };
    let (status, why) = match result {
        Ok(CommandOutcome::Done) => return ExitCode::SUCCESS,
        Ok(CommandOutcome::Found) => return ExitCode::from(3),
        Err(CommandFailure::Usage(why)) => (2, why),
        Err(CommandFailure::Failed(why)) => (1, why),
    };
    eprintln!("clearbeam: {}", why.replace('\n', " "));
    ExitCode::from(status)
}

/// Reads a part's file, or a scan as a part; `camera`: the one that took it, where it is a depth image.
fn source_of(file: &Path, camera: Option<&Path>) -> Result<Source, CommandFailure> {
    let read = read_source(file, camera, &Progress::default()).map_err(CommandFailure::failed)?;
    // Nobody can have cancelled it.
    Ok(read.unwrap_or_default())
}

/// Says on stderr what was found in a part's file.
fn tell_of_file<'a>(file: &Path, findings: impl IntoIterator<Item = &'a PartFinding>) {
    for finding in findings {
        eprintln!("{}", say!(in_file, file = file.display().to_string(), what = with_option(finding)));
    }
}

/// Prints; a reader that has gone (`| head`) is no failure.
fn print(text: &str) {
    use std::io::Write as _;
    let _ = std::io::stdout().write_all(text.as_bytes());
}

/// Prints a value as JSON.
fn print_json(value: &impl serde::Serialize) -> Result<(), CommandFailure> {
    let json = serde_json::to_string_pretty(value)
        .map_err(|e| CommandFailure::Failed(say!(cli_no_json, reason = e.to_string())))?;
    print(&format!("{json}\n"));
    Ok(())
}
