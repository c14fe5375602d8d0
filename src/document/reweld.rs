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
    let (mut area, mut was_flipped) =
        (vec![0.0; after.orientation.shells + 1], vec![0.0; after.orientation.shells + 1]);
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
        let along =
            |&f: &u32| before.normals[f as usize].dot(&after.mesh.normals[f as usize]) * after.mesh.areas[f as usize];
        let is_along = facets.iter().map(along).fold(0.0, |a, b| a + b) > 0.0;
        settings.change(id, |s| s.flipped = !is_along);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::part::SurfaceEdit;
    use crate::pose::{Pin, Tilt};
    use crate::sample::{Triangles, solids, stl_bytes};
    use std::sync::Arc;

    /// A part, and a job on it that welds equal corners alone.
    fn read(triangles: &Triangles) -> (Source, Job) {
        let source = Source::from_bytes(&stl_bytes(triangles)).expect("a part");
        let mut job = Job::default();
        job.part.weld = Weld::Exact;
        (source, job)
    }

    fn built(source: &Source, job: &Job) -> Part {
        build_part(source, &job.part, Path::new("part.stl"), &Progress::default()).expect("a part").expect("whole")
    }

    fn welded(source: &Source, job: &Job) -> Document {
        let before = built(source, job);
        let anchor = RecutAnchor { job: job.clone(), surfaces: Arc::new(segmented(&before, job)) };
        let edit = Edit::weld(source, &before, &anchor, Weld::Auto, &Progress::default()).expect("a part");
        let mut document = Document::new(job.clone(), None);
        assert!(document.apply(&edit.expect("not cancelled"), &[], None));
        document
    }

    /// A cube of which one facet lies a rounding off its neighbours.
    fn cracked_cube() -> Triangles {
        let mut cube = solids::cube(10.0);
        cube[0] = cube[0].map(|p| p.map(|x| f64::from((x as f32).next_up())));
        cube
    }

    #[test]
    fn what_is_said_of_the_pieces_is_said_of_the_whole_and_undone() {
        let (source, mut job) = read(&cracked_cube());
        assert_eq!(segmented(&built(&source, &job), &job).list.len(), 7);
        job.settings.choose([2, 1, 7]);
        for n in [1, 2] {
            job.settings.change(SurfaceId(n), |s| (s.name, s.flipped) = ("Face".into(), true));
        }
        let pin = Pin { line: 0, at_mm: 1.0, tilt: Tilt::default() };
        job.settings.change(SurfaceId(7), |s| s.pins = vec![pin]);
        let mut document = welded(&source, &job);
        let after = document.job().clone();
        let surfaces = segmented(&built(&source, &after), &after);
        assert_eq!((after.part.weld, surfaces.list.len()), (Weld::Auto, 6));
        let face = after.settings.of(SurfaceId(1));
        assert_eq!((face.name.as_str(), face.flipped), ("Face", true));
        assert_eq!(after.settings.chosen(surfaces.ids()), [1, 6].map(SurfaceId));
        assert_eq!(after.settings.of(SurfaceId(6)).pins, [pin], "the same facets");
        document.undo();
        assert_eq!(*document.job(), job);
    }

    #[test]
    fn a_clean_part_loses_nothing() {
        let (source, mut job) = read(&solids::cube(10.0));
        job.surfaces.edits = vec![SurfaceEdit::Merge { merge: vec![1, 2] }];
        job.settings.choose([3, 1]);
        job.part.flipped_shells = vec![1];
        let after = welded(&source, &job).job().clone();
        assert_eq!(after, Job { part: JobPart { weld: Weld::Auto, ..job.part.clone() }, ..job });
    }

    #[test]
    fn merges_of_other_surfaces_go_and_a_turned_shell_stays_turned() {
        let (source, mut job) = read(&cracked_cube());
        job.surfaces.edits = vec![SurfaceEdit::Merge { merge: vec![2, 3] }];
        // Shell 1 is the facet alone, shell 2 all the rest.
        job.part.flipped_shells = vec![2];
        let before = built(&source, &job);
        let after = welded(&source, &job).job().clone();
        assert_eq!((after.surfaces.edits.len(), after.part.flipped_shells.as_slice()), (0, &[1][..]));
        let part = built(&source, &after);
        assert!((1..12).all(|f| before.mesh.normals[f].dot(&part.mesh.normals[f]) > 0.9));
        assert_ne!(part.digest, before.digest, "another part");
    }
}
