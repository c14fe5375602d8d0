//! What a saved job remembers of its part's surfaces, so that they are found again when the part's file changes.

use super::model::{Job, PartFile, segmented};
use crate::part::Part;
use crate::part::identity::{Landmarks, LoadedAs};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Of a job that cleans all of more surfaces than this nothing is remembered: its file would have megabytes.
const MOST: usize = 2000;

/// Landmarks, shared between copies of a job.
///
/// They follow from part and job, and say nothing that an operator decided: jobs are equal whatever is remembered.
#[derive(Clone, Debug, Default)]
pub struct Remembered(Option<Arc<Landmarks>>);

impl PartialEq for Remembered {
    fn eq(&self, _: &Remembered) -> bool {
        true
    }
}

impl Serialize for Remembered {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        self.0.as_deref().serialize(s)
    }
}

impl<'de> Deserialize<'de> for Remembered {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        Ok(Remembered(Some(Arc::new(Landmarks::deserialize(d)?))))
    }
}

impl Remembered {
    /// What is to be remembered of a part for a job; nothing where the job says nothing of single surfaces or
    /// shells. `loaded` is how the part was read.
    pub fn of(job: &Job, part: &Part, loaded: &PartFile) -> Remembered {
        let mut needed = named(job);
        if job.settings.cleans_all() {
            let all = segmented(part, job);
            if all.list.len() > MOST {
                return Remembered(None);
            }
            needed.extend(all.list.iter().map(|s| s.number));
        }
        if needed.is_empty() && job.surfaces.edits.is_empty() && loaded.flipped_shells.is_empty() {
            return Remembered(None);
        }
        let s = &job.surfaces;
        Remembered(Some(Arc::new(Landmarks::new(part, &loaded_as(loaded), &s.rule(), &s.edits, &needed))))
    }

    /// Whether nothing is.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// What is.
    pub(super) fn landmarks(&self) -> Option<&Landmarks> {
        self.0.as_deref()
    }
}

/// Numbers of the surfaces that a job says anything of.
pub(super) fn named(job: &Job) -> BTreeSet<u32> {
    job.settings.iter().map(|(id, _)| id.0).collect()
}

/// How a part is read for a job.
pub(super) fn loaded_as(of: &PartFile) -> LoadedAs<'_> {
    LoadedAs { units: of.units, placement: &of.placement, flipped_shells: &of.flipped_shells }
}
