//! The best entries along a given order: dynamic programming over some points of every closed line (and both
//! ends of open ones), then each seam by itself among all its points.

use super::Sense;
use super::ends::{Stop, Stops};

/// Points of a closed line spread over it that are looked at beside those nearest to its neighbours.
const SPREAD: usize = 12;
/// Rounds over all seams; each goes on only where a neighbour has moved.
const ROUNDS: usize = 8;

/// Chooses where closed lines are entered; the order stays, and the way gets no longer.
pub(super) fn chosen(stops: &Stops<'_>, order: Vec<Stop>) -> Vec<Stop> {
    if !order.iter().any(|s| stops.is_closed(s.line)) {
        return order;
    }
    let mut order = by_programming(stops, &order);
    let mut moved = vec![true; order.len()];
    for _ in 0..ROUNDS {
        let mut next = vec![false; order.len()];
        for i in 0..order.len() {
            let beside = |moved: &[bool]| (i.saturating_sub(1)..=i + 1).any(|k| moved.get(k) == Some(&true));
            if !stops.is_closed(order[i].line) || !beside(&moved) {
                continue;
            }
            let there = stops.stop(order[i].line, best_seam(stops, &order, i));
            let way = |stop: &Stop| around(stops, &order, i, stop);
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

fn around(stops: &Stops<'_>, order: &[Stop], i: usize, stop: &Stop) -> f64 {
    let before = i.checked_sub(1).map(|k| &order[k]);
    stops.hop(before, Some(stop)) + stops.hop(Some(stop), order.get(i + 1))
}

fn best_seam(stops: &Stops<'_>, order: &[Stop], i: usize) -> usize {
    let before = i.checked_sub(1).map(|k| order[k].leave).or(stops.start);
    let behind = order.get(i + 1).map(|s| s.enter);
    let to: Vec<_> = before.into_iter().chain(behind).collect();
    stops.nearest_seam(order[i].line, &to)
}

fn by_programming(stops: &Stops<'_>, order: &[Stop]) -> Vec<Stop> {
    let mut rows: Vec<Vec<(Stop, f64, usize)>> = Vec::with_capacity(order.len());
    for (i, &stop) in order.iter().enumerate() {
        // Its own entry first: of equal ones it stays.
        let mut own = vec![stop];
        if stops.is_closed(stop.line) {
            own.push(stops.stop(stop.line, best_seam(stops, order, i)));
            own.extend(stops.some_entries(stop.line, SPREAD));
        } else if stops.sense == Sense::Either {
            own.push(stops.turned(stop));
        }
        let row = own.into_iter().map(|stop| {
            let from = rows.last().and_then(|before: &Vec<(Stop, f64, usize)>| {
                let ways = before.iter().enumerate().map(|(k, b)| (b.1 + b.0.to(&stop), k));
                ways.reduce(|a, b| if b.0 < a.0 { b } else { a })
            });
            let (mm, k) = from.unwrap_or_else(|| (stops.hop(None, Some(&stop)), 0));
            (stop, mm, k)
        });
        rows.push(row.collect());
    }
    let least = |row: &Vec<(Stop, f64, usize)>| {
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
