//! The best order of few lines: dynamic programming over the set of lines done and the entry of the last one
//! (Held and Karp 1962). Every open line has all its entries; a closed one its points nearest to other lines.

use super::ends::{LineVisit, TourLines};
use nalgebra::Point3;

/// Entries of a closed line that are looked at.
const SEAMS: usize = 8;

/// The order with the least way. Memory doubles with every line: for few lines only.
pub(super) fn solved(tour: &TourLines<'_>) -> Vec<LineVisit> {
    let count = tour.count();
    let states: Vec<LineVisit> = (0..count).flat_map(|line| candidates(tour, line)).collect();
    let hops: Vec<Vec<f64>> = states.iter().map(|a| states.iter().map(|b| a.to(b)).collect()).collect();
    let mut way = vec![vec![f64::INFINITY; states.len()]; 1 << count];
    let mut before = vec![vec![usize::MAX; states.len()]; 1 << count];
    for (s, visit) in states.iter().enumerate() {
        way[1 << visit.line][s] = tour.hop(None, Some(visit));
    }
    for done in 1..1usize << count {
        for (s, here) in states.iter().enumerate() {
            let so_far = way[done][s];
            if done >> here.line & 1 == 0 || so_far == f64::INFINITY {
                continue;
            }
            for (t, next) in states.iter().enumerate().filter(|(_, next)| done >> next.line & 1 == 0) {
                let with = done | 1 << next.line;
                if so_far + hops[s][t] < way[with][t] {
                    way[with][t] = so_far + hops[s][t];
                    before[with][t] = s;
                }
            }
        }
    }
    let mut done = (1usize << count) - 1;
    let last = (0..states.len()).reduce(|a, b| if way[done][b] < way[done][a] { b } else { a });
    let mut order = Vec::with_capacity(count);
    let mut at = last;
    while let Some(s) = at {
        order.push(states[s]);
        at = Some(before[done][s]).filter(|&b| b != usize::MAX);
        done &= !(1 << states[s].line);
    }
    order.reverse();
    order
}

fn candidates(tour: &TourLines<'_>, line: usize) -> Vec<LineVisit> {
    if !tour.is_closed(line) {
        return tour.some_entries(line, 2).collect();
    }
    // Where the way to another line would be shortest: from some of its points there and back again.
    let onto = |line: usize, p: Point3<f64>| -> LineVisit {
        let entry = if tour.is_closed(line) { tour.nearest_seam(line, &[p]) } else { 0 };
        tour.visit(line, entry)
    };
    let mut found: Vec<(f64, usize)> = Vec::new();
    let mut see = |p: Point3<f64>| {
        let visit = onto(line, p);
        found.push(((visit.enter - p).norm(), visit.entry));
    };
    if let Some(start) = tour.start {
        see(start);
    }
    for other in (0..tour.count()).filter(|&o| o != line) {
        for sample in tour.some_entries(other, 3) {
            let p = sample.enter;
            if tour.is_closed(other) {
                let here = onto(line, p).enter;
                see(onto(other, here).enter);
            } else {
                see(p);
            }
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut seams: Vec<usize> = Vec::new();
    for seam in found.into_iter().map(|f| f.1).chain([0]) {
        if seams.len() < SEAMS && !seams.contains(&seam) {
            seams.push(seam);
        }
    }
    seams.into_iter().map(|entry| tour.visit(line, entry)).collect()
}
