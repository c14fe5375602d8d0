//! Working order that makes the way between the lines of a surface short.
//!
//! An open line may be begun at either end, a closed one at any of its points. Few lines are solved exactly
//! (`exact`); many by exchange of two and three ways, from the zigzag and from nearest neighbours (`search`),
//! with the seams of closed lines found anew along the order (`seams`). The zigzag is one of the starts, so
//! the result is never longer. The way is counted as the crow flies: what stands between is not looked at.

mod ends;
mod exact;
mod proximity;
mod seams;
mod search;
mod sense;
mod shift;

pub use sense::Sense;
pub use shift::shift_seams;

use super::order::{Order, ordered};
use super::section::TransversalLine;
use ends::{LineVisit, TourLines};
use nalgebra::{Point3, Vector3};

/// Below this many lines the order is solved exactly.
const EXACT_BELOW: usize = 12;

/// Length of the way between lines in this order, mm; with that from the start, if there is one.
pub fn way_mm(lines: &[TransversalLine], start: Option<&Point3<f64>>) -> f64 {
    let mut spot = start.copied();
    let mut sum = 0.0;
    for line in lines {
        let (Some(first), Some(last)) = (line.points.first(), line.points.last()) else { continue };
        sum += spot.map_or(0.0, |s| (first.p - s).norm());
        spot = Some(if line.closed { first.p } else { last.p });
    }
    sum
}

/// Puts lines in an order with short ways between; `start`: where the spot comes from, `normal` (unit): that
/// of the section planes, by which the zigzag finds its first corner.
///
/// Never longer than the zigzag of the same lines (one-way where the sense is kept). With fewer than twelve
/// lines the order is the best there is; seams of closed lines are then chosen among their points nearest to
/// other lines. Lines without points are dropped.
pub fn toured(
    lines: Vec<TransversalLine>,
    start: Option<&Point3<f64>>,
    sense: Sense,
    normal: &Vector3<f64>,
) -> Vec<TransversalLine> {
    let mut lines: Vec<TransversalLine> = lines.into_iter().filter(|l| !l.points.is_empty()).collect();
    lines.sort_by_key(|l| l.plane);
    let mut planes: Vec<usize> = lines.iter().map(|l| l.plane).collect();
    planes.dedup();
    let mut zigzag = ordered(lines, if sense == Sense::Kept { Order::OneWay } else { Order::Zigzag }, normal);
    for line in zigzag.iter_mut().filter(|l| l.closed && sense == Sense::Either) {
        // The zigzag turns every second plane; a closed line is as well begun where it begins in its own sense.
        if planes.binary_search(&line.plane).is_ok_and(|rank| rank % 2 == 1) {
            line.points.reverse();
            line.points.rotate_right(1);
        }
    }
    // Every line is now as the zigzag runs it, so the zigzag is the order of their numbers.
    let tour = TourLines::new(&zigzag, start.copied(), sense);
    let plain: Vec<LineVisit> = (0..zigzag.len()).map(|line| tour.visit(line, 0)).collect();
    let mut best = search::improved(&tour, starts(&tour, &plain));
    if zigzag.len() < EXACT_BELOW {
        let exact = seams::chosen(&tour, exact::solved(&tour));
        if tour.way_mm(&exact) < tour.way_mm(&best) - 1e-9 {
            best = exact;
        }
    }
    let mut taken: Vec<Option<TransversalLine>> = zigzag.into_iter().map(Some).collect();
    best.into_iter().filter_map(|visit| Some(ends::run_from(taken.get_mut(visit.line)?.take()?, visit.entry))).collect()
}

/// The zigzag, and nearest neighbours from its corners where there is no place to come from.
fn starts(tour: &TourLines<'_>, plain: &[LineVisit]) -> Vec<Vec<LineVisit>> {
    let corners = [plain.first(), plain.last()].into_iter().flatten().flat_map(|visit| [*visit, tour.turned(*visit)]);
    let firsts = corners.filter(|c| c.entry < tour.entries(c.line)).map(Some);
    let firsts: Vec<Option<LineVisit>> = if tour.start.is_some() { vec![None] } else { firsts.collect() };
    let nearest = firsts.into_iter().map(|first| search::nearest(tour, first));
    std::iter::once(plain.to_vec()).chain(nearest).collect()
}

#[cfg(test)]
mod tests;
