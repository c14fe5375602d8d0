//! Changes of how lines are laid, and the edit that makes one where the value of a surface comes from: the surface
//! itself, its recipe, or the job.

use super::edit::Edit;
use super::model::Job;
use super::recipe::Recipe;
use super::start_from::StartFrom;
use crate::part::SurfaceId;
use crate::path::{Direction, Strategy};

/// One change of how lines are laid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineChange {
    /// Another direction of the planes.
    Direction(Direction),
    /// Another spacing, mm.
    Spacing(f64),
    /// Another inset from the rim, mm.
    Inset(f64),
    /// Holes up to another width keep no lines off, mm.
    IgnoredHoles(f64),
    /// Pieces from another length are kept, mm.
    Shortest(f64),
    /// Offset lines start from the whole outline.
    WholeOutline,
    /// Another strategy.
    Strategy(Strategy),
}

impl LineChange {
    /// The edit that makes the change for a surface.
    pub fn edit(self, job: &Job, surface: SurfaceId) -> Edit {
        if self == LineChange::WholeOutline && job.settings.of(surface).border.is_some() {
            return Edit::SurfaceBorder(surface, Some(StartFrom::Whole));
        }
        match job.recipe_of(surface).and_then(|recipe| self.in_recipe(recipe)) {
            Some(changed) => Edit::Recipe(Box::new(changed), Vec::new()),
            None => self.in_job(),
        }
    }

    fn in_job(self) -> Edit {
        match self {
            LineChange::Direction(direction) => Edit::Direction(direction),
            LineChange::WholeOutline => Edit::Border(None),
            LineChange::Strategy(strategy) => Edit::Strategy(strategy),
            LineChange::Spacing(mm)
            | LineChange::Inset(mm)
            | LineChange::IgnoredHoles(mm)
            | LineChange::Shortest(mm) => Edit::Set(self.key(), mm),
        }
    }

    /// A recipe with the change; `None`: it leaves that to the job.
    fn in_recipe(self, recipe: &Recipe) -> Option<Recipe> {
        let mut changed = recipe.clone();
        match self {
            LineChange::Direction(direction) => *changed.direction.as_mut()? = direction,
            LineChange::WholeOutline => *changed.border.as_mut()? = StartFrom::Whole,
            LineChange::Strategy(strategy) => *changed.strategy.as_mut()? = strategy,
            LineChange::Spacing(mm)
            | LineChange::Inset(mm)
            | LineChange::IgnoredHoles(mm)
            | LineChange::Shortest(mm) => *changed.values.get_mut(self.key())? = mm,
        }
        Some(changed)
    }

    /// Key of the number that it changes; empty where it changes a choice.
    fn key(self) -> &'static str {
        match self {
            LineChange::Spacing(_) => "layers.spacing_mm",
            LineChange::Inset(_) => "layers.inset_mm",
            LineChange::IgnoredHoles(_) => "layers.ignore_holes_mm",
            LineChange::Shortest(_) => "layers.shortest_mm",
            LineChange::Direction(_) | LineChange::WholeOutline | LineChange::Strategy(_) => "",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Parameter;

    #[test]
    fn the_value_is_changed_where_it_comes_from() {
        let (plain, fine) = (SurfaceId(1), SurfaceId(2));
        let mut job = Job::default();
        let values = [("layers.inset_mm".to_owned(), 9.0)].into();
        let recipe = Recipe { name: "Fine".into(), direction: Some(Direction::Auto), values, ..Recipe::default() };
        job.recipes.push(recipe.clone());
        job.settings.change(fine, |s| s.recipe = Some("Fine".into()));
        job.settings.change(plain, |s| s.border = Some(StartFrom::Border(3)));

        assert_eq!(LineChange::Inset(2.0).edit(&job, plain), Edit::Set("layers.inset_mm", 2.0));
        assert_eq!(LineChange::Shortest(2.0).edit(&job, fine), Edit::Set("layers.shortest_mm", 2.0));
        let whole = Edit::SurfaceBorder(plain, Some(StartFrom::Whole));
        assert_eq!(LineChange::WholeOutline.edit(&job, plain), whole);
        assert_eq!(LineChange::WholeOutline.edit(&job, fine), Edit::Border(None));
        let x = Direction::AXES[0].1;
        for (change, wanted) in [
            (LineChange::Inset(2.0), Recipe { values: [("layers.inset_mm".to_owned(), 2.0)].into(), ..recipe.clone() }),
            (LineChange::Direction(x), Recipe { direction: Some(x), ..recipe.clone() }),
        ] {
            let edit = change.edit(&job, fine);
            assert_eq!(edit, Edit::Recipe(Box::new(wanted), Vec::new()));
            let mut changed = job.clone();
            edit.apply(&mut changed, &[plain, fine]);
            assert_eq!(changed.settings, job.settings, "surfaces keep their recipes");
            assert_ne!(changed.of_surface(fine).layers, job.of_surface(fine).layers);
            assert_eq!(changed.of_surface(plain).layers, job.of_surface(plain).layers);
        }
    }

    #[test]
    fn every_number_it_changes_is_a_parameter_of_recipes() {
        for change in [LineChange::Spacing, LineChange::Inset, LineChange::IgnoredHoles, LineChange::Shortest] {
            assert!(Parameter::by_key(change(1.0).key()).is_some_and(Parameter::is_for_recipes));
        }
    }
}
