//! A zigzag without lifting: lines in working order become one where the next begins near the end of the one before (P4
//! Fig. 21b). The step from line to line is straight.

use super::section::{TransversalLine, linked};

/// Lines of a zigzag are joined at the rim where their ends are no more than so many spacings apart: where a round rim
/// slopes by 60° against them they are two.
pub const REACH_IN_SPACINGS: f64 = 2.5;

/// Joins open lines, in the order in which they are run, where the way from one to the next is no longer than `reach_mm`.
/// A joined line has the rank of its first.
pub fn back_and_forth(lines: Vec<TransversalLine>, reach_mm: f64) -> Vec<TransversalLine> {
    linked(lines, |from, to| ((to.p - from.p).norm() <= reach_mm).then(Vec::new))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::SectionPoint;
    use nalgebra::{Point3, Vector3};

    fn line(plane: usize, ends: [[f64; 2]; 2], dark: &[usize]) -> TransversalLine {
        let points = ends.map(|[x, y]| SectionPoint { p: Point3::new(x, y, 0.0), n: Vector3::z() }).to_vec();
        TransversalLine { plane, points, closed: false, dark: dark.to_vec() }
    }

    #[test]
    fn near_lines_become_one_and_far_or_closed_ones_stay() {
        let lines = || {
            vec![
                line(0, [[0.0, 0.0], [10.0, 0.0]], &[]),
                line(1, [[10.0, 2.0], [0.0, 2.0]], &[1]),
                line(2, [[0.0, 9.0], [10.0, 9.0]], &[]),
            ]
        };
        let made = back_and_forth(lines(), 3.0);
        assert_eq!(made.iter().map(|l| (l.plane, l.points.len())).collect::<Vec<_>>(), [(0, 4), (2, 2)]);
        assert_eq!(made[0].dark, [3], "the gap stays where it was");
        assert_eq!(back_and_forth(lines(), 7.0).len(), 1);
        assert_eq!(back_and_forth(lines(), 1.9), lines());
        let closed = TransversalLine { closed: true, ..line(1, [[10.0, 2.0], [0.0, 2.0]], &[]) };
        assert_eq!(back_and_forth(vec![line(0, [[0.0, 0.0], [10.0, 0.0]], &[]), closed], 3.0).len(), 2);
    }
}
