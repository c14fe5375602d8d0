//! Where closed lines begin, moved on from line to line: bead starts that lay above each other would build up
//! a ridge, and so would starts of one layer above those of the last.

use crate::path::normals::between;
use crate::path::section::{SectionPoint, TransversalLine};
use nalgebra::{Point3, Vector3};

/// A start nearer to a point than this takes that point, mm.
const SAME_MM: f64 = 1e-9;

/// Moves the starts of closed lines along them, in working order; open lines stay.
///
/// The first begins at the share `first_share` (0 to 1) of its length behind its present start: another one for
/// every layer. Each next begins `shift_mm` behind the place that is nearest to the start of the closed line
/// before: ahead on the first line, and the same way round where others run against it. Points are added where a start falls between two, and none is lost.
pub fn shift_seams(lines: &mut [TransversalLine], shift_mm: f64, first_share: f64) {
    let mut last: Option<(Point3<f64>, Vector3<f64>, f64)> = None;
    for line in lines.iter_mut().filter(|l| l.closed && l.points.len() > 1) {
        let (whole_mm, round) = (line.length_mm(), round(line));
        let (at_mm, sign) = match last {
            None => (first_share * whole_mm, 1.0),
            Some((start, other, sign)) => {
                let sign = if round.dot(&other) < 0.0 { -sign } else { sign };
                (nearest_mm(line, &start) + sign * shift_mm, sign)
            }
        };
        if whole_mm > 0.0 && at_mm.is_finite() {
            begin_at(line, at_mm.rem_euclid(whole_mm));
            last = line.points.first().map(|q| (q.p, round, sign));
        }
    }
}

/// The area that a line goes round, as a vector: it tells in which sense.
fn round(line: &TransversalLine) -> Vector3<f64> {
    let Some(origin) = line.points.first() else { return Vector3::zeros() };
    line.sides().map(|(a, b)| (a.p - origin.p).cross(&(b.p - origin.p))).fold(Vector3::zeros(), |a, b| a + b)
}

/// The place nearest to a point, mm from the line's start.
fn nearest_mm(line: &TransversalLine, p: &Point3<f64>) -> f64 {
    let (mut best, mut from_mm) = ((f64::INFINITY, 0.0), 0.0);
    for (a, b) in line.sides() {
        let side = b.p - a.p;
        let t = ((p - a.p).dot(&side) / side.norm_squared().max(1e-300)).clamp(0.0, 1.0);
        let mm = (a.p + side * t - p).norm();
        if mm < best.0 {
            best = (mm, from_mm + t * side.norm());
        }
        from_mm += side.norm();
    }
    best.1
}

/// Lets a closed line begin so far behind its start.
fn begin_at(line: &mut TransversalLine, at_mm: f64) {
    let (mut from_mm, mut found) = (0.0, None);
    for (i, (a, b)) in line.sides().enumerate() {
        let side_mm = (b.p - a.p).norm();
        if at_mm <= from_mm + side_mm {
            found = Some((i, a, b, at_mm - from_mm, side_mm));
            break;
        }
        from_mm += side_mm;
    }
    // Beyond the last side by rounding: the start.
    let Some((i, a, b, along_mm, side_mm)) = found else { return };
    let count = line.points.len();
    if along_mm <= SAME_MM || side_mm - along_mm <= SAME_MM {
        let on = usize::from(along_mm > SAME_MM);
        line.points.rotate_left((i + on) % count);
        return;
    }
    let t = along_mm / side_mm;
    let start = SectionPoint { p: a.p + (b.p - a.p) * t, n: between(&a.n, &b.n, t) };
    line.points.insert(i + 1, start);
    line.points.rotate_left(i + 1);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A square of the edge 10 mm at a height, begun at its corner (0, 0).
    fn square(z: f64) -> TransversalLine {
        let at = |(x, y): (f64, f64)| SectionPoint { p: Point3::new(x, y, z), n: Vector3::z() };
        let points = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(at).to_vec();
        TransversalLine { plane: 0, points, closed: true, dark: Vec::new() }
    }

    fn starts(lines: &[TransversalLine]) -> Vec<[f64; 2]> {
        lines.iter().map(|l| [l.points[0].p.x, l.points[0].p.y]).collect()
    }

    #[test]
    fn starts_wander_round_a_tower() {
        let mut lines: Vec<_> = (0..5).map(|i| square(f64::from(i))).collect();
        shift_seams(&mut lines, 4.0, 0.0);
        assert_eq!(starts(&lines), [[0.0, 0.0], [4.0, 0.0], [8.0, 0.0], [10.0, 2.0], [10.0, 6.0]]);
        assert_eq!(lines.iter().map(|l| l.points.len()).collect::<Vec<_>>(), [4, 5, 5, 5, 5]);
        assert!(lines.iter().all(|l| l.length_mm() == 40.0));
    }

    #[test]
    fn they_wander_one_way_where_every_second_line_is_run_backwards() {
        let mut lines: Vec<_> = (0..4).map(|i| square(f64::from(i))).collect();
        lines[1].points.reverse();
        lines[3].points.reverse();
        shift_seams(&mut lines, 5.0, 0.125);
        assert_eq!(starts(&lines), [[5.0, 0.0], [10.0, 0.0], [10.0, 5.0], [10.0, 10.0]]);
    }

    proptest! {
        #[test]
        fn nothing_of_a_line_is_lost(shift in -100.0..100.0f64, share in 0.0..1.0f64, count in 3..20usize) {
            let round = |i: usize| libm::sin(i as f64) + 2.0;
            let point = |i: usize| {
                let a = i as f64 / count as f64 * std::f64::consts::TAU;
                SectionPoint { p: Point3::new(round(i) * libm::cos(a), round(i) * libm::sin(a), 0.0), n: Vector3::z() }
            };
            let line = TransversalLine { plane: 0, points: (0..count).map(point).collect(), closed: true, dark: vec![] };
            let mut lines = vec![line.clone(), line.clone()];
            shift_seams(&mut lines, shift, share);
            for moved in &lines {
                prop_assert!((moved.length_mm() - line.length_mm()).abs() < 1e-9);
                prop_assert!(line.points.iter().all(|q| moved.points.contains(q)));
                prop_assert!(moved.points.len() <= count + 1);
            }
        }
    }
}
