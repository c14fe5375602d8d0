//! Recipes: named sets of values that surfaces are worked with in place of the job's own.
//!
//! A recipe names parameters by their keys, so whatever the table of parameters knows of layers, beam,
//! path and bead can differ from surface to surface. What a recipe does not name is the job's.

use super::model::Job;
use super::parameter::Parameter;
use super::start_from::StartFrom;
use crate::part::SurfaceId;
use crate::path::{Direction, Order, Strategy};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Tables of the job file whose numbers a recipe may hold.
const TABLES: [&str; 4] = ["layers.", "beam.", "path.", "bead."];
/// What of them is the same for the whole program.
const WHOLE: [&str; 3] = ["beam.air_speed_mm_s", "beam.margin_mm", "path.tilt_rate_deg_s"];

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
    /// Whether recipes may hold a parameter.
    pub fn may_hold(key: &str) -> bool {
        TABLES.iter().any(|t| key.starts_with(t)) && !WHOLE.contains(&key)
    }

    /// The same for other parts: without the places of this one.
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
                (p.set)(&mut own, *value);
            }
        }
        own
    }

    /// What is wrong with it, as a sentence.
    ///
    /// # Errors
    /// A key that recipes do not hold, or a number out of range.
    pub fn check(&self) -> Result<(), String> {
        self.values.iter().try_for_each(|(key, value)| match Parameter::by_key(key) {
            Some(p) if Recipe::may_hold(key) => p.check(*value).map_err(|e| format!("recipe {:?}: {e}", self.name)),
            _ => Err(format!(
                "recipe {:?}: {key:?} is nothing that a recipe can hold; see the keys in the README",
                self.name
            )),
        })
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
    /// There is none for that.
    pub fn spacing_of_overlap(&self, percent: f64) -> Result<f64, String> {
        if !(0.0..=95.0).contains(&percent) {
            return Err(format!("overlap = {percent}: give a number from 0 to 95 %"));
        }
        Ok(self.track_mm() * (1.0 - 0.01 * percent))
    }

    /// The overlap of neighbouring spots, or beads where one is told, as a share of their width, per cent;
    /// negative where they do not meet.
    pub fn overlap_percent(&self) -> f64 {
        100.0 * (1.0 - self.layers.spacing_mm / self.track_mm())
    }

    /// What is wrong with its recipes, as a sentence.
    ///
    /// # Errors
    /// Two of one name, one that is not there, a key or number that cannot be.
    pub fn check_recipes(&self) -> Result<(), String> {
        for (i, r) in self.recipes.iter().enumerate() {
            r.check()?;
            if self.recipes[..i].iter().any(|other| other.name == r.name) {
                return Err(format!("there are two recipes {:?}; give one another name", r.name));
            }
        }
        for (surface, settings) in self.settings.iter() {
            let Some(name) = &settings.recipe else { continue };
            if !self.recipes.iter().any(|r| r.name == *name) {
                let known: Vec<&str> = self.recipes.iter().map(|r| r.name.as_str()).collect();
                return Err(format!(
                    "surface {surface} has the recipe {name:?}, which the job does not have (it has: {})",
                    known.join(", ")
                ));
            }
        }
        Ok(())
    }
}
