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
