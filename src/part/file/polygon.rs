//! Cuts polygons into triangles by their corners alone, ears first, whether they are convex or not. Every corner stays
//! one of a triangle, those on a straight edge too: the neighbour has it as well, and the surface would gape there.

use crate::part::raw_part::{FacetFault, RawPart, fault_of};

/// More corners are not cut: the work grows with their square, and programs that write polygons of thousands of
/// corners cut them themselves.
const MOST_CORNERS: usize = 4096;

/// Adds the triangles of a polygon whose text or record begins at `byte`, or notes why it has none.
pub(super) fn push(part: &mut RawPart, corners: &[[f32; 3]], byte: usize) {
    match triangles(corners) {
        Ok(list) => list.iter().for_each(|t| part.push_checked(t.map(|k| corners[k]), byte)),
        Err(fault) => part.push_invalid(fault, byte),
    }
}

fn triangles(corners: &[[f32; 3]]) -> Result<Vec<[usize; 3]>, FacetFault> {
    let n = corners.len();
    if n < 3 {
        return Err(FacetFault::NotThreeVertices);
    }
    if let Some(fault) = fault_of(corners.as_flattened()) {
        return Err(fault);
    }
    match n {
        3 => Ok(vec![[0, 1, 2]]),
        4..=MOST_CORNERS => ears(&flat(corners)).ok_or(FacetFault::CrossesItself),
        _ => Err(FacetFault::TooManyCorners),
    }
}

/// The polygon seen from where it goes round counter-clockwise, along the axis that it faces most; from the first
/// corner, so that a part far from the origin keeps its digits.
fn flat(corners: &[[f32; 3]]) -> Vec<[f64; 2]> {
    let from_first = |c: &[f32; 3]| -> [f64; 3] { std::array::from_fn(|k| f64::from(c[k]) - f64::from(corners[0][k])) };
    let points: Vec<[f64; 3]> = corners.iter().map(from_first).collect();
    let mut normal = [0.0; 3];
    for (a, b) in points.iter().zip(points.iter().cycle().skip(1)) {
        for (k, n) in normal.iter_mut().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            *n += a[i] * b[j] - a[j] * b[i];
        }
    }
    let most = (0..3).fold(0, |m, k| if normal[k].abs() > normal[m].abs() { k } else { m });
    let (i, j) = if normal[most] < 0.0 { ((most + 2) % 3, (most + 1) % 3) } else { ((most + 1) % 3, (most + 2) % 3) };
    points.iter().map(|p| [p[i], p[j]]).collect()
}

/// Twice the area of a triangle, positive where it goes round counter-clockwise.
fn area(points: &[[f64; 2]], [a, b, c]: [usize; 3]) -> f64 {
    let [a, b, c] = [points[a], points[b], points[c]];
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// So small a share of a polygon's area is none: corners on a straight edge are rounded to either side of it.
const NO_AREA: f64 = 1e-6;

/// Triangles of a polygon that goes round counter-clockwise; `None`: it crosses itself.
fn ears(points: &[[f64; 2]]) -> Option<Vec<[usize; 3]>> {
    let least = NO_AREA * (1..points.len() - 1).map(|k| area(points, [0, k, k + 1])).sum::<f64>();
    let mut left: Vec<usize> = (0..points.len()).collect();
    let mut out = Vec::with_capacity(points.len() - 2);
    let (mut at, mut tried) = (1, 0);
    while left.len() > 3 && tried < left.len() {
        let m = left.len();
        let ear = [at + m - 1, at, at + 1].map(|k| left[k % m]);
        if is_ear(points, &left, ear) {
            out.push(ear);
            left.remove(at % m);
            (at, tried) = (at % m, 0);
        } else {
            (at, tried) = (at + 1, tried + 1);
        }
    }
    // What is left is the last triangle, or all lies on one line.
    let rest = left[1..].windows(2).map(|w| [left[0], w[0], w[1]]);
    let is_left = |t: [usize; 3]| area(points, t) >= -least && (left.len() == 3 || area(points, t) <= least);
    rest.clone().all(is_left).then(|| out.into_iter().chain(rest).collect())
}

/// Whether the triangle of three corners in a row can be cut off: it turns as the polygon does, and no other corner
/// lies in it. Corners in the same place as its own do: the two sides of a cut that leads to a hole.
fn is_ear(points: &[[f64; 2]], left: &[usize], ear: [usize; 3]) -> bool {
    let [a, b, c] = ear;
    let lies_in = |p: usize| [[a, b, p], [b, c, p], [c, a, p]].iter().all(|t| area(points, *t) >= 0.0);
    let is_corner = |p: usize| ear.iter().any(|e| points[*e] == points[p]);
    area(points, ear) > 0.0 && !left.iter().any(|&p| !is_corner(p) && lies_in(p))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn total(corners: &[[f32; 3]]) -> Result<f64, FacetFault> {
        let flat = flat(corners);
        triangles(corners).map(|list| list.iter().map(|t| area(&flat, *t)).sum::<f64>() / 2.0)
    }

    #[test]
    fn squares_concave_ones_and_straight_edges() {
        let square = [[0.0, 0.0, 7.0], [2.0, 0.0, 7.0], [2.0, 2.0, 7.0], [0.0, 2.0, 7.0]];
        assert_eq!(triangles(&square), Ok(vec![[0, 1, 2], [0, 2, 3]]));
        // A fan from the first corner would reach outside of this arrow, and over its notch from any but one.
        let arrow = [[0.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 1.0, 0.0], [-4.0, 4.0, 0.0]];
        assert_eq!(triangles(&arrow).map(|l| l.len()), Ok(2));
        assert_eq!(total(&arrow), Ok(4.0));
        // Corners on straight edges: none is lost, no triangle is without area.
        let straight =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let list = triangles(&straight).expect("cut");
        let flat = flat(&straight);
        assert!((0..6).all(|k| list.iter().flatten().any(|c| *c == k)));
        assert!(list.iter().all(|t| area(&flat, *t) > 0.0), "{list:?}");
        // A frame: a square with a square hole, joined by a cut.
        let hole = [
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [0.0, 9.0],
            [0.0, 0.0],
            [3.0, 3.0],
            [3.0, 6.0],
            [6.0, 6.0],
            [6.0, 3.0],
            [3.0, 3.0],
        ];
        assert_eq!(total(&hole.map(|[x, y]| [5.0, y, -x])), Ok(72.0));
    }

    #[test]
    fn what_cannot_be_cut_is_told() {
        let bow = [[0.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
        assert_eq!(triangles(&bow), Err(FacetFault::CrossesItself));
        assert_eq!(triangles(&[[0.0; 3]; 2]), Err(FacetFault::NotThreeVertices));
        assert_eq!(triangles(&vec![[0.0; 3]; 4097]), Err(FacetFault::TooManyCorners));
        assert_eq!(triangles(&[[0.0, f32::NAN, 0.0]; 4]), Err(FacetFault::Nan));
        // On one line: triangles without area, which planning skips.
        let line: Vec<[f32; 3]> = (0..5).map(|x| [x as f32, 0.0, 0.0]).collect();
        assert_eq!(triangles(&line).map(|l| l.len()), Ok(3));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Stars of any radii are simple polygons: the triangles of one have its area, whichever way it faces.
        #[test]
        fn triangles_have_the_area_of_the_polygon(
            radii in prop::collection::vec(0.1f32..10.0, 4..40), axis in 0..3usize, mirrored: bool,
        ) {
            let n = radii.len();
            let point = |(k, r): (usize, &f32)| {
                let turn = std::f32::consts::TAU * k as f32 / n as f32;
                let (x, y) = (r * libm::cosf(turn), r * libm::sinf(turn));
                let mut p = [0.0; 3];
                (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = if mirrored { (y, x, 3.0) } else { (x, y, 3.0) };
                p
            };
            let corners: Vec<[f32; 3]> = radii.iter().enumerate().map(point).collect();
            let flat = flat(&corners);
            let side = |k: usize| area(&[[0.0, 0.0], flat[k], flat[(k + 1) % n]], [0, 1, 2]);
            let shoelace = (0..n).map(side).sum::<f64>() / 2.0;
            let cut = total(&corners);
            prop_assert!(cut.is_ok_and(|a| (a - shoelace).abs() < 1e-9 * shoelace), "{cut:?} {shoelace}");
        }
    }
}
