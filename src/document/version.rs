//! Versions of the job file. A file tells its `version` first; one that does not is of version 1, and means what it
//! meant when that was the only one.

use super::job_file::JobFileError;

/// The version that is written.
pub(super) const WRITTEN: i64 = 2;

/// What a job of version 1 takes for granted where it names no key and version 2 takes something else: as TOML,
/// by the keys of the job file.
const GRANTED_BY_1: &str = "";

/// The version of a job file, from 1 to [`WRITTEN`].
pub(super) fn of(table: &toml::Table) -> Result<i64, JobFileError> {
    match table.get("version") {
        None => Ok(1),
        Some(toml::Value::Integer(n @ 1..=WRITTEN)) => Ok(*n),
        Some(toml::Value::Integer(n)) if *n > WRITTEN => Err(JobFileError::Later(*n)),
        Some(other) => Err(JobFileError::NoVersion(other.to_string())),
    }
}

/// Puts in what a version takes for granted where the file names no key.
///
/// # Errors
/// Never, for what stands here.
pub(super) fn grant(version: i64, table: &mut toml::Table) -> Result<(), toml::de::Error> {
    if version == 1 {
        fill(table, toml::from_str(GRANTED_BY_1)?);
    }
    Ok(())
}

/// Puts values where a table names none.
fn fill(table: &mut toml::Table, granted: toml::Table) {
    for (key, value) in granted {
        match (table.get_mut(&key), value) {
            (None, value) => drop(table.insert(key, value)),
            (Some(toml::Value::Table(known)), toml::Value::Table(more)) => fill(known, more),
            (Some(_), _) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::job_file::parse;
    use super::*;
    use crate::document::Job;
    use crate::part::SurfaceId;

    fn refused(text: &str, said: &[&str]) {
        let why = parse(text).expect_err(text).to_string();
        assert!(said.iter().all(|part| why.contains(part)), "{text}: {why}");
        assert!(toml::from_str::<Job>(text).is_err(), "{text}");
    }

    #[test]
    fn versions_are_told_apart() {
        for known in ["", "version = 1\n", "version = 2\n"] {
            assert_eq!(parse(&format!("{known}[clean]\nsurfaces = [3]")).expect("reads").settings.choice(), [3].into());
        }
        // What a later version has beside that is not looked at.
        refused("version = 3\nnovelty = 1", &["version = 3", "later clearbeam", "open it with a newer"]);
        for none in ["0", "-1", "\"2\"", "2.0"] {
            refused(&format!("version = {none}"), &[&format!("version = {none}"), "give 2"]);
        }
        let text = toml::to_string(&Job::default()).expect("writes");
        assert!(text.starts_with("version = 2\n"), "{text}");
        let two = "[[tilts]]\nsurface = 1\nleast_deg = 5\n[[tilts]]\nsurface = 1\nleast_deg = 9";
        let job = parse(two).expect("version 1 takes the first");
        assert_eq!(job.settings.of(SurfaceId(1)).tilt.least_deg, 5.0);
        refused(&format!("version = 2\n{two}"), &["tilts: surface 1 stands twice"]);
    }

    #[test]
    fn what_is_granted_fills_gaps_alone() {
        let mut table: toml::Table = toml::from_str("[path]\nmax_turn_deg = 3.0").expect("reads");
        let granted = "[path]\nmax_turn_deg = 8.0\ncorrection = \"none\"\n[bead]\nlayers = 2.0";
        fill(&mut table, toml::from_str(granted).expect("reads"));
        let whole = "[path]\nmax_turn_deg = 3.0\ncorrection = \"none\"\n[bead]\nlayers = 2.0";
        assert_eq!(table, toml::from_str(whole).expect("reads"));
    }
}
