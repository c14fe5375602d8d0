//! Window or command line; nothing else.

use clearbeam::cli;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = cli::arguments();
    match &arguments.command {
        Some(command) => cli::run(command),
        None => match clearbeam::app::run(arguments.file) {
            Ok(()) => ExitCode::SUCCESS,
            Err(e) => {
                eprintln!("clearbeam: {e:#}");
                ExitCode::FAILURE
            }
        },
    }
}
