//! Surfaces that are cut: what is cut off one is worked with its recipe.

use super::edit::Edit;
use super::model::Job;
use super::model::segmented;
use crate::part::{Part, SurfaceEdit, Surfaces};

impl Edit {
    /// Cuts a surface again at a lower angle; what is cut off it keeps its recipe. `surfaces` are those of the
    /// part under this job.
    pub fn split(part: &Part, surfaces: &Surfaces, job: &Job, surface: u32, angle_deg: f64) -> Edit {
        let mut after = job.clone();
        after.surfaces.edits.push(SurfaceEdit::Split { split: surface, angle_deg });
        let made =
            segmented(part, &after).list.iter().map(|s| s.number).filter(|n| *n > surfaces.last_number).collect();
        Edit::Split { surface, angle_deg, made }
    }
}

impl Job {
    /// Surfaces that were cut off another are worked with its recipe.
    pub(super) fn keep_recipe(&mut self, of: u32, made: &[u32]) {
        if let Some(name) = self.recipe_of.get(&of.to_string()).cloned() {
            self.recipe_of.extend(made.iter().map(|n| (n.to_string(), name.clone())));
        }
    }

    /// The same for cuts. Each makes one surface with a number higher than all before, in their order; `surfaces`
    /// has those numbers among others.
    pub(super) fn keep_recipes_of_cuts(&mut self, cuts: &[SurfaceEdit], surfaces: &[u32]) {
        let mut made = surfaces.to_vec();
        made.sort_unstable();
        let made = made.split_off(made.len().saturating_sub(cuts.len()));
        for (cut, new) in cuts.iter().zip(made) {
            if let SurfaceEdit::Cut { cut, .. } = cut {
                self.keep_recipe(*cut, &[new]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{Document, Edit, Job, Recipe, segmented};
    use crate::part::{Part, Placement, SurfaceEdit, Units};
    use crate::sample::{solids, stl_bytes};

    /// A cube whose twelve facets are one surface.
    fn cube() -> (Part, Job) {
        let bytes = stl_bytes(&solids::cube(10.0));
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("a part");
        let mut job = Job::default();
        job.surfaces.angle_deg = 120.0;
        job.put_recipe(&Recipe { name: "Fine".into(), ..Recipe::default() }, &[1]);
        (part, job)
    }

    #[test]
    fn what_is_split_off_keeps_the_recipe() {
        let (part, job) = cube();
        let surfaces = segmented(&part, &job);
        assert_eq!(surfaces.list.len(), 1);
        let split = Edit::split(&part, &surfaces, &job, 1, 45.0);
        let mut doc = Document::new(job.clone(), None);
        doc.apply(&split, &[1], None);
        assert_eq!(segmented(&part, doc.job()).list.len(), 6);
        assert_eq!(doc.job().surfaces_of_recipe("Fine"), [1, 2, 3, 4, 5, 6]);
        assert_eq!(doc.undo_name(), Some("split surface 1"));
        doc.undo();
        assert_eq!(*doc.job(), job);
        let mut plain = Job { recipe_of: Default::default(), ..job };
        split.apply(&mut plain, &[1]);
        assert!(plain.recipe_of.is_empty(), "the job's own values stay");
    }

    #[test]
    fn what_is_put_aside_keeps_the_recipe() {
        let (_, mut job) = cube();
        job.put_recipe(&Recipe { name: "Other".into(), ..Recipe::default() }, &[2]);
        // Surface 2 is put aside whole; of 1 and 3 a patch is cut off.
        let cut = |cut: u32| SurfaceEdit::Cut { cut, facets: vec![0] };
        let later = Edit::Later { cuts: vec![cut(1), cut(3)], surfaces: vec![7, 2, 8] };
        later.apply(&mut job, &[1, 2, 3]);
        assert_eq!((job.surfaces_of_recipe("Fine"), job.surfaces_of_recipe("Other")), (vec![1, 7], vec![2]));
    }
}
