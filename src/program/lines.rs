//! A program as neutral lines: moves of the flange, outputs, waits, comments. From here on a
//! dialect only has to find the words.

use super::steps::{Pace, Step, Steps, Way};
use crate::cell::Setup;
use nalgebra::Isometry3;

/// A move.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// By joints or straight.
    pub way: Way,
    /// Where the flange goes; `None` for home without a robot, which is known by its joints only.
    pub base_from_flange: Option<Isometry3<f64>>,
    /// Where the joints go, as in the robot file, degrees; `None` without a robot.
    pub joints_deg: Option<[f64; 6]>,
    /// The same pose as focus in the part, turned by the spin; `None` for home.
    pub part_from_focus: Option<Isometry3<f64>>,
    /// How fast.
    pub pace: Pace,
    /// Whether the laser is on.
    pub lit: bool,
    /// Pass and point, for a target.
    pub target: Option<(usize, usize)>,
}

/// A line of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Line {
    /// A comment.
    Say(String),
    /// An output goes on or off.
    Output {
        /// Its number.
        number: u32,
        /// On or off.
        on: bool,
    },
    /// A dwell, s.
    Wait(f64),
    /// A move.
    Move(Box<Move>),
}

/// The lines of a program's steps.
pub fn lines(steps: &Steps, setup: &Setup) -> Vec<Line> {
    let cell = &setup.cell;
    let laser = |on| Line::Output { number: cell.laser_output, on };
    let mut lit = false;
    let mut out = vec![laser(false)];
    for step in &steps.list {
        match step {
            Step::Say(text) => out.push(Line::Say(text.clone())),
            Step::Laser(on) => {
                lit = *on;
                out.push(laser(lit));
            }
            Step::Home => {
                if out.len() > 1 {
                    out.push(laser(false));
                }
                let joints_deg = cell.air.home_joints_deg;
                out.push(Line::Move(Box::new(Move {
                    way: Way::Joint,
                    base_from_flange: setup.robot.as_ref().map(|r| r.forward(&joints_deg)),
                    joints_deg: Some(joints_deg),
                    part_from_focus: None,
                    pace: Pace::Percent(cell.air.home_percent),
                    lit: false,
                    target: None,
                })));
            }
            Step::Go(go) => {
                let part_from_focus = go.to.frame();
                out.push(Line::Move(Box::new(Move {
                    way: go.way,
                    base_from_flange: Some(setup.flange_for(&part_from_focus)),
                    joints_deg: go.joints_deg,
                    part_from_focus: Some(part_from_focus),
                    pace: go.pace,
                    lit,
                    target: go.target,
                })));
            }
        }
    }
    out
}
