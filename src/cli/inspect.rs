//! `clearbeam inspect`: what a part file holds.

use super::{CommandFailure, CommandOutcome, print, print_json, tell_of_file};
use crate::document::files::build_part;
use crate::document::{Job, Parameter, segmented};
use crate::part::inspect::InspectReport;
use crate::part::{Units, Weld};
use crate::progress::Progress;
use crate::text::parameter::refused_option;
use crate::text::{inspected, say, with_option};
use std::path::PathBuf;

const ANGLE: &Parameter = Parameter::named("surfaces.angle_deg");

/// Options of `inspect`.
#[derive(clap::Args, Debug)]
pub struct InspectArguments {
    #[arg(help = say!(cli_inspect_part))]
    part: PathBuf,
    #[arg(long, value_name = "DEG", default_value_t = ANGLE.default, allow_negative_numbers = true, help = say!(cli_inspect_angle))]
    angle: f64,
    #[arg(long, value_parser = super::word_options::units, help = say!(cli_inspect_units))]
    units: Option<Units>,
    #[arg(long, default_value = "auto", value_parser = super::word_options::weld, help = say!(cli_inspect_weld))]
    weld: Weld,
    #[arg(long, help = say!(cli_json))]
    json: bool,
}

/// Reads the part and prints what was found.
pub fn run(a: &InspectArguments) -> Result<CommandOutcome, CommandFailure> {
    ANGLE.check(a.angle).map_err(|e| CommandFailure::Usage(refused_option(&e)))?;
    let source = super::source_of(&a.part, None)?;
    let mut job = Job::default();
    (job.part.units, job.part.weld) = (a.units.unwrap_or_else(|| source.units()), a.weld);
    job.surfaces.angle_deg = a.angle;
    let built = build_part(&source, &job.part, &a.part, &Progress::default()).map_err(CommandFailure::failed)?;
    // Nobody can have cancelled it.
    let part = built.unwrap_or_default();
    let report = InspectReport::new(&part, &segmented(&part, &job), &job.surfaces.rule(), job.beam.spot_area_mm2());
    if a.json {
        print_json(&report)?;
        tell_of_file(&a.part, &report.findings);
    } else {
        let mut text = inspected(&report);
        for finding in &report.findings {
            text.push_str(&format!("! {}\n", with_option(finding)));
        }
        print(&text);
    }
    Ok(CommandOutcome::Done)
}
