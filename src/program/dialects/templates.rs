//! Outputs, their values, forces, dwells and comments as they are written by the templates of a controller's table. Moves are each
//! dialect's own; `signals` reads what is written here.

use super::spelling::Spelling;
use crate::cell::controllers::templates::{check_force, check_signals, cut, filled, fixed, plain};
use crate::program::neutral::comment::{Comment, Wording};
use crate::program::neutral::lines::ProgramLine;
use crate::program::write_error::{SignalKind, WriteError};

/// Decimals of a force, N.
const FORCE_DECIMALS: usize = 2;

/// A controller's templates of signals.
#[derive(Clone, Copy, Debug)]
pub struct SignalTemplates<'a> {
    /// The dialect's name, which is its table's in the cell file.
    pub dialect: &'static str,
    /// Output `{n}` on.
    pub output_on: &'a str,
    /// Output `{n}` off.
    pub output_off: &'a str,
    /// Analogue output `{n}` to `{v}`; empty: there is none.
    pub analogue: &'a str,
    /// Decimals of that `{v}`.
    pub analogue_decimals: usize,
    /// Group `{n}` of outputs to the whole number `{v}`; empty: there is none.
    pub group: &'a str,
    /// A contact tool presses with `{f}` newtons from here on; empty: that is a comment.
    pub force_on: &'a str,
    /// It presses no more.
    pub force_off: &'a str,
    /// Dwell of `{s}`.
    pub wait: &'a str,
    /// How seconds are written as `{s}`.
    pub seconds: fn(f64) -> String,
    /// How many `{s}` there are in a second: 1000 where the controller counts milliseconds.
    pub wait_per_s: f64,
    /// Comment of `{text}`.
    pub comment: &'a str,
    /// Characters that would end the comment.
    pub forbidden: &'a [char],
    /// Longest comment; longer ones are cut at blanks.
    pub width: Option<usize>,
    /// How the language may spell a line.
    pub spelling: Spelling,
}

impl SignalTemplates<'_> {
    /// Whether they can be written, read back and told apart.
    ///
    /// # Errors
    /// The first that cannot.
    pub fn check(&self) -> Result<(), WriteError> {
        // Not every controller has values of its own.
        let value = |template| Some(template).filter(|t: &&str| !t.is_empty());
        let (analogue, group) = (value(self.analogue), value(self.group));
        let (on, off, wait, comment) = (self.output_on, self.output_off, self.wait, self.comment);
        check_signals(self.dialect, [Some(on), Some(off), analogue, group, Some(wait), Some(comment)])?;
        check_force(self.dialect, self.force_on, self.force_off)?;
        if self.output_on == self.output_off { Err(WriteError::OffIsOn(self.dialect)) } else { Ok(()) }
    }

    /// The lines of anything but a move.
    ///
    /// # Errors
    /// There is no template for it.
    pub fn write(&self, line: &ProgramLine, wording: Wording) -> Result<Vec<String>, WriteError> {
        Ok(match line {
            ProgramLine::Comment(comment) => self.comments(&wording(comment)),
            ProgramLine::Output { number, on } => {
                let template = if *on { self.output_on } else { self.output_off };
                vec![filled(template, &[("n", &number.to_string())])]
            }
            ProgramLine::OutputValue { number, value, group } => {
                let (kind, template, decimals) = match group {
                    true => (SignalKind::Group, self.group, 0),
                    false => (SignalKind::Analogue, self.analogue, self.analogue_decimals),
                };
                if template.is_empty() {
                    return Err(WriteError::NoTemplate { dialect: self.dialect, kind });
                }
                vec![filled(template, &[("n", &number.to_string()), ("v", &fixed(*value, decimals))])]
            }
            ProgramLine::Force(force_n) if self.force_on.is_empty() => {
                self.comments(&wording(&Comment::Force(*force_n)))
            }
            ProgramLine::Force(force_n) if *force_n > 0.0 => {
                vec![filled(self.force_on, &[("f", &fixed(*force_n, FORCE_DECIMALS))])]
            }
            ProgramLine::Force(_) => vec![self.force_off.to_owned()],
            ProgramLine::Wait(seconds) => vec![filled(self.wait, &[("s", &(self.seconds)(*seconds))])],
            ProgramLine::Move(_) => Vec::new(),
        })
    }

    /// The comments of a program's head.
    pub fn head(&self, comments: &[Comment], wording: Wording) -> Vec<String> {
        comments.iter().flat_map(|comment| self.comments(&wording(comment))).collect()
    }

    /// A text as comments.
    pub fn comments(&self, text: &str) -> Vec<String> {
        let lines = text.split('\n').map(|line| plain(line, self.forbidden));
        let cut = |line: String| self.width.map_or_else(|| vec![line.trim().into()], |width| cut(line.trim(), width));
        lines.flat_map(cut).map(|t| self.comment(&t)).collect()
    }

    /// One line of comment.
    pub fn comment(&self, text: &str) -> String {
        filled(self.comment, &[("text", text)]).trim_end().into()
    }
}
