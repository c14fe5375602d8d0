//! What of a program is not as it was wanted, by surface: leads that are not free, and figures that the cell cannot
//! set though they change.

use crate::cell::outputs::{LevelForm, Outputs};
use crate::pose::Pass;
use std::collections::BTreeMap;

/// All remarks. `pieces`: for each lit piece its pass, and how many of its leads are left out.
pub fn remarks<'a>(pieces: impl Iterator<Item = (&'a Pass, usize)> + Clone, outputs: &Outputs) -> Vec<(u32, String)> {
    let mut out = left_out(pieces.clone());
    let mut hand = |form: LevelForm, (name, unit): (&str, &str), figure: fn(&Pass) -> f64| {
        if form == LevelForm::Comment {
            out.extend(by_hand(pieces.clone().map(|p| (p.0.surface, figure(p.0))), name, unit));
        }
    };
    hand(outputs.power.form, ("power", "W"), |p| p.work.power_w);
    hand(outputs.frequency.form, ("frequency", "kHz"), |p| p.work.frequency_khz);
    out.sort_by_key(|r| r.0);
    out
}

/// What is said of leads that were left out, by surface.
fn left_out<'a>(of_pieces: impl Iterator<Item = (&'a Pass, usize)>) -> Vec<(u32, String)> {
    let mut counts = BTreeMap::<u32, usize>::new();
    for (pass, left_out) in of_pieces {
        *counts.entry(pass.surface).or_default() += left_out;
    }
    counts.retain(|_, count| *count > 0);
    let said = |count| match count {
        1 => "1 lead-in or lead-out is left out: something would be touched on it".to_owned(),
        _ => format!("{count} lead-ins and lead-outs are left out: something would be touched on them"),
    };
    counts.into_iter().map(|(surface, count)| (surface, said(count))).collect()
}

/// Surfaces with another figure than the first has.
fn by_hand(mut figures: impl Iterator<Item = (u32, f64)>, name: &str, unit: &str) -> Vec<(u32, String)> {
    let Some((_, first)) = figures.next() else { return Vec::new() };
    let others: BTreeMap<u32, f64> = figures.filter(|f| f.1 != first).collect();
    let said = |value| {
        format!(
            "its {name} of {value} {unit} has to be set by hand where the program says so: give the cell outputs.{name}"
        )
    };
    others.into_iter().map(|(surface, value)| (surface, said(value))).collect()
}
