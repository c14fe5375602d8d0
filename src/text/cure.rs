//! What gives lines to surfaces that have none.

use super::{NamedSentence, Naming, Sentence, choices, exact, listed, say};
use crate::document::{Edit, LineChange};
use crate::part::SurfaceId;
use crate::planning::cures::Cure;

/// So many surfaces are named, and one more where that is the last.
const NAMED: usize = 3;

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
        let (change, surfaces) = (self.change.sentence(), named(&self.surfaces, naming));
        match &self.edit {
            Edit::Recipe(recipe, _) => say!(cure_in_recipe, change, recipe = &recipe.name, surfaces),
            _ => say!(cure, change, surfaces),
        }
    }
}

fn named(surfaces: &[SurfaceId], naming: &Naming<'_>) -> String {
    let names = |few: &[SurfaceId]| listed(few.iter().map(|s| naming.surface(*s)));
    match surfaces.get(..NAMED) {
        Some(few) if surfaces.len() > NAMED + 1 => {
            say!(cure_and_more, list = names(few), more = surfaces.len() - NAMED)
        }
        _ => names(surfaces),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Job, Recipe};

    #[test]
    fn a_cure_says_what_is_changed_where_and_for_whom() {
        let mut job = Job::default();
        job.settings.change(SurfaceId(2), |s| s.name = "Rim".into());
        let naming = Naming::of(&job);
        let told = |change: LineChange, edit: Edit, last: u32| {
            let surfaces = (1..=last).map(SurfaceId).collect();
            Cure { surfaces, change, edit }.sentence_with(&naming)
        };
        let inset = (LineChange::Inset(0.25), Edit::Set("layers.inset_mm", 0.25));
        assert_eq!(told(inset.0, inset.1.clone(), 1), "use an inset of 0.25 mm: that gives lines to surface 1");
        let all = "use an inset of 0.25 mm: that gives lines to surface 1, surface 2 \"Rim\", surface 3 and 5 more";
        assert_eq!(told(inset.0, inset.1, 8), all);
        let recipe = Edit::Recipe(Box::new(Recipe { name: "Fine".into(), ..Recipe::default() }), Vec::new());
        let fine = "keep pieces from 40 mm in the recipe Fine: that gives lines to surface 1";
        assert_eq!(told(LineChange::Shortest(40.0), recipe, 1), fine);
    }
}
