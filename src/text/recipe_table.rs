//! Recipes side by side: names of the rows, and the values in them.

use super::number::exact;
use super::parameter::label_with_unit;
use super::{Sentence as _, choices, say};
use crate::document::recipe_table::{Compared, ComparedValue};

/// What a row compares.
pub(crate) fn row_label(what: Compared) -> String {
    match what {
        Compared::Strategy => say!(compared_strategy),
        Compared::Direction => say!(compared_direction),
        Compared::Order => say!(compared_order),
        Compared::Start => say!(compared_start),
        Compared::Sense => say!(compared_sense),
        Compared::Centre => say!(compared_centre),
        Compared::Number(parameter) => label_with_unit(parameter),
    }
}

/// A value of a row.
pub(crate) fn value(value: ComparedValue) -> String {
    match value {
        ComparedValue::Strategy(strategy) => choices::strategy(strategy),
        ComparedValue::Direction(direction) => choices::direction(direction),
        ComparedValue::Order(order) => choices::order(order),
        ComparedValue::Start(start) => start.sentence(),
        ComparedValue::Inward(inward) => choices::spiral_sense(inward),
        ComparedValue::Centre(None) => say!(compared_middle),
        ComparedValue::Centre(Some(at_mm)) => choices::place(at_mm),
        ComparedValue::Number(number) => exact(number),
    }
}
