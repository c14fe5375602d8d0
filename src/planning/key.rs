//! The keys of the stages: digests of all that each depends on.
//!
//! A job is taken apart field by field, so that a new one does not compile until it is said here which
//! stages it makes stale. Names, notes and places of files are in no key; what the files hold is.

use crate::document::model::{JobPart, SurfaceParameters};
use crate::document::{Job, Settings};
use crate::part::{Digest, Hasher, Source};
use std::path::Path;

/// The keys of everything that is computed from one job.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keys {
    /// Key of the part: file, unit, welding, placement, turned shells.
    pub part: Digest,
    /// Key of its feature surfaces: the part, and the rules and edits that make them.
    pub surfaces: Digest,
    /// Key of head and clamps.
    pub tool: Digest,
    /// Key of the cell with the frames of its file.
    pub cell: Digest,
    /// Key of the set-up: robot, cell, head and clamps as the job combines them.
    pub setup: Digest,
    /// Key of lines and plan.
    pub plan: Digest,
    /// Key of the dose: the plan, and the thresholds that judge it.
    pub dose: Digest,
}

impl Keys {
    /// The keys of a job that stands in `job_file`, on a part as read. `reading` counts how often cell, robot,
    /// head and clamps were read: their files may change while their names stay.
    pub fn new(source: &Source, job: &Job, job_file: Option<&Path>, reading: u64) -> Keys {
        let Job { part, scan, surfaces, settings, layers, beam, optics, path, bead, dose, cell, clamps, recipes } = job;
        let part = part_key(source, part);
        let surfaces = surfaces_key(part, surfaces, settings);
        let folder = job_file.and_then(Path::parent).map(|f| f.to_string_lossy().into_owned());
        let files = Hasher::default().of(&folder).of(&reading).finish();
        let tool = Hasher::default().of(&files).of(&beam.head).of(clamps).finish();
        let cell_key = Hasher::default().of(&files).of(&cell.file).of(&cell.robot).finish();
        // Whether something stands in the beam's way is asked of beam and optics too.
        let setup = Hasher::default().of(&tool).of(&cell_key).of(cell).of(beam).of(optics).finish();
        let plan = Hasher::default()
            .of(&surfaces)
            .of(scan)
            .of(&setup)
            .of(settings)
            .of(layers)
            .of(path)
            .of(bead)
            .of(recipes)
            .finish();
        let dose = Hasher::default().of(&plan).of(dose).finish();
        Keys { part, surfaces, tool, cell: cell_key, setup, plan, dose }
    }
}

/// The key of a part.
pub(super) fn part_key(source: &Source, part: &JobPart) -> Digest {
    // The digest that the job was made for counts only by whether it is the digest of this file.
    let is_other = part.is_of_another_file(&source.sha256);
    let JobPart { file: _, sha256: _, units, weld, placement, flipped_shells, landmarks: _ } = part;
    Hasher::default().of(&source.sha256).of(&is_other).of(units).of(weld).of(placement).of(flipped_shells).finish()
}

fn surfaces_key(part: Digest, surfaces: &SurfaceParameters, settings: &Settings) -> Digest {
    let flipped: Vec<u32> = settings.having(|s| s.flipped).into_iter().map(|id| id.0).collect();
    Hasher::default().of(&part).of(surfaces).of(&flipped).finish()
}
