//! A program as neutral lines: moves of the flange, outputs, waits, comments. How they are written is each
//! dialect's.

use super::comment::Comment;
use super::shortfall::ByHand;
use super::steps::{Go, Interpolation, MoveTiming, Step, Steps};
use crate::beam::{ProcessSettings, WorkingMedium};
use crate::cell::Setup;
use crate::cell::outputs::{During, Outputs, Switch, ValueForm, ValueOutput};
use nalgebra::Isometry3;

/// A move.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// By joints or straight.
    pub interpolation: Interpolation,
    /// Where the flange goes; `None` for home without a robot, which is known by its joints only.
    pub base_from_flange: Option<Isometry3<f64>>,
    /// Where the joints go, as in the robot file, degrees; `None` without a robot.
    pub joints_deg: Option<[f64; 6]>,
    /// Where that brings the focus in the part, turned by the spin; `None` for home.
    pub part_from_focus: Option<Isometry3<f64>>,
    /// How fast.
    pub timing: MoveTiming,
    /// Whether the laser is on.
    pub lit: bool,
    /// Whether it works the part: then the laser is on, but for a dry run.
    pub at_work: bool,
    /// Pass and point, for a target.
    pub target: Option<(usize, usize)>,
    /// What it is worked with, or what was before it.
    pub settings: ProcessSettings,
}

/// A line of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum ProgramLine {
    /// A comment.
    Comment(Comment),
    /// An output goes on or off.
    Output {
        /// Its number.
        number: u32,
        /// On or off.
        on: bool,
    },
    /// An analogue output, or a group of digital ones, is set.
    OutputValue {
        /// Its number.
        number: u32,
        /// In its own units.
        value: f64,
        /// A group rather than an analogue output.
        group: bool,
    },
    /// A contact tool presses with so many newtons from here on; 0: no more.
    Force(f64),
    /// A dwell, s.
    Wait(f64),
    /// A move.
    Move(Box<Move>),
}

/// The lines of a program's steps, with every output in a safe order: cooling, gas, powder, laser
/// on, then the force of a contact tool, and off in reverse. The laser is switched off at the start, before each way home and at the end.
pub fn lines(steps: &Steps, setup: &Setup) -> Vec<ProgramLine> {
    let outputs = &setup.cell.outputs;
    let off = ProgramLine::Output { number: outputs.laser.number, on: false };
    let (whole, piece) = supplies(outputs);
    let first = steps.list.iter().find_map(|s| if let Step::Process(settings) = s { Some(*settings) } else { None });
    let mut settings = first.unwrap_or_default();
    let mut lit = false;
    let mut out = vec![off.clone()];
    out.extend(first.iter().flat_map(|first| output_values(outputs, None, first)));
    for switch in &whole {
        turn(&mut out, switch, true);
    }
    let begun = out.len();
    for step in &steps.list {
        match step {
            Step::Comment(comment) => out.push(ProgramLine::Comment(comment.clone())),
            Step::Process(with) => {
                out.extend(output_values(outputs, Some(&settings), with));
                settings = *with;
            }
            Step::Laser(on) => {
                lit = *on;
                // It presses when it runs, and no more before it stops.
                let presses = settings.force_n > 0.0;
                if lit {
                    piece.iter().for_each(|s| turn(&mut out, s, true));
                    out.extend(presses.then_some(ProgramLine::Force(settings.force_n)));
                } else {
                    out.extend(presses.then_some(ProgramLine::Force(0.0)));
                    piece.iter().rev().for_each(|s| turn(&mut out, s, false));
                }
            }
            Step::Home { percent } => {
                if out.len() > begun {
                    out.push(off.clone());
                }
                out.push(home(setup, *percent, settings));
            }
            Step::Go(go) => out.push(ProgramLine::Move(Box::new(move_to(setup, go, lit, settings)))),
        }
    }
    out.push(off);
    for switch in whole.iter().rev() {
        turn(&mut out, switch, false);
    }
    out
}

fn home(setup: &Setup, percent: f64, settings: ProcessSettings) -> ProgramLine {
    let air = &setup.cell.air;
    ProgramLine::Move(Box::new(Move {
        interpolation: Interpolation::Joint,
        base_from_flange: setup.robot.as_ref().map(|r| r.forward(&air.home_joints_deg)),
        joints_deg: Some(air.home_joints_deg),
        part_from_focus: None,
        timing: MoveTiming::Percent(percent),
        lit: false,
        at_work: false,
        target: None,
        settings,
    }))
}

fn move_to(setup: &Setup, go: &Go, lit: bool, settings: ProcessSettings) -> Move {
    let part_from_focus = go.to.frame();
    Move {
        interpolation: go.interpolation,
        base_from_flange: Some(setup.flange_for(&part_from_focus)),
        joints_deg: go.joints_deg,
        part_from_focus: Some(part_from_focus),
        timing: go.timing,
        lit,
        at_work: lit,
        target: go.target,
        settings,
    }
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

fn turn(out: &mut Vec<ProgramLine>, switch: &Switch, on: bool) {
    out.push(ProgramLine::Output { number: switch.number, on });
    let wait_s = if on { switch.on_wait_s } else { switch.off_wait_s };
    if wait_s > 0.0 {
        out.push(ProgramLine::Wait(wait_s));
    }
}

/// Power and frequency of a laser, where they change: by their outputs, or said where they are set by hand. What the first
/// piece is worked with stands in the program's head.
fn output_values(outputs: &Outputs, before: Option<&ProcessSettings>, with: &ProcessSettings) -> Vec<ProgramLine> {
    if with.medium != WorkingMedium::Light {
        return Vec::new();
    }
    let output_value = |output: &ValueOutput, by_hand: fn(f64) -> ByHand, value: f64, before: Option<f64>| {
        let scaled = value * output.scale;
        match output.form {
            _ if before.is_some_and(|b| b == value) => None,
            ValueForm::Comment => before.map(|_| ProgramLine::Comment(Comment::Set(by_hand(value)))),
            ValueForm::Analogue => {
                Some(ProgramLine::OutputValue { number: output.number, value: scaled, group: false })
            }
            ValueForm::Group => {
                Some(ProgramLine::OutputValue { number: output.number, value: scaled.round(), group: true })
            }
        }
    };
    let power = output_value(&outputs.power, ByHand::PowerW, with.power_w, before.map(|b| b.power_w));
    // Nobody asks for the frequency of a laser without pulses.
    let khz = before.map(|b| b.frequency_khz).or((with.frequency_khz == 0.0).then_some(0.0));
    let frequency = output_value(&outputs.frequency, ByHand::FrequencyKhz, with.frequency_khz, khz);
    power.into_iter().chain(frequency).collect()
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
             power = { as = \"group\", number = 2, scale = 0.255 }\n\
             frequency = { as = \"group\", number = 8 }",
        )
        .expect("outputs");
        let settings = ProcessSettings { power_w: 500.0, ..ProcessSettings::default() };
        let pulsed = ProcessSettings { frequency_khz: 20.0, ..settings };
        let home = Step::Home { percent: 10.0 };
        let list = vec![home.clone(), Step::Process(settings), Step::Laser(true), Step::Laser(false), home];
        let lines = lines(&Steps { list, ..Steps::default() }, &setup);
        let words: Vec<String> = lines
            .iter()
            .map(|l| match l {
                ProgramLine::Output { number, on } => format!("{number}{}", if *on { "+" } else { "-" }),
                ProgramLine::OutputValue { number, value, group: true } => format!("{number}={value}"),
                ProgramLine::Wait(s) => format!("{s}s"),
                ProgramLine::Move(_) => "home".into(),
                other => format!("{other:?}"),
            })
            .collect();
        let expected = "3- 2=128 6+ 2s home 5+ 4+ 0.5s 3+ 3- 4- 5- 1s 3- home 3- 6-";
        assert_eq!(words.join(" "), expected);
        let said = |outputs: &Outputs, before, with| {
            let of = |l: &ProgramLine| match l {
                ProgramLine::OutputValue { number, value, .. } => format!("{number}={value}"),
                other => format!("{other:?}"),
            };
            output_values(outputs, before, with).iter().map(of).collect::<Vec<_>>().join(" ")
        };
        let outputs = &setup.cell.outputs;
        assert_eq!(said(outputs, None, &pulsed), "2=128 8=20");
        assert_eq!(said(outputs, Some(&settings), &pulsed), "8=20");
        assert_eq!(said(outputs, Some(&pulsed), &settings), "8=0");
        let by_hand = Outputs::default();
        assert_eq!(said(&by_hand, None, &pulsed), "");
        assert_eq!(said(&by_hand, Some(&settings), &pulsed), "Comment(Set(FrequencyKhz(20.0)))");
        assert_eq!(said(&by_hand, Some(&pulsed), &pulsed), "");
    }
}
