//! What of cell and robot nobody has measured or checked, as far as the files tell.

use super::PlanFinding;
use crate::cell::{Mount, Setup};
use crate::document::Job;

/// Frames of the shipped cell that the plan is made for, where the job has none of its own; and figures that the robot's
/// file calls unchecked.
pub(super) fn unverified(job: &Job, setup: &Setup) -> Vec<PlanFinding> {
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
    let words =
        robot.map(|robot| PlanFinding::UnverifiedWord { robot: robot.name.clone(), words: robot.unverified.clone() });
    frames.into_iter().chain(words).collect()
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
        assert!(all.len() == 1 && all[0].ends_with(r#""frames":["base_from_laser","flange_from_part"]}"#), "{all:?}");
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
    fn what_was_found_in_the_file_is_told_as_it_is() {
        let finding = PartFinding::OpenEdges { count: 3 };
        assert_eq!(PlanFinding::InFile(finding.clone()).in_file(), Some(&finding));
    }
}
