//! Edits that cut the surfaces anew: another crease angle, island area or hysteresis. The new surfaces take over what
//! is said of the old ones that they cover.

use super::edit::Edit;
use super::model::{Job, segmented};
use super::parameter::Parameter;
use super::renumber::Renumbering;
use crate::part::{Part, Surfaces};
use std::sync::Arc;

/// The job at the beginning of a drag, and its surfaces: each step starts from there, so that a drag to 60° and
/// back loses nothing.
#[derive(Clone, Debug)]
pub struct RecutAnchor {
    /// The job.
    pub job: Job,
    /// The surfaces of the part under it.
    pub surfaces: Arc<Surfaces>,
}

impl Edit {
    /// Sets a parameter that cuts the surfaces anew (see [`Parameter::recuts`]). Merges, splits and cuts were made on
    /// other numbers and are gone, unless the value is the one that the anchor has.
    pub fn recut(part: &Part, anchor: &RecutAnchor, parameter: &Parameter, value: f64) -> Edit {
        let mut job = anchor.job.clone();
        job.set_number(parameter, value);
        let mut lost = Vec::new();
        if job.surfaces != anchor.job.surfaces {
            job.surfaces.edits.clear();
            let after = segmented(part, &job);
            lost = job.renumber(&Renumbering::by_area(&part.mesh.areas, &anchor.surfaces, &after));
        }
        let Job { surfaces, settings, .. } = job;
        Edit::Recut { key: parameter.key, value, edits: surfaces.edits, settings, lost }
    }
}
