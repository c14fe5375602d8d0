//! What a job says of the bead: its section, the spacing that follows from it, its layers.

use super::model::{BeadParameters, Job};
use super::value_error::{BeadError, RecipeError, ValueError};
use crate::process::bead::Bead;

impl Job {
    /// The section of its bead; `None`: the beam lays nothing on the part.
    pub fn section_of_bead(&self) -> Option<Bead> {
        Bead::new(self.bead.width_mm, self.bead.height_mm)
    }

    /// The distance of centres at which beads fill a layer of their own height (P3 4.1), mm.
    pub fn bead_spacing_mm(&self) -> Option<f64> {
        Some(self.section_of_bead()?.spacing_mm())
    }

    /// How wide a line is worked: the bead, or the spot where nothing is laid, mm.
    pub fn track_mm(&self) -> f64 {
        if self.bead.width_mm > 0.0 { self.bead.width_mm } else { self.beam.spot_mm }
    }

    /// How many layers are laid on top of each other.
    pub fn layer_count(&self) -> u32 {
        if self.section_of_bead().is_some() { self.bead.layers } else { 1 }
    }
}

/// A bead to begin with is so high, as a share of its width.
const FLAT: f64 = 0.3;

impl BeadParameters {
    /// The parameters with a bead or without. Without one there are no layers; a new one is flat and `width_mm` wide.
    pub fn with_bead(&self, has_bead: bool, width_mm: f64) -> BeadParameters {
        if !has_bead {
            let BeadParameters { start_shift_mm, alternate, .. } = *self;
            return BeadParameters { start_shift_mm, alternate, ..BeadParameters::default() };
        }
        if self.width_mm > 0.0 && self.height_mm > 0.0 {
            return self.clone();
        }
        let height_mm = (FLAT * width_mm * 1e3).round() / 1e3;
        BeadParameters { width_mm, height_mm, ..self.clone() }
    }
}

/// Checks the bead of a job, and what each of its recipes makes of it.
pub(super) fn check(job: &Job) -> Result<(), ValueError> {
    check_one(job)?;
    for recipe in &job.recipes {
        check_one(&recipe.applied(job)).map_err(|source| RecipeError::Bead { recipe: recipe.name.clone(), source })?;
    }
    Ok(())
}

fn check_one(job: &Job) -> Result<(), BeadError> {
    let BeadParameters { width_mm, height_mm, layers, .. } = job.bead;
    if (width_mm > 0.0) != (height_mm > 0.0) {
        return Err(BeadError::Half { width_mm, height_mm });
    }
    if layers > 1 && width_mm == 0.0 {
        return Err(BeadError::LayersOfNothing { layers });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Recipe;
    use crate::document::parameter::{NumberFault, Parameter};

    #[test]
    fn spacing_and_overlap_follow_the_bead() {
        let mut job = Job::default();
        assert_eq!((job.bead_spacing_mm(), job.track_mm(), job.layer_count()), (None, 1.0, 1));
        assert_eq!(job.spacing_of_overlap(50.0), Ok(0.5));
        (job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (4.0, 2.0, 3);
        // Half a circle: π/4 of the width apart.
        let spacing = job.bead_spacing_mm().expect("a bead");
        assert!((spacing - std::f64::consts::PI).abs() < 1e-12);
        job.layers.spacing_mm = spacing;
        let overlap = job.overlap_percent();
        assert!((overlap - 100.0 * (1.0 - std::f64::consts::PI / 4.0)).abs() < 1e-9);
        assert!((job.spacing_of_overlap(overlap).expect("a spacing") - spacing).abs() < 1e-12);
        assert_eq!(job.layer_count(), 3);
    }

    #[test]
    fn a_bead_comes_whole_and_goes_with_its_layers() {
        let mut job = Job::default();
        job.bead.start_shift_mm = 5.0;
        let none = job.bead.clone();
        job.bead = none.with_bead(true, 3.0);
        assert_eq!((job.bead.width_mm, job.bead.height_mm, check(&job)), (3.0, 0.9, Ok(())));
        job.bead.layers = 4;
        assert_eq!(job.bead.with_bead(true, 1.0), job.bead, "there is one");
        job.bead = job.bead.with_bead(false, 3.0);
        assert_eq!((job.bead.clone(), check(&job)), (none, Ok(())));
    }

    #[test]
    fn half_a_bead_is_refused() {
        let mut job = Job::default();
        job.bead.width_mm = 2.0;
        assert_eq!(check(&job), Err(BeadError::Half { width_mm: 2.0, height_mm: 0.0 }.into()));
        job.bead.height_mm = 1.0;
        assert_eq!(check(&job), Ok(()));
        job = Job::default();
        job.bead.layers = 2;
        assert_eq!(check(&job), Err(BeadError::LayersOfNothing { layers: 2 }.into()));
        job = Job::default();
        let thick = |key: &str, value: f64| Recipe {
            name: "thick".into(),
            values: [(key.to_owned(), value)].into(),
            ..Recipe::default()
        };
        job.recipes.push(thick("bead.height_mm", 1.0));
        let source = BeadError::Half { width_mm: 0.0, height_mm: 1.0 };
        assert_eq!(check(&job), Err(RecipeError::Bead { recipe: "thick".into(), source }.into()));
        assert!(Parameter::named("bead.layers").is_for_recipes());
        let fault = |r: &Recipe| match r.check() {
            Err(RecipeError::Number { source, .. }) => Some(source.fault),
            _ => None,
        };
        assert_eq!(fault(&thick("bead.layers", 1.5)), Some(NumberFault::NotWhole));
    }
}
