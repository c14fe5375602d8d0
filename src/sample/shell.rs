//! Puts facets together into the skin of a sample part: strips between loops, fans, plane faces.
//!
//! The one rule that keeps a skin watertight: neighbouring pieces are built from the *same* loop of
//! points, so that a shared corner is the same f32 and welds exactly. Nothing here intersects,
//! unites or repairs; loops that cross are not noticed (the tests compare areas and volumes).

use earcut::{Earcut, Refiner};

/// Facets with corners in mm, counter-clockwise seen from outside; every coordinate fits an f32.
pub type Triangles = Vec<[[f64; 3]; 3]>;

/// A point of a loop, mm. A closed loop does not repeat its first point.
pub(super) type Point = [f64; 3];

/// Where a plane face looks to: its outward normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Facing {
    PlusX,
    MinusX,
    PlusY,
    MinusY,
    PlusZ,
    MinusZ,
}

impl Facing {
    /// The two coordinates in which the face is seen from outside, first to the right, second up.
    fn axes(self) -> [usize; 2] {
        match self {
            Facing::PlusX => [1, 2],
            Facing::MinusX => [2, 1],
            Facing::PlusY => [2, 0],
            Facing::MinusY => [0, 2],
            Facing::PlusZ => [0, 1],
            Facing::MinusZ => [1, 0],
        }
    }
}

/// A skin in the making.
#[derive(Clone, Debug, Default)]
pub(super) struct Shell {
    triangles: Triangles,
}

impl Shell {
    pub(super) fn new() -> Shell {
        Shell::default()
    }

    /// The facets, in the order in which they were put in.
    pub(super) fn into_triangles(self) -> Triangles {
        self.triangles
    }

    /// One facet, counter-clockwise seen from outside.
    pub(super) fn facet(&mut self, a: Point, b: Point, c: Point) {
        self.triangles.push([stored(a), stored(b), stored(c)]);
    }

    /// A four-sided face a, b, c, d, counter-clockwise seen from outside.
    pub(super) fn quad(&mut self, a: Point, b: Point, c: Point, d: Point) {
        self.facet(a, b, c);
        self.facet(a, c, d);
    }

    /// The wall between two closed loops of equally many points.
    ///
    /// Loops run counter-clockwise about an axis. A wall from `from` to `to` *along* the axis looks
    /// outwards (a boss); *against* the axis it looks inwards (a bore, a bowl).
    pub(super) fn strip(&mut self, from: &[Point], to: &[Point]) {
        debug_assert_eq!(from.len(), to.len());
        let n = from.len().min(to.len());
        for i in 0..n {
            let j = (i + 1) % n;
            self.quad(from[i], from[j], to[j], to[i]);
        }
    }

    /// Strips through a row of loops, one after the other.
    pub(super) fn tube(&mut self, loops: &[Vec<Point>]) {
        for pair in loops.windows(2) {
            self.strip(&pair[0], &pair[1]);
        }
    }

    /// The straight wall between two loops, in `rows` rows, so that its facets are no needles.
    pub(super) fn wall(&mut self, from: &[Point], to: &[Point], rows: usize) {
        let between = |k: usize| -> Vec<Point> {
            let f = k as f64 / rows as f64;
            let mix = |(a, b): (&Point, &Point)| {
                std::array::from_fn(|c| if k == rows { b[c] } else { a[c] + f * (b[c] - a[c]) })
            };
            from.iter().zip(to).map(mix).collect()
        };
        self.tube(&(0..=rows).map(between).collect::<Vec<_>>());
    }

    /// Closes a loop with a point: a strip whose second loop has shrunk to `apex`.
    pub(super) fn fan(&mut self, from: &[Point], apex: Point) {
        for i in 0..from.len() {
            self.facet(from[i], from[(i + 1) % from.len()], apex);
        }
    }

    /// Opens a loop from a point: a strip whose first loop has shrunk to `apex`.
    pub(super) fn fan_from(&mut self, apex: Point, to: &[Point]) {
        for i in 0..to.len() {
            self.facet(apex, to[(i + 1) % to.len()], to[i]);
        }
    }

    /// The ring between two loops with different numbers of points, as [`Shell::strip`].
    ///
    /// The loops are walked side by side by their share of the way, so both must begin in the same
    /// direction and be divided about alike.
    pub(super) fn zip(&mut self, from: &[Point], to: &[Point]) {
        let (n, m) = (from.len(), to.len());
        let (mut i, mut j) = (0, 0);
        while i < n || j < m {
            // Whole numbers, so that the choice is the same on every machine.
            if j == m || (i < n && (i + 1) * m <= (j + 1) * n) {
                self.facet(from[i % n], from[(i + 1) % n], to[j % m]);
                i += 1;
            } else {
                self.facet(from[i % n], to[(j + 1) % m], to[j % m]);
                j += 1;
            }
        }
    }

    /// A plane face square to an axis, with holes; loops in any direction.
    ///
    /// No loop may have three neighbouring points on one straight line: the triangulation drops the
    /// middle one, and the wall behind it would no longer fit.
    pub(super) fn face(&mut self, facing: Facing, outer: &[Point], holes: &[&[Point]]) {
        let mut points: Vec<Point> = outer.iter().copied().map(stored).collect();
        let mut starts: Vec<usize> = Vec::with_capacity(holes.len());
        for hole in holes {
            starts.push(points.len());
            points.extend(hole.iter().copied().map(stored));
        }
        let [u, v] = facing.axes();
        let flat: Vec<[f64; 2]> = points.iter().map(|p| [p[u], p[v]]).collect();
        let mut corners: Vec<usize> = Vec::new();
        Earcut::new().earcut(flat.iter().copied(), &starts, &mut corners);
        Refiner::new().refine(&mut corners, &flat);
        for t in corners.chunks_exact(3) {
            let (a, b, c) = (flat[t[0]], flat[t[1]], flat[t[2]]);
            let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            let (second, third) = if twice > 0.0 { (t[1], t[2]) } else { (t[2], t[1]) };
            self.facet(points[t[0]], points[second], points[third]);
        }
    }
}

/// The point as the file holds it: rounded to f32, and no minus zero.
pub(super) fn stored(p: Point) -> Point {
    p.map(|x| f64::from(x as f32) + 0.0)
}
