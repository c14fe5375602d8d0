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
