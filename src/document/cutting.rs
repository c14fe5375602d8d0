//! Edits that split surfaces, cut facets off them or put what is cut off aside. Numbers of pieces follow from the part,
//! so they are looked up here and the edit holds them.

use super::edit::Edit;
use super::model::{Job, segmented};
use super::reshape::Cut;
use crate::part::{Part, SurfaceEdit, SurfaceId, Surfaces};
use crate::process::Patch;
use std::collections::BTreeMap;

impl Edit {
    /// Cuts a surface again at a lower angle. `surfaces` are those of the part under this job.
    pub fn split(part: &Part, surfaces: &Surfaces, job: &Job, surface: SurfaceId, angle_deg: f64) -> Edit {
        let mut after = job.clone();
        after.surfaces.edits.push(SurfaceEdit::Split { split: surface.0, angle_deg });
        let made = segmented(part, &after).ids().filter(|id| id.0 > surfaces.last_number).collect();
        Edit::Split { surface, angle_deg, made }
    }

    /// Cuts facets off a surface. `None` where it has none of them, or no others.
    pub fn cut(surfaces: &Surfaces, surface: SurfaceId, facets: &[u32]) -> Option<Edit> {
        let whole = surfaces.get(surface.0)?;
        let cut_off = whole.facets.iter().filter(|f| facets.contains(f)).count();
        let cut = Cut { of: surface, facets: facets.to_vec(), piece: SurfaceId(surfaces.last_number + 1) };
        (cut_off > 0 && cut_off < whole.facets.len()).then_some(Edit::Cut(cut))
    }

    /// Puts patches that no light comes to aside: each becomes a surface of its own, or the whole surface
    /// where nothing of it would be left. A gap between lines stays: it is a matter of spacing, not of another
    /// job. `None` where no such patch holds the larger half of any facet.
    pub fn aside(patches: &[Patch], surfaces: &Surfaces) -> Option<Edit> {
        let (mut cuts, mut aside) = (Vec::new(), Vec::new());
        let mut left: BTreeMap<u32, usize> = BTreeMap::new();
        for patch in patches.iter().filter(|p| p.cause.keeps_light_away() && !p.facets.is_empty()) {
            let Some(surface) = surfaces.get(patch.surface) else { continue };
            let left = left.entry(patch.surface).or_insert(surface.facets.len());
            *left = left.saturating_sub(patch.facets.len());
            let of = SurfaceId(patch.surface);
            if *left == 0 {
                aside.push(of);
            } else {
                let piece = SurfaceId(surfaces.last_number + cuts.len() as u32 + 1);
                cuts.push(Cut { of, facets: patch.facets.clone(), piece });
                aside.push(piece);
            }
        }
        (!aside.is_empty()).then_some(Edit::Later { cuts, surfaces: aside })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Recipe, UndoStep};
    use crate::part::{Placement, Units};
    use crate::sample::{solids, stl_bytes};

    /// A cube whose twelve facets are one surface.
    fn cube() -> (Part, Job) {
        let bytes = stl_bytes(&solids::cube(10.0));
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("a part");
        let mut job = Job::default();
        job.surfaces.angle_deg = 120.0;
        job.put_recipe(&Recipe { name: "Fine".into(), ..Recipe::default() }, &[SurfaceId(1)]);
        (part, job)
    }

    #[test]
    fn what_is_split_off_keeps_the_recipe() {
        let (part, job) = cube();
        let surfaces = segmented(&part, &job);
        assert_eq!(surfaces.list.len(), 1);
        let split = Edit::split(&part, &surfaces, &job, SurfaceId(1), 45.0);
        let mut doc = Document::new(job.clone(), None);
        doc.apply(&split, &[SurfaceId(1)], None);
        assert_eq!(segmented(&part, doc.job()).list.len(), 6);
        assert_eq!(doc.job().surfaces_of_recipe("Fine"), [1, 2, 3, 4, 5, 6].map(SurfaceId));
        assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(split.clone())));
        doc.undo();
        assert_eq!(*doc.job(), job);
        let mut plain = Job { settings: Default::default(), ..job };
        split.apply(&mut plain, &[SurfaceId(1)]);
        assert_eq!(plain.settings, Default::default(), "the job's own values stay");
    }

    #[test]
    fn what_is_put_aside_keeps_the_recipe() {
        let (_, mut job) = cube();
        job.put_recipe(&Recipe { name: "Other".into(), ..Recipe::default() }, &[SurfaceId(2)]);
        // Surface 2 is put aside whole; of 1 and 3 a patch is cut off.
        let cut = |of, piece| Cut { of: SurfaceId(of), facets: vec![0], piece: SurfaceId(piece) };
        let later = Edit::Later { cuts: vec![cut(1, 7), cut(3, 8)], surfaces: [7, 2, 8].map(SurfaceId).to_vec() };
        later.apply(&mut job, &[1, 2, 3].map(SurfaceId));
        assert_eq!(job.surfaces_of_recipe("Fine"), [1, 7].map(SurfaceId));
        assert_eq!(job.surfaces_of_recipe("Other"), [SurfaceId(2)]);
        assert_eq!(job.settings.having(|s| s.later), [2, 7, 8].map(SurfaceId));
    }

    #[test]
    fn a_cut_leaves_something_and_takes_something() {
        let (part, job) = cube();
        let surfaces = segmented(&part, &job);
        let all: Vec<u32> = (0..12).collect();
        assert_eq!(Edit::cut(&surfaces, SurfaceId(1), &all), None);
        assert_eq!(Edit::cut(&surfaces, SurfaceId(1), &[99]), None);
        assert_eq!(Edit::cut(&surfaces, SurfaceId(2), &[0]), None);
        let Some(Edit::Cut(cut)) = Edit::cut(&surfaces, SurfaceId(1), &[0, 1]) else { panic!("a cut") };
        assert_eq!(cut.piece, SurfaceId(2));
    }
}
