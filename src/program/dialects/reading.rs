//! What the readers share: where something is wrong, and subprograms that call each other.

use crate::program::dialect::{ProgramFile, ReadContext, ReadLine, Statement};
use crate::program::read_error::{LineFault, ReadError};

/// More than any program here, and little enough for memory: calls multiply.
const MOST_LINES: usize = 5_000_000;
/// Programs within programs.
const DEEPEST: usize = 8;

/// What was read so far, and through which files.
pub struct Found {
    /// In order.
    pub lines: Vec<ReadLine>,
    open: Vec<String>,
}

/// One file's lines, as they are added to `found`.
pub type ReadFile<'a> = dyn Fn(&ProgramFile, &mut Found) -> Result<(), ReadError> + 'a;

impl Found {
    /// Nothing yet.
    pub fn new() -> Found {
        Found { lines: Vec::new(), open: Vec::new() }
    }

    /// Whether the file that is read is the one to start, and none that another calls.
    pub fn is_main(&self) -> bool {
        self.open.len() == 1
    }

    /// Reads a file by `read`, which comes back here for the files it calls.
    ///
    /// # Errors
    /// Of `read`.
    pub fn file(&mut self, file: &ProgramFile, read: &ReadFile<'_>) -> Result<(), ReadError> {
        self.open.push(file.name.clone());
        let done = read(file, self);
        self.open.pop();
        done
    }

    /// Opens the file that a line calls.
    ///
    /// # Errors
    /// It is not there, or calls run in a circle.
    pub fn called(
        &self,
        name: String,
        from: &str,
        line: usize,
        reading: &ReadContext<'_>,
    ) -> Result<ProgramFile, ReadError> {
        if self.open.contains(&name) || self.open.len() >= DEEPEST || self.lines.len() > MOST_LINES {
            return Err(LineFault::Circle { called: name }.at(from, line));
        }
        match (reading.open)(&name) {
            Some(text) => Ok(ProgramFile { name, text }),
            None => Err(ReadError::Gone { file: from.into(), line, called: name }),
        }
    }
}

/// The error of a straight move from an unknown pose: without a robot, joint angles give no pose and so no duration.
/// It is reported at the line with the joint angles, and names the line that goes on from there.
pub fn unknown_start(before: &[ReadLine], file: &str, line: usize) -> ReadError {
    match before.iter().rev().find(|l| matches!(l.what, Statement::Move(_))) {
        None => LineFault::FromNowhere.at(file, line),
        Some(last) => LineFault::GoesOnStraight { file: file.into(), line }.at(&last.file, last.line),
    }
}
