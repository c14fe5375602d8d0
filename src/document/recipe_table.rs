//! Recipes beside each other: what a surface would be worked with under each of them.

use super::model::Job;
use super::parameter::PARAMETERS;
use super::recipe::Recipe;
use crate::path::Strategy;

/// One value under every recipe.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What it is, with its unit.
    pub label: String,
    /// As it is under each of them.
    pub cells: Vec<Cell>,
}

/// A value under one recipe.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// As people read it.
    pub text: String,
    /// Whether the recipe names it; else it is the job's.
    pub is_own: bool,
}

impl Row {
    /// Whether the recipes do not agree in it.
    pub fn differs(&self) -> bool {
        self.cells.windows(2).any(|w| w[0].text != w[1].text)
    }
}

/// The rows for some recipes of a job; `None` stands for its own values.
pub fn rows(job: &Job, recipes: &[Option<&Recipe>]) -> Vec<Row> {
    let under: Vec<(Option<&Recipe>, Job)> =
        recipes.iter().map(|r| (*r, r.map_or_else(|| job.clone(), |r| r.applied(job)))).collect();
    let row = |label: &str, text: &dyn Fn(&Job) -> String, is_own: &dyn Fn(&Recipe) -> bool| Row {
        label: label.into(),
        cells: under.iter().map(|(r, job)| Cell { text: text(job), is_own: r.is_some_and(is_own) }).collect(),
    };
    let mut rows = vec![
        row("Strategy", &|j| j.layers.strategy.word().into(), &|r| r.strategy.is_some()),
        row("Direction", &|j| j.layers.direction.to_string(), &|r| r.direction.is_some()),
        row("Lines", &|j| j.layers.order.word().into(), &|r| r.order.is_some()),
    ];
    if under.iter().any(|(_, j)| j.layers.strategy == Strategy::Offset) {
        let text = |j: &Job| {
            j.layers.border.map_or_else(|| "whole outline".into(), |b| format!("border {}", b.saturating_add(1)))
        };
        rows.push(row("Starts from", &text, &|r| r.border.is_some()));
    }
    if under.iter().any(|(_, j)| j.layers.strategy == Strategy::Spiral) {
        let sense = |j: &Job| if j.layers.inward { "inwards" } else { "outwards" }.to_owned();
        rows.push(row("Spiral runs", &sense, &|r| r.inward.is_some()));
        let centre = |j: &Job| j.layers.centre_mm.map_or_else(|| "middle".into(), place);
        rows.push(row("Spiral centre", &centre, &|r| r.centre_mm.is_some()));
    }
    for p in PARAMETERS.iter().filter(|p| Recipe::may_hold(p.key)) {
        let label = if p.unit.is_empty() { p.label.to_owned() } else { format!("{}, {}", p.label, p.unit) };
        rows.push(row(&label, &|j| format!("{}", (p.get)(j)), &|r| r.values.contains_key(p.key)));
    }
    rows
}

/// A place as people read it, mm.
pub fn place(at: [f64; 3]) -> String {
    // No minus before a zero.
    let [x, y, z] = at.map(|c| (c * 10.0).round() / 10.0 + 0.0);
    format!("({x:.1}, {y:.1}, {z:.1})")
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
        let differ: Vec<&str> = rows.iter().filter(|r| r.differs()).map(|r| r.label.as_str()).collect();
        assert_eq!(differ, ["Strategy", "Spacing, mm"]);
        let power = rows.iter().find(|r| r.label == "Power, W").expect("there");
        assert_eq!(
            power.cells.iter().map(|c| (c.text.as_str(), c.is_own)).collect::<Vec<_>>(),
            [("500", false), ("500", true)]
        );
        assert!(rows.iter().all(|r| r.label != "Air speed, mm/s"), "one for the whole program");
    }
}
