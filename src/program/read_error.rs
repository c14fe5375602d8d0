//! Why a program cannot be read: what was expected and what was found, as data. Code of a controller's language stands
//! in it as it would be written.

use std::borrow::Cow;
use thiserror::Error;

/// Why a program cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum ReadError {
    /// A line that the dialect does not know.
    #[error("{file}:{line}: {fault:?}")]
    Line {
        /// The file.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// What is wrong with it.
        fault: LineFault,
    },
    /// A subprogram that is not there.
    #[error("{file}:{line}: {called} is not there")]
    Gone {
        /// The calling file.
        file: String,
        /// Its line, from 1.
        line: usize,
        /// File that was looked for.
        called: String,
    },
    /// The text ends too early.
    #[error("{file}: cut off before {expected}")]
    CutOff {
        /// The file.
        file: String,
        /// The code that its end would be.
        expected: Cow<'static, str>,
    },
}

/// What is wrong with a line of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum LineFault {
    /// Other code was expected there.
    Expected {
        /// What may stand there: code, or its form.
        one_of: Vec<Cow<'static, str>>,
        /// What does.
        found: String,
    },
    /// So many numbers were expected, between commas.
    Numbers {
        /// How many.
        count: usize,
        /// What stands there.
        found: String,
    },
    /// A number above 0 was expected.
    NotAboveZero {
        /// What stands there.
        found: String,
    },
    /// A quaternion of another length than 1.
    Quaternion {
        /// Its length.
        length: f64,
    },
    /// It stands behind the end of the program.
    BehindEnd {
        /// The code that ended it.
        end: Cow<'static, str>,
    },
    /// It is not as the cell file has it.
    NotAsInCell {
        /// How it would be, or the key that says so.
        expected: String,
    },
    /// Something has to be said before it.
    Before {
        /// The code that says it.
        missing: Cow<'static, str>,
    },
    /// A name is given to two things.
    Twice {
        /// The name.
        name: String,
    },
    /// A name that nothing is called.
    Undefined {
        /// The name.
        name: String,
    },
    /// A part of the program that nothing calls.
    NeverCalled {
        /// Its name.
        name: String,
    },
    /// Programs call each other in a circle, or too deep.
    Circle {
        /// The one that is called.
        called: String,
    },
    /// A subprogram that calls another, which none that was written does.
    NestedCall,
    /// A call of something that is no number of a program.
    BadCall {
        /// What is called.
        called: String,
    },
    /// A line outside the program's function.
    OutsideFunction,
    /// Fewer or more lines, positions or rows than are promised.
    Count {
        /// The code that promises them.
        of: &'static str,
        /// How many are promised, if any number is.
        promised: Option<String>,
        /// How many are there.
        found: usize,
    },
    /// Lines are missing or out of order.
    OutOfOrder {
        /// The number that stands there.
        found: String,
        /// The number that would have to.
        expected: usize,
    },
    /// Nothing says which axes the program moves.
    NoMotionGroup,
    /// The program moves more than one arm.
    OtherMotionGroup {
        /// The code that says so.
        found: String,
    },
    /// A speed of the flange says nothing of the spot's.
    FlangeSpeed {
        /// What was given.
        found: String,
        /// What would do instead.
        one_of: &'static [&'static str],
    },
    /// An arc cannot be checked.
    Arc {
        /// What was given.
        found: String,
    },
    /// The duration of a straight move to joint angles is known with a robot only.
    NoDuration,
    /// A straight move before any position.
    FromNowhere,
    /// Joint angles, from which a line goes straight on: its duration is known with a robot only.
    GoesOnStraight {
        /// File of that line.
        file: String,
        /// The line, from 1.
        line: usize,
    },
    /// Pulses, without `yaskawa.pulses_per_deg` in the cell file.
    NoPulsesPerDegree,
    /// A row of a table is wrong.
    Row(RowFault),
}

/// What is wrong with a row of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum RowFault {
    /// The table has other columns.
    OtherColumns,
    /// Cells are filled that this kind of row does not use.
    UnusedCells {
        /// The kind.
        what: String,
    },
    /// A focus has to have a flange.
    FocusWithoutFlange,
    /// Joint angles and a flange cannot be compared without a robot.
    NoRobotToCompare,
    /// A move leads nowhere.
    NoGoal,
    /// A move has both a duration and a share of speed, or neither.
    NoTiming,
    /// Two figures that give one pose differ.
    Disagree {
        /// Which two.
        given_by: [MoveGivenBy; 2],
        /// Distance, mm.
        off_mm: f64,
        /// Turn, degrees.
        off_deg: f64,
    },
}

impl From<RowFault> for LineFault {
    fn from(fault: RowFault) -> Self {
        LineFault::Row(fault)
    }
}

/// How a table says where a move leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveGivenBy {
    /// By the arm's joints.
    Joints,
    /// By the flange in the base.
    Flange,
    /// By the focus in the part.
    Focus,
}

impl MoveGivenBy {
    /// The word that stands for it in tables.
    pub fn word(self) -> &'static str {
        match self {
            MoveGivenBy::Joints => "joints",
            MoveGivenBy::Flange => "flange",
            MoveGivenBy::Focus => "focus",
        }
    }
}

impl LineFault {
    /// Other code was expected there.
    pub fn expected<C: Into<Cow<'static, str>>>(one_of: impl IntoIterator<Item = C>, found: &str) -> LineFault {
        LineFault::Expected { one_of: one_of.into_iter().map(Into::into).collect(), found: found.into() }
    }

    /// So many numbers were expected.
    pub fn numbers(count: usize, found: &str) -> LineFault {
        LineFault::Numbers { count, found: found.into() }
    }

    /// The line of a file that it is wrong with.
    pub fn at(self, file: &str, line: usize) -> ReadError {
        ReadError::Line { file: file.into(), line, fault: self }
    }
}
