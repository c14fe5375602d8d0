//! What is wrong with a robot file.

use super::file::in_line_of;
use super::{Sentence, exact, id, listed, quoted, say};
use crate::cell::RobotError;
use crate::cell::robot::RobotFigureError;

impl Sentence for RobotError {
    fn sentence(&self) -> String {
        match self {
            RobotError::Unknown { name, shipped } => {
                say!(robot_unknown, name = quoted(name), shipped = shipped.join(" "))
            }
            RobotError::File(e) => e.sentence(),
            RobotError::Figure { file, line, what } => in_line_of(file, *line, what.sentence()),
        }
    }
}

impl Sentence for RobotFigureError {
    fn sentence(&self) -> String {
        match self {
            RobotFigureError::Figure(e) => e.sentence(),
            RobotFigureError::Kinematics => say!(robot_kinematics),
            RobotFigureError::Short { key, value_mm, least_mm } => {
                say!(robot_short, key = *key, value = exact(*value_mm), least = exact(*least_mm))
            }
            RobotFigureError::Sign { value } => say!(robot_sign, value = exact(*value)),
            RobotFigureError::Limits { joint, range_deg: [low, high] } => {
                say!(robot_limits, joint = id(joint), low = exact(*low), high = exact(*high))
            }
            RobotFigureError::Speed { joint, value, low, high } => {
                say!(robot_speed, joint = id(joint), value = exact(*value), low = exact(*low), high = exact(*high))
            }
            RobotFigureError::Dialect { dialect, known } => {
                say!(robot_dialect, dialect = quoted(dialect), known = listed(known.iter().copied()))
            }
        }
    }
}
