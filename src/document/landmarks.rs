//! What a job has to remember of its part's surfaces: landmarks of those that it says anything of.

use super::model::{Job, JobPart, segmented};
use super::remembered::Remembered;
use crate::part::Part;
use crate::part::identity::{Landmarks, LoadedAs};
use std::collections::BTreeSet;

/// A job that cleans all of more surfaces than this remembers none of them: its file would have megabytes.
const MOST: usize = 2000;

impl Remembered {
    /// What is to be remembered of a part for a job; nothing where the job says nothing of single surfaces or
    /// shells. `loaded` is how the part was read.
    pub fn of(job: &Job, part: &Part, loaded: &JobPart) -> Remembered {
        let mut needed = surfaces_named_in(job);
        if job.settings.cleans_all() {
            let all = segmented(part, job);
            if all.list.len() > MOST {
                return Remembered::default();
            }
            needed.extend(all.list.iter().map(|s| s.number));
        }
        if needed.is_empty() && job.surfaces.edits.is_empty() && loaded.flipped_shells.is_empty() {
            return Remembered::default();
        }
        let s = &job.surfaces;
        Remembered::new(Landmarks::new(part, &loaded_as(loaded), &s.rule(), &s.edits, &needed))
    }
}

/// Numbers of the surfaces that a job says anything of.
pub(super) fn surfaces_named_in(job: &Job) -> BTreeSet<u32> {
    job.settings.iter().map(|(id, _)| id.0).collect()
}

/// How a part is read for a job.
pub(super) fn loaded_as(of: &JobPart) -> LoadedAs<'_> {
    LoadedAs { units: of.units, placement: &of.placement, flipped_shells: &of.flipped_shells }
}
