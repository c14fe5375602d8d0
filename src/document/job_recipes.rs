//! What recipes make of a job: its values on one surface, the overlap of neighbouring lines, and whether its recipes are
//! sound together.

use super::model::Job;
use super::parameter::Parameter;
use super::recipe::Recipe;
use super::start_from::StartFrom;
use super::value_error::RecipeError;
use crate::part::SurfaceId;
use std::borrow::Cow;
use std::ops::RangeInclusive;
use thiserror::Error;

/// Per cent by which neighbouring spots or beads may overlap.
pub const OVERLAP_PERCENT: RangeInclusive<f64> = 0.0..=95.0;

/// An overlap that no spacing gives.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("an overlap of {percent} per cent")]
pub struct OverlapError {
    /// Per cent.
    pub percent: f64,
}

impl Recipe {
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
}

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
