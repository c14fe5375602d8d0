//! The numbers that an operator sets, each defined once, in [`PARAMETERS`]. From its row follow the field of the
//! panel, the option of the command line, what values are refused, what recipes may hold, and the reference's table.
//!
//! A row knows no job: [`Job`](super::Job) finds the number of a row by its key (`model/by_key`), and the structs of
//! the model take their defaults from here (`model/declare`). Words stand in `assets/text`, under the key.

mod kind;
mod place;
mod table;

pub use kind::NumberKind;
pub use place::{Affects, Group, Scope};
pub use table::PARAMETERS;

use thiserror::Error;

/// One number that an operator sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Key in the job file, `table.field`.
    pub key: &'static str,
    /// What it measures or counts.
    pub kind: NumberKind,
    /// What it can be.
    pub limits: Limits,
    /// What it is in a new job.
    pub default: f64,
    /// Section of the panel.
    pub group: Group,
    /// Whether recipes may hold it.
    pub scope: Scope,
    /// What another value makes stale.
    pub affects: Affects,
    /// Its option without the dashes; `None` for what only jobs and the window set.
    pub option: Option<&'static str>,
    /// Symbol in the papers; empty where it has none.
    pub symbol: &'static str,
}

/// From where to where a number may lie, in the unit of its kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub greatest: f64,
    /// Whether the least value itself is refused.
    pub is_above_least: bool,
}

impl Limits {
    /// Whether a value lies within.
    pub fn contain(&self, value: f64) -> bool {
        let is_high_enough = if self.is_above_least { value > self.least } else { value >= self.least };
        is_high_enough && value <= self.greatest
    }
}

/// Why a number is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberFault {
    /// It lies outside the limits.
    OutOfRange,
    /// It counts something, and is not whole.
    NotWhole,
}

/// A number that a parameter cannot be.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{} = {value}: {fault:?}", parameter.key)]
pub struct ParameterError {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The number.
    pub value: f64,
    /// What is wrong with it.
    pub fault: NumberFault,
}

impl Parameter {
    /// The parameter of a key that is known to be one. It is for constants, where another key does not compile.
    pub const fn named(key: &str) -> &'static Parameter {
        let mut row = 0;
        while row < PARAMETERS.len() {
            if is_same(PARAMETERS[row].key.as_bytes(), key.as_bytes()) {
                return &PARAMETERS[row];
            }
            row += 1;
        }
        panic!("no row of the table of parameters has this key")
    }

    /// The parameter of that option.
    pub fn by_option(option: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.option == Some(option))
    }

    /// The parameter of that key in the job file.
    pub fn by_key(key: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.key == key)
    }

    /// The parameters of a section, in the order of the panel.
    pub fn of_group(group: Group) -> impl Iterator<Item = &'static Parameter> {
        PARAMETERS.iter().filter(move |p| p.group == group)
    }

    /// Table and field of the key.
    pub fn table_and_field(&self) -> (&'static str, &'static str) {
        self.key.rsplit_once('.').unwrap_or(("", self.key))
    }

    /// Whether recipes may hold it.
    pub fn is_for_recipes(&self) -> bool {
        self.scope != Scope::Program
    }

    /// Whether another value cuts the surfaces of the part anew, so that their numbers mean other ones.
    pub fn recuts(&self) -> bool {
        self.affects == Affects::Surfaces
    }

    /// Whether it can be a number.
    ///
    /// # Errors
    /// It lies outside the limits, or is a count and not whole.
    pub fn check(&'static self, value: f64) -> Result<(), ParameterError> {
        let fault = if !self.limits.contain(value) {
            NumberFault::OutOfRange
        } else if self.kind.is_whole() && value.fract() != 0.0 {
            NumberFault::NotWhole
        } else {
            return Ok(());
        };
        Err(ParameterError { parameter: self, value, fault })
    }
}

const fn is_same(one: &[u8], other: &[u8]) -> bool {
    if one.len() != other.len() {
        return false;
    }
    let mut at = 0;
    while at < one.len() {
        if one[at] != other[at] {
            return false;
        }
        at += 1;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Job;
    use std::collections::BTreeSet;

    #[test]
    fn the_table_is_sound() {
        for p in PARAMETERS {
            assert_eq!(p.check(p.default), Ok(()), "{}", p.key);
            assert!(p.check(f64::NAN).is_err() && p.check(p.limits.greatest * 2.0 + 1.0).is_err(), "{}", p.key);
            assert_eq!(p.check(p.limits.least).is_err(), p.limits.is_above_least, "{}", p.key);
            assert_eq!(Parameter::named(p.key), p, "{} stands once", p.key);
        }
        let options: Vec<&str> = PARAMETERS.iter().filter_map(|p| p.option).collect();
        assert_eq!(options.iter().collect::<BTreeSet<_>>().len(), options.len());
    }

    #[test]
    fn every_row_is_a_number_of_the_job_at_its_place_in_the_file() {
        for p in PARAMETERS {
            let mut job = Job::default();
            assert_eq!(job.number(p), p.default, "{}", p.key);
            job.set_number(p, p.limits.greatest);
            assert_eq!(job.number(p), p.limits.greatest, "{} reads what was written", p.key);
            let file: toml::Table = toml::to_string(&job).expect("writes").parse().expect("reads");
            let found = p.key.split('.').try_fold(toml::Value::Table(file), |v, k| v.get(k).cloned());
            let wanted = match p.kind.is_whole() {
                true => toml::Value::Integer(p.limits.greatest as i64),
                false => toml::Value::Float(p.limits.greatest),
            };
            assert_eq!(found, Some(wanted), "{} is its place in the file", p.key);
        }
    }

    /// Keys of all numbers in a table.
    fn numbers(table: &toml::Table, before: &str, out: &mut BTreeSet<String>) {
        for (key, value) in table {
            match value {
                toml::Value::Table(inner) => numbers(inner, &format!("{before}{key}."), out),
                toml::Value::Float(_) | toml::Value::Integer(_) => drop(out.insert(format!("{before}{key}"))),
                _ => {}
            }
        }
    }

    #[test]
    fn every_number_of_the_job_has_a_row() {
        let file: toml::Table = toml::to_string(&Job::default()).expect("writes").parse().expect("reads");
        let mut found = BTreeSet::new();
        numbers(&file, "", &mut found);
        found.remove("version");
        assert_eq!(found, PARAMETERS.iter().map(|p| p.key.to_owned()).collect());
    }

    #[test]
    fn counts_are_read_as_whole_numbers_alone() {
        for p in PARAMETERS.iter().filter(|p| p.kind.is_whole()) {
            let (table, field) = p.table_and_field();
            let read = |value: &str| toml::from_str::<Job>(&format!("[{table}]\n{field} = {value}"));
            assert_eq!(read("3").expect("reads").number(p), 3.0, "{}", p.key);
            assert_eq!(read("3.0").expect("as older jobs have it"), read("3").expect("reads"), "{}", p.key);
            for wrong in ["1.5", "-1", "-1.0", "nan", "inf", "1e300", "\"3\""] {
                let why = read(wrong).expect_err(wrong).to_string();
                assert!(why.contains("whole number"), "{}: {why}", p.key);
            }
        }
    }

    #[test]
    fn what_is_refused_is_told_as_data() {
        let spacing = Parameter::by_option("spacing").expect("there");
        let refused = |value| spacing.check(value).map_err(|e| (e.parameter.key, e.value, e.fault));
        assert_eq!(refused(0.0), Err(("layers.spacing_mm", 0.0, NumberFault::OutOfRange)));
        assert!(refused(-1.0).is_err());
        let passes = Parameter::named("layers.passes");
        assert_eq!(passes.check(1.5).map_err(|e| e.fault), Err(NumberFault::NotWhole));
        assert_eq!(passes.check(0.5).map_err(|e| e.fault), Err(NumberFault::OutOfRange));
    }
}
