//! What edits do to the recipes of a job, so that every surface's recipe is one that is there.

use super::model::Job;
use super::recipe::Recipe;
use crate::part::SurfaceId;

impl Job {
    /// Puts a recipe in place of the one of its name, or adds it, and gives it to surfaces.
    pub(super) fn put_recipe(&mut self, recipe: &Recipe, surfaces: &[SurfaceId]) {
        match self.recipes.iter_mut().find(|r| r.name == recipe.name) {
            Some(known) => known.clone_from(recipe),
            None => self.recipes.push(recipe.clone()),
        }
        self.settings.change_each(surfaces, |s| s.recipe = Some(recipe.name.clone()));
    }

    pub(super) fn remove_recipe(&mut self, name: &str) {
        self.recipes.retain(|r| r.name != name);
        self.take_recipe(&self.surfaces_of_recipe(name));
    }

    /// Renames a recipe, unless the new name is empty or taken.
    pub(super) fn rename_recipe(&mut self, from: &str, to: &str) {
        let to = to.trim();
        if to.is_empty() || self.recipes.iter().any(|r| r.name == to) {
            return;
        }
        self.recipes.iter_mut().filter(|r| r.name == from).for_each(|r| r.name = to.into());
        self.settings.change_each(&self.surfaces_of_recipe(from), |s| s.recipe = Some(to.into()));
    }

    /// Puts a copy of a recipe behind it, under the first name that is free.
    pub(super) fn duplicate_recipe(&mut self, name: &str) {
        let Some(at) = self.recipes.iter().position(|r| r.name == name) else { return };
        let is_taken = |name: &str| self.recipes.iter().any(|r| r.name == name);
        let Some(free) = (2..).map(|k: u32| format!("{name} {k}")).find(|n| !is_taken(n)) else { return };
        let copy = Recipe { name: free, ..self.recipes[at].clone() };
        self.recipes.insert(at + 1, copy);
    }

    /// Surfaces are worked with the job's own values.
    pub(super) fn take_recipe(&mut self, surfaces: &[SurfaceId]) {
        self.settings.change_each(surfaces, |s| s.recipe = None);
    }

    /// The surfaces that are worked with a recipe, ascending.
    pub fn surfaces_of_recipe(&self, name: &str) -> Vec<SurfaceId> {
        self.settings.having(|s| s.recipe.as_deref() == Some(name))
    }

    /// A new recipe without values, under the first of the numbered names that is free.
    pub fn new_recipe(&self, numbered: impl Fn(u32) -> String) -> Recipe {
        let is_free = |name: &String| !self.recipes.iter().any(|r| r.name == *name);
        let name = (1..).map(numbered).find(is_free).unwrap_or_default();
        Recipe { name, ..Recipe::default() }
    }

    /// A recipe from elsewhere under a name that is free in the job, or that of an equal one of the job.
    pub fn under_free_name(&self, recipe: &Recipe) -> Recipe {
        let mut renamed = recipe.clone();
        for k in 2.. {
            match self.recipes.iter().find(|r| r.name == renamed.name) {
                Some(known) if *known != renamed => renamed.name = format!("{} {k}", recipe.name),
                _ => break,
            }
        }
        renamed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Edit, UndoStep};
    use crate::path::Strategy;

    fn ids(numbers: &[u32]) -> Vec<SurfaceId> {
        numbers.iter().copied().map(SurfaceId).collect()
    }

    fn named(name: &str, spacing_mm: f64) -> Recipe {
        let values = [("layers.spacing_mm".to_owned(), spacing_mm)].into();
        Recipe { name: name.into(), values, ..Recipe::default() }
    }

    #[test]
    fn recipes_are_given_renamed_and_removed_in_steps_that_undo_knows() {
        let mut doc = Document::default();
        let mut apply = |edit: Edit| {
            assert!(doc.apply(&edit, &ids(&[1, 2, 3]), None));
            assert_eq!(doc.job().check_recipes(), Ok(()), "{edit:?}");
            assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(edit)));
            doc.job().clone()
        };
        let job = apply(Edit::Recipe(Box::new(named("Fine", 0.2)), ids(&[2, 3])));
        assert_eq!(job.surfaces_of_recipe("Fine"), ids(&[2, 3]));
        assert_eq!(job.of_surface(SurfaceId(2)).layers.spacing_mm, 0.2);
        assert_eq!(job.of_surface(SurfaceId(1)).layers.spacing_mm, 0.5);
        let job = apply(Edit::Recipe(Box::new(named("Fine", 0.3)), ids(&[])));
        assert_eq!((job.recipes.len(), job.of_surface(SurfaceId(3)).layers.spacing_mm), (1, 0.3));
        apply(Edit::GiveRecipe(ids(&[3]), None));
        let job = apply(Edit::RenameRecipe("Fine".into(), " Finish ".into()));
        assert_eq!(job.recipe_of(SurfaceId(2)).map(|r| r.name.as_str()), Some("Finish"));
        apply(Edit::GiveRecipe(ids(&[1, 3]), Some(Box::new(named("Finish", 0.3)))));
        let job = apply(Edit::RemoveRecipe("Finish".into()));
        assert!(job.recipes.is_empty() && job.settings == Default::default());
        apply(Edit::Strategy(Strategy::Spiral));
        apply(Edit::Centre(Some([1.0, 2.0, 3.0])));
        apply(Edit::Inward(true));
        let job = apply(Edit::Border(Some(1)));
        assert_eq!((job.layers.border, job.layers.inward), (Some(1), true));
        for _ in 0..10 {
            doc.undo();
        }
        assert_eq!(*doc.job(), Job::default());
    }

    #[test]
    fn a_copy_stands_behind_its_recipe_under_a_free_name() {
        let mut doc = Document::default();
        for name in ["A", "B", "A 2"] {
            doc.apply(&Edit::Recipe(Box::new(named(name, 1.0)), ids(&[1])), &ids(&[1]), None);
        }
        assert!(doc.apply(&Edit::DuplicateRecipe("A".into()), &ids(&[1]), None));
        assert_eq!(doc.undo_step(), Some(&UndoStep::Edited(Edit::DuplicateRecipe("A".into()))));
        let names = |doc: &Document| doc.job().recipes.iter().map(|r| r.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&doc), ["A", "A 3", "B", "A 2"]);
        assert_eq!(doc.job().recipes[1], named("A 3", 1.0));
        assert!(doc.job().surfaces_of_recipe("A 3").is_empty());
        doc.undo();
        assert_eq!(names(&doc), ["A", "B", "A 2"]);
        assert!(!doc.apply(&Edit::DuplicateRecipe("C".into()), &ids(&[1]), None), "there is none of that name");
    }

    #[test]
    fn no_recipe_is_renamed_onto_another() {
        let mut doc = Document::default();
        doc.apply(&Edit::Recipe(Box::new(named("A", 1.0)), ids(&[1])), &ids(&[1]), None);
        doc.apply(&Edit::Recipe(Box::new(named("B", 2.0)), ids(&[])), &ids(&[1]), None);
        assert!(!doc.apply(&Edit::RenameRecipe("A".into(), "B".into()), &ids(&[1]), None), "two of one name");
        assert!(!doc.apply(&Edit::RenameRecipe("A".into(), "  ".into()), &ids(&[1]), None));
    }

    #[test]
    fn a_recipe_from_elsewhere_takes_a_free_name_unless_it_is_known() {
        let mut job = Job::default();
        job.put_recipe(&named("A", 1.0), &[]);
        assert_eq!(job.under_free_name(&named("A", 1.0)).name, "A");
        assert_eq!(job.under_free_name(&named("A", 2.0)).name, "A 2");
        job.put_recipe(&named("A 2", 3.0), &[]);
        assert_eq!(job.under_free_name(&named("A", 2.0)).name, "A 3");
        job.put_recipe(&named("Recipe 1", 1.0), &[]);
        assert_eq!(job.new_recipe(|k| format!("Recipe {k}")).name, "Recipe 2");
    }

    #[test]
    fn merged_surfaces_leave_no_recipe_of_gone_numbers() {
        let mut doc = Document::default();
        doc.apply(&Edit::Recipe(Box::new(named("A", 1.0)), ids(&[2, 5])), &ids(&[2, 5]), None);
        doc.apply(&Edit::Merge(ids(&[2, 5])), &ids(&[2, 5]), None);
        assert_eq!(doc.job().surfaces_of_recipe("A"), [SurfaceId(2)]);
    }
}
