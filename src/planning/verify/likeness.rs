//! A line that was read and a line of the plan: whether they are the same one, and in what words they differ.
//!
//! What kind of target a move has counts as much as where it is. Joint angles in place of a pose, or a move by
//! joints in place of a straight one, may bring the arm to the same place on another branch, and without a robot
//! nobody knows where they lead; so kind and way are compared before any place is.

use super::{MOST_OFF_MM, MOST_TURNED_DEG, Poses};
use crate::part::{angle, rpy};
use crate::program::dialect::{Goal, Read, ReadLine, ReadMove};
use crate::program::{Pace, Way};
use nalgebra::Isometry3;
use std::mem::discriminant;

/// Share by which a time may differ: speeds are written with few digits.
const MOST_SLOWER: f64 = 0.02;

/// Whether a line is the one of the plan, small changes of pose and time not looked at.
pub(super) fn is_same(poses: &Poses<'_>, want: &ReadLine, have: &ReadLine) -> bool {
    match (&want.what, &have.what) {
        (Read::Move(w), Read::Move(h)) => {
            is_same_kind(w, h)
                && off_joint(&w.goal, &h.goal, MOST_TURNED_DEG).is_none()
                && off(poses, &w.goal, &h.goal).is_none_or(is_near)
        }
        (w, h) => w == h,
    }
}

/// Whether two moves go the same way to the same kind of target.
pub(super) fn is_same_kind(a: &ReadMove, b: &ReadMove) -> bool {
    a.way == b.way && discriminant(&a.goal) == discriminant(&b.goal)
}

/// The first joint that stands otherwise by more than `most_deg`, from 0; none for poses.
pub(super) fn off_joint(a: &Goal, b: &Goal, most_deg: f64) -> Option<usize> {
    let (Goal::Joints(a), Goal::Joints(b)) = (a, b) else { return None };
    // What is no number is not within.
    let is_within = |j: &usize| (a[*j] - b[*j]).abs() <= most_deg;
    (0..6).find(|j| !is_within(j))
}

/// How far the spot is off, mm, and turned, degrees; `None` for joints without a robot.
pub(super) fn off(poses: &Poses<'_>, a: &Goal, b: &Goal) -> Option<(f64, f64)> {
    let (a, b) = (poses.focus(a)?, poses.focus(b)?);
    Some(((poses.spot(&a) - poses.spot(&b)).norm(), turn_deg(&a, &b)))
}

/// Whether that is no more than rounding.
pub(super) fn is_near((mm, deg): (f64, f64)) -> bool {
    mm <= MOST_OFF_MM && deg <= MOST_TURNED_DEG
}

/// Angle between two poses, degrees.
pub(super) fn turn_deg(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    angle::turned_deg(&a.rotation.rotation_to(&b.rotation).to_rotation_matrix())
}

/// Where two moves to the same kind of target differ in place; `None` where they do not.
pub(super) fn elsewhere(poses: &Poses<'_>, want: &Goal, have: &Goal) -> Option<String> {
    let spot = off(poses, want, have).filter(|o| !is_near(*o)).map(deviation);
    let joint = match (off_joint(want, have, MOST_TURNED_DEG), want, have) {
        (Some(j), Goal::Joints(w), Goal::Joints(h)) => Some(turned_joint(j, w[j], h[j])),
        _ => None,
    };
    spot.into_iter().chain(joint).reduce(|a, b| format!("{a}; {b}"))
}

/// A spot that is off, in words.
pub(super) fn deviation((mm, deg): (f64, f64)) -> String {
    format!("the spot is {mm:.3} mm off and turned by {deg:.3}\u{b0}")
}

/// A joint that stands otherwise, in words; `joint` from 0.
pub(super) fn turned_joint(joint: usize, planned_deg: f64, found_deg: f64) -> String {
    format!("J{} stands at {found_deg:.3}\u{b0}, the plan has {planned_deg:.3}\u{b0}", joint + 1)
}

/// Whether two paces are the same but for written digits.
pub(super) fn is_same_pace(a: &Pace, b: &Pace) -> bool {
    match (a, b) {
        // A millisecond is what controllers count in.
        (Pace::Seconds(a), Pace::Seconds(b)) => (a - b).abs() <= 0.002 + MOST_SLOWER * a.abs(),
        // A share of full speed turned into radians and back.
        (Pace::Percent(a), Pace::Percent(b)) => (a - b).abs() <= 1e-3 * a.abs(),
        _ => false,
    }
}

/// A pace in words.
pub(super) fn pace(p: &Pace) -> String {
    match p {
        Pace::Seconds(s) => format!("{s:.3} s"),
        Pace::Percent(p) => format!("{p} %"),
    }
}

/// A way in words.
pub(super) fn way(way: Way) -> &'static str {
    match way {
        Way::Joint => "a move by joints",
        Way::Linear => "a straight move",
    }
}

/// A line in a few words.
pub(super) fn said(l: &ReadLine) -> String {
    match &l.what {
        Read::Move(m) => format!("{} to {}", way(m.way), goal(&m.goal)),
        Read::Output { number, on } => format!("output {number} {}", if *on { "on" } else { "off" }),
        Read::Level { number, value, group } => {
            format!("{} {number} to {value}", if *group { "group" } else { "analogue output" })
        }
        Read::Wait(s) => format!("a wait of {s} s"),
        Read::Say(text) | Read::Other(text) => text.clone(),
    }
}

/// A target in words: mm, then turns about Z, Y and X in degrees.
fn goal(goal: &Goal) -> String {
    let list = |numbers: &[f64]| numbers.iter().map(|v| format!("{:.2}", v + 0.0)).collect::<Vec<_>>().join(", ");
    let pose = |at: &Isometry3<f64>| {
        let turns = rpy::from_rotation(&at.rotation.to_rotation_matrix());
        format!("({}; {})", list(at.translation.vector.as_slice()), list(&turns))
    };
    match goal {
        Goal::Joints(joints) => format!("the joint angles ({})", list(joints)),
        Goal::Flange(at) => format!("the flange pose {}", pose(at)),
        Goal::Focus(at) => format!("the focus pose {}", pose(at)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::{Robot, Setup};

    fn line(way: Way, goal: Goal) -> ReadLine {
        let what = Read::Move(ReadMove { way, goal, pace: Pace::Percent(10.0), rest: String::new() });
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
                    let same = is_same(&poses, &line(Way::Linear, *a), &line(Way::Linear, *b));
                    assert_eq!(same, i == k, "{a:?} {b:?}");
                    assert!(!is_same(&poses, &line(Way::Linear, *a), &line(Way::Joint, *b)));
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
        assert!(off(&poses, &was, &is).is_some_and(is_near));
        assert!(!is_same(&poses, &line(Way::Joint, was), &line(Way::Joint, is)));
        let said = elsewhere(&poses, &was, &is).expect("a turn");
        assert_eq!(said, format!("J6 stands at {:.3}\u{b0}, the plan has {:.3}\u{b0}", turned[5], home[5]));
        assert_eq!(elsewhere(&poses, &was, &was), None);
    }
}
