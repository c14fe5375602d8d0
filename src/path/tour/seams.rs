//! The best entries along a given order: dynamic programming over some points of every closed line (and both
//! ends of open ones), then each seam by itself among all its points.

use super::ends::{LineVisit, TourLines};
use super::sense::Sense;

/// Points of a closed line spread over it that are looked at beside those nearest to its neighbours.
const SPREAD: usize = 12;
/// Rounds over all seams; each goes on only where a neighbour has moved.
const ROUNDS: usize = 8;

/// Chooses where closed lines are entered; the order stays, and the way gets no longer.
pub(super) fn chosen(tour: &TourLines<'_>, order: Vec<LineVisit>) -> Vec<LineVisit> {
    if !order.iter().any(|s| tour.is_closed(s.line)) {
        return order;
    }
    let mut order = by_programming(tour, &order);
    let mut moved = vec![true; order.len()];
    for _ in 0..ROUNDS {
        let mut next = vec![false; order.len()];
        for i in 0..order.len() {
            let beside = |moved: &[bool]| (i.saturating_sub(1)..=i + 1).any(|k| moved.get(k) == Some(&true));
            if !tour.is_closed(order[i].line) || !beside(&moved) {
                continue;
            }
            let there = tour.visit(order[i].line, best_seam(tour, &order, i));
            let way = |visit: &LineVisit| way_beside_mm(tour, &order, i, visit);
            if way(&there) < way(&order[i]) - 1e-9 {
                order[i] = there;
                next[i] = true;
            }
        }
        if !next.contains(&true) {
            break;
        }
        moved = next;
    }
    order
}

fn way_beside_mm(tour: &TourLines<'_>, order: &[LineVisit], i: usize, visit: &LineVisit) -> f64 {
    let before = i.checked_sub(1).map(|k| &order[k]);
    tour.hop(before, Some(visit)) + tour.hop(Some(visit), order.get(i + 1))
}

fn best_seam(tour: &TourLines<'_>, order: &[LineVisit], i: usize) -> usize {
    let before = i.checked_sub(1).map(|k| order[k].leave).or(tour.start);
    let behind = order.get(i + 1).map(|s| s.enter);
    let to: Vec<_> = before.into_iter().chain(behind).collect();
    tour.nearest_seam(order[i].line, &to)
}

fn by_programming(tour: &TourLines<'_>, order: &[LineVisit]) -> Vec<LineVisit> {
    let mut rows: Vec<Vec<(LineVisit, f64, usize)>> = Vec::with_capacity(order.len());
    for (i, &visit) in order.iter().enumerate() {
        // Its own entry first: of equal ones it stays.
        let mut own = vec![visit];
        if tour.is_closed(visit.line) {
            own.push(tour.visit(visit.line, best_seam(tour, order, i)));
            own.extend(tour.some_entries(visit.line, SPREAD));
        } else if tour.sense == Sense::Either {
            own.push(tour.turned(visit));
        }
        let row = own.into_iter().map(|visit| {
            let from = rows.last().and_then(|before: &Vec<(LineVisit, f64, usize)>| {
                let ways = before.iter().enumerate().map(|(k, b)| (b.1 + b.0.to(&visit), k));
                ways.reduce(|a, b| if b.0 < a.0 { b } else { a })
            });
            let (mm, k) = from.unwrap_or_else(|| (tour.hop(None, Some(&visit)), 0));
            (visit, mm, k)
        });
        rows.push(row.collect());
    }
    let least = |row: &Vec<(LineVisit, f64, usize)>| {
        (0..row.len()).reduce(|a, b| if row[b].1 < row[a].1 { b } else { a }).unwrap_or_default()
    };
    let mut at = rows.last().map_or(0, least);
    let mut out = Vec::with_capacity(order.len());
    for row in rows.iter().rev() {
        out.push(row[at].0);
        at = row[at].2;
    }
    out.reverse();
    out
}
