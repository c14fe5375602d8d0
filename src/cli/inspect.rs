//! `clearbeam inspect`.

use super::{Failure, Outcome, print, tell};
use crate::document::{Job, Parameter, segmented};
use crate::part::inspect::InspectReport;
use crate::part::{PartFinding, Placement, Units, load};
use crate::text::{Sentence as _, inspected};
use std::path::PathBuf;

/// Options of `inspect`.
#[derive(clap::Args, Debug)]
pub struct Arguments {
    /// The part
    part: PathBuf,
    /// Crease angle, degrees
    #[arg(long, value_name = "DEG", default_value_t = 20.0, allow_negative_numbers = true)]
    angle: f64,
    /// Unit of the file: mm, m or inch
    #[arg(long, default_value = "mm", value_parser = super::options::units)]
    units: Units,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// Reads the part and prints what was found.
pub fn run(a: &Arguments) -> Result<Outcome, Failure> {
    if let Some(p) = Parameter::by_option("angle") {
        p.check(a.angle).map_err(Failure::Usage)?;
    }
    let part = load(&a.part, a.units, &Placement::default(), &[]).map_err(anyhow::Error::from)?;
    let mut job = Job::default();
    job.surfaces.angle_deg = a.angle;
    let report = InspectReport::new(&part, &segmented(&part, &job), a.angle);
    let findings = PartFinding::of(&part);
    if a.json {
        let json = serde_json::to_string_pretty(&report).map_err(anyhow::Error::from)?;
        print(&format!("{json}\n"));
        tell(&a.part, &findings);
    } else {
        let mut text = inspected(&report);
        for finding in findings {
            text.push_str(&format!("! {}\n", finding.sentence()));
        }
        print(&text);
    }
    Ok(Outcome::Done)
}
