//! Recipes: named sets of values that surfaces are worked with in place of the job's own.
//!
//! A recipe names parameters by their keys, so whatever the table of parameters allows for
//! recipes can differ from surface to surface. What a recipe does not name is the job's.

use super::parameter::Parameter;
use super::start_from::StartFrom;
use super::value_error::RecipeError;
use crate::part::keyed;
use crate::path::{Direction, Order, Strategy};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A named set of values.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Recipe {
    /// What it is called.
    pub name: String,
    /// What it is good for, in one line; it changes nothing.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub note: String,
    /// How lines are laid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strategy: Option<Strategy>,
    /// Normal of the section planes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<Direction>,
    /// Sense of neighbouring lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<Order>,
    /// For offset lines: the border to start from, or the whole outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub border: Option<StartFrom>,
    /// For a spiral: its centre, part frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_mm: Option<[f64; 3]>,
    /// For a spiral: from the rim to the centre.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inward: Option<bool>,
    /// Numbers by their keys in the job file.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<String, f64>,
}

impl Recipe {
    /// The recipe as it can be used on other parts: without border and centre, which are places on this one.
    pub fn without_places(&self) -> Recipe {
        let border = self.border.filter(|b| *b == StartFrom::Whole);
        Recipe { border, centre_mm: None, ..self.clone() }
    }

    /// Checks its numbers, each by itself.
    ///
    /// # Errors
    /// The first that recipes do not hold, or that cannot be.
    pub fn check(&self) -> Result<(), RecipeError> {
        let recipe = || self.name.clone();
        self.values.iter().try_for_each(|(key, value)| match Parameter::by_key(key) {
            Some(p) if p.is_for_recipes() => {
                p.check(*value).map_err(|source| RecipeError::Number { recipe: recipe(), source })
            }
            _ => Err(RecipeError::NotForRecipes { recipe: recipe(), key: key.clone() }),
        })
    }
}

// What a recipe is good for changes nothing.
keyed!(Recipe { name, strategy, direction, order, border, centre_mm, inward, values; note });
