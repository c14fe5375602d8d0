//! The job as TOML. On disk everything that is said of single surfaces stands in lists by their numbers, which
//! people and scripts write; in memory it is [`Settings`].
//!
//! What a file of an older version means is told in `version`.

mod error;
mod limits;
mod tables;
mod version;

pub use error::JobFileError;
pub use limits::FARTHEST_MM;
pub use version::WRITTEN;

use super::chosen::Chosen;
use super::model::{
    BeadParameters, BeamParameters, Job, JobCell, JobPart, JobScan, JobWeld, LineParameters, PathParameters,
    SurfaceTable,
};
use super::recipe::Recipe;
use super::settings::{Settings, SurfaceSettings};
use crate::beam::{Obstacle, Optics};
use crate::cell::frame;
use crate::file;
use crate::part::SurfaceId;
use crate::pose::{Pin, TiltRule};
use crate::process::DoseParameters;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use std::collections::{BTreeMap, BTreeSet};
use tables::{CleanTable, PinRow, StartRow, TiltRow};

/// A job as its file has it, in the order of the file.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct JobTables {
    version: i64,
    part: JobPart,
    scan: JobScan,
    weld: JobWeld,
    surfaces: SurfaceTable,
    clean: CleanTable,
    layers: LineParameters,
    beam: BeamParameters,
    optics: Optics,
    path: PathParameters,
    bead: BeadParameters,
    dose: DoseParameters,
    cell: JobCell,
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

/// The job that the bytes of a file hold.
///
/// # Errors
/// They are no job (with line and column).
pub fn from_bytes(bytes: &[u8]) -> Result<Job, JobFileError> {
    parse(file::decode(bytes)?)
}

/// The job that a text holds.
///
/// # Errors
/// Where in the text what is wrong; a number that is out of its range as well. What numbers must be together is looked
/// at when the job is planned: a job may be saved before it is whole.
pub fn parse(text: &str) -> Result<Job, JobFileError> {
    let table: toml::Table = file::read_toml(text).map_err(Box::new)?;
    let in_line = |e: JobFileError| limits::in_line(text, e);
    version::of(&table).map_err(in_line)?;
    for with_frames in ["cell", "scan"].into_iter().filter_map(|key| table.get(key)?.as_table()) {
        frame::check(with_frames).map_err(|e| in_line(e.into()))?;
    }
    // The text knows its lines, which the table does not.
    file::read_toml::<JobTables>(text).map_err(Box::new)?;
    let job = Job::try_from(table).map_err(in_line)?;
    limits::check(&job, text)?;
    Ok(job)
}

impl TryFrom<toml::Table> for Job {
    type Error = JobFileError;

    fn try_from(mut table: toml::Table) -> Result<Job, JobFileError> {
        let version = version::of(&table)?;
        version::fill_defaults(&mut table)?;
        let file: JobTables = table.try_into()?;
        let settings = file.settings(version)?;
        Ok(Job {
            part: file.part,
            scan: file.scan,
            weld: file.weld,
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

impl<'de> Deserialize<'de> for Job {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        Job::try_from(toml::Table::deserialize(d)?).map_err(D::Error::custom)
    }
}

impl Serialize for Job {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        JobTables::from(self.clone()).serialize(s)
    }
}

impl JobTables {
    /// What the lists say, by surface. In a job of version 1 a second tilt rule for a surface is passed over, as it
    /// always was.
    fn settings(&self, version: i64) -> Result<Settings, JobFileError> {
        let mut of: BTreeMap<SurfaceId, SurfaceSettings> = BTreeMap::new();
        if let Some(surface) = self.clean.surfaces.repeated() {
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
            let settings = of.entry(s.surface).or_default();
            (settings.border, settings.centre_mm) = (s.border, s.centre_mm);
        }
        Ok(Settings::new(self.clean.surfaces == Chosen::All, of))
    }
}

/// The surface that a key names.
fn id_of(key: &'static str, text: &str) -> Result<SurfaceId, JobFileError> {
    let number = text.parse().ok().filter(|n: &u32| n.to_string() == text);
    number.map(SurfaceId).ok_or_else(|| JobFileError::NoNumber { key, text: text.into() })
}

impl From<Job> for JobTables {
    fn from(job: Job) -> JobTables {
        let all = &job.settings;
        let free = TiltRule::default();
        let tilts = all.iter().filter(|(_, s)| s.tilt != free).map(|(surface, s)| {
            let TiltRule { preferred, least_deg, forbidden } = s.tilt.clone();
            TiltRow { surface, preferred, least_deg, forbidden }
        });
        let pin = |surface, p: &Pin| PinRow { surface, line: p.line, at_mm: p.at_mm, tilt: p.tilt };
        let starts = all.iter().filter(|(_, s)| s.border.is_some() || s.centre_mm.is_some());
        JobTables {
            version: version::WRITTEN,
            surfaces: SurfaceTable::new(&job.surfaces, all),
            clean: CleanTable { surfaces: all.choice(), later: all.having(|s| s.later) },
            recipe_of: all.iter().filter_map(|(id, s)| Some((id.to_string(), s.recipe.clone()?))).collect(),
            tilts: tilts.collect(),
            pins: all.iter().flat_map(|(id, s)| s.pins.iter().map(move |p| pin(id, p))).collect(),
            starts: starts.map(|(surface, s)| StartRow { surface, border: s.border, centre_mm: s.centre_mm }).collect(),
            part: job.part,
            scan: job.scan,
            weld: job.weld,
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

    /// Why a text is no job, which serde finds as well.
    pub(super) fn refusal(text: &str) -> JobFileError {
        assert!(toml::from_str::<Job>(text).is_err(), "{text}");
        match parse(text).expect_err(text) {
            JobFileError::InLine { what, .. } => *what,
            other => other,
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        use JobFileError::{NoNumber, Toml, Twice};
        let toml = |text: &str, line: usize, word: &str| match refusal(text) {
            Toml(e) => assert!(e.line == line && e.to_string().contains(word), "{text}: {e}"),
            other => panic!("{text}: {other:?}"),
        };
        toml("[layers]\nspaceing_mm = 2", 2, "spaceing_mm");
        toml("[[starts]]\nborder = 1", 1, "surface");
        toml("[[starts]]\nsurface = 1\nborder = \"all\"", 3, "whole outline");
        let twice = |list: &str, number| {
            let why = refusal(list);
            assert!(matches!(why, Twice { surface: SurfaceId(n), .. } if n == number), "{list}: {why:?}");
            why
        };
        let why = twice("[clean]\nsurfaces = [4, 1, 4]", 4);
        assert!(matches!(why, Twice { key: "clean.surfaces", .. }), "{why:?}");
        let why = twice("[[starts]]\nsurface = 1\n[[starts]]\nsurface = 1", 1);
        assert!(matches!(why, Twice { key: "starts", .. }), "{why:?}");
        let why = refusal("[surfaces.names]\nfour = \"Rim\"");
        assert!(matches!(&why, NoNumber { key: "surfaces.names", text } if text == "four"), "{why:?}");
        let why = refusal("[recipe_of]\n04 = \"Fine\"");
        assert!(matches!(&why, NoNumber { key: "recipe_of", text } if text == "04"), "{why:?}");
    }
}
