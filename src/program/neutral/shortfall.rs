//! What of a program is not as it was wanted, by surface: leads that are not free, and figures that the cell cannot
//! set though they change.

use crate::cell::outputs::{Outputs, ValueForm};
use crate::pose::Pass;
use serde::Serialize;
use std::collections::BTreeMap;

/// What of a surface's program is not as it was wanted. In `report.json` by its code.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum Shortfall {
    /// Lead-ins and lead-outs are left out, because something would be touched on them.
    LeadsLeftOut {
        /// How many.
        leads: usize,
    },
    /// Moves with the laser on that are shorter than the cell's least move, because chord error, turn or deviation ask
    /// for them.
    ShortMoves {
        /// How many.
        moves: usize,
        /// The shortest, s.
        shortest_s: f64,
        /// What a move should take at least, s.
        least_s: f64,
    },
    /// The operator has to set a figure where the program says so, because the cell has no output for it.
    SetByHand(ByHand),
}

/// A figure that an operator sets.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "figure", content = "value", rename_all = "snake_case")]
pub enum ByHand {
    /// Power, W.
    PowerW(f64),
    /// Frequency, kHz.
    FrequencyKhz(f64),
}

/// A surface on which the spot does not have its speed everywhere: the controller's words end before.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OffSpeed {
    /// The surface.
    pub surface: u32,
    /// Moves with the laser on that are slower, or faster where the words know nothing slower.
    pub moves: usize,
    /// Speed that was set, mm/s.
    pub wanted_mm_s: f64,
    /// Speed of the spot on the move that is furthest from it, mm/s.
    pub possible_mm_s: f64,
    /// The target that this move leads to: pass.
    pub pass: usize,
    /// Its point.
    pub point: usize,
}

/// All shortfalls. `pieces`: for each lit piece its pass, and how many of its leads are left out.
pub fn shortfalls<'a>(
    pieces: impl Iterator<Item = (&'a Pass, usize)> + Clone,
    outputs: &Outputs,
) -> Vec<(u32, Shortfall)> {
    let mut out = left_out(pieces.clone());
    let mut hand = |form: ValueForm, set: fn(f64) -> ByHand, figure: fn(&Pass) -> f64| {
        if form == ValueForm::Comment {
            out.extend(by_hand(pieces.clone().map(|p| (p.0.surface, figure(p.0))), set));
        }
    };
    hand(outputs.power.form, ByHand::PowerW, |p| p.settings.power_w);
    hand(outputs.frequency.form, ByHand::FrequencyKhz, |p| p.settings.frequency_khz);
    out.sort_by_key(|r| r.0);
    out
}

/// Leads that are left out, by surface.
fn left_out<'a>(of_pieces: impl Iterator<Item = (&'a Pass, usize)>) -> Vec<(u32, Shortfall)> {
    let mut counts = BTreeMap::<u32, usize>::new();
    for (pass, left_out) in of_pieces {
        *counts.entry(pass.surface).or_default() += left_out;
    }
    let counts = counts.into_iter().filter(|(_, leads)| *leads > 0);
    counts.map(|(surface, leads)| (surface, Shortfall::LeadsLeftOut { leads })).collect()
}

/// Surfaces with another figure than the first has.
fn by_hand(mut figures: impl Iterator<Item = (u32, f64)>, set: fn(f64) -> ByHand) -> Vec<(u32, Shortfall)> {
    let Some((_, first)) = figures.next() else { return Vec::new() };
    let others: BTreeMap<u32, f64> = figures.filter(|f| f.1 != first).collect();
    others.into_iter().map(|(surface, value)| (surface, Shortfall::SetByHand(set(value)))).collect()
}
