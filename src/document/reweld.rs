//! The edit that welds the part's corners otherwise. Facets stay, but what hangs together changes, and with it surfaces
//! and shells: each takes over what most of its area was, as when they are cut anew.

use super::edit::Edit;
use super::files::build_part;
use super::model::{Job, JobPart, segmented};
use super::recut::RecutAnchor;
use super::renumber::Renumbering;
use super::settings::Settings;
use crate::part::{LoadError, Part, Source, SurfaceId, Surfaces, Weld};
use crate::progress::Progress;
use std::collections::BTreeSet;
use std::path::Path;

impl Edit {
    /// Welds otherwise. `before` is the part of the anchor's job, whose file is `source`. Merges, splits and cuts are
    /// kept where the surfaces that they were made on are the same, and gone else. `None`: the work was cancelled.
    ///
    /// # Errors
    /// No facet has any area.
    pub fn weld(
        source: &Source,
        before: &Part,
        anchor: &RecutAnchor,
        weld: Weld,
        progress: &Progress,
    ) -> Result<Option<Edit>, LoadError> {
        let mut job = anchor.job.clone();
        job.part = JobPart { weld, flipped_shells: Vec::new(), ..job.part };
        let Some(mut after) = build_part(source, &job.part, Path::new(&job.part.file), progress)? else {
            return Ok(None);
        };
        job.part.flipped_shells = shells_kept(&anchor.job.part.flipped_shells, before, &after);
        for f in 0..after.mesh.facets.len() {
            if job.part.flipped_shells.contains(&after.orientation.shell_of[f]) {
                after.mesh.flip(f);
            }
        }
        let base = |part: &Part| {
            let mut job = anchor.job.clone();
            job.surfaces.edits.clear();
            segmented(part, &job).of_facet
        };
        if !job.surfaces.edits.is_empty() && base(before) != base(&after) {
            job.surfaces.edits.clear();
        }
        let surfaces = segmented(&after, &job);
        let lost = job.renumber(&Renumbering::by_area(&after.mesh.areas, &anchor.surfaces, &surfaces));
        keep_sides(&mut job.settings, &anchor.surfaces, &after, &surfaces);
        let Job { part, surfaces, settings, .. } = job;
        Ok(Some(Edit::Weld { weld, flipped_shells: part.flipped_shells, edits: surfaces.edits, settings, lost }))
    }
}

impl Job {
    /// Whether it says anything of surfaces or shells by their numbers, which welding can change.
    pub fn says_of_numbers(&self) -> bool {
        self.settings.iter().next().is_some() || !self.surfaces.edits.is_empty() || !self.part.flipped_shells.is_empty()
    }
}

/// The shells that are to be turned so that what was turned before, by most of its area, looks as it did.
fn shells_kept(flipped: &[u32], before: &Part, after: &Part) -> Vec<u32> {
    let shells = &after.orientation.shell_of;
    let (mut area, mut was_flipped) = (vec![0.0; after.orientation.shells + 1], vec![0.0; after.orientation.shells + 1]);
    let mut against = was_flipped.clone();
    for (f, &shell) in shells.iter().enumerate() {
        let (shell, mm2) = (shell as usize, after.mesh.areas[f]);
        area[shell] += mm2;
        if flipped.contains(&before.orientation.shell_of[f]) {
            was_flipped[shell] += mm2;
            against[shell] -= mm2 * before.mesh.normals[f].dot(&after.mesh.normals[f]);
        }
    }
    (1..area.len()).filter(|&s| was_flipped[s] > 0.5 * area[s] && against[s] > 0.0).map(|s| s as u32).collect()
}

/// Surfaces that are worked on from their other side stay worked on from the side that they were, whichever way their
/// facets look now.
fn keep_sides(settings: &mut Settings, before: &Surfaces, after: &Part, surfaces: &Surfaces) {
    let turned: BTreeSet<SurfaceId> = settings.having(|s| s.flipped).into_iter().collect();
    for id in turned {
        let facets = surfaces.get(id.0).map_or(&[][..], |s| &s.facets);
        let along = |&f: &u32| before.normals[f as usize].dot(&after.mesh.normals[f as usize]) * after.mesh.areas[f as usize];
        let is_along = facets.iter().map(along).fold(0.0, |a, b| a + b) > 0.0;
        settings.change(id, |s| s.flipped = !is_along);
    }
}
