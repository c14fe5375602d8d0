//! What of cell, robot and dialect nobody has measured or checked, as far as files and public sources tell.

use super::{PlanFinding, UnverifiedOf};
use crate::cell::{Mount, Setup};
use crate::document::Job;
use crate::program::dialects;

/// Frames of the shipped cell that the plan is made for, where the job has none of its own; figures that the robot's
/// file calls unchecked; and what no public source confirms of the words that the program is written in.
pub fn unverified(job: &Job, setup: &Setup) -> Vec<PlanFinding> {
    let own = &job.cell;
    let used = match setup.mount {
        Mount::PartInHand => {
            [("base_from_laser", own.base_from_laser.is_some()), ("flange_from_part", own.flange_from_part.is_some())]
        }
        Mount::ToolInHand => [("base_from_part", own.base_from_part.is_some()), ("flange_from_tool", false)],
    };
    let is_shipped = own.file.is_empty();
    let frames: Vec<&str> = used.into_iter().filter(|(_, own)| is_shipped && !own).map(|(frame, _)| frame).collect();
    let frames = (!frames.is_empty()).then(|| PlanFinding::UnverifiedFrame { cell: setup.cell.name.clone(), frames });
    let robot = setup.robot.as_ref().filter(|robot| !robot.unverified.is_empty());
    let of_robot = robot.map(|robot| PlanFinding::UnverifiedWord {
        of: UnverifiedOf::Robot(robot.name.clone()),
        words: robot.unverified.clone(),
    });
    let of_dialect = dialects::by_name(&job.cell.dialect).and_then(|dialect| {
        let words: Vec<String> = dialect.unverified(setup).into_iter().map(String::from).collect();
        let of = UnverifiedOf::Dialect(dialect.name());
        (!words.is_empty()).then_some(PlanFinding::UnverifiedWord { of, words })
    });
    frames.into_iter().chain(of_robot).chain(of_dialect).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{Cell, Robot};
    use crate::part::PartFinding;

    /// The findings of a job in the shipped cell of a robot, as JSON.
    fn told(job: &Job, mount: Mount, robot: Option<&str>) -> Vec<String> {
        let mut setup = Setup::shipped().expect("shipped");
        setup.mount = mount;
        if let Some(key) = robot {
            setup.robot = Some(Robot::load(key, None).expect("shipped"));
            setup.cell = Cell::shipped(key).expect("shipped");
        }
        let json = |f: &PlanFinding| serde_json::to_string(f).expect("JSON");
        let found = unverified(job, &setup);
        assert!(found.iter().all(|f| !f.leaves_undone() && f.in_file().is_none()));
        found.iter().map(json).collect()
    }

    #[test]
    fn frames_are_examples_until_the_job_or_its_cell_has_others() {
        let mut job = Job::default();
        let of = |told: &[String]| told.iter().filter(|t| t.contains("unverified_frame")).count();
        let all = told(&job, Mount::PartInHand, None);
        assert!(all.len() == 2 && all[0].ends_with(r#""frames":["base_from_laser","flange_from_part"]}"#), "{all:?}");
        let tool = told(&job, Mount::ToolInHand, Some("ur5e"));
        assert!(tool[0].ends_with(r#""frames":["base_from_part","flange_from_tool"]}"#), "{tool:?}");
        assert!(tool[1].starts_with(r#"{"code":"unverified_word","robot":"Universal Robots UR5e","words":["links""#));
        let own = Some(Setup::shipped().expect("shipped").cell.base_from_laser);
        job.cell.base_from_laser.clone_from(&own);
        assert!(told(&job, Mount::PartInHand, None)[0].ends_with(r#""frames":["flange_from_part"]}"#));
        job.cell.flange_from_part = own;
        assert_eq!(of(&told(&job, Mount::PartInHand, None)), 0);
        job = Job::default();
        job.cell.file = "cell.toml".into();
        assert_eq!(of(&told(&job, Mount::PartInHand, Some("ur5e"))), 0, "the user's own");
    }

    #[test]
    fn words_of_each_dialect_are_told_but_for_the_table() {
        let mut job = Job::default();
        for dialect in dialects::DIALECTS {
            job.cell.dialect = dialect.name().into();
            let told = told(&job, Mount::PartInHand, Some("mz04"));
            let own = format!(r#"{{"code":"unverified_word","dialect":"{}","words":["#, dialect.name());
            let count = told.iter().filter(|t| t.starts_with(&own)).count();
            assert_eq!(count, usize::from(dialect.name() != "csv"), "{told:?}");
        }
    }

    /// A key that is told is one of the cell file.
    #[test]
    fn keys_among_the_words_stand_in_the_cell_file() {
        let setup = Setup::shipped().expect("shipped");
        let cell = toml::Value::try_from(&setup.cell).expect("TOML");
        for dialect in dialects::DIALECTS {
            for word in dialect.unverified(&setup) {
                let key = word.strip_prefix(dialect.name()).and_then(|rest| rest.strip_prefix('.'));
                let stands = |key: &str| cell.get(dialect.name()).is_some_and(|table| table.get(key).is_some());
                assert!(key.is_none_or(stands), "{word}");
            }
        }
    }

    #[test]
    fn what_was_found_in_the_file_is_told_as_it_is() {
        let finding = PartFinding::OpenEdges { count: 3 };
        assert_eq!(PlanFinding::InFile(finding.clone()).in_file(), Some(&finding));
    }
}
