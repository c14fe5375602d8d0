//! Orders against brute force, the zigzag, and what must stay of a line. No timing: that is for benches.

use super::*;
use crate::path::section::SectionPoint;
use proptest::prelude::*;

fn line(plane: usize, points: &[[f64; 2]], closed: bool) -> TransversalLine {
    let at = |p: &[f64; 2]| SectionPoint { p: Point3::new(p[0], p[1], 0.0), n: Vector3::z() };
    TransversalLine { plane, points: points.iter().map(at).collect(), closed, dark: Vec::new() }
}

fn circle(plane: usize, centre: [f64; 2], radius: f64, count: usize) -> TransversalLine {
    let at = |i: usize| {
        let a = i as f64 / count as f64 * std::f64::consts::TAU;
        [centre[0] + radius * libm::cos(a), centre[1] + radius * libm::sin(a)]
    };
    line(plane, &(0..count).map(at).collect::<Vec<_>>(), true)
}

/// Lines of three points each, as told by two corners; planes three by three.
fn lines_of(corners: &[[f64; 4]]) -> Vec<TransversalLine> {
    let middle = |c: &[f64; 4]| [0.3 * c[0] + 0.7 * c[2], 0.5 * c[1] + 0.5 * c[3] + 1.0];
    corners.iter().enumerate().map(|(i, c)| line(i / 3, &[[c[0], c[1]], middle(c), [c[2], c[3]]], false)).collect()
}

fn zigzag_mm(lines: &[TransversalLine], sense: Sense, start: Option<&Point3<f64>>) -> f64 {
    let order = if sense == Sense::Either { Order::Zigzag } else { Order::OneWay };
    way_mm(&ordered(lines.to_vec(), order, &Vector3::y()), start)
}

/// All orders and senses of open lines.
fn least_mm(spot: Option<Point3<f64>>, left: &[TransversalLine], sense: Sense) -> f64 {
    if left.is_empty() {
        return 0.0;
    }
    let mut best = f64::INFINITY;
    for i in 0..left.len() {
        let mut rest = left.to_vec();
        let one = rest.remove(i);
        let (a, b) = (one.points[0].p, one.points[one.points.len() - 1].p);
        let ways = [(a, b), (b, a)];
        for (from, to) in &ways[..if sense == Sense::Either { 2 } else { 1 }] {
            let hop = spot.map_or(0.0, |s| (from - s).norm());
            best = best.min(hop + least_mm(Some(*to), &rest, sense));
        }
    }
    best
}

/// The points of a line, from the lowest, in the sense that comes first: the same for any turn of it.
fn name(line: &TransversalLine) -> Vec<[u64; 3]> {
    let bits = |l: &TransversalLine| l.points.iter().map(|q| [q.p.x, q.p.y, q.p.z].map(f64::to_bits)).collect();
    let mut all: Vec<Vec<[u64; 3]>> = vec![bits(line), bits(&line.clone().reversed())];
    if line.closed {
        for k in 1..line.points.len() {
            let mut turned = line.clone();
            turned.points.rotate_left(k);
            all.push(bits(&turned));
        }
        all.remove(1);
    }
    all.into_iter().min().expect("at least as it is")
}

fn names(lines: &[TransversalLine]) -> Vec<Vec<[u64; 3]>> {
    let mut names: Vec<_> = lines.iter().map(name).collect();
    names.sort();
    names
}

const SIDE: std::ops::Range<f64> = 0.0..100.0;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn few_lines_have_the_best_order(corners in prop::collection::vec(prop::array::uniform4(SIDE), 1..6),
                                     from in prop::option::of(prop::array::uniform2(SIDE)), kept in any::<bool>()) {
        let lines = lines_of(&corners);
        let start = from.map(|f| Point3::new(f[0], f[1], 0.0));
        let sense = if kept { Sense::Kept } else { Sense::Either };
        let found = way_mm(&toured(lines.clone(), start.as_ref(), sense, &Vector3::y()), start.as_ref());
        let least = least_mm(start, &lines, sense);
        prop_assert!((found - least).abs() < 1e-6, "{found} against {least}");
    }

    /// The search alone, that many lines rest upon.
    #[test]
    fn the_search_comes_near_the_best(corners in prop::collection::vec(prop::array::uniform4(SIDE), 7..12)) {
        let lines = lines_of(&corners);
        let tour = TourLines::new(&lines, None, Sense::Either);
        let least = tour.way_mm(&exact::solved(&tour));
        let plain: Vec<LineVisit> = (0..lines.len()).map(|line| tour.visit(line, 0)).collect();
        let found = tour.way_mm(&search::improved(&tour, starts(&tour, &plain)));
        prop_assert!(found <= least * 1.05 && found >= least - 1e-6, "{found} against {least}");
    }

    #[test]
    fn never_longer_than_the_zigzag_and_every_line_is_kept(
        corners in prop::collection::vec(prop::array::uniform4(SIDE), 0..30),
        rings in prop::collection::vec((prop::array::uniform2(SIDE), 1.0..20.0f64, 3..30usize), 0..10),
        from in prop::option::of(prop::array::uniform2(SIDE)), kept in any::<bool>(),
    ) {
        let mut lines = lines_of(&corners);
        lines.extend(rings.iter().enumerate().map(|(i, r)| circle(i / 2, r.0, r.1, r.2)));
        lines.sort_by_key(|l| l.plane);
        let start = from.map(|f| Point3::new(f[0], f[1], 0.0));
        let sense = if kept { Sense::Kept } else { Sense::Either };
        let tour = toured(lines.clone(), start.as_ref(), sense, &Vector3::y());
        prop_assert!(way_mm(&tour, start.as_ref()) <= zigzag_mm(&lines, sense, start.as_ref()) + 1e-6);
        // Closed lines keep their sense: a reversed one has another name.
        prop_assert_eq!(names(&tour), names(&lines));
        if kept {
            prop_assert!(tour.iter().filter(|l| !l.closed).all(|l| lines.contains(l)), "open lines run as they were");
        }
        prop_assert_eq!(&toured(lines, start.as_ref(), sense, &Vector3::y()), &tour);
    }
}

#[test]
fn a_plate_with_a_hole_is_done_side_by_side() {
    // Forty lines over a hole: the zigzag crosses it on every line, 20 mm each.
    let mut lines = Vec::new();
    for i in 0..40 {
        lines.push(line(i, &[[0.0, i as f64], [40.0, i as f64]], false));
        lines.push(line(i, &[[60.0, i as f64], [100.0, i as f64]], false));
    }
    let before = zigzag_mm(&lines, Sense::Either, None);
    assert!((before - (40.0 * 20.0 + 39.0)).abs() < 1e-9);
    let after = way_mm(&toured(lines, None, Sense::Either, &Vector3::y()), None);
    // Up on one side and down on the other: 78 ways of 1 mm and one of 20 mm.
    assert!((after - (78.0 + 20.0)).abs() < 1e-9, "{after}");
}

#[test]
fn rings_in_each_other_begin_beside_each_other() {
    // Seams lie anywhere; the best way goes straight out, ring by ring.
    let lines: Vec<_> = (1..=30)
        .map(|r| {
            let mut ring = circle(r, [0.0, 0.0], r as f64, 72);
            ring.points.rotate_left(r * 31 % 72);
            ring
        })
        .collect();
    let after = way_mm(&toured(lines, None, Sense::Either, &Vector3::z()), None);
    assert!((after - 29.0).abs() < 1e-6, "{after}");
}

#[test]
fn a_reversed_line_keeps_its_gaps() {
    let mut with_gap = line(0, &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [5.0, 0.0], [6.0, 0.0]], false);
    with_gap.dark = vec![3];
    let lengths = |l: &TransversalLine| l.pieces().map(<[SectionPoint]>::len).collect::<Vec<_>>();
    assert_eq!((lengths(&with_gap), with_gap.length_mm()), (vec![3, 2], 3.0));
    let turned = with_gap.clone().reversed();
    assert_eq!((lengths(&turned), turned.length_mm()), (vec![2, 3], 3.0));
    assert_eq!(turned.reversed(), with_gap);
}
