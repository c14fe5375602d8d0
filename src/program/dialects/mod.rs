//! All dialects, by name and by their text.
//!
//! A dialect is a folder with a writer and a reader, and one line in [`DIALECTS`]; its names, numbers and templates
//! are a table of the cell file. Beside the folders stands what several of them share.

pub mod abb;
mod arm_shape;
pub mod csv;
pub mod estun;
pub mod fanuc;
mod flange;
pub mod kuka;
pub mod nachi;
mod pace;
mod reading;
mod signals;
pub mod spelling;
mod subprograms;
mod templates;
pub mod ur;
pub mod yaskawa;

use super::dialect::{Dialect, Program};
use super::neutral::comment::WITHOUT_WORDS;
use super::neutral::lines::lines;
use super::neutral::steps::{Step, Steps};
use super::write_error::{DialectError, UnknownDialect};
use crate::beam::ProcessSettings;
use crate::cell::Setup;

/// Every dialect that is written and read, the default first.
pub const DIALECTS: &[&dyn Dialect] = &[
    &nachi::NachiDialect,
    &kuka::KukaDialect,
    &abb::AbbDialect,
    &fanuc::FanucDialect,
    &ur::UrDialect,
    &yaskawa::YaskawaDialect,
    &estun::EstunDialect,
    &csv::CsvDialect,
];

/// The dialect of that name.
pub fn by_name(name: &str) -> Option<&'static dyn Dialect> {
    DIALECTS.iter().copied().find(|d| d.name() == name)
}

/// The dialect of a program's text; `None` where no one, or more than one, knows it.
pub fn of_text(text: &str) -> Option<&'static dyn Dialect> {
    let mut claims = DIALECTS.iter().copied().filter(|d| d.claims(text));
    claims.next().filter(|_| claims.next().is_none())
}

/// The names of all dialects, the default first.
pub fn names() -> impl Iterator<Item = &'static str> {
    DIALECTS.iter().map(|d| d.name())
}

/// The dialect of that name.
///
/// # Errors
/// There is none.
pub fn known(name: &str) -> Result<&'static dyn Dialect, UnknownDialect> {
    by_name(name).ok_or_else(|| UnknownDialect(name.into()))
}

/// Whether a dialect can write what the cell says, outputs and templates, before anything is planned.
///
/// # Errors
/// What the controller could not take.
pub fn check(name: &str, setup: &Setup) -> Result<(), DialectError> {
    let pulsed = ProcessSettings { frequency_khz: 1.0, ..ProcessSettings::default() };
    let home = Step::Home { percent: setup.cell.air.home_percent };
    let steps = Steps { list: vec![Step::Process(pulsed), home.clone(), home], ..Steps::default() };
    let lines = lines(&steps, setup);
    known(name)?.write(&Program { head: Vec::new(), lines, setup, wording: WITHOUT_WORDS })?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::outputs::ValueForm;
    use crate::program::{SignalKind, WriteError};

    #[test]
    fn bad_names_and_templates_are_told_before_planning() {
        let mut setup = Setup::shipped().expect("shipped");
        assert_eq!(
            check("yaskawa", &setup),
            Err(WriteError::HomeNeedsPulses.into()),
            "home is known by its joints only"
        );
        setup.robot = Some(crate::cell::Robot::load("mz04", None).expect("shipped"));
        for dialect in DIALECTS {
            assert_eq!(check(dialect.name(), &setup), Ok(()));
        }
        assert_eq!(check("karel", &setup), Err(UnknownDialect("karel".into()).into()));
        assert_eq!((names().next(), names().last()), (Some("nachi"), Some("csv")));
        setup.cell.outputs.power.form = ValueForm::Analogue;
        let missing = WriteError::NoTemplate { dialect: "nachi", kind: SignalKind::Analogue };
        assert_eq!(check("nachi", &setup), Err(missing.into()), "no source for it");
        setup.cell.nachi.analogue = "AOUT {n},{v}".into();
        assert_eq!(check("nachi", &setup), Ok(()));
    }
}
