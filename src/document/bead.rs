//! What a job says of the bead: its section, the spacing that follows from it, its layers.

use super::model::{BeadParameters, Job};
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
        if self.section_of_bead().is_some() { self.bead.layers as u32 } else { 1 }
    }
}

/// A bead to begin with is so high, as a share of its width.
const FLAT: f64 = 0.3;

impl BeadParameters {
    /// The same with no bead, and then no layers; or where there is none with a flat one of a width, mm.
    pub fn laid(&self, is_laid: bool, width_mm: f64) -> BeadParameters {
        if !is_laid {
            return BeadParameters { width_mm: 0.0, height_mm: 0.0, layers: 1.0, ..self.clone() };
        }
        if self.width_mm > 0.0 && self.height_mm > 0.0 {
            return self.clone();
        }
        let height_mm = (FLAT * width_mm * 1e3).round() / 1e3;
        BeadParameters { width_mm, height_mm, ..self.clone() }
    }
}

/// What is wrong with the bead of a job or of one of its recipes, as a sentence.
pub(super) fn check(job: &Job) -> Result<(), String> {
    one(job).and_then(|()| {
        let of = |r: &super::Recipe| one(&r.applied(job)).map_err(|e| format!("recipe {:?}: {e}", r.name));
        job.recipes.iter().try_for_each(of)
    })
}

fn one(job: &Job) -> Result<(), String> {
    let b = &job.bead;
    if (b.width_mm > 0.0) != (b.height_mm > 0.0) {
        return Err(format!(
            "bead.width_mm = {}, bead.height_mm = {}: give both above 0, or both 0 where nothing is laid",
            b.width_mm, b.height_mm
        ));
    }
    if b.layers.fract() != 0.0 {
        return Err(format!("bead.layers = {}: give a whole number", b.layers));
    }
    if b.layers > 1.0 && b.width_mm == 0.0 {
        return Err(format!(
            "bead.layers = {}: give bead.width_mm and bead.height_mm too; without a bead use layers.passes",
            b.layers
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Recipe;

    #[test]
    fn spacing_and_overlap_follow_the_bead() {
        let mut job = Job::default();
        assert_eq!((job.bead_spacing_mm(), job.track_mm(), job.layer_count()), (None, 1.0, 1));
        assert_eq!(job.spacing_of_overlap(50.0), Ok(0.5));
        (job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (4.0, 2.0, 3.0);
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
        job.bead = none.laid(true, 3.0);
        assert_eq!((job.bead.width_mm, job.bead.height_mm, check(&job)), (3.0, 0.9, Ok(())));
        job.bead.layers = 4.0;
        assert_eq!(job.bead.laid(true, 1.0), job.bead, "there is one");
        job.bead = job.bead.laid(false, 3.0);
        assert_eq!((job.bead.clone(), check(&job)), (none, Ok(())));
    }

    #[test]
    fn half_a_bead_is_refused() {
        let mut job = Job::default();
        job.bead.width_mm = 2.0;
        assert!(check(&job).is_err_and(|e| e.contains("give both above 0")));
        job.bead.height_mm = 1.0;
        assert_eq!(check(&job), Ok(()));
        job.bead.layers = 1.5;
        assert!(check(&job).is_err_and(|e| e.contains("whole number")));
        job = Job::default();
        job.bead.layers = 2.0;
        assert!(check(&job).is_err_and(|e| e.contains("layers.passes")));
        job = Job::default();
        job.recipes.push(Recipe {
            name: "thick".into(),
            values: [("bead.height_mm".to_owned(), 1.0)].into(),
            ..Recipe::default()
        });
        assert!(check(&job).is_err_and(|e| e.contains("recipe \"thick\"")));
        assert!(Recipe::may_hold("bead.layers"));
    }
}
