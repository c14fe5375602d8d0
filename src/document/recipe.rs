//! Recipes: named sets of values that surfaces are worked with in place of the job's own.
//!
//! A recipe names parameters by their keys, so whatever the table of parameters allows for
//! recipes can differ from surface to surface. What a recipe does not name is the job's.

use super::bead::BeadError;
use super::model::Job;
use super::parameter::{Parameter, ParameterError};
use super::start_from::StartFrom;
use crate::part::{SurfaceId, keyed};
use crate::path::{Direction, Order, Strategy};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Per cent by which neighbouring spots or beads may overlap.
pub const OVERLAP_PERCENT: RangeInclusive<f64> = 0.0..=95.0;

/// What is wrong with the recipes of a job.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RecipeError {
    /// A key of a number that recipes do not hold, or of none.
    #[error("recipe {recipe:?}: {key:?} is not for recipes")]
    NotForRecipes {
        /// Name of the recipe.
        recipe: String,
        /// The key.
        key: String,
    },
    /// A number that cannot be.
    #[error("recipe {recipe:?}: {source}")]
    Number {
        /// Name of the recipe.
        recipe: String,
        /// Which, and what is wrong with it.
        source: ParameterError,
    },
    /// A bead that cannot be, with the job's values beside those of the recipe.
    #[error("recipe {recipe:?}: {source}")]
    Bead {
        /// Name of the recipe.
        recipe: String,
        /// What is wrong with it.
        source: BeadError,
    },
    /// Two of one name.
    #[error("two recipes {name:?}")]
    Twice {
        /// The name.
        name: String,
    },
    /// A surface has one that is not there.
    #[error("surface {surface} has recipe {name:?}, which is not there")]
    Missing {
        /// The surface.
        surface: SurfaceId,
        /// The name.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
}

/// An overlap that no spacing gives.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("an overlap of {percent} per cent")]
pub struct OverlapError {
    /// Per cent.
    pub percent: f64,
}

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
    /// As it can be used on other parts: without the places of this one.
    pub fn without_places(&self) -> Recipe {
        let border = self.border.filter(|b| *b == StartFrom::Whole);
        Recipe { border, centre_mm: None, ..self.clone() }
    }

    /// The job with the recipe's values in place of its own.
    pub fn applied(&self, job: &Job) -> Job {
        let mut own = job.clone();
        own.layers.strategy = self.strategy.unwrap_or(own.layers.strategy);
        own.layers.direction = self.direction.unwrap_or(own.layers.direction);
        own.layers.order = self.order.unwrap_or(own.layers.order);
        own.layers.border = self.border.map_or(own.layers.border, StartFrom::border);
        own.layers.centre_mm = self.centre_mm.or(own.layers.centre_mm);
        own.layers.inward = self.inward.unwrap_or(own.layers.inward);
        for (key, value) in &self.values {
            if let Some(p) = Parameter::by_key(key) {
                own.set_number(p, *value);
            }
        }
        own
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

impl Job {
    /// The recipe that a surface is worked with; `None`: the job's own values.
    pub fn recipe_of(&self, surface: SurfaceId) -> Option<&Recipe> {
        let name = self.settings.of(surface).recipe.as_ref()?;
        self.recipes.iter().find(|r| r.name == *name)
    }

    /// The job as it is for one surface: its recipe's values go before the job's, its own border and centre before
    /// both.
    pub fn of_surface(&self, surface: SurfaceId) -> Cow<'_, Job> {
        let own = self.settings.of(surface);
        let mut job = self.recipe_of(surface).map_or(Cow::Borrowed(self), |r| Cow::Owned(r.applied(self)));
        if let Some(start) = own.border {
            job.to_mut().layers.border = start.border();
        }
        if own.centre_mm.is_some() {
            job.to_mut().layers.centre_mm = own.centre_mm;
        }
        job
    }

    /// The spacing at which neighbouring spots, or beads where one is told, overlap by so many per cent of
    /// their width, mm.
    ///
    /// # Errors
    /// The overlap lies outside [`OVERLAP_PERCENT`].
    pub fn spacing_of_overlap(&self, percent: f64) -> Result<f64, OverlapError> {
        if !OVERLAP_PERCENT.contains(&percent) {
            return Err(OverlapError { percent });
        }
        Ok(self.track_mm() * (1.0 - 0.01 * percent))
    }

    /// The overlap of neighbouring spots, or beads where one is told, as a share of their width, per cent;
    /// negative where they do not meet.
    pub fn overlap_percent(&self) -> f64 {
        100.0 * (1.0 - self.layers.spacing_mm / self.track_mm())
    }

    /// Checks its recipes, and which surfaces have them.
    ///
    /// # Errors
    /// Two of one name, one that is not there, a key or number that cannot be.
    pub fn check_recipes(&self) -> Result<(), RecipeError> {
        for (i, r) in self.recipes.iter().enumerate() {
            r.check()?;
            if self.recipes[..i].iter().any(|other| other.name == r.name) {
                return Err(RecipeError::Twice { name: r.name.clone() });
            }
        }
        for (surface, settings) in self.settings.iter() {
            let Some(name) = &settings.recipe else { continue };
            if !self.recipes.iter().any(|r| r.name == *name) {
                let known = self.recipes.iter().map(|r| r.name.clone()).collect();
                return Err(RecipeError::Missing { surface, name: name.clone(), known });
            }
        }
        Ok(())
    }
}
