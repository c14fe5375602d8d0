//! Names of the choices that the window offers. Their words in files and on the command line belong to the types, and
//! are the same in all languages.

use super::number::{exact, fixed};
use super::say;
use crate::cell::Spin;
use crate::part::{Units, Weld};
use crate::path::{Direction, Order, Strategy};
use crate::pose::Correction;
use crate::process::Profile;

/// Name of a strategy.
pub(crate) fn strategy(strategy: Strategy) -> String {
    match strategy {
        Strategy::Planes => say!(choice_planes),
        Strategy::Adaptive => say!(choice_adaptive),
        Strategy::Offset => say!(choice_offset),
        Strategy::Spiral => say!(choice_spiral),
        Strategy::Cross => say!(choice_cross),
    }
}

/// What a strategy does, in a few words.
pub(crate) fn strategy_hint(strategy: Strategy) -> String {
    match strategy {
        Strategy::Planes => say!(choice_planes_hint),
        Strategy::Adaptive => say!(choice_adaptive_hint),
        Strategy::Offset => say!(choice_offset_hint),
        Strategy::Spiral => say!(choice_spiral_hint),
        Strategy::Cross => say!(choice_cross_hint),
    }
}

/// A direction: the letter of an axis, or its three numbers.
pub(crate) fn direction(direction: Direction) -> String {
    let axis = Direction::AXES.iter().find(|(_, d)| *d == direction).map(|(name, _)| *name);
    match (axis, direction) {
        (Some(name), _) => name.into(),
        (None, Direction::Auto) => say!(choice_direction_auto),
        (None, Direction::Along(vector)) => vector.map(exact).join(","),
    }
}

/// Name of an order of lines.
pub(crate) fn order(order: Order) -> String {
    match order {
        Order::Zigzag => say!(choice_zigzag),
        Order::OneWay => say!(choice_one_way),
        Order::Shortest => say!(choice_shortest),
    }
}

/// In which sense a spiral runs.
pub(crate) fn spiral_sense(inward: bool) -> String {
    if inward { say!(choice_inwards) } else { say!(choice_outwards) }
}

/// A place, mm.
pub(crate) fn place(at_mm: [f64; 3]) -> String {
    let [x, y, z] = at_mm.map(|c| fixed(c, 1));
    format!("({x}, {y}, {z})")
}

/// Name of a correction.
pub(crate) fn correction(correction: Correction) -> String {
    match correction {
        Correction::None => say!(choice_correction_none),
        Correction::SectionPlane => say!(choice_correction_section_plane),
        Correction::Clearance => say!(choice_correction_clearance),
    }
}

/// Name of a spot's profile.
pub(crate) fn profile(profile: Profile) -> String {
    match profile {
        Profile::Gaussian => say!(choice_gaussian),
        Profile::TopHat => say!(choice_top_hat),
        Profile::Line => say!(choice_line),
    }
}

/// Name of a unit of length.
pub(crate) fn units(units: Units) -> String {
    match units {
        Units::Mm => say!(choice_mm),
        Units::M => say!(choice_m),
        Units::Inch => say!(choice_inch),
    }
}

/// Which corners become one vertex.
pub(crate) fn weld(weld: Weld) -> String {
    match weld {
        Weld::Auto => say!(choice_weld_auto),
        Weld::Exact => say!(choice_weld_exact),
    }
}

/// What a way of welding does, in a sentence.
pub(crate) fn about_weld(weld: Weld) -> String {
    match weld {
        Weld::Auto => say!(choice_weld_auto_about),
        Weld::Exact => say!(choice_weld_exact_about),
    }
}

/// What turns the tool about the beam.
pub(crate) fn spin(spin: Spin) -> String {
    match spin {
        Spin::Free => say!(choice_spin_free),
        Spin::Travel => say!(choice_spin_travel),
    }
}
