//! `clearbeam weld`: from the two images of a weld to a folder with its mask, bead, paths and program (P4).

use super::plan::{PlanTarget, plan_and_write, told};
use super::word_options::{RobotOptions, full_path};
use super::{CommandFailure, CommandOutcome, print, print_json};
use crate::document::files::read_part;
use crate::document::model::{GrindingStrategy, JobWeld, NamedImage, WeldFiles};
use crate::document::{Job, Parameter};
use crate::planning::export::ExportOptions;
use crate::text::parameter::refused_option;
use crate::text::{Sentence as _, say, weld_lines};
use std::path::{Path, PathBuf};

const PASS_DEPTH: &Parameter = Parameter::named("weld.pass_depth_mm");
const RESIDUAL: &Parameter = Parameter::named("weld.residual_mm");

/// Options of `weld`.
#[derive(clap::Args, Debug)]
pub struct WeldArguments {
    #[arg(long, value_name = "G", help = say!(cli_weld_gray))]
    gray: PathBuf,
    #[arg(long, value_name = "D", help = say!(cli_weld_depth))]
    depth: PathBuf,
    #[arg(long, value_name = "CAM.toml", help = say!(cli_weld_camera))]
    camera: PathBuf,
    #[arg(long, value_name = "PART.stl", help = say!(cli_weld_part))]
    part: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = say!(cli_weld_hand_eye))]
    hand_eye: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = say!(cli_weld_tool))]
    tool: Option<PathBuf>,
    #[arg(long, value_name = "MM", default_value_t = PASS_DEPTH.default, allow_negative_numbers = true, help = say!(cli_weld_pass_depth))]
    pass_depth: f64,
    #[arg(long, value_name = "MM", default_value_t = RESIDUAL.default, allow_negative_numbers = true, help = say!(cli_weld_residual))]
    residual: f64,
    #[arg(long, value_parser = strategy, help = say!(cli_weld_strategy))]
    strategy: Option<GrindingStrategy>,
    #[command(flatten)]
    robot: RobotOptions,
    #[arg(long, value_name = "DIR", help = say!(cli_plan_out))]
    out: PathBuf,
    #[arg(long, help = say!(cli_weld_json))]
    json: bool,
}

/// Measures the weld, plans its grinding and writes both.
pub fn run(a: &WeldArguments) -> Result<CommandOutcome, CommandFailure> {
    let numbers = [(PASS_DEPTH, a.pass_depth), (RESIDUAL, a.residual)];
    numbers.iter().try_for_each(|(p, n)| p.check(*n)).map_err(|e| CommandFailure::Usage(refused_option(&e)))?;
    let named = |file: &Path| Ok(NamedImage { file: full_path(file)?, ..NamedImage::default() });
    let images = WeldFiles { gray: named(&a.gray)?, depth: named(&a.depth)?, camera: named(&a.camera)? };
    let of = |file: &Option<PathBuf>| file.as_deref().map(full_path).transpose().map(Option::unwrap_or_default);
    let mut job = Job::grinding(JobWeld {
        images,
        pass_depth_mm: a.pass_depth,
        residual_mm: a.residual,
        hand_eye: of(&a.hand_eye)?,
        tool: of(&a.tool)?,
        ..JobWeld::default()
    });
    if let Some(strategy) = a.strategy {
        (job.weld.strategy, job.weld.bead_strategy) = (strategy, strategy);
    }
    if let Some(part) = &a.part {
        job.part.file = full_path(part)?;
    }
    a.robot.apply(&mut job)?;
    job.check().map_err(|e| CommandFailure::Usage(e.sentence()))?;
    let source = read_part(&job, None).map_err(CommandFailure::failed)?;
    job.part.begin_with(&source, None);
    let target = PlanTarget { input: &a.gray, out: &a.out, options: ExportOptions::default(), overwrite: false };
    let made = plan_and_write(&target, (job, None), source, &[])?;
    let report = &made.exported.report;
    let Some(weld) = &report.weld else { return Ok(CommandOutcome::Found) };
    if a.json {
        print_json(weld)?;
    } else {
        print(&format!("{}\n{}", weld_lines(weld).join("\n"), told(&made)));
    }
    Ok(if weld.has_bead() { CommandOutcome::Done } else { CommandOutcome::Found })
}

fn strategy(text: &str) -> Result<GrindingStrategy, String> {
    GrindingStrategy::from_word(text).ok_or_else(|| say!(give_grinding_strategy))
}
