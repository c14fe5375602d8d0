//! Every change of a job is an [`Edit`]; buttons, keys, menus, drag and drop and tests send the same.

use super::model::{BeadParameters, CellFile, Chosen, Job, Offset};
use super::parameter::Parameter;
use super::recipe::Recipe;
use crate::beam::Obstacle;
use crate::cell::{Mount, Spin};
use crate::part::{Placement, SurfaceEdit, Surfaces, Units};
use crate::path::{Direction, Order, Strategy};
use crate::pose::{Correction, Pin, TiltRule};
use crate::process::{Patch, Profile};
use std::collections::BTreeMap;

/// A change of the document.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// A number of the parameter table, by its key in the job file.
    Set(&'static str, f64),
    /// Direction of the section planes.
    Direction(Direction),
    /// First plane.
    Offset(Offset),
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
    Recipe(Box<Recipe>, Vec<u32>),
    /// A recipe goes; its surfaces are worked with the job's own values again.
    RemoveRecipe(String),
    /// A copy of a recipe under a free name, behind it; no surface has it yet.
    DuplicateRecipe(String),
    /// Another name for a recipe: from, to.
    RenameRecipe(String, String),
    /// Surfaces are worked with a recipe, which the job has from then on, or with the job's own values.
    GiveRecipe(Vec<u32>, Option<Box<Recipe>>),
    /// Correction.
    Correction(Correction),
    /// Surfaces to the end of *To clean*.
    Clean(Vec<u32>),
    /// Surfaces back out of it.
    Unclean(Vec<u32>),
    /// Surfaces up (−1) or down (1) in the order of work.
    Shift(Vec<u32>, i32),
    /// The whole list, in this order.
    Reorder(Vec<u32>),
    /// A merge, a split or a cut of surfaces. After a split its pieces have no recipe: see [`Edit::split`].
    Surfaces(SurfaceEdit),
    /// A surface is cut again at a lower angle, and what is cut off it keeps its recipe. See [`Edit::split`].
    Split {
        /// The surface.
        surface: u32,
        /// The local angle, degrees.
        angle_deg: f64,
        /// Numbers of what is cut off.
        made: Vec<u32>,
    },
    /// Surfaces are put aside for another job, after some of their facets were cut off for that; back
    /// they come by [`Edit::Clean`]. See [`Edit::aside`].
    Later {
        /// Cuts that make them surfaces of their own.
        cuts: Vec<SurfaceEdit>,
        /// Their numbers.
        surfaces: Vec<u32>,
    },
    /// Angle, island area or hysteresis changed: its number, and what *To clean* and flipped
    /// surfaces are called afterwards. Merges and splits were made on other numbers and are gone.
    Recut {
        /// Key of the parameter.
        key: &'static str,
        /// Its new value.
        value: f64,
        /// The surfaces to clean by their new numbers.
        clean: Vec<u32>,
        /// The flipped ones.
        flipped: Vec<u32>,
        /// Their recipes.
        recipe_of: BTreeMap<String, String>,
    },
    /// A name for a surface; empty takes it away.
    Rename(u32, String),
    /// The other side of a surface.
    FlipSurface(u32),
    /// The other side of a shell.
    FlipShell(u32),
    /// Where the part stands.
    Place(Placement),
    /// The unit of the file.
    Units(Units),
    /// A cell file, as written in the job.
    Cell(String),
    /// Key or file of the robot, and the dialect that goes with it.
    Robot(String, String),
    /// What the robot carries.
    Mount(Mount),
    /// Where part and laser stand for this job.
    Frames(Box<CellFile>),
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
    /// What a surface asks of the tilt; one that asks nothing is taken away.
    Tilt(TiltRule),
    /// Tilts set on lines of one surface, in place of those there were.
    Pins(u32, Vec<Pin>),
    /// How the power is spread over the spot.
    Profile(Profile),
}

impl Edit {
    /// What *Undo* calls it.
    pub fn name(&self) -> String {
        let some = |list: &[u32]| match list {
            [one] => format!("surface {one}"),
            many => format!("{} surfaces", many.len()),
        };
        match self {
            Edit::Set(key, _) | Edit::Recut { key, .. } => {
                let label = Parameter::by_key(key).map_or(*key, |p| p.label);
                format!("change {}", label.to_lowercase())
            }
            Edit::Direction(_) => "change direction".into(),
            Edit::Offset(_) => "change first offset".into(),
            Edit::Order(_) => "change order".into(),
            Edit::Strategy(_) => "change strategy".into(),
            Edit::Border(_) => "change border".into(),
            Edit::Centre(_) => "change spiral centre".into(),
            Edit::Inward(_) => "turn spiral".into(),
            Edit::Recipe(recipe, _) => format!("change recipe {}", recipe.name),
            Edit::RemoveRecipe(name) => format!("remove recipe {name}"),
            Edit::DuplicateRecipe(name) => format!("duplicate recipe {name}"),
            Edit::RenameRecipe(from, _) => format!("rename recipe {from}"),
            Edit::GiveRecipe(list, Some(recipe)) => format!("give {} recipe {}", some(list), recipe.name),
            Edit::GiveRecipe(list, None) => format!("take recipe of {} away", some(list)),
            Edit::Correction(_) => "change correction".into(),
            Edit::Clean(list) => format!("move {} to clean", some(list)),
            Edit::Unclean(list) => format!("move {} back", some(list)),
            Edit::Shift(list, _) => format!("move {} in the order", some(list)),
            Edit::Reorder(_) => "change order of work".into(),
            Edit::Surfaces(SurfaceEdit::Merge { merge }) => format!("merge {}", some(merge)),
            Edit::Surfaces(SurfaceEdit::Split { split: n, .. }) | Edit::Split { surface: n, .. } => {
                format!("split surface {n}")
            }
            Edit::Surfaces(SurfaceEdit::Cut { cut, facets }) => {
                format!("cut {} facets off surface {cut}", facets.len())
            }
            Edit::Later { surfaces, .. } => format!("put {} aside", some(surfaces)),
            Edit::Rename(n, _) => format!("rename surface {n}"),
            Edit::FlipSurface(n) => format!("flip surface {n}"),
            Edit::FlipShell(n) => format!("flip shell {n}"),
            Edit::Place(_) => "place part".into(),
            Edit::Units(_) => "change unit".into(),
            Edit::Cell(_) => "change cell".into(),
            Edit::Robot(..) => "change robot".into(),
            Edit::Mount(_) => "change mounting".into(),
            Edit::Frames(_) => "change set-up".into(),
            Edit::Dialect(_) => "change dialect".into(),
            Edit::Bead(_) => "change bead".into(),
            Edit::Spin(_) => "change spin".into(),
            Edit::Head(file) if file.is_empty() => "take the head away".into(),
            Edit::Head(_) => "change head".into(),
            Edit::Clamps(_) => "change clamps".into(),
            Edit::Tilt(rule) => format!("change tilt of surface {}", rule.surface),
            Edit::Pins(surface, _) => format!("change pinned tilts of surface {surface}"),
            Edit::Profile(_) => "change beam profile".into(),
        }
    }

    /// Puts patches that no light comes to aside: each becomes a surface of its own, or the whole surface
    /// where nothing of it would be left. A gap between lines stays: it is a matter of spacing, not of another
    /// job. `None` where no such patch holds the larger half of any facet.
    pub fn aside(patches: &[Patch], surfaces: &Surfaces) -> Option<Edit> {
        let (mut cuts, mut numbers) = (Vec::new(), Vec::new());
        let mut left: BTreeMap<u32, usize> = BTreeMap::new();
        for patch in patches.iter().filter(|p| p.cause.keeps_light_away() && !p.facets.is_empty()) {
            let Some(surface) = surfaces.get(patch.surface) else { continue };
            let left = left.entry(patch.surface).or_insert(surface.facets.len());
            *left = left.saturating_sub(patch.facets.len());
            if *left == 0 {
                numbers.push(patch.surface);
            } else {
                cuts.push(SurfaceEdit::Cut { cut: patch.surface, facets: patch.facets.clone() });
                numbers.push(surfaces.last_number + cuts.len() as u32);
            }
        }
        (!numbers.is_empty()).then_some(Edit::Later { cuts, surfaces: numbers })
    }

    /// Applies it. `all` are the numbers of the surfaces that exist, for a job that cleans all.
    pub fn apply(&self, job: &mut Job, all: &[u32]) {
        match self {
            Edit::Set(key, value) => {
                if let Some(p) = Parameter::by_key(key) {
                    (p.set)(job, *value);
                }
            }
            Edit::Direction(d) => job.layers.direction = *d,
            Edit::Offset(o) => job.layers.offset_mm = *o,
            Edit::Order(o) => job.layers.order = *o,
            Edit::Strategy(s) => job.layers.strategy = *s,
            Edit::Border(b) => job.layers.border = *b,
            Edit::Centre(c) => job.layers.centre_mm = *c,
            Edit::Inward(inward) => job.layers.inward = *inward,
            Edit::Recipe(recipe, surfaces) | Edit::GiveRecipe(surfaces, Some(recipe)) => {
                job.put_recipe(recipe, surfaces);
            }
            Edit::GiveRecipe(surfaces, None) => job.take_recipe(surfaces),
            Edit::RemoveRecipe(name) => job.remove_recipe(name),
            Edit::DuplicateRecipe(name) => job.duplicate_recipe(name),
            Edit::RenameRecipe(from, to) => job.rename_recipe(from, to),
            Edit::Correction(c) => job.path.correction = *c,
            Edit::Clean(list) => {
                change_list(job, all, |clean| {
                    clean.retain(|n| !list.contains(n));
                    clean.extend(list);
                });
                job.clean.later.retain(|n| !list.contains(n));
            }
            Edit::Unclean(list) => change_list(job, all, |clean| clean.retain(|n| !list.contains(n))),
            Edit::Shift(list, by) => change_list(job, all, |clean| shift(clean, list, *by)),
            Edit::Reorder(list) => job.clean.surfaces = Chosen::These(list.clone()),
            Edit::Surfaces(edit) => {
                job.surfaces.edits.push(edit.clone());
                if let SurfaceEdit::Merge { merge } = edit {
                    merged(job, all, merge);
                }
            }
            Edit::Split { surface, angle_deg, made } => {
                job.surfaces.edits.push(SurfaceEdit::Split { split: *surface, angle_deg: *angle_deg });
                job.keep_recipe(*surface, made);
            }
            Edit::Later { cuts, surfaces } => {
                job.surfaces.edits.extend(cuts.iter().cloned());
                job.keep_recipes_of_cuts(cuts, surfaces);
                job.clean.later.extend(surfaces.iter().filter(|n| !job.clean.later.contains(n)).collect::<Vec<_>>());
                if let Chosen::These(list) = &mut job.clean.surfaces {
                    list.retain(|n| !surfaces.contains(n));
                }
            }
            Edit::Recut { key, value, clean, flipped, recipe_of } => {
                Edit::Set(key, *value).apply(job, all);
                job.surfaces.edits.clear();
                job.surfaces.names.clear();
                job.clean.later.clear();
                job.surfaces.flipped = flipped.clone();
                job.recipe_of.clone_from(recipe_of);
                if job.clean.surfaces != Chosen::All {
                    job.clean.surfaces = Chosen::These(clean.clone());
                }
            }
            Edit::Rename(n, name) => {
                if name.trim().is_empty() {
                    job.surfaces.names.remove(&n.to_string());
                } else {
                    job.surfaces.names.insert(n.to_string(), name.trim().into());
                }
            }
            Edit::FlipSurface(n) => toggle(&mut job.surfaces.flipped, *n),
            Edit::FlipShell(n) => toggle(&mut job.part.flipped_shells, *n),
            Edit::Place(p) => job.part.placement = *p,
            Edit::Units(u) => job.part.units = *u,
            Edit::Cell(file) => job.cell.file = file.clone(),
            Edit::Robot(robot, dialect) => {
                job.cell.robot = robot.clone();
                job.cell.dialect = dialect.clone();
            }
            Edit::Mount(mount) => job.cell.mount = Some(*mount),
            Edit::Frames(cell) => {
                job.cell.flange_from_part.clone_from(&cell.flange_from_part);
                job.cell.base_from_laser.clone_from(&cell.base_from_laser);
                job.cell.base_from_part.clone_from(&cell.base_from_part);
            }
            Edit::Dialect(dialect) => job.cell.dialect = dialect.clone(),
            Edit::Bead(bead) => job.bead.clone_from(bead),
            Edit::Spin(spin) => job.cell.spin = *spin,
            Edit::Head(file) => job.beam.head.clone_from(file),
            Edit::Clamps(clamps) => job.clamps.clone_from(clamps),
            Edit::Tilt(rule) => {
                job.tilts.retain(|t| t.surface != rule.surface);
                let asks_nothing = *rule == TiltRule { surface: rule.surface, ..TiltRule::default() };
                if !asks_nothing {
                    job.tilts.push(rule.clone());
                    job.tilts.sort_by_key(|t| t.surface);
                }
            }
            Edit::Pins(surface, pins) => {
                job.pins.retain(|p| p.surface != *surface);
                job.pins.extend(pins);
            }
            Edit::Profile(profile) => job.dose.profile = *profile,
        }
    }
}

fn change_list(job: &mut Job, all: &[u32], change: impl FnOnce(&mut Vec<u32>)) {
    let mut list = job.clean.surfaces.numbers(all.iter().copied());
    change(&mut list);
    job.clean.surfaces = Chosen::These(list);
}

/// Moves the marked ones by one place, as a block, keeping their order.
fn shift(list: &mut [u32], marked: &[u32], by: i32) {
    let count = list.len();
    let step = |i: usize| if by < 0 { i.checked_sub(1) } else { (i + 1 < count).then_some(i + 1) };
    let order: Vec<usize> = if by < 0 { (0..count).collect() } else { (0..count).rev().collect() };
    for i in order {
        if let Some(to) = step(i)
            && marked.contains(&list[i])
            && !marked.contains(&list[to])
        {
            list.swap(i, to);
        }
    }
}

/// After a merge the kept number stands for all: it is cleaned if any of them was.
fn merged(job: &mut Job, all: &[u32], merge: &[u32]) {
    let Some(&keep) = merge.iter().min() else { return };
    job.clean.later.retain(|n| !merge.contains(n));
    merge.iter().filter(|n| **n != keep).for_each(|n| drop(job.recipe_of.remove(&n.to_string())));
    if job.clean.surfaces == Chosen::All {
        return;
    }
    change_list(job, all, |clean| {
        if let Some(at) = clean.iter().position(|n| merge.contains(n)) {
            clean[at] = keep;
            let mut seen = false;
            clean.retain(|n| !merge.contains(n) || (*n == keep && !std::mem::replace(&mut seen, true)));
        }
    });
}

fn toggle(list: &mut Vec<u32>, n: u32) {
    match list.iter().position(|&x| x == n) {
        Some(at) => {
            list.remove(at);
        }
        None => list.push(n),
    }
}
