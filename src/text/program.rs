//! Why a program cannot be written, and how it differs from what was wanted.

use super::{Sentence, exact, fixed, id, listed, say};
use crate::program::{ByHand, DialectError, Shortfall, UnknownDialect, WriteError, dialects};

impl Sentence for UnknownDialect {
    fn sentence(&self) -> String {
        say!(dialect_unknown, name = &self.0, known = listed(dialects::names()))
    }
}

impl Sentence for DialectError {
    fn sentence(&self) -> String {
        match self {
            DialectError::Unknown(e) => e.sentence(),
            DialectError::Write(e) => e.sentence(),
        }
    }
}

impl Sentence for WriteError {
    fn sentence(&self) -> String {
        match self {
            WriteError::NoRobot(dialect) => say!(write_no_robot, dialect = *dialect),
            WriteError::Template(e) => e.sentence(),
            WriteError::OffIsOn(dialect) => say!(write_off_is_on, dialect = *dialect),
            WriteError::NoTemplate { dialect, kind } => say!(write_no_template, dialect = *dialect, key = kind.key()),
            WriteError::TimedJointMove(dialect) => say!(write_timed_joint_move, dialect = *dialect),
            WriteError::StraightInPercent(dialect) => say!(write_straight_in_percent, dialect = *dialect),
            WriteError::FromUnknownPose(dialect) => say!(write_from_unknown_pose, dialect = *dialect),
            WriteError::HomeNeedsPulses => say!(write_home_needs_pulses),
            WriteError::PieceTooLong { lines, most } => say!(write_piece_too_long, lines = *lines, most = id(most)),
            WriteError::ProgramNumbers { number, subprograms, last } => {
                say!(write_program_numbers, number = id(number), pages = *subprograms, last = id(last))
            }
            WriteError::TooManyPositions => say!(write_too_many_positions),
        }
    }
}

impl Sentence for Shortfall {
    fn sentence(&self) -> String {
        match *self {
            Shortfall::LeadsLeftOut { leads } => say!(shortfall_leads, count = leads),
            Shortfall::ShortMoves { moves, shortest_s, least_s } => {
                let (shortest, least) = (fixed(1000.0 * shortest_s, 1), exact(1000.0 * least_s));
                say!(shortfall_short_moves, moves, shortest, least)
            }
            Shortfall::SetByHand(ByHand::PowerW(value)) => say!(shortfall_power, value = exact(value)),
            Shortfall::SetByHand(ByHand::FrequencyKhz(value)) => say!(shortfall_frequency, value = exact(value)),
        }
    }
}
