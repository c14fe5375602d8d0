//! Order and sense of a surface's lines: plane by plane, zigzag or one-way, each next line the nearest of its
//! plane. A closed line begins at its point nearest to the spot. `tour` finds the order with the shortest ways.

use super::section::{SectionPoint, TransversalLine};
use crate::part::angle::any_square_to;
use nalgebra::{Point3, Vector3};
use serde::{Deserialize, Serialize};

/// Sense of neighbouring lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Order {
    /// Every second plane is run backwards.
    #[default]
    Zigzag,
    /// All lines run in the same sense.
    OneWay,
    /// The order with the shortest ways between the lines; see [`super::tour`].
    Shortest,
}

crate::part::keyed_words!(Order: Zigzag, OneWay, Shortest);

impl Order {
    /// All of them, in the order of lists.
    pub const ALL: [Order; 3] = [Order::Zigzag, Order::OneWay, Order::Shortest];

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Order::Zigzag => "zigzag",
            Order::OneWay => "one-way",
            Order::Shortest => "shortest",
        }
    }

    /// The order of that word.
    pub fn from_word(word: &str) -> Option<Order> {
        Order::ALL.into_iter().find(|o| o.word() == word)
    }
}

/// Puts lines (sorted by plane) in working order, turned as they will be run.
pub fn ordered(lines: Vec<TransversalLine>, order: Order, normal: &Vector3<f64>) -> Vec<TransversalLine> {
    let mut done: Vec<TransversalLine> = Vec::with_capacity(lines.len());
    let mut spot: Option<Point3<f64>> = None;
    let mut backwards = false;
    let mut rest = lines.into_iter().peekable();
    while let Some(plane) = rest.peek().map(|l| l.plane) {
        let mut here: Vec<TransversalLine> = Vec::new();
        while let Some(line) = rest.next_if(|l| l.plane == plane) {
            here.push(if backwards { line.reversed() } else { line });
        }
        while !here.is_empty() {
            let (index, start) = nearest_start(&here, spot, normal);
            let mut line = here.remove(index);
            line.points.rotate_left(start);
            let end = if line.closed { line.points.first() } else { line.points.last() };
            spot = end.map(|q| q.p);
            done.push(line);
        }
        backwards = order == Order::Zigzag && !backwards;
    }
    done
}

/// Index of a line and of the point to start it at.
fn nearest_start(lines: &[TransversalLine], spot: Option<Point3<f64>>, normal: &Vector3<f64>) -> (usize, usize) {
    let (u, grain) = (any_square_to(normal), 1e-6);
    let v = normal.cross(&u);
    // For the first line of all: the lowest corner of the plane. In steps of a micrometre fraction,
    // so that points of one height are told apart by the second coordinate, not by rounding.
    let rank = |q: &SectionPoint| match spot {
        Some(s) => (((q.p - s).norm() / grain).round(), 0.0),
        None => ((q.p.coords.dot(&u) / grain).round(), (q.p.coords.dot(&v) / grain).round()),
    };
    let mut best = ((f64::INFINITY, f64::INFINITY), (0, 0));
    for (i, line) in lines.iter().enumerate() {
        let starts = if line.closed { line.points.len() } else { 1 };
        for (k, q) in line.points.iter().take(starts).enumerate() {
            let r = rank(q);
            if r < best.0 {
                best = (r, (i, k));
            }
        }
    }
    best.1
}
