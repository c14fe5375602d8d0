//! The options of `plan`, and how they override a job.

use super::Failure;
use crate::cell::{Mount, Spin};
use crate::document::{Chosen, Edit, Job, Offset, Parameter, RecutAnchor, segmented};
use crate::part::{Source, Units};
use crate::path::{Direction, DirectionError, Order, Strategy};
use crate::pose::Correction;
use crate::progress::Progress;
use crate::text::Sentence as _;
use std::path::PathBuf;
use std::sync::Arc;

/// What can be overridden; what is not given stays as in the job, or its default.
#[derive(clap::Args, Clone, Debug, Default)]
pub struct PlanOptions {
    /// Unit of the file: mm, m or inch [default: mm]
    #[arg(long, value_parser = units)]
    units: Option<Units>,
    /// Crease angle, degrees [default: 20]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    angle: Option<f64>,
    /// Surfaces to clean, in the order of work: all, or numbers like 4,1 [default: all]
    #[arg(long, value_name = "LIST", value_parser = surfaces)]
    surfaces: Option<Chosen>,
    /// Normal of the section planes: x, y, z, auto or DX,DY,DZ [default: z]
    #[arg(long, allow_hyphen_values = true, value_parser = direction)]
    direction: Option<Direction>,
    /// Distance of the section planes, mm [default: 0.5]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    spacing: Option<f64>,
    /// Lines: planes, adaptive, offset, spiral or cross [default: planes]
    #[arg(long, value_parser = strategy)]
    strategy: Option<Strategy>,
    /// Overlap of neighbouring spots (of beads, where they are told), per cent, in place of the spacing
    #[arg(long, value_name = "%", allow_negative_numbers = true, conflicts_with = "spacing")]
    overlap: Option<f64>,
    /// What lines keep from the rim of a surface, mm; negative: run over it [default: 0]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    inset: Option<f64>,
    /// How often a surface is gone over [default: 1]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    passes: Option<f64>,
    /// First plane above the lowest point, mm, or centred [default: centred]
    #[arg(long, value_name = "MM", allow_negative_numbers = true, value_parser = offset)]
    offset: Option<Offset>,
    /// zigzag, one-way or shortest [default: zigzag]
    #[arg(long, value_parser = order)]
    order: Option<Order>,
    /// Focus above the surface, mm [default: 20]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    defocus: Option<f64>,
    /// Largest distance of the surface from a straight move, mm [default: 0.02]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    chord_error: Option<f64>,
    /// Longest move between two targets, mm [default: 5]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    max_step: Option<f64>,
    /// Largest turn of the normal between two targets, degrees [default: 5]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    max_turn: Option<f64>,
    /// section-plane, clearance or none [default: section-plane]
    #[arg(long, value_parser = correction)]
    correction: Option<Correction>,
    /// Speed of the spot, mm/s [default: 3]
    #[arg(long, value_name = "MM/S", allow_negative_numbers = true)]
    speed: Option<f64>,
    /// Speed with the laser off, mm/s [default: 100]
    #[arg(long, value_name = "MM/S", allow_negative_numbers = true)]
    air_speed: Option<f64>,
    /// Laser power, W [default: 500]
    #[arg(long, value_name = "W", allow_negative_numbers = true)]
    power: Option<f64>,
    /// Spot diameter, mm [default: 1]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    spot: Option<f64>,
    /// Greatest angle between beam and normal, degrees [default: 45]
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    max_tilt: Option<f64>,
    /// What cone and head keep from everything, mm [default: 0.5]
    #[arg(long, value_name = "MM", allow_negative_numbers = true)]
    margin: Option<f64>,
    /// Head: a TOML stack (part: from_mm to_mm r0_mm r1_mm, from the focus on), or an STL [default: the ray alone]
    #[arg(long, value_name = "FILE")]
    head: Option<PathBuf>,
    /// Cell file [default: the shipped cell of the robot]
    #[arg(long, value_name = "CELL.toml")]
    cell: Option<PathBuf>,
    /// Robot: mz04 mz07f kr6-r900 irb120 irb1200 irb2400 lrmate200id m10ia tx2-60 gp7 gp8 ur5e, or a
    /// robot file [default: none, poses only]
    #[arg(long, value_name = "NAME")]
    robot: Option<String>,
    /// What the robot carries: part-in-hand or tool-in-hand [default: part-in-hand, or as the cell says]
    #[arg(long, value_parser = mount)]
    mount: Option<Mount>,
    /// Program: nachi kuka abb fanuc ur yaskawa estun csv [default: nachi]
    #[arg(long, value_name = "NAME")]
    dialect: Option<String>,
    /// Rotation about the beam: free or travel [default: free]
    #[arg(long, value_parser = spin)]
    spin: Option<Spin>,
}

impl PlanOptions {
    /// Writes the given options into a job on the part that was read from `source`.
    ///
    /// # Errors
    /// A number that is out of range; the part cannot be cut by it.
    pub fn apply(&self, job: &mut Job, source: &Source) -> Result<(), Failure> {
        let numbers = [
            ("angle", self.angle),
            ("spacing", self.spacing),
            ("defocus", self.defocus),
            ("chord-error", self.chord_error),
            ("max-step", self.max_step),
            ("max-turn", self.max_turn),
            ("speed", self.speed),
            ("air-speed", self.air_speed),
            ("power", self.power),
            ("spot", self.spot),
            ("max-tilt", self.max_tilt),
            ("margin", self.margin),
            ("inset", self.inset),
            ("passes", self.passes),
        ];
        for (option, value) in numbers {
            if let (Some(p), Some(value)) = (Parameter::by_option(option), value) {
                p.check(value).map_err(|why| Failure::Usage(format!("--{why}")))?;
                if p.recuts && job.settings.iter().next().is_some() {
                    recut(job, source, p, value)?;
                } else {
                    (p.set)(job, value);
                }
            }
        }
        if let Some(percent) = self.overlap {
            job.layers.spacing_mm = job.spacing_of_overlap(percent).map_err(Failure::Usage)?;
        }
        job.layers.strategy = self.strategy.unwrap_or(job.layers.strategy);
        if let Some(list) = &self.surfaces {
            job.settings.choose(list.clone());
        }
        job.part.units = self.units.unwrap_or(job.part.units);
        job.layers.direction = self.direction.unwrap_or(job.layers.direction);
        job.layers.offset_mm = self.offset.unwrap_or(job.layers.offset_mm);
        job.layers.order = self.order.unwrap_or(job.layers.order);
        job.path.correction = self.correction.unwrap_or(job.path.correction);
        job.cell.mount = self.mount.or(job.cell.mount);
        job.cell.spin = self.spin.unwrap_or(job.cell.spin);
        if let Some(dialect) = &self.dialect {
            job.cell.dialect.clone_from(dialect);
        }
        crate::document::parameter::check_all(job).map_err(Failure::Usage)
    }

    /// Key of a shipped robot, or a robot file as seen from the current folder.
    pub fn robot(&self) -> Option<&String> {
        self.robot.as_ref()
    }

    /// The head's file, as seen from the current folder.
    pub fn head(&self) -> Option<&PathBuf> {
        self.head.as_ref()
    }

    /// The cell file, as seen from the current folder.
    pub fn cell(&self) -> Option<&PathBuf> {
        self.cell.as_ref()
    }
}

/// Cuts the surfaces anew as the window does: what the job says of them is carried over to their new numbers.
fn recut(job: &mut Job, source: &Source, p: &Parameter, value: f64) -> Result<(), Failure> {
    let of = &job.part;
    let built = source.part(of.units, &of.placement, &of.flipped_shells, &Progress::default());
    // Nobody can have cancelled it.
    let part = built.map_err(Failure::failed)?.unwrap_or_default();
    let anchor = RecutAnchor { job: job.clone(), surfaces: Arc::new(segmented(&part, job)) };
    for lost in Edit::recut(&part, &anchor, p, value).apply(job, &[]) {
        eprintln!("{lost}");
    }
    Ok(())
}

fn word<T>(text: &str, parsed: Option<T>, words: &str) -> Result<T, String> {
    parsed.ok_or_else(|| format!("{text:?}: give {words}"))
}

pub(super) fn units(text: &str) -> Result<Units, String> {
    word(text, Units::from_word(text), "mm, m or inch")
}

fn order(text: &str) -> Result<Order, String> {
    word(text, Order::from_word(text), "zigzag, one-way or shortest")
}

fn strategy(text: &str) -> Result<Strategy, String> {
    word(text, Strategy::from_word(text), "planes, adaptive, offset, spiral or cross")
}

fn correction(text: &str) -> Result<Correction, String> {
    word(text, Correction::from_word(text), "section-plane, clearance or none")
}

fn mount(text: &str) -> Result<Mount, String> {
    word(text, Mount::from_word(text), "part-in-hand or tool-in-hand")
}

fn spin(text: &str) -> Result<Spin, String> {
    word(text, Spin::from_word(text), "free or travel")
}

fn direction(text: &str) -> Result<Direction, String> {
    text.parse().map_err(|e: DirectionError| e.sentence())
}

fn offset(text: &str) -> Result<Offset, String> {
    if text == "centred" {
        return Ok(Offset::Centred);
    }
    word(text, text.parse().ok().filter(|x: &f64| x.is_finite()).map(Offset::FromLowest), "a number of mm, or centred")
}

fn surfaces(text: &str) -> Result<Chosen, String> {
    if text == "all" {
        return Ok(Chosen::All);
    }
    let list: Result<Vec<u32>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let chosen: Chosen = word(text, list.ok(), "all, or surface numbers like 4,1")?.into();
    match chosen.twice() {
        Some(surface) => Err(format!("surface {surface} stands twice in the list; name it once")),
        None => Ok(chosen),
    }
}
