//! A name or note that is being typed, until it becomes an edit.

use crate::document::{Edit, Job, Recipe};

/// What is typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typed {
    /// Another name.
    Name,
    /// A note.
    Note,
}

/// The text so far, and the recipe that it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Draft {
    recipe: String,
    what: Typed,
    text: String,
}

impl Draft {
    /// A text for a recipe.
    pub fn new(recipe: &Recipe, what: Typed, text: String) -> Draft {
        Draft { recipe: recipe.name.clone(), what, text }
    }

    /// Whether it belongs to a recipe.
    pub fn is_of(&self, recipe: &Recipe) -> bool {
        self.recipe == recipe.name
    }

    /// Whether this is what is typed.
    pub fn is(&self, what: Typed) -> bool {
        self.what == what
    }

    /// The text so far.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What it makes of its recipe; `None`: that is gone.
    pub fn edit(&self, job: &Job) -> Option<Edit> {
        let known = job.recipes.iter().find(|r| r.name == self.recipe)?;
        let text = self.text.trim().to_owned();
        Some(match self.what {
            Typed::Name => Edit::RenameRecipe(known.name.clone(), text),
            Typed::Note => Edit::Recipe(Box::new(Recipe { note: text, ..known.clone() }), Vec::new()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_draft_becomes_an_edit_of_its_recipe_as_long_as_that_is_there() {
        let recipe = Recipe { name: "fine".into(), ..Recipe::default() };
        let job = Job { recipes: vec![recipe.clone()], ..Job::default() };
        let name = Draft::new(&recipe, Typed::Name, " finer ".into());
        assert_eq!(name.edit(&job), Some(Edit::RenameRecipe("fine".into(), "finer".into())));
        let note = Draft::new(&recipe, Typed::Note, "for rims".into());
        let noted = Recipe { note: "for rims".into(), ..recipe.clone() };
        assert_eq!(note.edit(&job), Some(Edit::Recipe(Box::new(noted), Vec::new())));
        assert!(note.is_of(&recipe) && note.is(Typed::Note) && !note.is(Typed::Name));
        assert_eq!(name.edit(&Job::default()), None);
    }
}
