//! A program as neutral lines: moves of the flange, outputs, waits, comments. From here on a
//! dialect only has to find the words.

use super::steps::{Pace, Step, Steps, Way};
use crate::beam::Work;
use crate::cell::Setup;
use crate::cell::outputs::{During, Outputs, PowerForm, PowerOutput, Switch};
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
    /// What it is worked with, or the work before it.
    pub work: Work,
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
    /// An analogue output, or a group of digital ones, is set.
    Level {
        /// Its number.
        number: u32,
        /// In its own units.
        value: f64,
        /// A group rather than an analogue output.
        group: bool,
    },
    /// A dwell, s.
    Wait(f64),
    /// A move.
    Move(Box<Move>),
}

/// The lines of a program's steps, with every output in a safe order: cooling, gas, powder, laser
/// on, and off in reverse. The laser is switched off at the start, before each way home and at the end.
pub fn lines(steps: &Steps, setup: &Setup, power_w: f64) -> Vec<Line> {
    let cell = &setup.cell;
    let outputs = &cell.outputs;
    let off = Line::Output { number: outputs.laser.number, on: false };
    let (whole, piece) = supplies(outputs);
    let first = steps.list.iter().find_map(|s| if let Step::Work(work) = s { Some(*work) } else { None });
    let mut work = first.unwrap_or(Work { power_w, ..Work::default() });
    let mut lit = false;
    let mut out = vec![off.clone()];
    out.extend(level(outputs, work.power_w));
    for switch in &whole {
        turn(&mut out, switch, true);
    }
    let begun = out.len();
    for step in &steps.list {
        match step {
            Step::Say(text) => out.push(Line::Say(text.clone())),
            Step::Work(with) => {
                if with.power_w != work.power_w {
                    out.extend(level(outputs, with.power_w));
                }
                work = *with;
            }
            Step::Laser(on) => {
                lit = *on;
                if lit {
                    piece.iter().for_each(|s| turn(&mut out, s, true));
                } else {
                    piece.iter().rev().for_each(|s| turn(&mut out, s, false));
                }
            }
            Step::Home => {
                if out.len() > begun {
                    out.push(off.clone());
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
                    work,
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
                    work,
                })));
            }
        }
    }
    out.push(off);
    for switch in whole.iter().rev() {
        turn(&mut out, switch, false);
    }
    out
}

/// What is on for the whole program and what for each lit piece, in the order of going on.
fn supplies(outputs: &Outputs) -> (Vec<Switch>, Vec<Switch>) {
    let (mut whole, mut piece) = (Vec::new(), Vec::new());
    for supply in [outputs.cooling, outputs.shielding_gas].into_iter().flatten() {
        match supply.during {
            During::Program => whole.push(supply.switch()),
            During::Piece => piece.push(supply.switch()),
        }
    }
    piece.extend(outputs.powder);
    piece.push(outputs.laser);
    (whole, piece)
}

fn turn(out: &mut Vec<Line>, switch: &Switch, on: bool) {
    out.push(Line::Output { number: switch.number, on });
    let wait_s = if on { switch.on_wait_s } else { switch.off_wait_s };
    if wait_s > 0.0 {
        out.push(Line::Wait(wait_s));
    }
}

/// The power as an output's level; `None` where it is set by hand.
fn level(outputs: &Outputs, power_w: f64) -> Option<Line> {
    let PowerOutput { form, number, scale } = outputs.power;
    let value = power_w * scale;
    match form {
        PowerForm::Comment => None,
        PowerForm::Analogue => Some(Line::Level { number, value, group: false }),
        PowerForm::Group => Some(Line::Level { number, value: value.round(), group: true }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outputs_go_on_in_order_and_off_in_reverse() {
        let mut setup = Setup::shipped().expect("shipped");
        setup.cell.outputs = toml::from_str(
            "cooling = { number = 6, on_wait_s = 2.0 }\n\
             shielding_gas = { number = 5, off_wait_s = 1.0, during = \"piece\" }\n\
             powder = { number = 4, on_wait_s = 0.5 }\n\
             laser = { number = 3 }\n\
             power = { as = \"group\", number = 2, scale = 0.255 }",
        )
        .expect("outputs");
        let list = vec![Step::Home, Step::Laser(true), Step::Laser(false), Step::Home];
        let lines = lines(&Steps { list, ..Steps::default() }, &setup, 500.0);
        let words: Vec<String> = lines
            .iter()
            .map(|l| match l {
                Line::Output { number, on } => format!("{number}{}", if *on { "+" } else { "-" }),
                Line::Level { number, value, group: true } => format!("{number}={value}"),
                Line::Wait(s) => format!("{s}s"),
                Line::Move(_) => "home".into(),
                other => format!("{other:?}"),
            })
            .collect();
        let expected = "3- 2=128 6+ 2s home 5+ 4+ 0.5s 3+ 3- 4- 5- 1s 3- home 3- 6-";
        assert_eq!(words.join(" "), expected);
    }
}
