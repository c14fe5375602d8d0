//! What gives lines to surfaces that have none.

use super::{NamedSentence, Naming, Sentence, choices, exact, listed, say};
use crate::document::{Edit, LineChange};
use crate::planning::cures::Cure;

impl Sentence for LineChange {
    fn sentence(&self) -> String {
        match *self {
            LineChange::Direction(direction) => say!(change_direction, direction = choices::direction(direction)),
            LineChange::Spacing(mm) => say!(change_spacing, mm = exact(mm)),
            LineChange::Inset(mm) => say!(change_inset, mm = exact(mm)),
            LineChange::IgnoredHoles(mm) => say!(change_ignored_holes, mm = exact(mm)),
            LineChange::Shortest(mm) => say!(change_shortest, mm = exact(mm)),
            LineChange::WholeOutline => say!(change_whole_outline),
            LineChange::Strategy(strategy) => say!(change_strategy, strategy = choices::strategy(strategy)),
        }
    }
}

/// The change, where it is made if that is a recipe, and which surfaces get lines by it.
impl NamedSentence for Cure {
    fn sentence_with(&self, naming: &Naming<'_>) -> String {
        let (change, surfaces) = (self.change.sentence(), listed(self.surfaces.iter().map(|s| naming.surface(*s))));
        match &self.edit {
            Edit::Recipe(recipe, _) => say!(cure_in_recipe, change, recipe = &recipe.name, surfaces),
            _ => say!(cure, change, surfaces),
        }
    }
}
