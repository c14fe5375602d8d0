//! What the comparison shows: which recipes, and which rows of them.

use super::super::library::shelf::Shelf;
use crate::document::{Job, Recipe};
use crate::part::SurfaceId;
use std::collections::BTreeSet;

/// What is compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compare {
    /// The recipes, by shelf and name.
    chosen: BTreeSet<(Shelf, String)>,
    /// Whether the job's own values stand beside them.
    pub with_job: bool,
    /// Whether rows in which they agree are shown too.
    pub all_rows: bool,
}

impl Compare {
    /// The job's own values and its recipes, or those that the selected surfaces have, if there are several.
    pub fn of(job: &Job, selected: &[SurfaceId]) -> Compare {
        let of_selected: BTreeSet<&str> =
            selected.iter().filter_map(|&n| job.recipe_of(n)).map(|r| r.name.as_str()).collect();
        let wanted = |r: &&Recipe| of_selected.len() < 2 || of_selected.contains(r.name.as_str());
        let chosen = job.recipes.iter().filter(wanted).map(|r| (Shelf::Job, r.name.clone())).collect();
        Compare { chosen, with_job: true, all_rows: false }
    }

    /// Whether a recipe is among those compared.
    pub fn has(&self, shelf: Shelf, recipe: &Recipe) -> bool {
        self.chosen.contains(&(shelf, recipe.name.clone()))
    }

    /// Compares a recipe with the others, or does not.
    pub fn set(&mut self, shelf: Shelf, recipe: &Recipe, on: bool) {
        let key = (shelf, recipe.name.clone());
        if on {
            self.chosen.insert(key);
        } else {
            self.chosen.remove(&key);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recipes_of_the_selection_are_compared_if_there_are_several() {
        let recipe = |name: &str| Recipe { name: name.into(), ..Recipe::default() };
        let [a, b, c] = ["a", "b", "c"].map(recipe);
        let mut job = Job { recipes: vec![a.clone(), b.clone(), c.clone()], ..Job::default() };
        job.settings.change(SurfaceId(1), |s| s.recipe = Some("a".into()));
        job.settings.change(SurfaceId(2), |s| s.recipe = Some("b".into()));
        let shown = |compare: &Compare| [&a, &b, &c].map(|r| compare.has(Shelf::Job, r));
        assert_eq!(shown(&Compare::of(&job, &[SurfaceId(1)])), [true; 3]);
        let mut compare = Compare::of(&job, &[SurfaceId(1), SurfaceId(2)]);
        assert_eq!(shown(&compare), [true, true, false]);
        compare.set(Shelf::Job, &a, false);
        compare.set(Shelf::Mine, &c, true);
        assert_eq!(shown(&compare), [false, true, false]);
        assert!(compare.has(Shelf::Mine, &c));
    }
}
