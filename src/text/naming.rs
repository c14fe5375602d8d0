//! What people call the surfaces of a job.

use super::{id, listed, say};
use crate::document::{Job, Settings};
use crate::part::SurfaceId;

/// The names that an operator gave to surfaces, for sentences about them.
#[derive(Clone, Copy, Debug)]
pub struct Naming<'a> {
    settings: &'a Settings,
}

impl<'a> Naming<'a> {
    /// The names in a job.
    pub fn of(job: &'a Job) -> Naming<'a> {
        Naming { settings: &job.settings }
    }

    /// A surface by its number, and by its name where it has one.
    pub fn surface(&self, surface: SurfaceId) -> String {
        match self.settings.of(surface).name.as_str() {
            "" => say!(surface_by_number, number = id(surface)),
            name => say!(surface_by_name, number = id(surface), name),
        }
    }

    /// Surfaces, each by its number and its name.
    pub fn surfaces(&self, list: &[SurfaceId]) -> String {
        listed(list.iter().map(|s| self.surface(*s)))
    }
}

/// Something about surfaces of a job, as a sentence for people.
pub trait NamedSentence {
    /// One line, without a full stop, as [`super::Sentence::sentence`].
    fn sentence_with(&self, naming: &Naming<'_>) -> String;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_is_said_as_the_operator_named_it() {
        let mut job = Job::default();
        job.settings.change(SurfaceId(3), |s| s.name = "Rim".into());
        let naming = Naming::of(&job);
        assert_eq!(naming.surfaces(&[SurfaceId(3), SurfaceId(1042)]), "surface 3 \"Rim\", surface 1042");
    }
}
