//! What the tables of a cell file, and those of a robot file, check alike: ranges, names and lines of programs.
//! What is wrong is told by key and figure; the sentences are made elsewhere.

use super::controllers::templates::TemplateError;
use super::frame::FrameError;
use thiserror::Error;

/// What makes no sense in a file, by its key.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum FigureError {
    /// A figure is out of its range.
    #[error("{key} = {value}, range {low} to {high}")]
    Range {
        /// The key, with its table's.
        key: String,
        /// What stands there.
        value: f64,
        /// The least that may.
        low: f64,
        /// The most that may.
        high: f64,
    },
    /// A figure has to be greater than 0.
    #[error("{key} = {value}, range above 0 to {high}")]
    NotPositive {
        /// The key, with its table's.
        key: &'static str,
        /// What stands there.
        value: f64,
        /// The most that may.
        high: f64,
    },
    /// A figure is infinite or no number at all.
    #[error("{key} = {value}")]
    NotFinite {
        /// The key, with its table's.
        key: &'static str,
        /// What stands there.
        value: f64,
    },
    /// A piece of the head ends before it begins, or beyond all reason.
    #[error("bodies.head from {from_mm} to {to_mm}")]
    HeadPiece {
        /// Where it begins, mm from the focus against the light.
        from_mm: f64,
        /// Where it ends.
        to_mm: f64,
    },
    /// The place of an obstacle is no number.
    #[error("bodies.obstacles: {file} not finite")]
    Obstacle {
        /// The obstacle's file.
        file: String,
    },
    /// A name has letters that the controller does not take, or too many.
    #[error("{key} = {value:?}, at most {longest}")]
    Name {
        /// The key, with its table's.
        key: &'static str,
        /// What stands there.
        value: String,
        /// Letters that it may have.
        letters: Letters,
        /// How many.
        longest: usize,
    },
    /// A line is empty, more than one, or has other characters than ASCII.
    #[error("{key} has {line:?}")]
    Line {
        /// The key, with its table's.
        key: &'static str,
        /// The line.
        line: String,
    },
    /// A word has none of the forms that the controller knows.
    #[error("{key} = {value}")]
    WordForm {
        /// The key, with its table's.
        key: &'static str,
        /// What stands there, as in the file.
        value: String,
        /// What may.
        form: WordForm,
    },
    /// A template cannot be used.
    #[error(transparent)]
    Template(#[from] TemplateError),
    /// Two outputs share a number.
    #[error("{key} = {number}, taken by {by}")]
    Taken {
        /// The key, with its table's.
        key: String,
        /// The number of the output.
        number: u32,
        /// The output that has it already.
        by: &'static str,
    },
    /// A frame other than the tool's is given by poses that touch with its tip.
    #[error("{frame}: tip_poses")]
    TipPoses {
        /// The frame's key.
        frame: &'static str,
    },
    /// A frame cannot be told from what the file has of it.
    #[error(transparent)]
    Frame(#[from] FrameError),
}

impl FigureError {
    /// The key that it is about, with its table's; a frame by its own.
    pub fn key(&self) -> &str {
        match self {
            FigureError::Range { key, .. } | FigureError::Taken { key, .. } => key,
            FigureError::NotPositive { key, .. } | FigureError::NotFinite { key, .. } => key,
            FigureError::Name { key, .. } | FigureError::Line { key, .. } | FigureError::WordForm { key, .. } => key,
            FigureError::HeadPiece { .. } => "bodies.head",
            FigureError::Obstacle { .. } => "bodies.obstacles",
            FigureError::Template(e) => &e.key,
            FigureError::TipPoses { frame } => frame,
            FigureError::Frame(e) => e.frame,
        }
    }
}

/// Letters of a program's names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// A letter, then letters, digits and `_`.
    Identifier,
    /// A capital, then capitals, digits and `_`.
    CapitalIdentifier,
    /// Capitals, digits, `-` and `_`.
    Capitals,
}

impl Letters {
    fn fit(self, name: &str) -> bool {
        let first = |c: char| match self {
            Letters::Identifier => c.is_ascii_alphabetic(),
            Letters::CapitalIdentifier => c.is_ascii_uppercase(),
            Letters::Capitals => true,
        };
        let all = |c: char| match self {
            Letters::Identifier => c.is_ascii_alphanumeric() || c == '_',
            Letters::CapitalIdentifier => c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_',
            Letters::Capitals => c.is_ascii_uppercase() || c.is_ascii_digit() || matches!(c, '-' | '_'),
        };
        name.starts_with(first) && name.chars().all(all)
    }
}

/// Forms that words of single controllers have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordForm {
    /// ESTUN: a line of ASCII that begins with `//`.
    Version,
    /// FANUC: `FINE`, or `CNT0` to `CNT100`.
    Termination,
    /// FANUC: letters and turns, such as `N U T, 0, 0, 0`.
    Configuration,
    /// NACHI: letters, digits, `-` and `_` of a file's name.
    Unit,
    /// Yaskawa: 8 or 32 letters.
    LongestName,
    /// Yaskawa: lines that begin with `///`.
    Attributes,
    /// Yaskawa: pulses for a degree, of either sign.
    Pulses,
}

/// Whether a controller can take a name.
///
/// # Errors
/// The name has other letters, or more.
pub fn name(key: &'static str, value: &str, letters: Letters, longest: usize) -> Result<(), FigureError> {
    if letters.fit(value) && value.len() <= longest {
        return Ok(());
    }
    Err(FigureError::Name { key, value: value.to_owned(), letters, longest })
}

/// Whether each of the lines can stand in a program as one.
///
/// # Errors
/// The first of the lines that is more than a line, or holds what a controller might not take.
pub fn plain_lines(key: &'static str, lines: &[String]) -> Result<(), FigureError> {
    match lines.iter().find(|l| l.trim().is_empty() || !l.chars().all(|c| c.is_ascii_graphic() || c == ' ')) {
        Some(bad) => Err(FigureError::Line { key, line: bad.clone() }),
        None => Ok(()),
    }
}

/// Whether figures are within their ranges: key, figure, least and greatest.
///
/// # Errors
/// The first of the figures that is not.
pub fn ranges(list: &[(&str, f64, f64, f64)]) -> Result<(), FigureError> {
    match list.iter().find(|(_, value, low, high)| !(low..=high).contains(&value)) {
        Some(&(key, value, low, high)) => Err(FigureError::Range { key: key.to_owned(), value, low, high }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::controllers::{Abb, Estun, Kuka, Yaskawa};
    use super::*;

    #[test]
    fn what_a_controller_refuses_is_named() {
        assert_eq!(Kuka::default().check(), Ok(()));
        assert_eq!(Abb::default().check(), Ok(()));
        assert_eq!(Yaskawa::default().check(), Ok(()));
        assert_eq!(Estun::default().check(), Ok(()));
        let told = |refused: Result<(), FigureError>| refused.expect_err("refused");
        let kuka = told(Kuka { name: "a_name_that_is_much_too_long".into(), ..Kuka::default() }.check());
        assert!(matches!(kuka, FigureError::Name { key: "kuka.name", longest: 20, .. }), "{kuka}");
        let start = told(Kuka { start: vec!["two\nlines".into()], ..Kuka::default() }.check());
        assert_eq!(start, FigureError::Line { key: "kuka.start", line: "two\nlines".into() });
        let mass = told(Abb { mass_kg: 0.0, ..Abb::default() }.check());
        let range = FigureError::Range { key: "abb.mass_kg".into(), value: 0.0, low: 0.001, high: 2000.0 };
        assert_eq!(mass, range);
        let long = Yaskawa { name: "CLEANING".into(), ..Yaskawa::default() };
        let refused = told(long.check());
        assert!(matches!(refused, FigureError::Name { key: "yaskawa.name", longest: 5, .. }), "{refused}");
        assert_eq!(Yaskawa { longest_name: 32, ..long }.check(), Ok(()));
        let none = told(Estun { wait: "Wait{}".into(), ..Estun::default() }.check());
        assert!(matches!(&none, FigureError::Template(TemplateError { key, .. }) if key == "estun.wait"), "{none}");
        for bad in ["1a", "", "a-b", "ä"] {
            assert!(name("x", bad, Letters::Identifier, 9).is_err(), "{bad}");
        }
        assert!(
            name("x", "Aa", Letters::CapitalIdentifier, 9).is_err() && name("x", "", Letters::Capitals, 9).is_err()
        );
    }
}
