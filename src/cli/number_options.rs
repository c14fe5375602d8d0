//! The options that are numbers, made from the table of parameters.

use crate::document::parameter::NumberKind;
use crate::document::{PARAMETERS, Parameter};
use crate::text::parameter::{meaning, with_unit};
use crate::text::say;
use clap::{Arg, ArgMatches};

/// One option of each row that has one, in the order of the table.
pub(super) fn arguments() -> impl Iterator<Item = Arg> {
    PARAMETERS.iter().filter_map(|p| Some(argument(p, p.option?)))
}

/// The numbers that were given.
pub(super) fn given(matches: &ArgMatches) -> Vec<(&'static Parameter, f64)> {
    PARAMETERS.iter().filter_map(|p| Some((p, *matches.get_one::<f64>(p.option?)?))).collect()
}

fn argument(p: &'static Parameter, option: &'static str) -> Arg {
    let help = say!(option_number, meaning = meaning(p), default = with_unit(p.default, p.kind));
    Arg::new(option)
        .long(option)
        .value_name(placeholder(p.kind))
        .allow_negative_numbers(true)
        .value_parser(number)
        .help(help)
}

/// Reads a number as people type it.
pub(super) fn number(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| say!(give_number))
}

/// The placeholder of the value in the help.
fn placeholder(kind: NumberKind) -> &'static str {
    match kind {
        NumberKind::Length => "MM",
        NumberKind::Wavelength => "NM",
        NumberKind::Area => "MM2",
        NumberKind::Angle => "DEG",
        NumberKind::TurnPerLength => "DEG/MM",
        NumberKind::TurnRate => "DEG/S",
        NumberKind::Speed => "MM/S",
        NumberKind::Power => "W",
        NumberKind::Frequency => "KHZ",
        NumberKind::Fluence => "J/CM2",
        NumberKind::Force => "N",
        NumberKind::Acceleration => "MM/S2",
        NumberKind::Pixels => "PX",
        NumberKind::Share => "PERCENT",
        NumberKind::Factor => "X",
        NumberKind::Count => "N",
    }
}
