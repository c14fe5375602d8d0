//! Which lines are near each other: the only ones that are tried as neighbours of an order.

use super::ends::{LineVisit, TourLines};

/// Number of neighbours kept for every entry.
const NEAREST: usize = 6;
/// Entries of a closed line that are looked at.
const SPREAD: usize = 4;

/// For each line the lines with entries nearest to one of its own, each once.
pub(super) fn neighbours(tour: &TourLines<'_>) -> Vec<Vec<usize>> {
    let entries: Vec<LineVisit> = (0..tour.count()).flat_map(|line| both_ends(tour, line)).collect();
    let at: Vec<_> = entries.iter().map(|s| s.enter).collect();
    let (lo, hi) = crate::part::topology::bounds_of(at.iter().copied());
    // Sorted along the longest side of their box, so that far ones are never looked at.
    let axis = (hi - lo).imax();
    let mut sorted: Vec<usize> = (0..entries.len()).collect();
    sorted.sort_by(|&a, &b| at[a][axis].total_cmp(&at[b][axis]).then(a.cmp(&b)));
    let mut near: Vec<Vec<usize>> = vec![Vec::new(); tour.count()];
    for (rank, &own) in sorted.iter().enumerate() {
        let line = entries[own].line;
        let mut found: Vec<(f64, usize)> = Vec::with_capacity(NEAREST + 1);
        let (mut left, mut right) = (rank, rank + 1);
        loop {
            let off = |k: Option<&usize>| k.map_or(f64::INFINITY, |&k| (at[k][axis] - at[own][axis]).abs());
            let (l, r) = (off(left.checked_sub(1).and_then(|k| sorted.get(k))), off(sorted.get(right)));
            let least = l.min(r);
            let far = found.get(NEAREST - 1).map_or(f64::INFINITY, |f| f.0);
            if least == f64::INFINITY || least > far {
                break;
            }
            let other = if l <= r {
                left -= 1;
                sorted[left]
            } else {
                right += 1;
                sorted[right - 1]
            };
            let other_line = entries[other].line;
            let mm = (at[other] - at[own]).norm();
            if other_line == line || mm >= far {
                continue;
            }
            match found.iter().position(|f| f.1 == other_line) {
                Some(k) if found[k].0 <= mm => continue,
                Some(k) => {
                    found.remove(k);
                }
                None => {}
            }
            let k = found.partition_point(|f| f.0 <= mm);
            found.insert(k, (mm, other_line));
            found.truncate(NEAREST);
        }
        for (_, other) in found {
            if !near[line].contains(&other) {
                near[line].push(other);
            }
        }
    }
    near
}

/// Both ends of a line even where it is entered at one only: what is near its end may follow it.
fn both_ends(tour: &TourLines<'_>, line: usize) -> Vec<LineVisit> {
    if tour.is_closed(line) {
        return tour.some_entries(line, SPREAD).collect();
    }
    vec![tour.visit(line, 0), tour.visit(line, 1)]
}
