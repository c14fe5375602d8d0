//! Cell, robot, head and clamps of a job, and the set-up that they make.

use super::error::JobError;
use super::paths::resolved;
use crate::beam::{ContactTool, Grinding, Head, Tool, ToolGeometry};
use crate::cell::robot::RobotFigureError;
use crate::cell::{Cell, Mount, Robot, RobotError, Setup};
use crate::document::model::Job;
use crate::part::Part;
use crate::pose::{BeamInterference, Blocker, Obstruction};
use crate::program::dialects;
use nalgebra::{Point3, Vector3};
use std::path::Path;

/// Cell, robot, mount, head and clamps of a job.
///
/// # Errors
/// A file cannot be read or has absurd figures.
pub fn load_setup(job: &Job, job_file: Option<&Path>) -> Result<Setup, JobError> {
    let robot = load_robot(job, job_file)?;
    set_up(job, robot, load_cell(job, job_file)?, load_tool(job, job_file)?)
}

/// The robot of a job; `None`: poses only.
///
/// # Errors
/// There is none of that name, or its file cannot be read or has absurd figures.
pub fn load_robot(job: &Job, job_file: Option<&Path>) -> Result<Option<Robot>, JobError> {
    Ok(match job.cell.robot.as_str() {
        "" => None,
        name => {
            let robot = Robot::load(name, job_file.and_then(Path::parent))?;
            if dialects::by_name(&robot.dialect).is_none() {
                let known = dialects::names().collect();
                let what = RobotFigureError::Dialect { dialect: robot.dialect, known };
                return Err(RobotError::Figure { file: name.into(), line: None, what: Box::new(what) }.into());
            }
            Some(robot)
        }
    })
}

/// Head, or grinding tool, and clamps of a job.
///
/// # Errors
/// A file cannot be read or has absurd figures.
pub fn load_tool(job: &Job, job_file: Option<&Path>) -> Result<Tool, JobError> {
    let named = Some(&job.beam.head).filter(|f| !f.is_empty());
    let head = named.map(|f| Head::load(&resolved(job_file, f))).transpose()?;
    let mut clamps = job.clamps.clone();
    clamps.iter_mut().try_for_each(|c| c.load(job_file.and_then(Path::parent)))?;
    let contact = job.weld.is_there().then(|| grinding(job, job_file)).transpose()?;
    Ok(Tool { head, clamps, slack_mm: 0.0, contact })
}

/// How the grinding tool of a job is led.
///
/// # Errors
/// Its file cannot be read or has absurd figures.
fn grinding(job: &Job, job_file: Option<&Path>) -> Result<Grinding, JobError> {
    let weld = &job.weld;
    let tool = match weld.tool.as_str() {
        "" => ContactTool::shipped(),
        file => ContactTool::load(&resolved(job_file, file))?,
    };
    let (lead_deg, arc_mm, force_n) = (weld.lead_deg, weld.arc_mm, weld.force_n);
    Ok(Grinding { tool, lead_deg, arc_mm, force_n, gouge_mm: weld.gouge_mm + job.path.chord_error_mm })
}

/// The cell that a job names, with the frames of its file.
///
/// # Errors
/// The file cannot be read or has absurd figures.
pub fn load_cell(job: &Job, job_file: Option<&Path>) -> Result<Cell, JobError> {
    Ok(match job.cell.file.as_str() {
        "" => Cell::shipped(cell_key(job))?,
        file => Cell::load(&resolved(job_file, file))?,
    })
}

/// Key of the shipped cell of a job that names no cell file: its robot's.
pub(super) fn cell_key(job: &Job) -> &str {
    if job.cell.robot.is_empty() { "mz04" } else { &job.cell.robot }
}

/// The robot in the cell, with the frames of the job in place of the cell's.
///
/// # Errors
/// The robot cannot stand there.
pub fn set_up(job: &Job, robot: Option<Robot>, mut cell: Cell, mut tool: Tool) -> Result<Setup, JobError> {
    job.cell.put_frames(&mut cell);
    let mount = job.cell.mount.unwrap_or(cell.mount);
    if mount == Mount::ToolInHand {
        // The part stands still in the cell, and what stands beside it is in the way of beam and head.
        let part_from_base = cell.base_from_part.isometry().inverse();
        tool.clamps.extend(cell.bodies.obstacles.iter().map(|o| o.seen_in(&part_from_base)));
    }
    let setup = Setup { cell, robot, mount, tool };
    setup.check()?;
    if mount == Mount::PartInHand {
        clear_of_obstacles(job, &setup)?;
    }
    Ok(setup)
}

/// A laser that stands still is blocked for good by what stands in its way.
fn clear_of_obstacles(job: &Job, setup: &Setup) -> Result<(), JobError> {
    let obstacles = &setup.cell.bodies.obstacles;
    let tool = Tool { clamps: obstacles.clone(), ..setup.tool.clone() };
    let (b, nothing) = (&job.beam, Part::default());
    let defocus_mm = tool.contact.as_ref().map_or(b.defocus_mm, |grinding| grinding.place().defocus_mm);
    let body = ToolGeometry::new(&tool, &job.optics, b.spot_mm, defocus_mm, b.margin_mm);
    let laser = setup.cell.base_from_laser.isometry();
    let a = laser.rotation * Vector3::z();
    let spot = Point3::from(laser.translation.vector) - a * defocus_mm;
    let blocker = BeamInterference::with(&nothing, body.as_ref()).blocker(&spot, &a);
    let Some(Blocker { tool_body, obstruction: Obstruction::Clamp(i), .. }) = blocker else { return Ok(()) };
    let obstacle = obstacles.get(i as usize).map_or(String::new(), |o| o.file.clone());
    Err(JobError::LaserBlocked { cell: setup.cell.name.clone(), obstacle, by: tool_body })
}
