//! A piece of a facet: a convex polygon in the facet's own plane, cut along a grid that lies along the
//! facet's longest side. So a long thin facet gives no more pieces than its area needs, and turning the
//! part does not change them.

use nalgebra::{Point3, Vector3};

/// A triangle cut by a rectangle has no more corners than this.
const MOST: usize = 7;

/// The plane of a facet.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    origin: Point3<f64>,
    u: Vector3<f64>,
    v: Vector3<f64>,
}

/// A convex polygon in it, and the box around its corners, mm.
#[derive(Clone, Copy, Debug)]
pub struct FacetPolygon {
    corners: [[f64; 2]; MOST],
    count: usize,
    low: [f64; 2],
    high: [f64; 2],
}

impl Plane {
    /// The plane of a facet that has an area, and the whole facet in it.
    pub fn of(facet: &[Point3<f64>; 3]) -> (Plane, FacetPolygon) {
        let side = |k: usize| (facet[(k + 1) % 3] - facet[k]).norm_squared();
        let longest = (0..3).fold(0, |best, k| if side(k) > side(best) { k } else { best });
        let [a, b, c] = [0, 1, 2].map(|k| facet[(longest + k) % 3]);
        let u = (b - a).normalize();
        let off = c - a - u * (c - a).dot(&u);
        let plane = Plane { origin: a, u, v: off.normalize() };
        let mut cell = FacetPolygon::empty();
        for corner in [[0.0, 0.0], [(b - a).dot(&u), 0.0], [(c - a).dot(&u), off.norm()]] {
            cell.push(corner);
        }
        (plane, cell)
    }

    /// A place of the plane in space.
    pub fn place(&self, [u, v]: [f64; 2]) -> Point3<f64> {
        self.origin + self.u * u + self.v * v
    }
}

impl FacetPolygon {
    fn empty() -> FacetPolygon {
        FacetPolygon { corners: [[0.0; 2]; MOST], count: 0, low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] }
    }

    fn push(&mut self, corner: [f64; 2]) {
        if self.count < MOST {
            self.corners[self.count] = corner;
            self.count += 1;
            for (k, x) in corner.into_iter().enumerate() {
                self.low[k] = self.low[k].min(x);
                self.high[k] = self.high[k].max(x);
            }
        }
    }

    /// Its corners, counter-clockwise as those of the facet.
    pub fn corners(&self) -> &[[f64; 2]] {
        &self.corners[..self.count]
    }

    /// The longer side of its box, mm.
    pub fn size_mm(&self) -> f64 {
        (self.high[0] - self.low[0]).max(self.high[1] - self.low[1])
    }

    /// Middle and half diagonal of its box.
    pub fn disc(&self) -> ([f64; 2], f64) {
        let half = [0, 1].map(|k| 0.5 * (self.high[k] - self.low[k]));
        ([0, 1].map(|k| 0.5 * (self.low[k] + self.high[k])), libm::hypot(half[0], half[1]))
    }

    /// Its area, mm², and its centroid.
    pub fn area(&self) -> (f64, [f64; 2]) {
        let Some(&first) = self.corners().first() else { return (0.0, [0.0; 2]) };
        let (mut twice, mut sum) = (0.0, [0.0; 2]);
        for w in self.corners().windows(2) {
            let [p, q] = [w[0], w[1]].map(|c| [c[0] - first[0], c[1] - first[1]]);
            let cross = p[0] * q[1] - p[1] * q[0];
            twice += cross;
            sum = [0, 1].map(|k| sum[k] + cross * (p[k] + q[k]));
        }
        let inside = |k: usize| if twice > 0.0 { first[k] + sum[k] / (3.0 * twice) } else { first[k] };
        (0.5 * twice, [inside(0), inside(1)])
    }

    /// Its two pieces on either side of a line of the grid, the one that is shared by the largest
    /// squares; `None` where no side of its box is longer than `pitch_mm`.
    pub fn halves(&self, pitch_mm: f64) -> Option<[FacetPolygon; 2]> {
        let axis = usize::from(self.high[1] - self.low[1] > self.high[0] - self.low[0]);
        let (low, high) = (self.low[axis], self.high[axis]);
        // A hair more than one square is one square.
        if high - low <= pitch_mm * (1.0 + 1e-9) {
            return None;
        }
        let middle = 0.5 * (low + high);
        let mut line = (middle / pitch_mm).round() * pitch_mm;
        let mut step = 2.0 * pitch_mm;
        while step < high - low {
            let wider = (middle / step).round() * step;
            if wider <= low || wider >= high {
                break;
            }
            line = wider;
            step *= 2.0;
        }
        Some([self.clipped(axis, line, 1.0), self.clipped(axis, line, -1.0)])
    }

    /// The piece on the side `sign·(x − line) ≤ 0`.
    fn clipped(&self, axis: usize, line: f64, sign: f64) -> FacetPolygon {
        let mut out = FacetPolygon::empty();
        let corners = self.corners();
        for (i, a) in corners.iter().enumerate() {
            let b = corners[(i + 1) % corners.len()];
            let (x, y) = (sign * (a[axis] - line), sign * (b[axis] - line));
            if x <= 0.0 {
                out.push(*a);
            }
            if (x < 0.0 && y > 0.0) || (x > 0.0 && y < 0.0) {
                let t = x / (x - y);
                let mut cut = [0, 1].map(|k| a[k] + (b[k] - a[k]) * t);
                cut[axis] = line;
                out.push(cut);
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cut(cell: &FacetPolygon, pitch_mm: f64, out: &mut Vec<FacetPolygon>) {
        match cell.halves(pitch_mm) {
            None => out.push(*cell),
            Some(halves) => halves.iter().for_each(|h| cut(h, pitch_mm, out)),
        }
    }

    proptest! {
        /// Nothing is lost or counted twice, no piece is too large, and there are not many too many.
        #[test]
        fn the_pieces_are_the_facet(c in prop::array::uniform9(-9.0..9.0f64), pitch in 0.2..3.0f64) {
            let facet = [0, 3, 6].map(|k| Point3::new(c[k], c[k + 1], c[k + 2]));
            let cross = (facet[1] - facet[0]).cross(&(facet[2] - facet[0]));
            prop_assume!(cross.norm() > 0.1);
            let (plane, whole) = Plane::of(&facet);
            let mut cells = Vec::new();
            cut(&whole, pitch, &mut cells);
            let area: f64 = cells.iter().map(|c| c.area().0).sum();
            prop_assert!((area - 0.5 * cross.norm()).abs() < 1e-9 * area);
            let centroid: Vector3<f64> = cells.iter().map(|c| plane.place(c.area().1).coords * c.area().0).sum::<Vector3<f64>>() / area;
            prop_assert!((centroid - (facet[0].coords + facet[1].coords + facet[2].coords) / 3.0).norm() < 1e-9);
            prop_assert!(cells.iter().all(|c| c.size_mm() <= pitch * 1.001 && c.disc().1 <= pitch * 0.7079));
            let longest = (0..3).map(|k| (facet[(k + 1) % 3] - facet[k]).norm()).fold(0.0, f64::max);
            // Its squares, and those that a side runs through.
            let most = area / (pitch * pitch) + 6.0 * longest / pitch + 8.0;
            prop_assert!((cells.len() as f64) < most, "{} of {most}", cells.len());
        }
    }
}
