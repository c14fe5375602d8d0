//! What is wrong with the values of a job, of its recipes and its bead.

use super::number::exact;
use super::{Sentence, id, listed, say};
use crate::document::job_recipes::{OVERLAP_PERCENT, OverlapError};
use crate::document::value_error::{BeadError, RecipeError, ValueError};

impl Sentence for ValueError {
    fn sentence(&self) -> String {
        match self {
            ValueError::Parameter(e) => e.sentence(),
            ValueError::Recipe(e) => e.sentence(),
            ValueError::Bead(e) => e.sentence(),
            ValueError::Dialect(e) => e.sentence(),
            ValueError::Transform(fault) => say!(transform_of_scan, what = fault.sentence()),
            ValueError::OffsetOutside { offset_mm, spacing_mm } => {
                say!(offset_outside, offset = exact(*offset_mm), spacing = exact(*spacing_mm))
            }
        }
    }
}

impl Sentence for RecipeError {
    fn sentence(&self) -> String {
        match self {
            RecipeError::NotForRecipes { recipe, key } => say!(recipe_key_unknown, recipe, key),
            RecipeError::Number { recipe, source } => say!(recipe_in, recipe, what = source.sentence()),
            RecipeError::Bead { recipe, source } => say!(recipe_in, recipe, what = source.sentence()),
            RecipeError::Twice { name } => say!(recipe_twice, name),
            RecipeError::Missing { surface, name, known } if known.is_empty() => {
                say!(recipe_missing_all, surface = id(surface), name)
            }
            RecipeError::Missing { surface, name, known } => {
                say!(recipe_missing, surface = id(surface), name, known = listed(known))
            }
        }
    }
}

impl Sentence for BeadError {
    fn sentence(&self) -> String {
        match *self {
            BeadError::Half { width_mm, height_mm } => {
                say!(bead_half, width = exact(width_mm), height = exact(height_mm))
            }
            BeadError::LayersOfNothing { layers } => say!(bead_layers_of_nothing, layers),
        }
    }
}

impl Sentence for OverlapError {
    fn sentence(&self) -> String {
        let (least, greatest) = (exact(*OVERLAP_PERCENT.start()), exact(*OVERLAP_PERCENT.end()));
        say!(overlap_out_of_range, percent = exact(self.percent), least, greatest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Job, Recipe};
    use crate::part::SurfaceId;

    #[test]
    fn recipes_and_beads_are_told_by_name() {
        let mut job = Job::default();
        job.settings.change(SurfaceId(4), |s| s.recipe = Some("Fine".into()));
        let told = |job: &Job| job.check().expect_err("it cannot be").sentence();
        assert_eq!(told(&job), "surface 4 has the recipe \"Fine\", but the job has no recipes");
        let values = [("layers.spacing_mm".to_owned(), 0.0)].into();
        job.recipes.push(Recipe { name: "Fine".into(), values, ..Recipe::default() });
        assert_eq!(told(&job), "recipe \"Fine\": layers.spacing_mm = 0: give a number above 0, up to 1000 mm");
        job.recipes[0].values = [("bead.height_mm".to_owned(), 1.0)].into();
        let half = "bead.width_mm = 0, bead.height_mm = 1: give both above 0, or both 0 where nothing is laid";
        assert_eq!(told(&job), format!("recipe \"Fine\": {half}"));
        assert_eq!(
            job.spacing_of_overlap(-1.0).expect_err("none").sentence(),
            "overlap = -1: give a number from 0 to 95 %"
        );
    }
}
