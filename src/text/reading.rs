//! Why a program cannot be read: what was expected in a line, and what was found there.

use super::list::listed_choices;
use super::{Sentence, fixed, id, say};
use crate::program::{LineFault, ReadError, RowFault};

impl Sentence for ReadError {
    fn sentence(&self) -> String {
        match self {
            ReadError::Line { file, line, fault } => {
                say!(read_at_line, file, line = id(line), what = fault.sentence())
            }
            ReadError::Gone { file, line, called } => say!(read_gone, file, line = id(line), called),
            ReadError::CutOff { file, expected } => say!(read_cut_off, file, expected = &**expected),
        }
    }
}

impl Sentence for LineFault {
    fn sentence(&self) -> String {
        match self {
            LineFault::Expected { one_of, found } => {
                say!(read_expected, found, expected = listed_choices(one_of.iter().map(AsRef::<str>::as_ref)))
            }
            LineFault::Numbers { count, found } => say!(read_numbers, found, count = *count),
            LineFault::NotAboveZero { found } => say!(read_not_above_zero, found),
            LineFault::Quaternion { length } => say!(read_quaternion, length = fixed(*length, 6)),
            LineFault::BehindEnd { end } => say!(read_behind_end, end = &**end),
            LineFault::NotAsInCell { expected } => say!(read_not_as_in_cell, expected),
            LineFault::Before { missing } => say!(read_before, missing = &**missing),
            LineFault::Twice { name } => say!(read_twice, name),
            LineFault::Undefined { name } => say!(read_undefined, name),
            LineFault::NeverCalled { name } => say!(read_never_called, name),
            LineFault::Circle { called } => say!(read_circle, called),
            LineFault::NestedCall => say!(read_nested_call),
            LineFault::BadCall { called } => say!(read_bad_call, called),
            LineFault::OutsideFunction => say!(read_outside_function),
            LineFault::Count { of, promised: Some(promised), found } => {
                say!(read_count, of = *of, promised, found = *found)
            }
            LineFault::Count { of, promised: None, found } => say!(read_count_missing, of = *of, found = *found),
            LineFault::OutOfOrder { found, expected } => say!(read_out_of_order, found, expected = id(expected)),
            LineFault::NoMotionGroup => say!(read_no_motion_group),
            LineFault::OtherMotionGroup { found } => say!(read_other_motion_group, found),
            LineFault::FlangeSpeed { found, one_of } => {
                say!(read_flange_speed, found, expected = listed_choices(one_of.iter().map(AsRef::<str>::as_ref)))
            }
            LineFault::Arc { found } => say!(read_arc, found),
            LineFault::NoDuration => say!(read_no_duration),
            LineFault::FromNowhere => say!(read_from_nowhere),
            LineFault::GoesOnStraight { file, line } => say!(read_goes_on_straight, file, line = id(line)),
            LineFault::NoPulsesPerDegree => say!(read_no_pulses_per_degree),
            LineFault::Row(fault) => fault.sentence(),
        }
    }
}

impl Sentence for RowFault {
    fn sentence(&self) -> String {
        match self {
            RowFault::OtherColumns => say!(read_other_columns),
            RowFault::UnusedCells { what } => say!(read_unused_cells, what),
            RowFault::FocusWithoutFlange => say!(read_focus_without_flange),
            RowFault::NoRobotToCompare => say!(read_no_robot_to_compare),
            RowFault::NoGoal => say!(read_no_goal),
            RowFault::NoTiming => say!(read_no_timing),
            RowFault::Disagree { given_by: [first, second], off_mm, off_deg } => {
                let (mm, deg) = (fixed(*off_mm, 4), fixed(*off_deg, 4));
                say!(read_disagree, first = first.word(), second = second.word(), mm, deg)
            }
        }
    }
}
