//! Orders made shorter by exchange: a stretch turned round (2-opt), a few lines moved elsewhere (Or-opt),
//! then kicks: two neighbouring stretches change places, one of them turned or not, and what gets no shorter is
//! taken back.
//!
//! Only lines near each other are tried as new neighbours, and only around what has changed, so the time
//! grows little faster than the number of lines.

use super::ends::{LineVisit, TourLines};
use super::proximity::neighbours;
use super::{Sense, seams};
use std::collections::VecDeque;

/// Lines moved together by Or-opt.
const MOVED: usize = 3;
/// Kicks by the number of lines: few lines are then as good as solved, and many still take little time.
const KICKS: (usize, usize, usize) = (60_000, 50, 600);
/// Stretches that a kick exchanges are no longer than this.
const KICKED: u64 = 30;
/// Least gain that counts as shorter, mm: more than rounding.
const GAIN_MM: f64 = 1e-9;
/// Rounds that alternate exchanges and seams.
const ROUNDS: usize = 3;

/// Nearest neighbours: from this entry always the nearest that is left.
pub(super) fn nearest(tour: &TourLines<'_>, first: Option<LineVisit>) -> Vec<LineVisit> {
    let most = (8000 / tour.count().max(1)).clamp(2, 16);
    let mut left: Vec<LineVisit> = (0..tour.count()).flat_map(|line| tour.some_entries(line, most)).collect();
    let mut order: Vec<LineVisit> = Vec::with_capacity(tour.count());
    order.extend(first);
    left.retain(|s| first.is_none_or(|f| s.line != f.line));
    while !left.is_empty() {
        let way = |to: &LineVisit| tour.hop(order.last(), Some(to));
        let mut best = (f64::INFINITY, left[0]);
        for to in &left {
            let mm = way(to);
            if mm < best.0 {
                best = (mm, *to);
            }
        }
        left.retain(|s| s.line != best.1.line);
        order.push(best.1);
    }
    order
}

/// The best that is found from these orders, no longer than any of them.
///
/// Each is settled, and the best then kicked.
pub(super) fn improved(tour: &TourLines<'_>, starts: Vec<Vec<LineVisit>>) -> Vec<LineVisit> {
    let near = neighbours(tour);
    let settled = |order: Vec<LineVisit>, kicked: bool| {
        let mut search = OrderSearch::new(tour, &near, seams::chosen(tour, order));
        search.settle((0..tour.count()).collect());
        if kicked {
            search.kick();
        }
        seams::chosen(tour, search.order)
    };
    // Of equal ones the first, so that the zigzag stays where nothing is better.
    let shorter =
        |a: Vec<LineVisit>, b: Vec<LineVisit>| if tour.way_mm(&b) < tour.way_mm(&a) - GAIN_MM { b } else { a };
    let best = starts.into_iter().map(|order| settled(order, false)).reduce(shorter).unwrap_or_default();
    let mut order = settled(best, true);
    // Where seams have moved, other orders may be shorter.
    for _ in 0..ROUNDS {
        let before = tour.way_mm(&order);
        order = settled(order, false);
        if tour.way_mm(&order) > before - 1e-6 {
            break;
        }
    }
    order
}

struct OrderSearch<'a> {
    tour: &'a TourLines<'a>,
    near: &'a [Vec<usize>],
    order: Vec<LineVisit>,
    /// Place of each line in the order.
    place: Vec<usize>,
}

impl OrderSearch<'_> {
    fn new<'a>(tour: &'a TourLines<'a>, near: &'a [Vec<usize>], order: Vec<LineVisit>) -> OrderSearch<'a> {
        let mut search = OrderSearch { tour, near, place: vec![0; order.len()], order };
        search.number(0, search.order.len());
        search
    }

    fn number(&mut self, from: usize, to: usize) {
        for i in from..to.min(self.order.len()) {
            self.place[self.order[i].line] = i;
        }
    }

    fn at(&self, i: usize) -> Option<&LineVisit> {
        self.order.get(i)
    }

    fn before(&self, i: usize) -> Option<&LineVisit> {
        i.checked_sub(1).and_then(|k| self.at(k))
    }

    /// The line at a place, run the other way.
    fn turned(&self, i: usize) -> Option<LineVisit> {
        self.at(i).map(|s| self.tour.turned(*s))
    }

    fn hop(&self, from: Option<&LineVisit>, to: Option<&LineVisit>) -> f64 {
        self.tour.hop(from, to)
    }

    /// Exchanges around these lines, and around what changes, until nothing gets shorter; the gain, mm.
    fn settle(&mut self, lines: Vec<usize>) -> f64 {
        let mut waits = vec![false; self.order.len()];
        lines.iter().for_each(|&l| waits[l] = true);
        let mut queue: VecDeque<usize> = lines.into();
        let mut gain = 0.0;
        // Every exchange gains; the bound is for gains that come to nothing.
        let mut left = 200 * self.order.len() + 1000;
        while let Some(line) = queue.pop_front() {
            waits[line] = false;
            while let Some((mm, touched)) = self.exchange(line).filter(|_| left > 0) {
                left -= 1;
                gain += mm;
                for line in touched.into_iter().filter_map(|i| self.order.get(i)).map(|s| s.line) {
                    if !std::mem::replace(&mut waits[line], true) {
                        queue.push_back(line);
                    }
                }
            }
        }
        gain
    }

    /// The first exchange at a line that makes the way shorter: what it gains, and the places it joins anew.
    fn exchange(&mut self, line: usize) -> Option<(f64, Vec<usize>)> {
        let near = self.near;
        let i = self.place[line];
        if self.tour.sense == Sense::Either {
            let last = self.order.len() - 1;
            let others = near[line].iter().map(|&other| self.place[other]);
            let turns = others.flat_map(|j| {
                let (lo, hi) = (i.min(j), i.max(j));
                [(lo + 1, hi), (lo, hi.saturating_sub(1)), (lo, hi)]
            });
            let turns = turns.chain([(0, i), (i, last), (i, i)]);
            let found = turns.filter(|(from, to)| from <= to).map(|(from, to)| (self.turn_gain(from, to), from, to));
            let best = found.reduce(|a, b| if b.0 > a.0 { b } else { a });
            if let Some((gain, from, to)) = best.filter(|b| b.0 > GAIN_MM) {
                self.turn(from, to);
                return Some((gain, vec![from.saturating_sub(1), from, to, to + 1]));
            }
        }
        self.shift(i)
    }

    fn turn_gain(&self, from: usize, to: usize) -> f64 {
        let (before, behind) = (self.before(from), self.at(to + 1));
        self.hop(before, self.at(from)) + self.hop(self.at(to), behind)
            - self.hop(before, self.turned(to).as_ref())
            - self.hop(self.turned(from).as_ref(), behind)
    }

    fn turn(&mut self, from: usize, to: usize) {
        self.order[from..=to].reverse();
        for visit in &mut self.order[from..=to] {
            *visit = self.tour.turned(*visit);
        }
        self.number(from, to + 1);
    }

    /// Moves up to three lines, from or to the place `i`, next to a line that is near.
    fn shift(&mut self, i: usize) -> Option<(f64, Vec<usize>)> {
        let last = self.order.len() - 1;
        let mut best = (GAIN_MM, None);
        for count in 1..=MOVED.min(last) {
            for from in [Some(i), (i + 1).checked_sub(count)].into_iter().flatten().filter(|f| f + count - 1 <= last) {
                let to = from + count - 1;
                let (before, behind) = (self.before(from), self.at(to + 1));
                let freed = self.hop(before, self.at(from)) + self.hop(self.at(to), behind) - self.hop(before, behind);
                let turned = (self.turned(from), self.turned(to));
                let beside = self.near[self.order[i].line].iter().flat_map(|&l| [self.place[l], self.place[l] + 1]);
                // `gap`: in front of the line that is there now.
                for gap in beside.chain([0, last + 1]).filter(|&g| g < from || g > to + 1) {
                    let (left, right) = (self.before(gap), self.at(gap));
                    let saved = self.hop(left, right);
                    let cost = |first: Option<&LineVisit>, end: Option<&LineVisit>| {
                        self.hop(left, first) + self.hop(end, right) - saved
                    };
                    let gain = freed - cost(self.at(from), self.at(to));
                    if gain > best.0 {
                        best = (gain, Some((from, to, gap, false)));
                    }
                    if self.tour.sense == Sense::Either {
                        let gain = freed - cost(turned.1.as_ref(), turned.0.as_ref());
                        if gain > best.0 {
                            best = (gain, Some((from, to, gap, true)));
                        }
                    }
                }
            }
        }
        let (from, to, gap, is_turned) = best.1?;
        if is_turned {
            self.turn(from, to);
        }
        let count = to - from + 1;
        let touched = if gap < from {
            self.order[gap..=to].rotate_right(count);
            self.number(gap, to + 1);
            [gap.saturating_sub(1), gap, gap + count - 1, gap + count, to, to + 1]
        } else {
            self.order[from..gap].rotate_left(count);
            self.number(from, gap);
            [from.saturating_sub(1), from, gap - count - 1, gap - count, gap - 1, gap]
        };
        Some((best.0, touched.to_vec()))
    }

    /// Two neighbouring stretches change places, again and again, the one put first turned or not; kept where
    /// the way is no longer for it.
    fn kick(&mut self) {
        let count = self.order.len();
        if count < 4 {
            return;
        }
        let mut random = 0x9e37_79b9_7f4a_7c15u64;
        let mut below = |n: u64| {
            // xorshift64*: the same kicks every time.
            random ^= random >> 12;
            random ^= random << 25;
            random ^= random >> 27;
            (random.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 33) % n
        };
        for _ in 0..(KICKS.0 / count).clamp(KICKS.1, KICKS.2) {
            let (order, place) = (self.order.clone(), self.place.clone());
            let (mut loss, mut touched) = (0.0, Vec::new());
            // One alone is often just taken back by the exchanges.
            for _ in 0..=below(3) {
                let most = KICKED.min(count as u64 / 2);
                let (one, two) = (1 + below(most) as usize, 1 + below(most) as usize);
                let from = below((count - one - two) as u64 + 1) as usize;
                let end = from + one + two;
                let joints = |s: &OrderSearch<'_>, middle: usize| {
                    let hop = |i: usize| s.hop(s.before(i), s.at(i));
                    hop(from) + hop(middle) + hop(end)
                };
                let before = joints(self, from + one);
                self.order[from..end].rotate_left(one);
                self.number(from, end);
                if self.tour.sense == Sense::Either && below(2) == 0 {
                    self.turn(from, from + two - 1);
                }
                loss += joints(self, from + two) - before;
                let seen = [from.saturating_sub(1), from, from + two - 1, from + two, end - 1, end];
                touched.extend(seen.into_iter().filter_map(|i| self.at(i)).map(|s| s.line));
            }
            touched.sort_unstable();
            touched.dedup();
            if self.settle(touched) < loss + GAIN_MM {
                (self.order, self.place) = (order, place);
            }
        }
    }
}
