//! A job whose part's file has changed: what it says of surfaces is carried over to those that are found again.
//! Nothing is guessed, and nothing goes in silence; whether to go on is for the operator to say.

use super::files::build_part;
use super::landmarks::{loaded_as, surfaces_named_in};
use super::model::{Job, JobPart};
use super::remembered::Remembered;
use super::renumber::Renumbering;
use crate::part::identity::{LostReason, find};
use crate::part::{LoadError, Part, Source, SurfaceId};
use crate::progress::{Cancelled, Progress};
use nalgebra::Isometry3;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A surface that was not found again.
#[derive(Clone, Debug, PartialEq)]
pub struct LostSurface {
    /// Its number.
    pub surface: SurfaceId,
    /// The name that the operator gave it; empty: none.
    pub name: String,
    /// Whether it was to be cleaned.
    pub is_chosen: bool,
    /// Why it was not found.
    pub why: LostReason,
}

/// What becomes of a job on the part's file as it is now.
#[derive(Clone, Debug)]
pub struct CarriedOver {
    /// The job for the changed part.
    pub job: Job,
    /// Surfaces that were found again: as they were called, and as they are called now.
    pub kept: Vec<(SurfaceId, SurfaceId)>,
    /// Surfaces that were not.
    pub lost: Vec<LostSurface>,
    /// Merges, splits and cuts that could not be repeated.
    pub lost_edits: usize,
    /// Turned shells that were not found.
    pub lost_shells: usize,
    /// The job cleans all, and does not say what that was.
    pub knows_no_surface: bool,
    /// By this shift or turn of the whole part, in the file's coordinates, everything was found, and only so.
    pub motion: Option<Isometry3<f64>>,
    /// Everything is there, but so many times larger.
    pub scale: Option<f64>,
    /// SHA-256 of the file that the job was made for.
    pub was: String,
    /// SHA-256 of the file as it is.
    pub is: String,
}

impl CarriedOver {
    /// Carries a job over to what was read of the changed `file`. `None`: the work was cancelled.
    ///
    /// # Errors
    /// No facet of the file has any area.
    pub fn to_file(
        job: &Job,
        source: &Source,
        file: &Path,
        progress: &Progress,
    ) -> Result<Option<CarriedOver>, LoadError> {
        let part = build_part(source, &without_turned_shells(&job.part), file, progress)?;
        Ok(part.and_then(|part| CarriedOver::on(job, &part, progress).ok()))
    }

    /// Carries a job over. `part` is built from the changed file as the job says, but with no shell turned.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    fn on(job: &Job, part: &Part, progress: &Progress) -> Result<CarriedOver, Cancelled> {
        let landmarks = job.part.landmarks.landmarks().cloned().unwrap_or_default();
        let mut needed = surfaces_named_in(job);
        if job.settings.cleans_all() {
            needed.extend(landmarks.numbers());
        }
        let s = &job.surfaces;
        let loaded = without_turned_shells(&job.part);
        let found = find(&landmarks, part, &loaded_as(&loaded), &s.rule(), (&s.edits, &needed), progress)?;
        let numbers: BTreeMap<SurfaceId, SurfaceId> = found
            .numbers
            .iter()
            .filter(|(old, _)| needed.contains(old))
            .map(|(old, new)| (SurfaceId(*old), SurfaceId(*new)))
            .collect();
        let lost = found.lost.iter().map(|l| LostSurface::new(job, SurfaceId(l.number), l.why)).collect();
        let mut after = job.clone();
        after.renumber(&Renumbering::found(&numbers));
        after.surfaces.edits = found.edits;
        let shells: BTreeSet<u32> =
            job.part.flipped_shells.iter().filter_map(|n| found.shells.get(n).copied()).collect();
        let lost_shells = job.part.flipped_shells.len() - shells.len().min(job.part.flipped_shells.len());
        after.part.flipped_shells = shells.into_iter().collect();
        after.part.sha256.clone_from(&part.sha256);
        // Those of the file that is no more would find nothing in the next one.
        after.part.landmarks = Remembered::default();
        Ok(CarriedOver {
            job: after,
            kept: numbers.into_iter().collect(),
            lost,
            lost_edits: found.lost_edits.len(),
            lost_shells,
            knows_no_surface: job.settings.cleans_all() && job.part.landmarks.is_empty(),
            motion: found.motion,
            scale: found.scale,
            was: job.part.sha256.clone(),
            is: part.sha256.clone(),
        })
    }

    /// Whether nothing was lost.
    pub fn is_complete(&self) -> bool {
        self.lost.is_empty() && self.lost_edits == 0 && self.lost_shells == 0 && !self.knows_no_surface
    }

    /// Whether the work can go on unasked: all that is to be cleaned was found in its place.
    pub fn is_work_in_place(&self) -> bool {
        self.motion.is_none()
            && self.lost_edits == 0
            && self.lost_shells == 0
            && !self.knows_no_surface
            && self.lost.iter().all(|lost| !lost.is_chosen)
    }
}

impl LostSurface {
    fn new(job: &Job, surface: SurfaceId, why: LostReason) -> LostSurface {
        let settings = job.settings.of(surface);
        let is_chosen = settings.work.is_some() || job.settings.cleans_all() && !settings.later;
        LostSurface { surface, name: settings.name.clone(), is_chosen, why }
    }
}

/// How a changed file is read: which of its shells are those that were turned is not known yet.
fn without_turned_shells(part: &JobPart) -> JobPart {
    JobPart { flipped_shells: Vec::new(), ..part.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Chosen, segmented};
    use crate::part::{Placement, Units};
    use crate::pose::tilt::TiltSide;
    use crate::sample::{Triangles, solids, stl_bytes};

    fn part(triangles: &Triangles) -> Part {
        Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part")
    }

    fn groove() -> Triangles {
        solids::v_groove(35.0, 8.0, 9.0, 40.0)
    }

    /// A job on the grooved block: two surfaces to clean, names, a tilt, a pin, one put aside.
    fn job(part: &Part) -> Job {
        let mut job = Job::default();
        job.part.sha256.clone_from(&part.sha256);
        job.settings.choose([4, 2]);
        job.settings.change(SurfaceId(4), |s| s.name = "Flank".into());
        job.settings.change(SurfaceId(2), |s| s.tilt.forbidden = vec![TiltSide::Left]);
        job.settings.change(SurfaceId(3), |s| s.later = true);
        job.part.landmarks = Remembered::of(&job, part, &job.part);
        job
    }

    /// Where the surface of a number lies, and how large it is.
    fn place(part: &Part, job: &Job, id: SurfaceId) -> (f64, nalgebra::Vector3<f64>) {
        let surfaces = segmented(part, job);
        let facets = &surfaces.get(id.0).expect("there").facets;
        let of = |f: &u32| part.mesh.centroid(*f as usize).coords * part.mesh.areas[*f as usize];
        let area = facets.iter().map(|f| part.mesh.areas[*f as usize]).sum();
        (area, facets.iter().map(of).sum::<nalgebra::Vector3<f64>>() / area)
    }

    fn carried_over(job: &Job, part: &Part) -> CarriedOver {
        CarriedOver::on(job, part, &Progress::default()).expect("nobody ends it")
    }

    #[test]
    fn another_order_of_facets_loses_nothing() {
        let before = part(&groove());
        let job = job(&before);
        let mut turned = groove();
        turned.reverse();
        turned.rotate_left(7);
        let after = part(&turned);
        assert_ne!(before.sha256, after.sha256);
        let carried = carried_over(&job, &after);
        assert!(carried.is_complete() && carried.is_work_in_place(), "{carried:?}");
        assert_eq!(carried.job.part.sha256, after.sha256);
        for (old, new) in &carried.kept {
            let ((a0, c0), (a1, c1)) = (place(&before, &job, *old), place(&after, &carried.job, *new));
            assert!((a0 - a1).abs() < 1e-6 && (c0 - c1).norm() < 1e-6, "{old} is no {new}");
            let (was, is) = (job.settings.of(*old), carried.job.settings.of(*new));
            assert_eq!((&was.name, was.work, was.later, &was.tilt), (&is.name, is.work, is.later, &is.tilt));
        }
        assert_eq!(carried.kept.len(), 3);
    }

    #[test]
    fn what_is_gone_is_told_by_number_and_name_and_the_rest_is_kept() {
        let before = part(&groove());
        let job = job(&before);
        // A steeper groove: its flanks are others, the rest of the block is wider.
        let after = part(&solids::v_groove(30.0, 8.0, 9.0, 40.0));
        let carried = carried_over(&job, &after);
        assert!(!carried.is_work_in_place());
        assert!(carried.lost.iter().all(|l| (l.name == "Flank") == (l.surface == SurfaceId(4))), "{carried:?}");
    }

    #[test]
    fn a_moved_part_is_told_and_never_taken_in_silence() {
        let before = part(&groove());
        let job = job(&before);
        let shifted: Triangles = groove().into_iter().map(|t| t.map(|[x, y, z]| [x + 100.0, y, z])).collect();
        let carried = carried_over(&job, &part(&shifted));
        let motion = carried.motion.expect("moved");
        assert!((motion.translation.vector.x - 100.0).abs() < 0.01, "{carried:?}");
        assert!(carried.is_complete() && !carried.is_work_in_place());
    }

    #[test]
    fn a_job_that_remembers_nothing_loses_what_it_says_and_says_so() {
        let before = part(&groove());
        let mut job = job(&before);
        job.part.landmarks = Remembered::default();
        let mut turned = groove();
        turned.reverse();
        let carried = carried_over(&job, &part(&turned));
        assert_eq!((carried.kept.len(), carried.lost.len()), (0, 3));
        assert!(carried.lost.iter().all(|l| l.why == LostReason::NotRemembered), "{carried:?}");
        let none = Job { settings: Default::default(), ..job.clone() };
        assert!(carried_over(&none, &part(&turned)).is_complete(), "there is nothing to lose");
        let mut all = none;
        all.settings.choose(Chosen::All);
        assert!(!carried_over(&all, &part(&turned)).is_work_in_place(), "all of what?");
    }

    #[test]
    fn all_surfaces_are_all_to_be_found() {
        let before = part(&groove());
        let mut all = Job::default();
        all.part.sha256.clone_from(&before.sha256);
        all.settings.choose(Chosen::All);
        all.part.landmarks = Remembered::of(&all, &before, &all.part);
        let mut turned = groove();
        turned.reverse();
        let carried = carried_over(&all, &part(&turned));
        assert!(carried.is_work_in_place() && carried.job.settings.cleans_all(), "{carried:?}");
        assert_eq!(carried.kept.len(), segmented(&before, &all).list.len());
        let other = carried_over(&all, &part(&solids::v_groove(20.0, 8.0, 9.0, 40.0)));
        assert!(!other.is_work_in_place() && other.lost.iter().any(|l| l.is_chosen), "{other:?}");
    }
}
