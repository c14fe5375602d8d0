//! A line that was read and a line of the plan: whether they are the same one, and by how much they differ.
//!
//! What kind of target a move has counts as much as where it is. Joint angles in place of a pose, or a move by
//! joints in place of a straight one, may bring the arm to the same place on another branch, and without a robot
//! nobody knows where they lead; so kind and way are compared before any place is.

use super::expected::Poses;
use super::verdict::{Difference, JointOff, SpotOff};
use crate::part::angle;
use crate::program::MoveTiming;
use crate::program::dialect::{Goal, ReadLine, ReadMove, Statement};
use crate::program::dialects::spelling::is_same_code;
use nalgebra::Isometry3;
use std::mem::discriminant;

/// The spot may stand so far from where it was planned, mm.
pub const MOST_OFF_MM: f64 = 0.01;
/// The beam with its spin, and every joint, may be turned by so much, degrees.
pub const MOST_TURNED_DEG: f64 = 0.01;
/// Share by which the time that the dialect's words give may differ from the plan's: speeds are written with few digits.
const MOST_SLOWER: f64 = 0.02;
/// Share by which a time or speed may differ from the same plan as it is written: what it changes of a dose is below
/// what any gauge shows, and digits that a controller rounds change less.
const MOST_OTHERWISE: f64 = 0.005;

/// Whether a line is the one of the plan, small changes of pose and time not looked at.
pub(super) fn is_same(poses: &Poses<'_>, want: &ReadLine, have: &ReadLine) -> bool {
    match (&want.what, &have.what) {
        (Statement::Move(w), Statement::Move(h)) => {
            is_same_kind(w, h)
                && off_joint(&w.goal, &h.goal, MOST_TURNED_DEG).is_none()
                && off(poses, &w.goal, &h.goal).is_none_or(SpotOff::is_near)
        }
        (Statement::Other(w), Statement::Other(h)) => is_same_code(w, h),
        (w, h) => w == h,
    }
}

/// Whether two moves go the same way to the same kind of target.
pub(super) fn is_same_kind(a: &ReadMove, b: &ReadMove) -> bool {
    a.interpolation == b.interpolation && discriminant(&a.goal) == discriminant(&b.goal)
}

/// The first joint that stands otherwise by more than `most_deg`, from 0; none for poses.
pub(super) fn off_joint(a: &Goal, b: &Goal, most_deg: f64) -> Option<usize> {
    let (Goal::Joints(a), Goal::Joints(b)) = (a, b) else { return None };
    // What is no number is not within.
    let is_within = |j: &usize| (a[*j] - b[*j]).abs() <= most_deg;
    (0..6).find(|j| !is_within(j))
}

/// How far the spot is off; `None` for joints without a robot.
pub(super) fn off(poses: &Poses<'_>, a: &Goal, b: &Goal) -> Option<SpotOff> {
    let (a, b) = (poses.focus(a)?, poses.focus(b)?);
    Some(SpotOff { mm: (poses.spot(&a) - poses.spot(&b)).norm(), deg: turn_deg(&a, &b) })
}

impl SpotOff {
    /// Whether that is no more than rounding.
    pub(super) fn is_near(self) -> bool {
        self.mm <= MOST_OFF_MM && self.deg <= MOST_TURNED_DEG
    }
}

/// Angle between two poses, degrees.
pub(super) fn turn_deg(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    angle::turned_deg(&a.rotation.rotation_to(&b.rotation).to_rotation_matrix())
}

/// Where two moves to the same kind of target differ in place; `None` where they do not.
pub(super) fn position_difference(poses: &Poses<'_>, want: &Goal, have: &Goal) -> Option<Difference> {
    let spot = off(poses, want, have).filter(|o| !o.is_near());
    let joint = match (off_joint(want, have, MOST_TURNED_DEG), want, have) {
        (Some(j), Goal::Joints(w), Goal::Joints(h)) => Some(JointOff::new(j, w, h)),
        _ => None,
    };
    let goals = Some([*have, *want]);
    (spot.is_some() || joint.is_some()).then_some(Difference::Elsewhere { spot, joint, goals })
}

/// Whether a pace is that of the same move as the plan writes it.
pub(super) fn is_pace_as_written(written: &MoveTiming, read: &MoveTiming) -> bool {
    match (written, read) {
        (MoveTiming::Seconds(w), MoveTiming::Seconds(r)) | (MoveTiming::Percent(w), MoveTiming::Percent(r)) => {
            (w - r).abs() <= MOST_OTHERWISE * w.abs()
        }
        _ => false,
    }
}

/// Whether the pace that a dialect's words give is the plan's but for their digits.
pub(super) fn is_same_pace(a: &MoveTiming, b: &MoveTiming) -> bool {
    match (a, b) {
        // A millisecond is what controllers count in.
        (MoveTiming::Seconds(a), MoveTiming::Seconds(b)) => (a - b).abs() <= 0.002 + MOST_SLOWER * a.abs(),
        // A share of full speed turned into radians and back.
        (MoveTiming::Percent(a), MoveTiming::Percent(b)) => (a - b).abs() <= 1e-3 * a.abs(),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{Robot, Setup};
    use crate::program::Interpolation;

    fn line(interpolation: Interpolation, goal: Goal) -> ReadLine {
        let what =
            Statement::Move(ReadMove { interpolation, goal, timing: MoveTiming::Percent(10.0), rest: String::new() });
        ReadLine { file: "a".into(), line: 1, what }
    }

    #[test]
    fn another_kind_at_the_same_place_is_another_line() {
        let bare = Setup::shipped().expect("shipped");
        let robot = Robot::load("mz04", None).expect("shipped");
        let joints = [10.0, 80.0, 5.0, 20.0, 30.0, -40.0];
        let flange = robot.forward(&joints);
        let with = Setup { robot: Some(robot), ..bare.clone() };
        let focus = with.focus_for(&flange);
        let goals = [Goal::Joints(joints), Goal::Flange(flange), Goal::Focus(focus)];
        for setup in [&bare, &with] {
            let poses = Poses { setup, defocus_mm: 20.0 };
            for (i, a) in goals.iter().enumerate() {
                for (k, b) in goals.iter().enumerate() {
                    let same = is_same(&poses, &line(Interpolation::Linear, *a), &line(Interpolation::Linear, *b));
                    assert_eq!(same, i == k, "{a:?} {b:?}");
                    assert!(!is_same(&poses, &line(Interpolation::Linear, *a), &line(Interpolation::Joint, *b)));
                }
            }
        }
    }

    #[test]
    fn joints_that_leave_the_flange_alone_are_others() {
        let robot = Robot::load("mz04", None).expect("shipped");
        let setup = Setup { robot: Some(robot), ..Setup::shipped().expect("shipped") };
        let poses = Poses { setup: &setup, defocus_mm: 20.0 };
        // With the wrist stretched axes 4 and 6 are one, and a whole turn of axis 6 is none.
        let home = setup.home_joints_deg();
        let mut turned = home;
        turned[5] += 360.0;
        let (was, is) = (Goal::Joints(home), Goal::Joints(turned));
        assert!(off(&poses, &was, &is).is_some_and(SpotOff::is_near));
        assert!(!is_same(&poses, &line(Interpolation::Joint, was), &line(Interpolation::Joint, is)));
        let turned = JointOff { joint: 5, planned_deg: home[5], found_deg: turned[5] };
        let found = Difference::Elsewhere { spot: None, joint: Some(turned), goals: Some([is, was]) };
        assert_eq!(position_difference(&poses, &was, &is), Some(found));
        assert_eq!(position_difference(&poses, &was, &was), None);
    }
}
