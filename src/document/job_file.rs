//! The job as TOML. On disk everything that is said of single surfaces stands in lists by their numbers, which
//! people and scripts write; in memory it is [`Settings`].
//!
//! What a file of an older version means is told in `version`.

use super::chosen::Chosen;
use super::model::{BeadParameters, BeamParameters, CellFile, Job, Layers, PartFile, PathParameters, SurfaceTable};
use super::recipe::Recipe;
use super::settings::{Settings, SurfaceSettings};
use super::start_from::StartFrom;
use super::version;
use crate::beam::{Obstacle, Optics};
use crate::part::SurfaceId;
use crate::pose::tilt::Side;
use crate::pose::{Pin, Tilt, TiltRule};
use crate::process::DoseParameters;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// Why a text is no job.
#[derive(Debug, Error)]
pub enum JobFileError {
    /// It is no TOML, or has a key or value that no job has.
    #[error("{0}")]
    Toml(#[from] toml::de::Error),
    /// It is of a version that is not known yet.
    #[error(
        "version = {0}: the job was made by a later clearbeam, and this one knows jobs up to version {known}; \
         open it with a newer clearbeam",
        known = version::WRITTEN
    )]
    Later(i64),
    /// There is no such version.
    #[error("version = {0}: give {known}, or leave the line out for a job of version 1", known = version::WRITTEN)]
    NoVersion(String),
    /// A list names a surface twice.
    #[error("{key}: surface {surface} stands twice in the list; name it once")]
    Twice {
        /// Key of the list.
        key: &'static str,
        /// The surface.
        surface: SurfaceId,
    },
    /// A key that should be the number of a surface is none.
    #[error("{key}: {text:?} is no surface number; give a number like 4")]
    NoNumber {
        /// Key of the table.
        key: &'static str,
        /// What stands there.
        text: String,
    },
}

/// A job as its file has it, in the order of the file.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct JobFile {
    version: i64,
    part: PartFile,
    surfaces: SurfaceTable,
    clean: CleanTable,
    layers: Layers,
    beam: BeamParameters,
    optics: Optics,
    path: PathParameters,
    bead: BeadParameters,
    dose: DoseParameters,
    cell: CellFile,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    clamps: Vec<Obstacle>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    recipes: Vec<Recipe>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    recipe_of: BTreeMap<String, String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    tilts: Vec<TiltRow>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pins: Vec<PinRow>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    starts: Vec<StartRow>,
}

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct CleanTable {
    surfaces: Chosen,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    later: Vec<SurfaceId>,
}

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct TiltRow {
    surface: SurfaceId,
    preferred: Tilt,
    least_deg: f64,
    forbidden: Vec<Side>,
}

#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct PinRow {
    surface: SurfaceId,
    line: u32,
    at_mm: f64,
    tilt: Tilt,
}

/// Where the lines of one surface start.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct StartRow {
    surface: SurfaceId,
    #[serde(skip_serializing_if = "Option::is_none")]
    border: Option<StartFrom>,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre_mm: Option<[f64; 3]>,
}

/// Reads a job.
///
/// # Errors
/// Where in the text what is wrong.
pub fn parse(text: &str) -> Result<Job, JobFileError> {
    let table: toml::Table = toml::from_str(text)?;
    version::of(&table)?;
    // The text knows its lines, which the table does not.
    toml::from_str::<JobFile>(text)?;
    Job::try_from(table)
}

impl TryFrom<toml::Table> for Job {
    type Error = JobFileError;

    fn try_from(mut table: toml::Table) -> Result<Job, JobFileError> {
        let version = version::of(&table)?;
        version::grant(version, &mut table)?;
        let file: JobFile = table.try_into()?;
        let settings = file.settings(version)?;
        Ok(Job {
            part: file.part,
            surfaces: file.surfaces.into_parameters(),
            settings,
            layers: file.layers,
            beam: file.beam,
            optics: file.optics,
            path: file.path,
            bead: file.bead,
            dose: file.dose,
            cell: file.cell,
            clamps: file.clamps,
            recipes: file.recipes,
        })
    }
}

impl JobFile {
    /// The lists by surface. In a job of version 1 a second rule for a surface is passed over, as it always was.
    fn settings(&self, version: i64) -> Result<Settings, JobFileError> {
        let mut of: BTreeMap<SurfaceId, SurfaceSettings> = BTreeMap::new();
        if let Some(surface) = self.clean.surfaces.twice() {
            return Err(JobFileError::Twice { key: "clean.surfaces", surface });
        }
        if let Chosen::These(list) = &self.clean.surfaces {
            (0..).zip(list).for_each(|(place, id)| of.entry(*id).or_default().work = Some(place));
        }
        self.clean.later.iter().for_each(|id| of.entry(*id).or_default().later = true);
        self.surfaces.flipped.iter().for_each(|id| of.entry(*id).or_default().flipped = true);
        for (text, name) in &self.surfaces.names {
            of.entry(id_of("surfaces.names", text)?).or_default().name.clone_from(name);
        }
        for (text, recipe) in &self.recipe_of {
            of.entry(id_of("recipe_of", text)?).or_default().recipe = Some(recipe.clone());
        }
        let mut ruled = BTreeSet::new();
        for t in &self.tilts {
            if ruled.insert(t.surface) {
                let rule = TiltRule { preferred: t.preferred, least_deg: t.least_deg, forbidden: t.forbidden.clone() };
                of.entry(t.surface).or_default().tilt = rule;
            } else if version > 1 {
                return Err(JobFileError::Twice { key: "tilts", surface: t.surface });
            }
        }
        for p in &self.pins {
            of.entry(p.surface).or_default().pins.push(Pin { line: p.line, at_mm: p.at_mm, tilt: p.tilt });
        }
        let mut started = BTreeSet::new();
        for s in &self.starts {
            if !started.insert(s.surface) {
                return Err(JobFileError::Twice { key: "starts", surface: s.surface });
            }
            let own = of.entry(s.surface).or_default();
            (own.border, own.centre_mm) = (s.border, s.centre_mm);
        }
        Ok(Settings::new(self.clean.surfaces == Chosen::All, of))
    }
}

/// The surface that a key names.
fn id_of(key: &'static str, text: &str) -> Result<SurfaceId, JobFileError> {
    let number = text.parse().ok().filter(|n: &u32| n.to_string() == text);
    number.map(SurfaceId).ok_or_else(|| JobFileError::NoNumber { key, text: text.into() })
}

impl From<Job> for JobFile {
    fn from(job: Job) -> JobFile {
        let all = &job.settings;
        let silent = TiltRule::default();
        let tilts = all.iter().filter(|(_, s)| s.tilt != silent).map(|(surface, s)| {
            let TiltRule { preferred, least_deg, forbidden } = s.tilt.clone();
            TiltRow { surface, preferred, least_deg, forbidden }
        });
        let pin = |surface, p: &Pin| PinRow { surface, line: p.line, at_mm: p.at_mm, tilt: p.tilt };
        let starts = all.iter().filter(|(_, s)| s.border.is_some() || s.centre_mm.is_some());
        JobFile {
            version: version::WRITTEN,
            surfaces: SurfaceTable::new(&job.surfaces, all),
            clean: CleanTable { surfaces: all.choice(), later: all.having(|s| s.later) },
            recipe_of: all.iter().filter_map(|(id, s)| Some((id.to_string(), s.recipe.clone()?))).collect(),
            tilts: tilts.collect(),
            pins: all.iter().flat_map(|(id, s)| s.pins.iter().map(move |p| pin(id, p))).collect(),
            starts: starts.map(|(surface, s)| StartRow { surface, border: s.border, centre_mm: s.centre_mm }).collect(),
            part: job.part,
            layers: job.layers,
            beam: job.beam,
            optics: job.optics,
            path: job.path,
            bead: job.bead,
            dose: job.dose,
            cell: job.cell,
            clamps: job.clamps,
            recipes: job.recipes,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str, said: &[&str]) {
        let why = parse(text).expect_err(text).to_string();
        assert!(said.iter().all(|part| why.contains(part)), "{text}: {why}");
        assert!(toml::from_str::<Job>(text).is_err(), "{text}");
    }

    #[test]
    fn what_is_wrong_is_named() {
        refused("[layers]\nspaceing_mm = 2", &["line 2", "spaceing_mm"]);
        refused("[clean]\nsurfaces = [4, 1, 4]", &["clean.surfaces", "surface 4 stands twice", "name it once"]);
        refused("[surfaces.names]\nfour = \"Rim\"", &["surfaces.names", "\"four\"", "give a number"]);
        refused("[recipe_of]\n04 = \"Fine\"", &["recipe_of", "\"04\""]);
        refused("[[starts]]\nsurface = 1\n[[starts]]\nsurface = 1", &["starts: surface 1 stands twice"]);
        refused("[[starts]]\nborder = 1", &["line 1", "surface"]);
        refused("[[starts]]\nsurface = 1\nborder = \"all\"", &["line 3", "whole outline"]);
    }
}
