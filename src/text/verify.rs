//! How a program differs from its plan, and why it cannot be compared.

use super::{Sentence, fixed, id, listed, listed_clauses, say};
use crate::document::files::InputKind;
use crate::part::rpy;
use crate::planning::verify::{Difference, Finding, InputChange, JointOff, SpotOff, VerifyError};
use crate::program::dialect::{Goal, Statement};
use crate::program::{Interpolation, MoveTiming, WriteError, dialects};
use nalgebra::Isometry3;

impl Sentence for VerifyError {
    fn sentence(&self) -> String {
        match self {
            VerifyError::NoDialect { file } => say!(verify_no_dialect, file, known = listed(dialects::names())),
            // Whoever verifies gives no options of planning: the job says what it was planned with.
            VerifyError::Unwritable(WriteError::NoRobot(dialect) | WriteError::FromUnknownPose(dialect)) => {
                say!(verify_plan_needs_robot, dialect = *dialect)
            }
            VerifyError::Unwritable(WriteError::HomeNeedsPulses) => say!(verify_plan_needs_pulses),
            VerifyError::Unwritable(e) => say!(verify_plan_unwritable, reason = e.sentence()),
            VerifyError::NoProgram => say!(verify_no_program),
            VerifyError::Cancelled => say!(text_cancelled),
            VerifyError::OwnUnreadable(e) => say!(verify_plan_unreadable, reason = e.sentence()),
        }
    }
}

impl Sentence for InputChange {
    fn sentence(&self) -> String {
        let (name, what) = (&self.name, input_word(self.kind));
        match (&self.was, &self.is) {
            (Some(was), Some(is)) => say!(verify_input_changed, name, what, was, is),
            (Some(was), None) => say!(verify_input_gone, name, what, was),
            (None, is) => say!(verify_input_new, name, what, is = is.as_deref().unwrap_or_default()),
        }
    }
}

fn input_word(kind: InputKind) -> String {
    match kind {
        InputKind::Part => say!(input_part),
        InputKind::Scan => say!(input_scan),
        InputKind::Image => say!(input_image),
        InputKind::Camera => say!(input_camera),
        InputKind::HandEye => say!(input_hand_eye),
        InputKind::Grinder => say!(input_grinder),
        InputKind::Cell => say!(input_cell),
        InputKind::Robot => say!(input_robot),
        InputKind::Head => say!(input_head),
        InputKind::Clamp => say!(input_clamp),
        InputKind::Obstacle => say!(input_obstacle),
    }
}

/// What is wrong, without where.
impl Sentence for Finding {
    fn sentence(&self) -> String {
        self.what.sentence()
    }
}

impl Sentence for Difference {
    fn sentence(&self) -> String {
        match self {
            Difference::Unreadable(e) => e.sentence(),
            Difference::Missing { planned } => say!(verify_missing, line = line(planned)),
            Difference::EndMissing { lines, first } => say!(verify_end_missing, lines = *lines, first = line(first)),
            Difference::Extra { found } => say!(verify_extra, line = line(found)),
            Difference::BehindEnd { found } => say!(verify_behind_end, line = line(found)),
            Difference::OtherLine { found, planned } => {
                say!(verify_other, found = line(found), planned = line(planned))
            }
            Difference::Elsewhere { spot, joint, goals } => elsewhere(*spot, *joint, goals.as_ref()),
            Difference::OtherWay { found, planned } => {
                say!(verify_other_meaning, found = way(*found), planned = way(*planned))
            }
            Difference::OtherPace { found, planned } => {
                say!(verify_other_meaning, found = pace(found), planned = pace(planned))
            }
            Difference::OtherTime { found, planned } => {
                say!(verify_other, found = pace(found), planned = pace(planned))
            }
            Difference::OtherWords { found, planned } => say!(verify_other_words, found, planned),
            Difference::OutOfReach { robot } => say!(verify_out_of_reach, robot),
            Difference::BeyondRange { joint, at_deg, range_deg: [low, high] } => {
                let (joint, low, high) = (id(joint + 1), fixed(*low, 0), fixed(*high, 0));
                say!(verify_beyond_range, joint, at = fixed(*at_deg, 2), low, high)
            }
            Difference::TooFast { joint, deg_s, most_deg_s } => {
                say!(verify_too_fast, joint = id(joint + 1), speed = fixed(*deg_s, 0), most = fixed(*most_deg_s, 0))
            }
            Difference::LitByJoints => say!(verify_lit_by_joints),
            Difference::LitToUnknown => say!(verify_lit_to_unknown),
            Difference::EndsLit => say!(verify_ends_lit),
            Difference::Touches(blocker) => say!(verify_touches, what = blocker.sentence()),
            Difference::HitsFacet { spot: p, facet } => {
                say!(verify_hits_facet, x = fixed(p.x, 2), y = fixed(p.y, 2), z = fixed(p.z, 2), facet = id(facet))
            }
        }
    }
}

fn elsewhere(spot: Option<SpotOff>, joint: Option<JointOff>, goals: Option<&[Goal; 2]>) -> String {
    // Joints are told one by one.
    let poses = goals.filter(|_| joint.is_none());
    let poses = poses.map(|[found, planned]| say!(verify_other, found = goal(found), planned = goal(planned)));
    let spot = spot.map(|s| say!(verify_spot_off, mm = fixed(s.mm, 3), deg = fixed(s.deg, 3)));
    let joint = joint.map(|j| {
        let (found, planned) = (fixed(j.found_deg, 3), fixed(j.planned_deg, 3));
        say!(verify_joint_off, joint = id(j.joint + 1), found, planned)
    });
    listed_clauses(spot.into_iter().chain(joint).chain(poses))
}

fn pace(pace: &MoveTiming) -> String {
    match pace {
        MoveTiming::Seconds(s) => say!(pace_seconds, seconds = fixed(*s, 3)),
        MoveTiming::Percent(p) => say!(pace_percent, percent = p.to_string()),
    }
}

fn way(way: Interpolation) -> String {
    match way {
        Interpolation::Joint => say!(way_by_joints),
        Interpolation::Linear => say!(way_straight),
    }
}

/// What a line of a program does, in a few words.
fn line(what: &Statement) -> String {
    match what {
        Statement::Move(m) => say!(line_move, way = way(m.interpolation), goal = goal(&m.goal)),
        Statement::Output { number, on: true } => say!(line_output_on, number = id(number)),
        Statement::Output { number, on: false } => say!(line_output_off, number = id(number)),
        Statement::OutputValue { number, value, group: true } => {
            say!(line_group, number = id(number), value = value.to_string())
        }
        Statement::OutputValue { number, value, group: false } => {
            say!(line_analogue, number = id(number), value = value.to_string())
        }
        Statement::Force(n) => say!(line_force, force = n.to_string()),
        Statement::Wait(s) => say!(line_wait, seconds = s.to_string()),
        Statement::Comment(text) | Statement::Other(text) => text.clone(),
    }
}

/// A target: mm, then turns about Z, Y and X in degrees. As many digits as a difference that counts has.
fn goal(goal: &Goal) -> String {
    let list = |numbers: &[f64]| listed(numbers.iter().map(|v| fixed(v + 0.0, 3)));
    let pose = |at: &Isometry3<f64>| {
        let turns = rpy::from_rotation(&at.rotation.to_rotation_matrix());
        format!("({}; {})", list(at.translation.vector.as_slice()), list(&turns))
    };
    match goal {
        Goal::Joints(joints) => say!(goal_joints, angles = list(joints)),
        Goal::Flange(at) => say!(goal_flange, pose = pose(at)),
        Goal::Focus(at) => say!(goal_focus, pose = pose(at)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_and_a_joint_that_are_off_stand_in_one_line() {
        let spot = Some(SpotOff { mm: 0.5, deg: 0.0 });
        let joint = Some(JointOff { joint: 5, planned_deg: 1.0, found_deg: 361.0 });
        assert_eq!(
            Difference::Elsewhere { spot, joint, goals: None }.sentence(),
            "the spot is 0.500 mm off and turned by 0.000\u{b0}; J6 stands at 361.000\u{b0}, the plan has 1.000\u{b0}"
        );
    }
}
