//! `clearbeam deviation`: how far the part on the bench is off its model, and where that is wear.

use super::{CommandFailure, CommandOutcome, print, print_json, scans};
use crate::document::files::write_atomic;
use crate::document::model::JobScan;
use crate::document::{Job, Parameter, segmented};
use crate::planning::scanned::{DeviationReport, compare, lay};
use crate::progress::Progress;
use crate::scan::transform_file;
use crate::text::parameter::refused_option;
use crate::text::{deviation_lines, say};
use std::path::PathBuf;
use std::sync::Arc;

const MIN_DEPTH: &Parameter = Parameter::named("scan.min_depth_mm");

/// Options of `deviation`.
#[derive(clap::Args, Debug)]
pub struct DeviationArguments {
    #[arg(help = say!(cli_deviation_scan))]
    scan: PathBuf,
    #[arg(long, value_name = "PART", help = say!(cli_register_part))]
    part: PathBuf,
    #[arg(long, value_name = "FILE.ply", help = say!(cli_deviation_out))]
    out: PathBuf,
    #[arg(long, value_name = "MM", default_value_t = MIN_DEPTH.default, allow_negative_numbers = true, help = say!(cli_deviation_min_depth))]
    min_depth: f64,
    #[arg(long, value_name = "FILE", help = say!(cli_deviation_transform))]
    transform: Option<PathBuf>,
    #[arg(long, help = say!(cli_json))]
    json: bool,
}

/// Lays the scan on the part, unless it is told where it lies, and compares.
pub fn run(a: &DeviationArguments) -> Result<CommandOutcome, CommandFailure> {
    MIN_DEPTH.check(a.min_depth).map_err(|e| CommandFailure::Usage(refused_option(&e)))?;
    let transform = a.transform.as_deref().map(scans::transform).transpose()?.map(|m| transform_file::rows(&m));
    let scan = JobScan { min_depth_mm: a.min_depth, transform, ..JobScan::default() };
    let cloud = scans::read(&a.scan)?;
    let part = scans::part(&a.part)?;
    let job = Job { scan, ..Job::default() };
    let (surfaces, progress) = (segmented(&part, &job), Progress::default());
    let laid = lay(&Arc::new(part), &Arc::new(surfaces), &cloud, &job, &progress).map_err(CommandFailure::failed)?;
    // Nobody can cancel it.
    let compared = compare(&laid, &job.scan, &progress).map_err(|_| CommandFailure::Failed(say!(text_cancelled)))?;
    let depth: Vec<(&str, &[f32])> =
        vec![("deviation_mm", &compared.deviation.signed_mm), ("depth_mm", &compared.depth_mm)];
    let ply = crate::scan::ply_file::bytes(&laid.cloud_in_part, &depth);
    write_atomic(&a.out, &ply).map_err(CommandFailure::failed)?;
    let report = DeviationReport::new(&compared, a.min_depth);
    if a.json {
        print_json(&report)?;
    } else {
        print(&format!("{}\n", deviation_lines(&report).join("\n")));
    }
    Ok(CommandOutcome::Done)
}
