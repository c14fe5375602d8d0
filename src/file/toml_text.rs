//! A TOML text as a value, or what is wrong in which line and at which key.
//!
//! Beside what TOML and the value's own keys ask, numbers have to be finite: TOML knows `inf` and `nan`, and no file
//! of clearbeam has a use for them. What range a number has is for others to check.

use super::key_lines::{key_at, line_at};
use serde::de::DeserializeOwned;
use std::ops::Range;
use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What is wrong with a TOML text, and where.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("line {line}: {key}: {fault:?}")]
pub struct TomlError {
    /// The line, from 1.
    pub line: usize,
    /// The key with those of its tables; empty where it is not known.
    pub key: String,
    /// What is wrong.
    pub fault: TomlFault,
}

/// What is wrong with a TOML text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TomlFault {
    /// A backslash in a text in double quotes begins a sign that is none, or is one in the name of a file: a path of
    /// Windows.
    Backslash,
    /// A number is infinite, or none; as it stands there.
    NotFinite(String),
    /// A key that does not belong there.
    UnknownKey {
        /// The key.
        key: String,
        /// The one that is spelt most alike, if any is.
        meant: Option<String>,
        /// Those there may be.
        known: Vec<String>,
    },
    /// What the reader says of it, in English.
    Other(String),
}

/// Keys of files' names. A tab or line break in one comes of `\t` or `\n` in a path of Windows.
const NAMES_OF_FILES: &[&str] = &["file", "head", "robot"];

/// What a TOML text says.
///
/// # Errors
/// It is no TOML, has a number that is not finite, or a key or a value that does not belong there, or lacks one.
pub fn read<T: DeserializeOwned>(text: &str) -> Result<T, TomlError> {
    let root = DeTable::parse(text).map_err(|e| syntax(text, &e))?;
    if let Some((at, fault)) = first_fault(root.get_ref()) {
        return Err(TomlError { line: line_at(text, at.start), key: key_at(root.get_ref(), at.start), fault });
    }
    toml::from_str(text).map_err(|e| {
        let at = e.span().map_or(0, |s| s.start);
        let fault = unknown_key(e.message()).unwrap_or_else(|| TomlFault::Other(one_line(e.message())));
        TomlError { line: line_at(text, at), key: key_at(root.get_ref(), at), fault }
    })
}

/// A text that is no TOML.
fn syntax(text: &str, e: &toml::de::Error) -> TomlError {
    let at = e.span().unwrap_or(0..0);
    let begin = text.get(..at.start).map_or(0, |before| before.rfind('\n').map_or(0, |n| n + 1));
    let line = text.get(begin..).and_then(|rest| rest.lines().next()).unwrap_or_default();
    let fault = if line.contains('\\') { TomlFault::Backslash } else { TomlFault::Other(one_line(e.message())) };
    let key = line.split_once('=').map_or(String::new(), |(key, _)| key.trim().to_owned());
    TomlError { line: line_at(text, at.start), key, fault }
}

/// The first value that no file has a use for, whatever its key.
fn first_fault(table: &DeTable<'_>) -> Option<(Range<usize>, TomlFault)> {
    let faults = table.iter().filter_map(|(key, value)| fault_of(key.get_ref(), value));
    faults.min_by_key(|(at, _)| at.start)
}

fn fault_of(key: &str, value: &Spanned<DeValue<'_>>) -> Option<(Range<usize>, TomlFault)> {
    match value.get_ref() {
        DeValue::Float(f) if !f.as_str().parse::<f64>().is_ok_and(f64::is_finite) => {
            Some((value.span(), TomlFault::NotFinite(f.as_str().to_owned())))
        }
        DeValue::String(s) if NAMES_OF_FILES.contains(&key) && s.contains(char::is_control) => {
            Some((value.span(), TomlFault::Backslash))
        }
        DeValue::Array(list) => list.iter().find_map(|v| fault_of(key, v)),
        DeValue::Table(table) => first_fault(table),
        _ => None,
    }
}

/// What serde says of a key that it does not know: ``unknown field `a`, expected one of `b`, `c` ``.
fn unknown_key(message: &str) -> Option<TomlFault> {
    let mut quoted = message.strip_prefix("unknown field ")?.split('`').skip(1).step_by(2).map(str::to_owned);
    let key = quoted.next()?;
    let known: Vec<String> = quoted.collect();
    let nearest = known.iter().map(|k| (letters_apart(&key, k), k)).min();
    // Two letters of five may be wrong: `spaceing` for `spacing_mm` has four of eleven.
    let meant = nearest.filter(|(apart, k)| 5 * apart <= 2 * k.chars().count()).map(|(_, k)| k.clone());
    Some(TomlFault::UnknownKey { key, meant, known })
}

/// By how many letters two words differ: left out, put in, or replaced (Levenshtein's distance).
fn letters_apart(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, a) in one.chars().enumerate() {
        let mut above_left = i;
        let mut left = i + 1;
        for (cell, b) in row.iter_mut().skip(1).zip(&other) {
            let above = *cell;
            left = (above + 1).min(left + 1).min(above_left + usize::from(a != *b));
            above_left = above;
            *cell = left;
        }
        row[0] = i + 1;
    }
    row.last().copied().unwrap_or_default()
}

/// What the reader of TOML says of a fault, on one line.
pub fn one_line(message: &str) -> String {
    message.trim_end().replace('\n', ", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Layers {
        #[serde(rename = "spacing_mm")]
        _spacing_mm: f64,
        #[serde(default, rename = "file")]
        _file: String,
        #[serde(default, rename = "turns")]
        _turns: Vec<f64>,
    }

    fn refused(text: &str) -> TomlError {
        read::<Layers>(text).map(|l| format!("{l:?}")).expect_err(text)
    }

    #[test]
    fn what_is_wrong_is_told_by_line_and_key() {
        let place = |e: &TomlError| (e.line, e.key.clone());
        let e = refused("\nspacing_mm = nan");
        assert_eq!((place(&e), e.fault), ((2, "spacing_mm".into()), TomlFault::NotFinite("nan".into())));
        let e = refused("spacing_mm = 1\nturns = [0,\n -inf]");
        assert_eq!((place(&e), e.fault), ((3, "turns".into()), TomlFault::NotFinite("-inf".into())));
        let e = refused("spacing_mm = \"wide\"");
        assert!(matches!(&e.fault, TomlFault::Other(said) if said.contains("expected f64")), "{e}");
        assert_eq!(place(&e), (1, "spacing_mm".into()));
        let e = refused("spacing_mm = ");
        assert!(matches!(e.fault, TomlFault::Other(_)) && place(&e) == (1, "spacing_mm".into()), "{e}");
    }

    #[test]
    fn a_path_of_windows_is_told_whatever_its_letters_mean() {
        for path in [r"C:\parts\Users", r"C:\temp\new.stl", r"C:\boxes", r"C:\ulm.stl"] {
            let e = refused(&format!("spacing_mm = 1\nfile = \"{path}\""));
            assert_eq!((e.line, e.key, e.fault), (2, "file".into(), TomlFault::Backslash), "{path}");
        }
        read::<Layers>("spacing_mm = 1\nfile = 'C:\\parts\\a.stl'").expect("in single quotes it is plain text");
    }

    #[test]
    fn a_key_is_guessed_where_it_is_near_one() {
        let e = refused("spacing_mm = 1\nspaceing_mm = 2");
        let TomlFault::UnknownKey { key, meant, known } = e.fault else { panic!("{e}") };
        assert_eq!((key.as_str(), meant.as_deref(), e.line), ("spaceing_mm", Some("spacing_mm"), 2));
        assert_eq!(known, ["spacing_mm", "file", "turns"]);
        let e = refused("spacing_mm = 1\nvelocity = 2");
        assert!(matches!(e.fault, TomlFault::UnknownKey { meant: None, .. }), "{e}");
    }

    #[test]
    fn letters_apart_are_counted() {
        for (a, b, n) in [("", "", 0), ("a", "", 1), ("", "ab", 2), ("kitten", "sitting", 3), ("spot", "spot", 0)] {
            assert_eq!((letters_apart(a, b), letters_apart(b, a)), (n, n), "{a} {b}");
        }
    }
}
