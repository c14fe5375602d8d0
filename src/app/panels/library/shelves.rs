//! All recipes at hand.

use super::super::super::context::Context;
use super::shelf::Shelf;
use crate::document::Recipe;

impl<'a> Context<'a> {
    /// The recipes of each shelf.
    pub fn shelves(self) -> [(Shelf, Vec<&'a Recipe>); 3] {
        let library = self.recipes;
        [
            (Shelf::Job, self.document.job().recipes.iter().collect()),
            (Shelf::Mine, library.kept.iter().map(|(_, r)| r).collect()),
            (Shelf::Shipped, library.shipped.iter().collect()),
        ]
    }
}
