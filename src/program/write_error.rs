//! Why a program cannot be written in a dialect, as data.

use crate::cell::controllers::templates::TemplateError;
use thiserror::Error;

/// There is no dialect of that name.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("no dialect {0:?}")]
pub struct UnknownDialect(pub String);

/// Why nothing can be written in a dialect.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum DialectError {
    /// There is no such dialect.
    #[error(transparent)]
    Unknown(#[from] UnknownDialect),
    /// The controller could not take it.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Why a program cannot be written. Each names the dialect as on the command line.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum WriteError {
    /// The controller takes joint angles, and without a robot there are none.
    #[error("{0}: no robot")]
    NoRobot(&'static str),
    /// A template of the cell file cannot be used.
    #[error(transparent)]
    Template(#[from] TemplateError),
    /// Outputs go on and off by one and the same line, so the laser would stay on.
    #[error("{0}: output_off is output_on")]
    OffIsOn(&'static str),
    /// The cell file has no template for a kind of signal that an output of its needs.
    #[error("{dialect}: no template of {kind:?}")]
    NoTemplate {
        /// The dialect.
        dialect: &'static str,
        /// The signal.
        kind: SignalKind,
    },
    /// A move by joints with a duration, which the controller does not know.
    #[error("{0}: joint move with a duration")]
    TimedJointMove(&'static str),
    /// A straight move in per cent, which the controller does not know.
    #[error("{0}: straight move in per cent")]
    StraightInPercent(&'static str),
    /// A straight move from home: without a robot it is not known how far that is, and so how fast.
    #[error("{0}: straight move from an unknown pose")]
    FromUnknownPose(&'static str),
    /// Home is known by its joints, and the controller would need a robot or pulses for it.
    #[error("yaskawa: home has no pose and no pulses")]
    HomeNeedsPulses,
    /// A lit piece is longer than one program may be, and a call in the middle would let the spot stand.
    #[error("fanuc: a lit piece of {lines} lines, at most {most}")]
    PieceTooLong {
        /// Lines that it needs.
        lines: usize,
        /// `fanuc.max_lines`.
        most: usize,
    },
    /// Sub-programs would be numbered beyond 999.
    #[error("nachi: {subprograms} sub-programs from {number} on, up to {last}")]
    ProgramNumbers {
        /// `nachi.number`.
        number: u32,
        /// How many there would be.
        subprograms: usize,
        /// Number of the last.
        last: u32,
    },
    /// A job has more positions without a pause of the laser than it can number.
    #[error("yaskawa: more than 100000 positions")]
    TooManyPositions,
}

/// Signals that a cell file may have no template for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalKind {
    /// An analogue output.
    Analogue,
    /// A group of digital outputs.
    Group,
}

impl SignalKind {
    /// The key in a controller's table of the cell file.
    pub fn key(self) -> &'static str {
        match self {
            SignalKind::Analogue => "analogue",
            SignalKind::Group => "group",
        }
    }
}
