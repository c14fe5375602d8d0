//! `clearbeam inspect`.

use super::{Failure, Outcome, print};
use crate::document::{Job, Parameter, segmented};
use crate::part::inspect::InspectReport;
use crate::part::{Placement, Units, load};
use crate::text::parameter::refused_option;
use std::path::PathBuf;

const ANGLE: &Parameter = Parameter::named("surfaces.angle_deg");

/// Options of `inspect`.
#[derive(clap::Args, Debug)]
pub struct Arguments {
    /// The part
    part: PathBuf,
    /// Crease angle, degrees
    #[arg(long, value_name = "DEG", default_value_t = ANGLE.default, allow_negative_numbers = true)]
    angle: f64,
    /// Unit of the file: mm, m or inch
    #[arg(long, default_value = "mm", value_parser = super::word_options::units)]
    units: Units,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Reads the part and prints what was found.
pub fn run(a: &Arguments) -> Result<Outcome, Failure> {
    ANGLE.check(a.angle).map_err(|e| Failure::Usage(refused_option(&e)))?;
    let part = load(&a.part, a.units, &Placement::default(), &[]).map_err(anyhow::Error::from)?;
    let mut job = Job::default();
    job.surfaces.angle_deg = a.angle;
    let report = InspectReport::new(&part, &segmented(&part, &job), a.angle);
    let sentences = part.findings.sentences(&part.mesh, &part.orientation);
    if a.json {
        let json = serde_json::to_string_pretty(&report).map_err(anyhow::Error::from)?;
        print(&format!("{json}\n"));
        for s in sentences {
            eprintln!("{}: {s}", a.part.display());
        }
    } else {
        let mut text = report.text();
        for s in sentences {
            text.push_str(&format!("! {s}\n"));
        }
        print(&text);
    }
    Ok(Outcome::Done)
}
