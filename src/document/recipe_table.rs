//! Recipes beside each other: what a surface would be worked with under each of them, as values.

use super::model::Job;
use super::parameter::{PARAMETERS, Parameter};
use super::recipe::Recipe;
use super::start_from::StartFrom;
use crate::path::{Direction, Order, Strategy};

/// What a row compares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Compared {
    /// How lines are laid.
    Strategy,
    /// Normal of the section planes.
    Direction,
    /// Sense and order of lines.
    Order,
    /// What offset lines start from.
    Start,
    /// In which sense a spiral runs.
    Sense,
    /// Centre of a spiral.
    Centre,
    /// A number.
    Number(&'static Parameter),
}

/// A value of that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ComparedValue {
    /// How lines are laid.
    Strategy(Strategy),
    /// Normal of the section planes.
    Direction(Direction),
    /// Sense and order of lines.
    Order(Order),
    /// What offset lines start from.
    Start(StartFrom),
    /// Whether a spiral runs from the rim to its centre.
    Inward(bool),
    /// Centre of a spiral, part frame, mm; `None`: the middle of the surface.
    Centre(Option<[f64; 3]>),
    /// A number, in the unit of its parameter.
    Number(f64),
}

impl Compared {
    /// The value that a job has.
    fn of(self, job: &Job) -> ComparedValue {
        let l = &job.layers;
        match self {
            Compared::Strategy => ComparedValue::Strategy(l.strategy),
            Compared::Direction => ComparedValue::Direction(l.direction),
            Compared::Order => ComparedValue::Order(l.order),
            Compared::Start => ComparedValue::Start(l.border.into()),
            Compared::Sense => ComparedValue::Inward(l.inward),
            Compared::Centre => ComparedValue::Centre(l.centre_mm),
            Compared::Number(p) => ComparedValue::Number(job.number(p)),
        }
    }

    /// Whether a recipe names a value of its own.
    fn is_named_by(self, recipe: &Recipe) -> bool {
        match self {
            Compared::Strategy => recipe.strategy.is_some(),
            Compared::Direction => recipe.direction.is_some(),
            Compared::Order => recipe.order.is_some(),
            Compared::Start => recipe.border.is_some(),
            Compared::Sense => recipe.inward.is_some(),
            Compared::Centre => recipe.centre_mm.is_some(),
            Compared::Number(p) => recipe.values.contains_key(p.key),
        }
    }
}

/// One value under every recipe.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedRow {
    /// What it is.
    pub what: Compared,
    /// As it is under each of them.
    pub cells: Vec<ComparedCell>,
}

/// A value under one recipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedCell {
    /// The value.
    pub value: ComparedValue,
    /// Whether the recipe names it; else it is the job's.
    pub is_own: bool,
}

impl ComparedRow {
    /// Whether the recipes do not agree in it.
    pub fn differs(&self) -> bool {
        self.cells.windows(2).any(|w| w[0].value != w[1].value)
    }
}

/// The rows for some recipes of a job; `None` stands for its own values.
pub fn rows(job: &Job, recipes: &[Option<&Recipe>]) -> Vec<ComparedRow> {
    let under: Vec<(Option<&Recipe>, Job)> =
        recipes.iter().map(|r| (*r, r.map_or_else(|| job.clone(), |r| r.applied(job)))).collect();
    let any = |strategy: Strategy| under.iter().any(|(_, j)| j.layers.strategy == strategy);
    let mut compared = vec![Compared::Strategy, Compared::Direction, Compared::Order];
    if any(Strategy::Offset) {
        compared.push(Compared::Start);
    }
    if any(Strategy::Spiral) {
        compared.extend([Compared::Sense, Compared::Centre]);
    }
    compared.extend(PARAMETERS.iter().filter(|p| p.is_for_recipes()).map(Compared::Number));
    let cell = |what: Compared, recipe: Option<&Recipe>, job: &Job| ComparedCell {
        value: what.of(job),
        is_own: recipe.is_some_and(|r| what.is_named_by(r)),
    };
    let row = |what: Compared| ComparedRow { what, cells: under.iter().map(|(r, job)| cell(what, *r, job)).collect() };
    compared.into_iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_tell_what_differs_and_whose_it_is() {
        let job = Job::default();
        let values = [("layers.spacing_mm".to_owned(), 0.25), ("beam.power_w".to_owned(), 500.0)].into();
        let fine = Recipe { name: "Fine".into(), strategy: Some(Strategy::Spiral), values, ..Recipe::default() };
        let rows = rows(&job, &[None, Some(&fine)]);
        let differ: Vec<Compared> = rows.iter().filter(|r| r.differs()).map(|r| r.what).collect();
        assert_eq!(differ, [Compared::Strategy, Compared::Number(Parameter::named("layers.spacing_mm"))]);
        let of = |key: &str| rows.iter().find(|r| r.what == Compared::Number(Parameter::named(key)));
        let cells = &of("beam.power_w").expect("there").cells;
        assert_eq!(
            cells.iter().map(|c| (c.value, c.is_own)).collect::<Vec<_>>(),
            [(ComparedValue::Number(500.0), false), (ComparedValue::Number(500.0), true)]
        );
        assert_eq!(of("beam.air_speed_mm_s"), None, "one for the whole program");
    }
}
