//! The options of `plan` that are words, lists or files.

use super::CommandFailure;
use super::number_options::number;
use crate::cell::{Mount, Robot, Spin};
use crate::document::{Chosen, FirstPlane, Job};
use crate::part::{Units, Weld};
use crate::path::{Direction, Order, Strategy};
use crate::pose::Correction;
use crate::program::dialects;
use crate::text::{id, say};
use std::path::{Path, PathBuf};

/// The words, lists and files that were given.
#[derive(clap::Args, Clone, Debug, Default)]
pub(super) struct WordOptions {
    #[arg(long, value_parser = units, help = say!(option_units))]
    pub units: Option<Units>,
    #[arg(long, value_parser = weld, help = say!(option_weld))]
    pub weld: Option<Weld>,
    #[arg(long, value_name = "LIST", value_parser = surfaces, help = say!(option_surfaces))]
    pub surfaces: Option<Chosen>,
    #[arg(long, allow_hyphen_values = true, value_parser = direction, help = say!(option_direction))]
    pub direction: Option<Direction>,
    #[arg(long, value_parser = strategy, help = say!(option_strategy))]
    pub strategy: Option<Strategy>,
    #[arg(long, value_name = "%", allow_negative_numbers = true, value_parser = number, conflicts_with = "spacing",
        help = say!(option_overlap))]
    pub overlap: Option<f64>,
    #[arg(long, value_name = "MM", allow_negative_numbers = true, value_parser = offset, help = say!(option_offset))]
    pub offset: Option<FirstPlane>,
    #[arg(long, value_parser = order, help = say!(option_order))]
    pub order: Option<Order>,
    #[arg(long, value_parser = correction, help = say!(option_correction))]
    pub correction: Option<Correction>,
    #[arg(long, value_name = "FILE", help = say!(option_head))]
    pub head: Option<PathBuf>,
    #[command(flatten)]
    pub robot: RobotOptions,
}

/// Robot, cell and program that were given.
#[derive(clap::Args, Clone, Debug, Default)]
pub(super) struct RobotOptions {
    #[arg(long, value_name = "CELL.toml", help = say!(option_cell))]
    pub cell: Option<PathBuf>,
    #[arg(long, value_name = "NAME", help = say!(option_robot, shipped = robots()))]
    pub robot: Option<String>,
    #[arg(long, value_parser = mount, help = say!(option_mount))]
    pub mount: Option<Mount>,
    #[arg(long, value_name = "NAME", help = say!(option_dialect, dialects = dialects()))]
    pub dialect: Option<String>,
    #[arg(long, value_parser = spin, help = say!(option_spin))]
    pub spin: Option<Spin>,
}

impl RobotOptions {
    /// Writes what was given into a job.
    ///
    /// # Errors
    /// A file has no full path.
    pub(super) fn apply(&self, job: &mut Job) -> Result<(), CommandFailure> {
        job.cell.mount = self.mount.or(job.cell.mount);
        job.cell.spin = self.spin.unwrap_or(job.cell.spin);
        if let Some(dialect) = &self.dialect {
            job.cell.dialect.clone_from(dialect);
        }
        if let Some(cell) = &self.cell {
            job.cell.file = full_path(cell)?;
        }
        if let Some(robot) = &self.robot {
            job.cell.robot = if Robot::is_shipped(robot) { robot.clone() } else { full_path(Path::new(robot))? };
        }
        Ok(())
    }
}

/// The path of a file from the root.
pub(super) fn full_path(path: &Path) -> Result<String, CommandFailure> {
    match std::path::absolute(path) {
        Ok(full) => Ok(full.display().to_string()),
        Err(e) => {
            Err(CommandFailure::Failed(say!(cli_no_path, file = path.display().to_string(), reason = e.to_string())))
        }
    }
}

fn robots() -> String {
    Robot::shipped().collect::<Vec<_>>().join(" ")
}

fn dialects() -> String {
    dialects::names().collect::<Vec<_>>().join(" ")
}

/// Reads a unit of length.
pub(super) fn units(text: &str) -> Result<Units, String> {
    Units::from_word(text).ok_or_else(|| say!(give_units))
}

/// Reads which corners become one vertex.
pub(super) fn weld(text: &str) -> Result<Weld, String> {
    Weld::from_word(text).ok_or_else(|| say!(give_weld))
}

fn order(text: &str) -> Result<Order, String> {
    Order::from_word(text).ok_or_else(|| say!(give_order))
}

fn strategy(text: &str) -> Result<Strategy, String> {
    Strategy::from_word(text).ok_or_else(|| say!(give_strategy))
}

fn correction(text: &str) -> Result<Correction, String> {
    Correction::from_word(text).ok_or_else(|| say!(give_correction))
}

fn mount(text: &str) -> Result<Mount, String> {
    Mount::from_word(text).ok_or_else(|| say!(give_mount))
}

fn spin(text: &str) -> Result<Spin, String> {
    Spin::from_word(text).ok_or_else(|| say!(give_spin))
}

fn direction(text: &str) -> Result<Direction, String> {
    text.parse().map_err(|_| say!(give_direction))
}

fn offset(text: &str) -> Result<FirstPlane, String> {
    if text == "centred" {
        return Ok(FirstPlane::Centred);
    }
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.map(FirstPlane::FromLowest).ok_or_else(|| say!(give_offset))
}

fn surfaces(text: &str) -> Result<Chosen, String> {
    if text == "all" {
        return Ok(Chosen::All);
    }
    let list: Result<Vec<u32>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let chosen = Chosen::from(list.map_err(|_| say!(give_surfaces))?);
    match chosen.repeated() {
        Some(surface) => Err(say!(give_surface_once, surface = id(surface))),
        None => Ok(chosen),
    }
}
