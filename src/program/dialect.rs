//! What every controller dialect does: write a program, know its own text, read it back.
//!
//! A dialect neither plans nor judges: what it reads is compared with the plan elsewhere.

use super::neutral::comment::{Comment, WITHOUT_WORDS, Wording};
use super::neutral::lines::ProgramLine;
use super::neutral::steps::{Interpolation, MoveTiming, Steps};
use super::neutral::variant::Variant;
use super::read_error::ReadError;
use super::write_error::WriteError;
use crate::cell::{Cell, Setup};
use nalgebra::Isometry3;

/// A program before any controller's words.
#[derive(Clone, Debug)]
pub struct Program<'a> {
    /// Comments at its head.
    pub head: Vec<Comment>,
    /// What it does, in order; home moves included.
    pub lines: Vec<ProgramLine>,
    /// Frames, outputs, templates; the robot and what it carries.
    pub setup: &'a Setup,
    /// The words of its comments.
    pub wording: Wording,
}

/// A file of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramFile {
    /// By the dialect's rule.
    pub name: String,
    /// ASCII.
    pub text: String,
}

/// Where a move that was read goes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// Joint angles as in the robot file (couplings of the pendant taken out), degrees.
    Joints([f64; 6]),
    /// Flange in the base.
    Flange(Isometry3<f64>),
    /// Focus in the part: programs with a stationary tool, and tool in hand with a work object.
    Focus(Isometry3<f64>),
}

/// A move that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadMove {
    /// By joints or straight.
    pub interpolation: Interpolation,
    /// The target.
    pub goal: Goal,
    /// How fast.
    pub timing: MoveTiming,
    /// Everything else the instruction says (tool, accuracy, zone, configuration), verbatim: it has
    /// to be as it was written.
    pub rest: String,
}

/// What a line that was read does.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A move.
    Move(ReadMove),
    /// An output.
    Output {
        /// Its number.
        number: u32,
        /// On or off.
        on: bool,
    },
    /// An analogue output, or a group of digital ones, is set.
    OutputValue {
        /// Its number.
        number: u32,
        /// In its own units.
        value: f64,
        /// A group rather than an analogue output.
        group: bool,
    },
    /// A contact tool presses with so many newtons from here on; 0: no more.
    Force(f64),
    /// A dwell, s.
    Wait(f64),
    /// A comment.
    Comment(String),
    /// A setting, declaration or any other statement that acts: it has to be as it was written.
    Other(String),
}

/// A line that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadLine {
    /// The file it stands in.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// What it does.
    pub what: Statement,
}

/// What a reader needs beside the text.
pub struct ReadContext<'a> {
    /// Frames and templates; the robot and what it carries.
    pub setup: &'a Setup,
    /// The text of another file in the same folder.
    pub open: &'a dyn Fn(&str) -> Option<String>,
}

/// A controller's language.
pub trait Dialect: Sync {
    /// The word on the command line.
    fn name(&self) -> &'static str;

    /// Writes a program; the file to start comes first.
    ///
    /// # Errors
    /// What of it the controller could not take.
    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError>;

    /// Gives the names and numbers of the cell's programs to a variant of them, by the dialect's rule.
    fn rename(&self, cell: &mut Cell, variant: Variant);

    /// A setup with the program names of a variant.
    fn named(&self, setup: &Setup, variant: Variant) -> Setup {
        let mut named = setup.clone();
        self.rename(&mut named.cell, variant);
        named
    }

    /// Names of the files that a variant of any program has, however long it is, the one to start first; none where the
    /// cell's words cannot be written.
    fn file_names(&self, setup: &Setup, variant: Variant) -> Vec<String> {
        let setup = &self.named(setup, variant);
        let nothing = Program { head: Vec::new(), lines: Vec::new(), setup, wording: WITHOUT_WORDS };
        self.write(&nothing).unwrap_or_default().into_iter().map(|f| f.name).collect()
    }

    /// How fast its words make the moves of a program, in their order: as they were to be or a little slower, to the
    /// words' last digit and within their greatest speeds. Moves that are so already stay.
    fn paces(&self, lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming>;

    /// The lines of a variant of the program, of the steps that it has, with paces that its words can say: the program's
    /// were planned so, and a dry run's are so low that some controllers write them with one digit.
    fn lines(&self, variant: Variant, steps: &Steps, setup: &Setup) -> Vec<ProgramLine> {
        let mut lines = variant.lines(steps, setup);
        if variant.dry_run {
            let paces = self.paces(&lines, setup);
            let moves = lines.iter_mut().filter_map(|l| if let ProgramLine::Move(m) = l { Some(m) } else { None });
            for (m, pace) in moves.zip(paces) {
                m.timing = pace;
            }
        }
        lines
    }

    /// How many moves the laser may stay on for; `None`: as many as there are. A longer program than its controller takes
    /// is cut where the laser is off.
    fn most_lit_moves(&self, _setup: &Setup) -> Option<usize> {
        None
    }

    /// What no public source confirms of what it writes for a setup: words of the controller, and figures of its table
    /// of the cell file with the table's name before them. Words that are written otherwise by a cell file are those of
    /// its templates.
    fn unverified(&self, setup: &Setup) -> Vec<&'static str>;

    /// Whether a text is of this dialect.
    fn claims(&self, text: &str) -> bool;

    /// Reads a program from its first file; subprograms stand where they are called.
    ///
    /// # Errors
    /// The first line that cannot be understood: what a reader guesses is no check.
    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError>;
}
