//! Versions of the job file. A file tells its `version` first; one that does not is of version 1, and means what it
//! meant when that was the only one.

use super::error::JobFileError;

/// The version that is written.
pub const WRITTEN: i64 = 2;

/// What a job file takes for granted where it names no key and new jobs begin with something else: as TOML, by the
/// keys of the job file. It is so in every version: a file that leaves a key out means what it always meant, and what
/// was welded by equal coordinates alone stays so, with the numbers of its surfaces.
const WHERE_NOT_NAMED: &str = "[part]\nweld = \"exact\"\n[layers]\ndirection = \"z\"\n";

/// The version of a job file, from 1 to [`WRITTEN`].
pub(super) fn of(table: &toml::Table) -> Result<i64, JobFileError> {
    match table.get("version") {
        None => Ok(1),
        Some(toml::Value::Integer(n @ 1..=WRITTEN)) => Ok(*n),
        Some(toml::Value::Integer(n)) if *n > WRITTEN => Err(JobFileError::Later(*n)),
        Some(other) => Err(JobFileError::NoVersion(other.to_string())),
    }
}

/// Puts in what job files take for granted where they name no key.
///
/// # Errors
/// Never, for what stands here.
pub(super) fn fill_defaults(table: &mut toml::Table) -> Result<(), toml::de::Error> {
    fill_gaps(table, toml::from_str(WHERE_NOT_NAMED)?);
    Ok(())
}

/// Puts values where a table names none.
fn fill_gaps(table: &mut toml::Table, defaults: toml::Table) {
    for (key, value) in defaults {
        match (table.get_mut(&key), value) {
            (None, value) => drop(table.insert(key, value)),
            (Some(toml::Value::Table(known)), toml::Value::Table(more)) => fill_gaps(known, more),
            (Some(_), _) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::parse;
    use super::super::tests::refusal;
    use super::*;
    use crate::document::Job;
    use crate::part::SurfaceId;

    #[test]
    fn versions_are_told_apart() {
        for known in ["", "version = 1\n", "version = 2\n"] {
            assert_eq!(parse(&format!("{known}[clean]\nsurfaces = [3]")).expect("reads").settings.choice(), [3].into());
        }
        // What a later version has beside that is not looked at.
        assert!(matches!(refusal("version = 3\nnovelty = 1"), JobFileError::Later(3)));
        for none in ["0", "-1", "\"2\"", "2.0"] {
            let why = refusal(&format!("version = {none}"));
            assert!(matches!(&why, JobFileError::NoVersion(text) if text == none), "{why:?}");
        }
        let text = toml::to_string(&Job::default()).expect("writes");
        assert!(text.starts_with("version = 2\n"), "{text}");
        let two = "[[tilts]]\nsurface = 1\nleast_deg = 5\n[[tilts]]\nsurface = 1\nleast_deg = 9";
        let job = parse(two).expect("version 1 takes the first");
        assert_eq!(job.settings.of(SurfaceId(1)).tilt.least_deg, 5.0);
        let why = refusal(&format!("version = 2\n{two}"));
        assert!(matches!(why, JobFileError::Twice { key: "tilts", surface: SurfaceId(1) }), "{why:?}");
    }

    #[test]
    fn what_is_silent_is_welded_as_it_was() {
        use crate::part::Weld;
        for silent in ["", "version = 1", "version = 2", "version = 2\n[part]\nunits = \"m\""] {
            assert_eq!(parse(silent).expect("reads").part.weld, Weld::Exact, "{silent}");
        }
        assert_eq!(parse("version = 2\n[part]\nweld = \"auto\"").expect("reads").part.weld, Weld::Auto);
        assert!(toml::to_string(&Job::default()).expect("writes").contains("weld = \"auto\"\n"));
        let why = refusal("version = 2\n[part]\nweld = \"close\"").to_string();
        assert!(why.contains("auto") && why.contains("exact"), "{why}");
    }

    #[test]
    fn a_file_without_a_direction_has_z_and_a_new_job_has_auto() {
        use crate::path::Direction;
        let z = Direction::Along([0.0, 0.0, 1.0]);
        for known in ["", "version = 1\n", "version = 2\n", "version = 2\n[layers]\nspacing_mm = 2.0\n"] {
            assert_eq!(parse(known).expect("reads").layers.direction, z, "{known}");
        }
        assert_eq!(parse("[layers]\ndirection = \"auto\"").expect("reads").layers.direction, Direction::Auto);
        assert_eq!(Job::default().layers.direction, Direction::Auto);
        let text = toml::to_string(&Job::default()).expect("writes");
        assert_eq!(parse(&text).expect("reads"), Job::default(), "a job that is saved names every key");
    }

    #[test]
    fn defaults_fill_gaps_alone() {
        let mut table: toml::Table = toml::from_str("[path]\nmax_turn_deg = 3.0").expect("reads");
        let defaults = "[path]\nmax_turn_deg = 8.0\ncorrection = \"none\"\n[bead]\nlayers = 2.0";
        fill_gaps(&mut table, toml::from_str(defaults).expect("reads"));
        let whole = "[path]\nmax_turn_deg = 3.0\ncorrection = \"none\"\n[bead]\nlayers = 2.0";
        assert_eq!(table, toml::from_str(whole).expect("reads"));
    }
}
