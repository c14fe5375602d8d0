//! Every change of a job is an [`Edit`]; buttons, keys, menus, drag and drop and tests send the same.

use super::chosen::Chosen;
use super::model::{BeadParameters, FirstPlane, Job, JobCell};
use super::parameter::Parameter;
use super::recipe::Recipe;
use super::renumber::LostSettings;
use super::reshape::Cut;
use super::scan_carried;
use super::scan_edit::ScanEdit;
use super::settings::Settings;
use super::start_from::StartFrom;
use super::weld_edit::WeldEdit;
use crate::beam::Obstacle;
use crate::cell::{Mount, Spin};
use crate::part::{Placement, SurfaceEdit, SurfaceId, Units, Weld};
use crate::path::{Direction, Order, Strategy};
use crate::pose::{Correction, Pin, TiltRule};
use crate::process::Profile;
use std::mem::discriminant;

/// A change of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// A number of the parameter table, by its key in the job file; for one that cuts the surfaces anew see
    /// [`Edit::recut`].
    Set(&'static str, f64),
    /// Direction of the section planes.
    Direction(Direction),
    /// First plane.
    Offset(FirstPlane),
    /// Sense and order of lines.
    Order(Order),
    /// How lines are laid.
    Strategy(Strategy),
    /// Border that offset lines start from; `None`: the whole outline.
    Border(Option<u32>),
    /// Centre of a spiral, mm, part frame; `None`: the middle of the surface.
    Centre(Option<[f64; 3]>),
    /// Whether a spiral runs from the rim to its centre.
    Inward(bool),
    /// A recipe, in place of the one of its name if there is one, and surfaces that are worked with it
    /// from now on.
    Recipe(Box<Recipe>, Vec<SurfaceId>),
    /// A recipe goes; its surfaces are worked with the job's own values again.
    RemoveRecipe(String),
    /// A copy of a recipe under a free name, behind it; no surface has it yet.
    DuplicateRecipe(String),
    /// Another name for a recipe: from, to.
    RenameRecipe(String, String),
    /// Surfaces are worked with a recipe, which the job has from then on, or with the job's own values.
    GiveRecipe(Vec<SurfaceId>, Option<Box<Recipe>>),
    /// Correction.
    Correction(Correction),
    /// Surfaces to the end of *To clean*, also those that were put aside.
    Clean(Vec<SurfaceId>),
    /// Surfaces back out of it.
    Unclean(Vec<SurfaceId>),
    /// Surfaces up (−1) or down (1) in the order of work.
    Shift(Vec<SurfaceId>, i32),
    /// The whole list, in this order.
    Reorder(Vec<SurfaceId>),
    /// Surfaces become one, under the lowest of their numbers.
    Merge(Vec<SurfaceId>),
    /// A surface is cut again at a lower angle. See [`Edit::split`].
    Split {
        /// The surface.
        surface: SurfaceId,
        /// The local angle, degrees.
        angle_deg: f64,
        /// Numbers of what is cut off.
        made: Vec<SurfaceId>,
    },
    /// Facets of a surface become one of their own. See [`Edit::cut`].
    Cut(Cut),
    /// Surfaces are put aside for another job, after some of their facets were cut off for that. See
    /// [`Edit::aside`].
    Later {
        /// Cuts that make them surfaces of their own.
        cuts: Vec<Cut>,
        /// Their numbers.
        surfaces: Vec<SurfaceId>,
    },
    /// What was put aside comes back, and is not chosen by that: where a job cleans all, it cleans those that it
    /// did before. [`Edit::Clean`] chooses it as well.
    TakeBack(Vec<SurfaceId>),
    /// Angle, island area or hysteresis changed. See [`Edit::recut`].
    Recut {
        /// Key of the parameter.
        key: &'static str,
        /// Its new value.
        value: f64,
        /// Merges, splits and cuts that are still good.
        edits: Vec<SurfaceEdit>,
        /// What is said of the surfaces under their new numbers.
        settings: Settings,
        /// What was lost on the way.
        lost: Vec<LostSettings>,
    },
    /// A name for a surface; empty takes it away.
    Rename(SurfaceId, String),
    /// A name for several surfaces; each gets it with a number behind.
    RenameSeveral(Vec<SurfaceId>, String),
    /// What the offset lines of one surface start from; `None`: as recipe or job say.
    SurfaceBorder(SurfaceId, Option<StartFrom>),
    /// The centre of one surface's spiral, mm, part frame; `None`: as recipe or job say.
    SurfaceCentre(SurfaceId, Option<[f64; 3]>),
    /// The other side of a surface.
    FlipSurface(SurfaceId),
    /// The other side of a shell.
    FlipShell(u32),
    /// Where the part stands.
    Place(Placement),
    /// The unit of the file.
    Units(Units),
    /// Which corners of the part become one vertex. See [`Edit::weld`].
    Weld {
        /// Which.
        weld: Weld,
        /// Shells whose other side is to be worked on, by their new numbers.
        flipped_shells: Vec<u32>,
        /// Merges, splits and cuts that are still good.
        edits: Vec<SurfaceEdit>,
        /// What is said of the surfaces under their new numbers.
        settings: Settings,
        /// What was lost on the way.
        lost: Vec<LostSettings>,
    },
    /// The part's file has changed, or another is taken for it: the job for that. See
    /// [`CarriedOver`](super::CarriedOver).
    ChangedPart(Box<Job>),
    /// A cell file, as written in the job.
    Cell(String),
    /// Key or file of the robot, and the dialect that goes with it.
    Robot(String, String),
    /// What the robot carries.
    Mount(Mount),
    /// Where part and laser stand for this job.
    Frames(Box<JobCell>),
    /// Dialect of the program.
    Dialect(String),
    /// The bead that is laid, or that none is.
    Bead(BeadParameters),
    /// Rotation about the beam axis.
    Spin(Spin),
    /// A head file, as written in the job; empty takes it away.
    Head(String),
    /// What stands on the part.
    Clamps(Vec<Obstacle>),
    /// What a surface asks of the tilt.
    Tilt(SurfaceId, TiltRule),
    /// Tilts set on lines of one surface, in place of those there were.
    Pins(SurfaceId, Vec<Pin>),
    /// How the power is spread over the spot.
    Profile(Profile),
    /// The scan of the part.
    Scan(Box<ScanEdit>),
    /// The weld that is ground.
    Grind(Box<WeldEdit>),
}

/// What an edit changes a property of.
#[derive(PartialEq)]
enum Subject<'a> {
    Job,
    Parameter(&'a str),
    Recipe(&'a str),
    Surfaces(&'a [SurfaceId]),
    Shell(u32),
    Scan(&'a ScanEdit),
    Weld(&'a WeldEdit),
}

impl Edit {
    /// Whether two edits within one drag are one step of undo: they change one property of one subject.
    pub(super) fn goes_on_from(&self, earlier: &Edit) -> bool {
        match (self.subject(), earlier.subject()) {
            // Some values cut the surfaces anew, others do not.
            (Subject::Scan(now), Subject::Scan(before)) => now.goes_on_from(before),
            (Subject::Weld(now), Subject::Weld(before)) => now.goes_on_from(before),
            (now @ Subject::Parameter(_), before @ Subject::Parameter(_)) => now == before,
            (now, before) => discriminant(self) == discriminant(earlier) && now == before,
        }
    }

    fn subject(&self) -> Subject<'_> {
        match self {
            Edit::Set(key, _) | Edit::Recut { key, .. } => Subject::Parameter(key),
            Edit::Recipe(recipe, _) => Subject::Recipe(&recipe.name),
            Edit::RemoveRecipe(name) | Edit::DuplicateRecipe(name) | Edit::RenameRecipe(name, _) => {
                Subject::Recipe(name)
            }
            Edit::Clean(list)
            | Edit::Unclean(list)
            | Edit::Shift(list, _)
            | Edit::GiveRecipe(list, _)
            | Edit::RenameSeveral(list, _)
            | Edit::Merge(list)
            | Edit::Later { surfaces: list, .. }
            | Edit::TakeBack(list) => Subject::Surfaces(list),
            Edit::Split { surface: id, .. }
            | Edit::Cut(Cut { of: id, .. })
            | Edit::Rename(id, _)
            | Edit::SurfaceBorder(id, _)
            | Edit::SurfaceCentre(id, _)
            | Edit::FlipSurface(id)
            | Edit::Tilt(id, _)
            | Edit::Pins(id, _) => Subject::Surfaces(std::slice::from_ref(id)),
            Edit::FlipShell(shell) => Subject::Shell(*shell),
            Edit::Scan(edit) => Subject::Scan(edit),
            Edit::Grind(edit) => Subject::Weld(edit),
            Edit::Direction(_)
            | Edit::Offset(_)
            | Edit::Order(_)
            | Edit::Strategy(_)
            | Edit::Border(_)
            | Edit::Centre(_)
            | Edit::Inward(_)
            | Edit::Correction(_)
            | Edit::Reorder(_)
            | Edit::Place(_)
            | Edit::Units(_)
            | Edit::Weld { .. }
            | Edit::ChangedPart(_)
            | Edit::Cell(_)
            | Edit::Robot(..)
            | Edit::Mount(_)
            | Edit::Frames(_)
            | Edit::Dialect(_)
            | Edit::Bead(_)
            | Edit::Spin(_)
            | Edit::Head(_)
            | Edit::Clamps(_)
            | Edit::Profile(_) => Subject::Job,
        }
    }

    /// Applies it. `all` are the surfaces that exist, for a job that cleans all. Returns what surfaces lost because
    /// their facets are others now.
    pub fn apply(&self, job: &mut Job, all: &[SurfaceId]) -> Vec<LostSettings> {
        let settings = &mut job.settings;
        match self {
            Edit::Merge(list) => return job.merge(list, all),
            Edit::Split { surface, angle_deg, made } => return job.split(*surface, *angle_deg, made),
            Edit::Cut(cut) => return job.cut(std::slice::from_ref(cut)),
            Edit::Later { cuts, surfaces } => return job.put_aside(cuts, surfaces),
            Edit::Recut { key, value, edits, settings, lost } => {
                set(job, key, *value);
                job.surfaces.edits.clone_from(edits);
                job.settings.clone_from(settings);
                return lost.clone();
            }
            Edit::Weld { weld, flipped_shells, edits, settings, lost } => {
                job.part.weld = *weld;
                job.part.flipped_shells.clone_from(flipped_shells);
                job.surfaces.edits.clone_from(edits);
                job.settings.clone_from(settings);
                return lost.clone();
            }
            Edit::Clean(list) => settings.append(list, all),
            Edit::Unclean(list) => settings.remove(list, all),
            Edit::Shift(list, by) => settings.shift(list, *by, all),
            Edit::Reorder(list) => settings.choose(Chosen::These(list.clone())),
            Edit::TakeBack(list) => settings.take_back(list, all),
            Edit::Rename(id, name) => settings.change(*id, |s| s.name = name.trim().into()),
            Edit::RenameSeveral(list, name) => {
                for (at, id) in list.iter().enumerate() {
                    settings.change(*id, |s| s.name = format!("{} {}", name.trim(), at + 1));
                }
            }
            Edit::SurfaceBorder(id, border) => settings.change(*id, |s| s.border = *border),
            Edit::SurfaceCentre(id, centre) => settings.change(*id, |s| s.centre_mm = *centre),
            Edit::FlipSurface(id) => settings.change(*id, |s| s.flipped = !s.flipped),
            Edit::Tilt(id, rule) => settings.change(*id, |s| s.tilt.clone_from(rule)),
            Edit::Pins(id, pins) => settings.change(*id, |s| s.pins.clone_from(pins)),
            Edit::Recipe(recipe, list) | Edit::GiveRecipe(list, Some(recipe)) => job.put_recipe(recipe, list),
            Edit::GiveRecipe(list, None) => job.take_recipe(list),
            Edit::RemoveRecipe(name) => job.remove_recipe(name),
            Edit::DuplicateRecipe(name) => job.duplicate_recipe(name),
            Edit::RenameRecipe(from, to) => job.rename_recipe(from, to),
            Edit::Set(key, value) => set(job, key, *value),
            Edit::Direction(d) => job.layers.direction = *d,
            Edit::Offset(o) => job.layers.offset_mm = *o,
            Edit::Order(o) => job.layers.order = *o,
            Edit::Strategy(s) => job.layers.strategy = *s,
            Edit::Border(b) => job.layers.border = *b,
            Edit::Centre(c) => job.layers.centre_mm = *c,
            Edit::Inward(inward) => job.layers.inward = *inward,
            Edit::Correction(c) => job.path.correction = *c,
            Edit::FlipShell(n) => toggle(&mut job.part.flipped_shells, *n),
            Edit::Place(p) => {
                scan_carried::carry(&mut job.scan, &job.part.placement, p);
                job.part.placement = *p;
            }
            Edit::ChangedPart(changed) => job.clone_from(changed),
            Edit::Units(u) => job.part.units = *u,
            Edit::Cell(file) => job.cell.file.clone_from(file),
            Edit::Robot(robot, dialect) => {
                job.cell.robot.clone_from(robot);
                job.cell.dialect.clone_from(dialect);
            }
            Edit::Mount(mount) => job.cell.mount = Some(*mount),
            Edit::Frames(cell) => job.cell.take_frames(cell),
            Edit::Dialect(dialect) => job.cell.dialect.clone_from(dialect),
            Edit::Bead(bead) => job.bead.clone_from(bead),
            Edit::Spin(spin) => job.cell.spin = *spin,
            Edit::Head(file) => job.beam.head.clone_from(file),
            Edit::Clamps(clamps) => job.clamps.clone_from(clamps),
            Edit::Profile(profile) => job.dose.profile = *profile,
            Edit::Scan(edit) => edit.apply(&mut job.scan),
            Edit::Grind(edit) => edit.apply(&mut job.weld),
        }
        Vec::new()
    }
}

fn set(job: &mut Job, key: &str, value: f64) {
    if let Some(p) = Parameter::by_key(key) {
        job.set_number(p, value);
    }
}

fn toggle(list: &mut Vec<u32>, n: u32) {
    match list.iter().position(|&x| x == n) {
        Some(at) => {
            list.remove(at);
        }
        None => list.push(n),
    }
}
