//! All dialects, by name and by their text.

use super::abb::Rapid;
use super::csv::Csv;
use super::dialect::{Dialect, Program};
use super::estun::Erp;
use super::fanuc::Fanuc;
use super::kuka::Krl;
use super::lines::lines;
use super::nachi::Nachi;
use super::steps::{Step, Steps};
use super::ur::Ur;
use super::yaskawa::Jbi;
use crate::beam::Work;
use crate::cell::Setup;

/// Every dialect that is written and read, the default first.
pub const DIALECTS: &[&dyn Dialect] = &[&Nachi, &Krl, &Rapid, &Fanuc, &Ur, &Jbi, &Erp, &Csv];

/// The dialect of that name.
pub fn by_name(name: &str) -> Option<&'static dyn Dialect> {
    DIALECTS.iter().copied().find(|d| d.name() == name)
}

/// The dialect of a program's text; `None` where no one, or more than one, knows it.
pub fn of_text(text: &str) -> Option<&'static dyn Dialect> {
    let mut claims = DIALECTS.iter().copied().filter(|d| d.claims(text));
    claims.next().filter(|_| claims.next().is_none())
}

/// Their names, for messages.
pub fn names() -> String {
    DIALECTS.iter().map(|d| d.name()).collect::<Vec<_>>().join(", ")
}

/// The dialect of that name.
///
/// # Errors
/// The names there are.
pub fn known(name: &str) -> Result<&'static dyn Dialect, String> {
    by_name(name).ok_or_else(|| format!("dialect = {name:?}: give one of {}", names()))
}

/// Whether a dialect can write what the cell says, outputs and templates, before anything is planned.
///
/// # Errors
/// What the controller could not take.
pub fn check(name: &str, setup: &Setup) -> Result<(), String> {
    let pulsed = Work { frequency_khz: 1.0, ..Work::default() };
    let home = Steps { list: vec![Step::Work(pulsed), Step::Home, Step::Home], ..Steps::default() };
    let lines = lines(&home, setup);
    known(name)?.write(&Program { head: Vec::new(), lines, setup }).map(drop).map_err(|e| e.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::outputs::LevelForm;

    #[test]
    fn bad_names_and_templates_are_told_before_planning() {
        let mut setup = Setup::shipped().expect("shipped");
        let said = check("yaskawa", &setup).expect_err("home is known by its joints only");
        assert!(said.contains("robot"), "{said}");
        setup.robot = Some(crate::cell::Robot::load("mz04", None).expect("shipped"));
        for dialect in DIALECTS {
            assert_eq!(check(dialect.name(), &setup), Ok(()));
        }
        let said = check("karel", &setup).expect_err("none");
        assert!(said.contains("karel") && said.contains("nachi") && said.contains("csv"), "{said}");
        setup.cell.outputs.power.form = LevelForm::Analogue;
        let said = check("nachi", &setup).expect_err("no source for it");
        assert!(said.contains("nachi.analogue"), "{said}");
        setup.cell.nachi.analogue = "AOUT {n},{v}".into();
        assert_eq!(check("nachi", &setup), Ok(()));
    }
}
